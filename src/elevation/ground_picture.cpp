// Aerial images as one picture along the world's axes.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/common.hpp>
#include <limits>

#include "elevation/chart.h"
#include "elevation/mosaic.h"
#include "skydrop/core/error.h"
#include "skydrop/elevation/aerial_image.h"

namespace skydrop::elevation {
namespace {

using core::DataError;
using terrain::GroundPicture;

// Sides are multiples of this, so that levels halve evenly.
constexpr int kGrainTexels = 64;

// Colours are averaged as light: sRGB to linear values of 16 bits, and back.
struct SrgbTables {
  static constexpr int kSteps = 4096;
  std::array<float, 256> linear{};
  std::array<std::uint8_t, kSteps + 1> encoded{};

  SrgbTables() {
    for (int i = 0; i < 256; ++i) {
      const double s = i / 255.0;
      linear[static_cast<std::size_t>(i)] =
          static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    for (int i = 0; i <= kSteps; ++i) {
      // By the square root, which is near to the encoding: dark values have as many steps as light ones.
      const double root = i / double{kSteps}, light = root * root;
      const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
      encoded[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * s));
    }
  }
  std::uint8_t encode(float light) const {
    const float root = std::sqrt(std::clamp(light, 0.0F, 1.0F));
    return encoded[static_cast<std::size_t>(root * kSteps + 0.5F)];
  }
};
const SrgbTables& srgb() {
  static const SrgbTables tables;
  return tables;
}

// A sum of colours, each by its weight.
struct Light {
  std::array<float, 3> sum{};
  float weight = 0, all = 0;  // of what shows something; of everything

  void add(const std::uint8_t* rgba, float weightOfIt) {
    all += weightOfIt;
    const float shown = weightOfIt * static_cast<float>(rgba[3]) / 255.0F;
    if (shown <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) sum[i] += shown * srgb().linear[rgba[i]];
    weight += shown;
  }
  void put(std::uint8_t* rgba) const {
    if (weight <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) rgba[i] = srgb().encode(sum[i] / weight);
  }
};

// An image with so many pixels across and down made one; the last ones may be of fewer.
struct Averaged {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  const std::uint8_t* at(int column, int row) const {
    return rgba.data() + 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column));
  }
};

Averaged averaged(const AerialImage& image, glm::ivec2 times) {
  Averaged out;
  out.width = (image.width() + times.x - 1) / times.x;
  out.height = (image.height() + times.y - 1) / times.y;
  const auto width = static_cast<std::size_t>(out.width);
  out.rgba.assign(4 * width * static_cast<std::size_t>(out.height), 0);
  std::deque<std::vector<Light>> open;  // rows that are not complete, from `first` on
  int first = 0;
  const auto close = [&](int past) {
    for (; first < past && !open.empty(); ++first) {
      std::uint8_t* to = out.rgba.data() + 4 * width * static_cast<std::size_t>(first);
      for (const Light& light : open.front()) {
        light.put(to);
        to[3] = static_cast<std::uint8_t>(std::lround(light.all > 0 ? 255 * light.weight / light.all : 0));
        to += 4;
      }
      open.pop_front();
    }
  };
  image.scan([&](const AerialImage::Part& part) {
    close(part.row / times.y);
    for (int r = 0; r < part.rows; ++r) {
      const int row = (part.row + r) / times.y;
      while (row - first >= static_cast<int>(open.size())) open.emplace_back(width);
      std::vector<Light>& lights = open[static_cast<std::size_t>(row - first)];
      const std::uint8_t* pixel =
          part.rgba + 4 * static_cast<std::size_t>(r) * static_cast<std::size_t>(part.columns);
      for (int c = 0; c < part.columns; ++c, pixel += 4)
        lights[static_cast<std::size_t>((part.column + c) / times.x)].add(pixel, 1);
    }
  });
  close(out.height);
  return out;
}

// Where an image lies in the world.
struct Placed {
  WorldRect rect;
  glm::dvec2 cellM;
  double middle;           // its east coordinate there
  bool isByAPole = false;  // in degrees, where each texel has to be asked for
};

Placed placedOf(const LocalPlane& plane, const AerialImage& image) {
  const Georeference& of = image.georeference();
  const Projection projection(of.crs, image.name());
  constexpr double kMost = std::numeric_limits<double>::max();
  Placed placed{{{kMost, kMost}, {-kMost, -kMost}}, of.cell, centreOf(of, 0.5 * image.width(), 0).x};
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = 0; k <= kSteps; ++k) {
      const auto place = projection.inverse(
          centreOf(of, image.width() * i / double{kSteps} - 0.5, image.height() * k / double{kSteps} - 0.5));
      if (!place) continue;
      constexpr double kNodesDegrees = 0.2;  // that the nodes of a chart reach further
      placed.isByAPole =
          placed.isByAPole ||
          (projection.isGeographic() && std::abs(place->latitude) > Chart::kSmoothLatitude - kNodesDegrees);
      const glm::dvec2 at = plane.positionOf(*place);
      placed.rect.lo = glm::min(placed.rect.lo, at);
      placed.rect.hi = glm::max(placed.rect.hi, at);
    }
  }
  if (projection.isGeographic()) {
    constexpr double kMetresPerDegree = 111320, kRadians = 0.017453292519943295;
    const double latitude = std::clamp(centreOf(of, 0, 0.5 * image.height()).y, -89.5, 89.5);
    placed.cellM = {of.cell.x * kMetresPerDegree * std::cos(latitude * kRadians),
                    of.cell.y * kMetresPerDegree};
  }
  // Between the places asked for its sides are curves.
  const double bulge =
      0.005 * std::max(placed.rect.hi.x - placed.rect.lo.x, placed.rect.hi.y - placed.rect.lo.y);
  placed.rect.lo = glm::max(placed.rect.lo - bulge, glm::dvec2(-kFarthestM));
  placed.rect.hi = glm::min(placed.rect.hi + bulge, glm::dvec2(kFarthestM));
  if (!(placed.rect.lo.x < placed.rect.hi.x && placed.rect.lo.y < placed.rect.hi.y))
    throw DataError(image.name(), "georeference", "lies more than 500 km from the place that one flies over");
  return placed;
}

// The texels that nobody has yet.
void lay(const LocalPlane& plane, const AerialImage& image, const Placed& placed, double texelM,
         glm::dvec2 corner, GroundPicture::Level& level) {
  const glm::ivec2 times{std::clamp(static_cast<int>(texelM / placed.cellM.x + 0.01), 1, image.width()),
                         std::clamp(static_cast<int>(texelM / placed.cellM.y + 0.01), 1, image.height())};
  const Averaged from = averaged(image, times);
  const Chart chart(plane, image.georeference(), placed.middle, placed.rect, image.name());
  const auto texelOf = [&](double metres, double origin, int most) {
    return std::clamp(static_cast<int>((metres - origin) / texelM), 0, most);
  };
  const int left = texelOf(placed.rect.lo.x, corner.x, level.width),
            right = texelOf(placed.rect.hi.x, corner.x, level.width - 1) + 1;
  const int top = texelOf(placed.rect.lo.y, corner.y, level.height),
            bottom = texelOf(placed.rect.hi.y, corner.y, level.height - 1) + 1;
  for (int z = top; z < bottom; ++z) {
    Chart::Row row(chart, corner.y + (z + 0.5) * texelM);
    std::uint8_t* to =
        level.rgba.data() + 4 * (static_cast<std::size_t>(z) * static_cast<std::size_t>(level.width) +
                                 static_cast<std::size_t>(left));
    for (int x = left; x < right; ++x, to += 4) {
      if (to[3] != 0) continue;
      const Chart::Spot spot = row.at(corner.x + (x + 0.5) * texelM);
      if (!spot.isValid || !(spot.at.x >= -0.5 && spot.at.y >= -0.5 && spot.at.x <= image.width() - 0.5 &&
                             spot.at.y <= image.height() - 0.5))
        continue;
      const double column = (spot.at.x + 0.5) / times.x - 0.5, line = (spot.at.y + 0.5) / times.y - 0.5;
      const double c0 = std::floor(column), r0 = std::floor(line);
      const auto inX = static_cast<float>(column - c0), inY = static_cast<float>(line - r0);
      Light light;
      for (int dy = 0; dy < 2; ++dy) {
        for (int dx = 0; dx < 2; ++dx)
          light.add(from.at(std::clamp(static_cast<int>(c0) + dx, 0, from.width - 1),
                            std::clamp(static_cast<int>(r0) + dy, 0, from.height - 1)),
                    (dx ? inX : 1 - inX) * (dy ? inY : 1 - inY));
      }
      if (light.weight < 0.5F * light.all) continue;
      light.put(to);
      to[3] = 255;
    }
  }
}

// Alpha becomes the share, by how far the nearest texel is that shows nothing: in steps of 1 and sqrt(2),
// which makes at most 8 % more of it.
void comeIn(GroundPicture::Level& level, double edgeTexels) {
  const int width = level.width, height = level.height;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<float> away(level.rgba.size() / 4);
  constexpr float kSlant = 1.41421356F;
  const auto nearest = [&](int x, int y, int dy, int dx) {
    const auto of = [&](int cx, int cy) {
      return cx < 0 || cy < 0 || cx >= width || cy >= height ? 0.0F : away[index(cx, cy)];
    };
    return std::min(
        {of(x + dx, y) + 1, of(x, y + dy) + 1, of(x - 1, y + dy) + kSlant, of(x + 1, y + dy) + kSlant});
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      away[index(x, y)] = level.rgba[4 * index(x, y) + 3] == 0 ? 0 : nearest(x, y, -1, -1);
  }
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) {
      float& at = away[index(x, y)];
      at = std::min(at, nearest(x, y, 1, 1));
      const double t = std::clamp(at / std::max(edgeTexels, 1.0), 0.0, 1.0);
      level.rgba[4 * index(x, y) + 3] = static_cast<std::uint8_t>(std::lround(255 * t * t * (3 - 2 * t)));
    }
  }
}

// Coarser levels: colours of what shows something, shares of everything; and finer ones get the colours where
// they show nothing, so that what is between two texels is not darker than both.
void addLevels(GroundPicture& picture) {
  while (picture.levels.back().width % 2 == 0 && picture.levels.back().height % 2 == 0) {
    const GroundPicture::Level& fine = picture.levels.back();
    GroundPicture::Level coarse{fine.width / 2, fine.height / 2, {}};
    coarse.rgba.assign(fine.rgba.size() / 4, 0);
    const std::size_t line = 4 * static_cast<std::size_t>(fine.width);
    for (int y = 0; y < coarse.height; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        const std::uint8_t* from =
            fine.rgba.data() + 2 * static_cast<std::size_t>(y) * line + 8 * static_cast<std::size_t>(x);
        std::uint8_t* to =
            coarse.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(coarse.width) +
                                      static_cast<std::size_t>(x));
        Light light;
        int share = 2;
        for (const std::uint8_t* one : {from, from + 4, from + line, from + line + 4}) {
          light.add(one, 1);
          share += one[3];
        }
        light.put(to);
        to[3] = static_cast<std::uint8_t>(share / 4);
        if (to[3] == 0 && light.weight > 0) to[3] = 1;
      }
    }
    picture.levels.push_back(std::move(coarse));
  }
  for (std::size_t i = picture.levels.size() - 1; i-- > 0;) {
    GroundPicture::Level& fine = picture.levels[i];
    const GroundPicture::Level& coarse = picture.levels[i + 1];
    for (int y = 0; y < fine.height; ++y) {
      for (int x = 0; x < fine.width; ++x) {
        std::uint8_t* to =
            fine.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.width) +
                                    static_cast<std::size_t>(x));
        if (to[3] != 0) continue;
        const std::uint8_t* from = coarse.rgba.data() + 4 * (static_cast<std::size_t>(y / 2) *
                                                                 static_cast<std::size_t>(coarse.width) +
                                                             static_cast<std::size_t>(x / 2));
        std::copy_n(from, 3, to);
      }
    }
  }
}

}  // namespace

GroundPicture makeGroundPicture(const std::vector<std::shared_ptr<const AerialImage>>& images,
                                const GeoPlace& origin, const terrain::GroundPictureSettings& settings) {
  const LocalPlane plane(origin);
  std::vector<Placed> placed;
  WorldRect all{glm::dvec2(1e9), glm::dvec2(-1e9)};
  double finest = 1e9;
  for (const auto& image : images) {
    placed.push_back(placedOf(plane, *image));
    all.lo = glm::min(all.lo, placed.back().rect.lo);
    all.hi = glm::max(all.hi, placed.back().rect.hi);
    finest = std::min({finest, placed.back().cellM.x, placed.back().cellM.y});
  }
  // A whole number of the finest image's pixels, as few as the budget allows.
  const glm::dvec2 size = all.hi - all.lo;
  // By a pole a texel takes a hundred times as long.
  constexpr double kBudgetByAPole = 1 << 17;
  const bool isByAPole =
      std::any_of(placed.begin(), placed.end(), [](const Placed& p) { return p.isByAPole; });
  double budget = settings.megatexels * 1048576;
  if (isByAPole) budget = std::min(budget, kBudgetByAPole);
  double least = std::max({finest, std::sqrt(size.x * size.y / budget),
                           std::max(size.x, size.y) / (terrain::kMostGroundTexels - 2 * kGrainTexels)});
  GroundPicture picture;
  picture.texelM = finest * std::ceil(least / finest - 1e-6);
  picture.corner = all.lo - picture.texelM;
  const auto sideOf = [&](double metres) {
    const int texels = static_cast<int>(std::ceil(metres / picture.texelM)) + 2;
    return (texels + kGrainTexels - 1) / kGrainTexels * kGrainTexels;
  };
  GroundPicture::Level& level = picture.levels.emplace_back();
  level.width = sideOf(size.x);
  level.height = sideOf(size.y);
  level.rgba.assign(4 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height), 0);
  for (std::size_t i = 0; i < images.size(); ++i)
    lay(plane, *images[i], placed[i], picture.texelM, picture.corner, level);
  comeIn(level, settings.edgeM / picture.texelM);
  addLevels(picture);
  return picture;
}

}  // namespace skydrop::elevation
