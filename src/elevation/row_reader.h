// The surface of a mosaic along rows of samples: what Mosaic::at gives, but for the rounding of floats.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "elevation/mosaic.h"
#include "elevation/surface_kernels.h"

namespace skydrop::elevation {

// One thread; the mosaic must outlive it. Holds at most kHeldPages pages beside those that the mosaic keeps.
class RowReader {
 public:
  static constexpr std::size_t kHeldPages = 16;

  // For samples within `rect`.
  RowReader(const Mosaic& mosaic, const SurfaceKernels& kernels, const WorldRect& rect);

  // `count` (at most kRowSize) samples at x, x + step, ..., a power of two; valid until the next call. False
  // where the weights of all of them are 0, and `row` is undefined.
  bool read(glm::dvec2 xz, double step, int count);
  const SurfaceRow& row() const { return *row_; }

 private:
  void place(glm::dvec2 xz, double step, int count);
  void withhold(int from, int past);
  bool fade(int count);
  void findCells(int count);

  const Mosaic& mosaic_;
  const SurfaceKernels& kernels_;
  std::vector<FadingBlock> blocks_;  // near the rectangle
  bool isCovered_ = false;
  bool isOutside_ = false;  // some sample of the row has no place
  struct Held {
    std::int32_t column, row;
    std::shared_ptr<const Page> page;
  };
  std::vector<Held> held_;  // the newest last
  std::unique_ptr<SurfaceRow> row_ = std::make_unique<SurfaceRow>();
};

}  // namespace skydrop::elevation
