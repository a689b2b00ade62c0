// What a subject (subject.h) computes at one point of a study: the numbers that an error is measured in.
// A value; any thread.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "skydrop/core/image.h"

namespace skydrop::accuracy {

// A subject fills what it has and leaves the rest empty; two observations of one subject are of one shape.
struct Observation {
  // Of a picture: linear radiance, three values a pixel, row 0 at the top. Else samples of a quantity.
  std::vector<double> values;
  std::string unit = "1";     // of the values
  int width = 0, height = 0;  // pixels; 0: the values are no picture
  core::Image display;        // the picture as it is drawn: sRGB, tone-mapped, in 8 bits
  std::vector<double> seen;   // the same before it is rounded, three values a pixel in [0, 1]

  std::vector<glm::dvec3> positions;   // m
  std::vector<glm::dvec3> directions;  // unit
  std::vector<glm::dquat> attitudes;   // unit
  std::vector<double> energies;        // J
  bool isPicture() const { return width > 0; }
};

// Where a value is not finite, for a message: "the value of pixel (3, 7) is not finite"; empty: nowhere.
std::string notFiniteAt(const Observation& observation);

}  // namespace skydrop::accuracy
