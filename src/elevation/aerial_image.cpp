#include "skydrop/elevation/aerial_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elevation/readers.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/picture_file.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

core::Image readSmallPicture(const std::filesystem::path& file) {
  core::Image image = core::readPicture(file);
  if (image.rgba.size() / 4 > kMostPicturePixels)
    throw DataError(file.string(), "size", "more than 2^26 pixels: hand it in as a GeoTIFF");
  return image;
}

// A picture that is decoded when it is wanted, and not held between.
class PictureImage final : public AerialImage {
 public:
  PictureImage(std::filesystem::path file, std::string form, int width, int height,
               const Georeference& georeference)
      : AerialImage(file.string(), std::move(form), width, height, georeference), file_(std::move(file)) {}

  void scan(const std::function<void(const Part&)>& take) const override {
    const core::Image image = readSmallPicture(file_);
    if (image.width != width() || image.height != height())
      throw DataError(name(), "size", "has changed since it was opened");
    constexpr int kRows = 64;
    for (int row = 0; row < image.height; row += kRows)
      take({0, row, image.width, std::min(kRows, image.height - row), image.pixel(0, row)});
  }

 private:
  std::filesystem::path file_;
};

Georeference placeOf(const std::filesystem::path& file, const core::Image& image,
                     const std::optional<ImageCorners>& corners) {
  const std::string name = file.string();
  Georeference place;
  if (corners) {
    if (!(corners->west < corners->east && corners->south < corners->north))
      throw DataError(name, "corners", "do not go from west to east and from south to north");
    place.cell = {(corners->east - corners->west) / image.width,
                  (corners->north - corners->south) / image.height};
    place.first = {corners->west + place.cell.x / 2, corners->north - place.cell.y / 2};
  } else if (const auto world = worldFileBeside(file)) {
    place = *world;
  } else {
    throw DataError(name, "georeference",
                    "there is no world file (.pgw, .jgw, .wld) beside it, and no corners are stated");
  }
  const glm::dvec2 last = centreOf(place, image.width - 1, image.height - 1);
  const auto crs = crsBeside(file);
  const auto guess = guessedCrs({place.first.x, last.y}, {last.x, place.first.y});
  if (!crs && !guess)
    throw DataError(name, "reference system", "is not told by the coordinates: put a .prj file beside it");
  place.crs = crs.value_or(guess.value_or(""));
  return place;
}

}  // namespace

AerialImage::AerialImage(std::string name, std::string form, int width, int height, Georeference georeference)
    : name_(std::move(name)),
      form_(std::move(form)),
      width_(width),
      height_(height),
      georeference_(std::move(georeference)) {
  const auto isUsable = [](glm::dvec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::abs(v.x) < 1e9 && std::abs(v.y) < 1e9;
  };
  if (!isUsable(georeference_.first) || !isUsable(georeference_.cell) || georeference_.cell.x < 1e-9 ||
      georeference_.cell.y < 1e-9)
    throw DataError(name_, "georeference", "the pixels lie nowhere on the earth or have no size");
}

std::shared_ptr<const AerialImage> openAerialImage(const std::filesystem::path& file,
                                                   const std::optional<ImageCorners>& corners) {
  const std::string head = core::readFileStart(file, 16);
  const auto begins = [&](std::string_view with) { return head.starts_with(with); };
  if (isTiff(head)) {
    if (corners) throw DataError(file.string(), "corners", "a GeoTIFF has its own");
    return openGeoTiffImage(file);
  }
  const bool isPng = begins("\x89PNG");
  if (!isPng && !begins("\xff\xd8"))
    throw DataError(file.string(), "", "is no aerial image: none of GeoTIFF, PNG, JPEG");
  const core::Image image = readSmallPicture(file);
  return std::make_shared<PictureImage>(file, isPng ? "PNG" : "JPEG", image.width, image.height,
                                        placeOf(file, image, corners));
}

GeoPlace centreOf(const AerialImage& image) {
  const Projection projection(image.georeference().crs, image.name());
  const auto place = projection.inverse(
      centreOf(image.georeference(), 0.5 * (image.width() - 1), 0.5 * (image.height() - 1)));
  if (!place)
    throw DataError(image.name(), "georeference", "does not lie where its reference system reaches");
  return *place;
}

}  // namespace skydrop::elevation
