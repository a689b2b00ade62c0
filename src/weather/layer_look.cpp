#include "skydrop/weather/layer_look.h"

#include <algorithm>

#include "skydrop/weather/state.h"

namespace skydrop::weather {
namespace {

constexpr double kHighestM = 20000, kThinnestM = 10;  // of a usable layer; and what it keeps

bool isOfIce(Genus genus) {
  return genus == Genus::cirrus || genus == Genus::cirrostratus || genus == Genus::cirrocumulus;
}

}  // namespace

Layer withLook(const Layer& layer, const LayerLook& look) {
  if (isOfIce(layer.genus)) return layer;
  Layer out = layer;
  out.look = look;
  out.cover = std::min(layer.cover * look.cover, 1.0);
  // Written as differences, which vanish without a change.
  const double thickness = layer.topM - layer.baseM;
  const double rise = layer.baseM * (look.base - 1), growth = thickness * (look.thickness - 1);
  if (rise == 0 && growth == 0) return out;
  out.baseM = std::clamp(layer.baseM + rise, -500.0, kHighestM - kThinnestM);
  out.topM = std::clamp(layer.topM + rise + growth, out.baseM + kThinnestM, kHighestM);
  return out;
}

void lookLow(State& state, const LayerLook& look) { state.layers[0] = withLook(state.layers[0], look); }

}  // namespace skydrop::weather
