#include "skydrop/core/light_shafts.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/shared_clouds.h"
#include "skydrop/core/shared_erosion_lines.h"
#include "skydrop/core/shared_flash.h"
#include "skydrop/core/shared_glitter.h"
#include "skydrop/core/shared_ground_cover.h"
#include "skydrop/core/shared_ground_detail.h"
#include "skydrop/core/shared_guard_marks.h"
#include "skydrop/core/shared_ice.h"
#include "skydrop/core/shared_lamps.h"
#include "skydrop/core/shared_optics.h"
#include "skydrop/core/shared_places.h"
#include "skydrop/core/shared_precipitation.h"
#include "skydrop/core/shared_sea.h"
#include "skydrop/core/shared_spray.h"
#include "skydrop/core/shared_woods.h"
#include "skydrop/lab/shared.h"
#include "support/hunt.h"

// NOLINTBEGIN: the statements are those of GLSL.
#define HUNTED(name, arguments, results, ...) \
  inline void hunted_##name(const Real* a, Real* r) { __VA_ARGS__; }
namespace skydrop::core::shared::f32 {
#include "support/hunt_functions.inl"
}
namespace skydrop::core::shared::f64 {
#include "support/hunt_functions.inl"
}
#undef HUNTED
// NOLINTEND

namespace skydrop::test {
const std::vector<HuntedFunction>& huntedFunctions() {
#define HUNT_LIST(...) \
  { __VA_ARGS__ }
#define HUNTED(name, arguments, results, ...) \
  {#name,                                     \
   HUNT_LIST arguments,                       \
   HUNT_LIST results,                         \
   core::shared::f32::hunted_##name,          \
   core::shared::f64::hunted_##name,          \
   #__VA_ARGS__},
  static const std::vector<HuntedFunction> functions = {
#include "support/hunt_functions.inl"
  };
#undef HUNTED
#undef HUNT_LIST
  return functions;
}

}  // namespace skydrop::test
