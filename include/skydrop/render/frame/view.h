// From where, in which direction and how wide a frame is seen. World positions are double; what reaches the
// GPU is float and relative to the eye, so a frame at 1e9 m equals the same frame at the origin.
//
// Depth is reversed with an infinite far plane: depth = nearM / distance along the view axis, 1 at the near
// plane and 0 at infinity (shaders/shared/depth.glsl).
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace skydrop::render {

struct View {
  glm::dvec3 position{0};         // the eye, m
  glm::dmat3 worldToView{1};      // rows: right, up, back. A rotation: orthonormal, determinant 1
  double fovYRad = 1.0471975512;  // vertical field of view, (0, 3)
  int width = 1280;               // pixels, [1, 16384]
  int height = 720;
  double nearM = 0.1;  // near plane, m, > 0
  // Where the axis of the picture's middle meets the plane 1 m ahead: metres right and up. 0 but for a part
  // of a larger picture (partOf).
  glm::dvec2 offAxis{0};

  double aspect() const { return static_cast<double>(width) / height; }
  // Of a pixel in the middle of the picture; elsewhere it is seen under a smaller angle.
  double pixelAngleRad() const { return 2 * std::tan(fovYRad / 2) / height; }
  glm::dvec3 right() const { return {worldToView[0][0], worldToView[1][0], worldToView[2][0]}; }
  glm::dvec3 up() const { return {worldToView[0][1], worldToView[1][1], worldToView[2][1]}; }
  glm::dvec3 forward() const { return -glm::dvec3{worldToView[0][2], worldToView[1][2], worldToView[2][2]}; }
};

// Throws core::RangeError in one line for anything above that does not hold: a camera that is not finite can
// give a plausible picture without one NaN pixel, so it is refused here.
void requireValid(const View& view);

// A square part of a picture as a view of its own: `side` x `side` pixels, each as large as pixelSize x
// pixelSize of the whole, the first at `corner` (pixels of the whole from its lower left corner). It may
// reach beyond the whole. Of pixel size 1 its rays are those of the whole, but for rounding.
View partOf(const View& whole, const glm::ivec2& corner, int side, int pixelSize);

// The same picture of fewer or more pixels: of either side this share, rounded, within the range above.
View scaled(const View& view, double share);

// Clip space of OpenGL with glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE).
glm::mat4 projection(const View& view);
// Of positions relative to the eye, in world axes, to clip space.
glm::mat4 viewProjection(const View& view);
// The only way from a world position to a float one: subtracted in double.
inline glm::vec3 relativeToEye(const View& view, const glm::dvec3& world) {
  return glm::vec3(world - view.position);
}
// Model space to eye-relative world axes, of a body at `position` with orientation body to world.
glm::mat4 bodyMatrix(const View& view, const glm::dvec3& position, const glm::dquat& orientation,
                     double scale = 1);

// Unit direction of the ray through a point of the picture, in pixels from the lower left corner (centres at
// .5).
glm::dvec3 rayDirection(const View& view, const glm::dvec2& pixel);
// NDC x, y and 1 to an unnormalised ray direction whose component along the view axis is 1: ray = m * (x, y,
// 1).
glm::dmat3 rayMatrix(const View& view);

}  // namespace skydrop::render
