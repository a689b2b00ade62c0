#include "skydrop/weather/usual_layer.h"

#include <array>

namespace skydrop::weather {
namespace {

struct Usual {
  double baseM, topM, cover, density;
  std::size_t place;
};

// Order of Genus.
constexpr std::array<Usual, 10> kUsual{{{400, 900, 0.95, 1, 0},
                                        {1200, 2000, 0.75, 1, 0},
                                        {1300, 3000, 0.4, 1, 0},
                                        {3500, 5500, 0.9, 0.6, 1},
                                        {4000, 4700, 0.5, 0.6, 1},
                                        {8500, 10000, 0.35, 0.3, 2},
                                        {8500, 9500, 0.8, 0.2, 2},
                                        {9000, 9400, 0.4, 0.3, 2},
                                        {700, 5500, 1, 1, 0},
                                        {1000, 11000, 0.5, 1, 0}}};

const Usual& usualOf(Genus genus) { return kUsual[static_cast<std::size_t>(genus)]; }

}  // namespace

Layer usualLayer(Genus genus) {
  const Usual& usual = usualOf(genus);
  return {genus, usual.baseM, usual.topM, usual.cover, usual.density};
}

std::size_t usualPlace(Genus genus) { return usualOf(genus).place; }

}  // namespace skydrop::weather
