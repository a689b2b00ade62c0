// A view as the words of --pose: the free camera that sees the same.
#pragma once

#include <string>

#include "app/types/pose.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

// The pose whose view is `view`, whatever camera made it. Of the many poses that look straight up or down it
// is one.
Pose poseOf(const render::View& view);

// "--pose=X,Y,Z,YAW,PITCH,ROLL", with as many digits as read back to the same bits. One word, so that a
// negative X is no flag.
std::string poseText(const Pose& pose);

}  // namespace skydrop::app
