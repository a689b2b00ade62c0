// What the models of a frame hide of the sun, for whoever draws their shadows.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/models/model.h"

namespace skydrop::render {

// Takes one part of a thing that is made of models: the model, where it stands (to eye-relative world axes)
// and how.
using DrawPart = std::function<void(const Model& model, const glm::mat4& toEye, const ModelPose& pose)>;

// Something solid that hides the sun.
struct ShadowCaster {
  glm::dvec3 middle{0};  // of a ball that holds it, world, m
  double radiusM = 0;
  double areaM2 = 0;  // of its outline, roughly: how far off its shadow can be told
  std::function<void(const View&, const DrawPart&)> parts;
};

// Adds what there is in a frame. It must stay callable as long as the pass that asks lives; what a caster
// refers to must outlive the frame.
using ShadowSource = std::function<void(const FrameInput&, std::vector<ShadowCaster>&)>;

}  // namespace skydrop::render
