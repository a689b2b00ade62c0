#include <algorithm>
#include <cmath>
#include <limits>

#include "elevation/readers.h"

namespace skydrop::elevation {
namespace {

class HeldRaster final : public Raster {
 public:
  HeldRaster(std::string name, std::string form, int columns, int rows, const Georeference& georeference,
             std::vector<float> heights)
      : Raster(std::move(name), std::move(form), columns, rows, georeference), heights_(std::move(heights)) {}

  void read(int column, int row, int columns, int rows, float* out) const override {
    for (int r = 0; r < rows; ++r) {
      const float* from = heights_.data() + static_cast<std::size_t>(row + r) * width() + column;
      out = std::copy(from, from + columns, out);
    }
  }
  std::size_t heldBytes() const override { return heights_.capacity() * sizeof(float); }

 private:
  std::vector<float> heights_;
};

// Means of k x k cells of another raster.
class AveragedRaster final : public Raster {
 public:
  AveragedRaster(std::shared_ptr<const Raster> fine, int k)
      : Raster(fine->name(),
               fine->form() + ", averaged from " + std::to_string(k) + " x " + std::to_string(k),
               (fine->width() + k - 1) / k, (fine->height() + k - 1) / k, georeferenceOf(*fine, k)),
        fine_(std::move(fine)),
        k_(k) {}

  void read(int column, int row, int columns, int rows, float* out) const override {
    const int firstColumn = column * k_, pastColumn = std::min((column + columns) * k_, fine_->width());
    const int fineColumns = pastColumn - firstColumn;
    std::vector<float> band(static_cast<std::size_t>(fineColumns) * k_);
    for (int r = 0; r < rows; ++r) {
      const int firstRow = (row + r) * k_, fineRows = std::min(k_, fine_->height() - firstRow);
      fine_->read(firstColumn, firstRow, fineColumns, fineRows, band.data());
      for (int c = 0; c < columns; ++c) {
        double sum = 0;
        int count = 0;
        for (int y = 0; y < fineRows; ++y) {
          for (int x = c * k_; x < std::min((c + 1) * k_, fineColumns); ++x) {
            const float height = band[static_cast<std::size_t>(y) * fineColumns + x];
            if (!(height == height)) continue;
            sum += height;
            ++count;
          }
        }
        *out++ = count > 0 ? static_cast<float>(sum / count) : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  int rowsTogether() const override { return (fine_->rowsTogether() + k_ - 1) / k_; }
  void rest() const override { fine_->rest(); }
  std::size_t heldBytes() const override { return fine_->heldBytes(); }

 private:
  static Georeference georeferenceOf(const Raster& fine, int k) {
    const Georeference& of = fine.georeference();
    const double middle = 0.5 * (k - 1);
    return {of.crs, centreOf(of, middle, middle), of.cell * static_cast<double>(k)};
  }

  std::shared_ptr<const Raster> fine_;
  int k_;
};

}  // namespace

float heightOrVoid(double metres) {
  const bool isHeight = metres >= kLowestHeight && metres <= kHighestHeight;  // false for NaN
  return isHeight ? static_cast<float>(metres) : std::numeric_limits<float>::quiet_NaN();
}

std::shared_ptr<const Raster> makeHeldRaster(std::string name, std::string form, int width, int height,
                                             const Georeference& georeference, std::vector<float> heights) {
  for (float& value : heights) value = heightOrVoid(value);
  return std::make_shared<HeldRaster>(std::move(name), std::move(form), width, height, georeference,
                                      std::move(heights));
}

std::shared_ptr<const Raster> averaged(std::shared_ptr<const Raster> raster, int cells) {
  return std::make_shared<AveragedRaster>(std::move(raster), cells);
}

}  // namespace skydrop::elevation
