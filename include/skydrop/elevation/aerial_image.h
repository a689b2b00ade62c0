// Aerial images: colours that lie somewhere on the earth (docs/elevation.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/elevation/projection.h"
#include "skydrop/elevation/raster.h"
#include "skydrop/terrain/ground_picture.h"

namespace skydrop::elevation {

// The corners of a picture that says nothing itself of where it lies: in degrees, or in LV95 where the
// numbers are of that.
struct ImageCorners {
  double west = 0, south = 0, east = 0, north = 0;  // of the outermost pixels' outer edges; west < east
};

// Immutable; one thread at a time.
class AerialImage {
 public:
  // Pixels of 8-bit sRGB-encoded colour and straight alpha, row-major; what is transparent shows nothing.
  struct Part {
    int column = 0, row = 0, columns = 0, rows = 0;
    const std::uint8_t* rgba = nullptr;
  };

  virtual ~AerialImage() = default;

  int width() const { return width_; }  // pixels, 1 .. kMostSide
  int height() const { return height_; }
  const Georeference& georeference() const { return georeference_; }
  const std::string& name() const { return name_; }
  const std::string& form() const { return form_; }  // for people

  // All of it, once: parts in the order of their rows, of which one is held at a time. Throws core::DataError
  // where the file does not give them.
  virtual void scan(const std::function<void(const Part&)>& take) const = 0;

 protected:
  // Throws core::DataError where size or georeference are beyond the limits.
  AerialImage(std::string name, std::string form, int width, int height, Georeference georeference);

 private:
  std::string name_, form_;
  int width_, height_;
  Georeference georeference_;
};

// By content: GeoTIFF of 8 bits, grey or RGB, with alpha or without, in strips or tiles, not compressed or by
// LZW, deflate or JPEG, placed by its tags; PNG or JPEG of at most kMostPicturePixels, placed by the corners
// where they are given, else by a world file beside it. Throws core::DataError.
inline constexpr std::size_t kMostPicturePixels = std::size_t{1} << 26;
std::shared_ptr<const AerialImage> openAerialImage(const std::filesystem::path& file,
                                                   const std::optional<ImageCorners>& corners = {});

// The middle of an image. Throws core::DataError where its system does not reach there.
GeoPlace centreOf(const AerialImage& image);

// What the images show of the world whose origin is the place, the first that shows something having the say:
// averaged to texels of as many metres as the budget of settings.megatexels asks for, in the world's metres.
// At least one image. Reads each once; holds beside the result about four times as much while it works.
// Throws core::DataError: an image that cannot be read, or lies too far from the origin (500 km).
terrain::GroundPicture makeGroundPicture(const std::vector<std::shared_ptr<const AerialImage>>& images,
                                         const GeoPlace& origin,
                                         const terrain::GroundPictureSettings& settings);

}  // namespace skydrop::elevation
