// The camera that goes down with a package: from the side that the aircraft flew on from, a little above it,
// until some seconds after the landing. A view of it is a function of the snapshot, the heading that it was
// begun with and the land. Main thread.
#pragma once

#include <cstdint>
#include <optional>

#include "app/types/size.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::app {

class PackageCamera {
 public:
  static constexpr double kStaysSeconds = 4;  // after the landing

  // Goes down with the package that left last and is still there; false where there is none.
  bool begin(const game::Snapshot& now);
  void end() { package_.reset(); }
  // Once a frame: false from when the package is gone, or has lain for a while.
  bool follow(const game::Snapshot& now);
  bool rides() const { return package_.has_value(); }

  // From where the package is seen while it is followed; nothing where it is not in the snapshot. `ground`
  // may be null.
  std::optional<render::View> view(const game::Snapshot& now, const render::CameraSettings& settings,
                                   Size size, const terrain::HeightSource* ground) const;

 private:
  std::optional<std::uint32_t> package_;
  double headingRad_ = 0;  // along which it is looked at
  std::optional<double> landedAt_;
};

// The package that left last and has not been taken away; null: there is none.
const game::PackageSnapshot* newestPackage(const game::Snapshot& now);

}  // namespace skydrop::app
