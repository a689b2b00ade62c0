// Marks over the picture at places of the world: where a package comes down, and an arrow at the edge that
// points to a target out of view. Pure; the eye is handed in as numbers, because the interface knows no
// renderer.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "skydrop/game/snapshot.h"

namespace skydrop::ui {

// From where the picture is seen (as render::View): the eye in world metres, a rotation whose rows are right,
// up and back, the vertical field of view, and the size in pixels.
struct Eye {
  glm::dvec3 position{0};
  glm::dmat3 worldToView{1};
  double fovYRad = 1;
  double width = 1, height = 1;
};

struct HudMark {
  enum class Kind {
    landing,  // of a package in the air
    aim,      // of one that would be dropped now
    toTarget  // an arrow: the target is out of view
  } kind = Kind::landing;
  glm::dvec2 place{0};  // pixels from the top left; of an arrow only the side is meant: 0 or the width
  bool isInTarget = false;
  std::string text;  // beside it; may be empty
};

// Beyond this the aim is not shown: m to the target.
inline constexpr double kAimRangeM = 3000;

// Of the newest package in the air, of the aim near a target, and to the target. Nothing that is not finite,
// behind the eye or outside the picture, but for the arrow.
std::vector<HudMark> hudMarks(const game::Snapshot& snapshot, const Eye& eye);

}  // namespace skydrop::ui
