// What a picture's file says about how it was made: enough to make it again.
#pragma once

#include <vector>

#include "app/session/run_config.h"
#include "skydrop/core/image.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

// Software (name and version), Scene (its name), Seed, Time (simulated seconds), Pose (the words of --pose),
// and Settings: a preset for that scene, with every setting of the run that has another value than by default
// or than in the scene, but for those of keys and sticks.
std::vector<core::PictureText> pictureTexts(const RunConfig& run, const game::Snapshot& drawn,
                                            const render::View& view);

}  // namespace skydrop::app
