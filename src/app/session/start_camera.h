// The camera that the command line asks for.
#pragma once

#include <optional>
#include <string>

#include "app/types/pose.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::app {

// Makes it a free camera at the pose; `ground` is what a pose above ground is counted from. At most
// render::kHighestCameraM up: what is counted from a mountain may be lowered.
void placeCamera(render::Camera& camera, const Pose& pose, const terrain::HeightSource& ground);

// A line for a camera below the surface, where nothing but the inside of the land is seen.
std::optional<std::string> underSurface(const render::Camera& camera, const terrain::HeightSource& ground);

}  // namespace skydrop::app
