// From where water shows the scene: from the eye's mirror image at the plane of the sea.
#pragma once

#include <optional>
#include <string>

#include "skydrop/render/frame/view.h"

namespace skydrop::render {

// From this height of the eye on water mirrors none of the scene, m: few of the rays of a far wave meet
// anything, and what they meet, as snow of a far peak, would be spots.
inline constexpr double kMirrorEndsM = 200;

// Why a view has nothing that water mirrors of the scene; nullopt: it may have.
std::optional<std::string> whyNothingIsMirrored(const View& view);

// The view from the mirrored eye (x, -y, z), looking and standing the other way up, so that it is a rotation
// as every view: its picture is the mirror's turned upside down. Its pixels are `spacing` (at least 1) times
// as wide as the view's, and it reaches beyond the view on all sides by this share of its width and height
// (at least 0; at most 2.9 rad high and wide in all).
View mirroredView(const View& view, double margin, int spacing);

}  // namespace skydrop::render
