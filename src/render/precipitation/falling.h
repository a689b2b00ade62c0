// What falls at the eye of a frame.
#pragma once

#include <optional>
#include <string>

#include "skydrop/render/frame/frame_input.h"
#include "skydrop/weather/fall.h"

namespace skydrop::render {

// The weather at the eye; nullopt in frames without. In frames that warm up there is one in which everything
// falls.
std::optional<weather::State> weatherOf(const FrameInput& frame);

// Why nothing falls from it; nullopt: something does.
std::optional<std::string> whyDry(const std::optional<weather::State>& state);

}  // namespace skydrop::render
