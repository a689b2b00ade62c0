// Where the aircraft flew well: the places from which a crash is flown again.
#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>

#include "skydrop/core/hash.h"

namespace skydrop::game {

struct SafePlace {
  std::uint64_t step = 0;
  glm::dvec3 position{0};
  double headingRad = 0;  // compass
};

// Notes of the last minute, oldest first. The first may be where the aircraft was placed.
class SafePlaces {
 public:
  // Forgets everything but this.
  void startFrom(const SafePlace& place);
  void note(const SafePlace& place);
  // The newest that is at least `steps` old at `now`; else the oldest.
  const SafePlace& newestBefore(std::uint64_t now, std::uint64_t steps) const;

  void addTo(core::StateHasher& hash) const;

 private:
  std::deque<SafePlace> places_;  // never empty once started
};

}  // namespace skydrop::game
