// How the low layer of a weather departs from what its genus usually looks like: what the seven parameters of
// the clouds (clouds::CloudLayerSettings) become where a weather makes the layers. A plain value; any thread.
#pragma once

namespace skydrop::weather {

struct Layer;
struct State;

struct LayerLook {
  // Times what the layer and its genus have, >= 0.
  double base = 1, thickness = 1, cover = 1;
  double scale = 1, extinction = 1, higherScale = 1, weatherScale = 1, erosion = 1;
  // Added to what they have: a genus may have none of it.
  double threshold = 0, typeShift = 0, anisotropy = 0, forwardShare = 0;

  bool operator==(const LayerLook&) const = default;
};

// The layer at its new heights and cover, with the rest kept for who draws and flies through it
// (Layer::look). A usable layer stays usable (requireUsable()); a look of ones and zeros leaves each bit. Ice
// is left alone: its looks are no medium of water.
Layer withLook(const Layer& layer, const LayerLook& look);

// The same of the state's first layer, which is the low one.
void lookLow(State& state, const LayerLook& look);

}  // namespace skydrop::weather
