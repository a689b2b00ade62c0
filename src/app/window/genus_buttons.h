// The pictures of the weather's page, and the rows that each sets.
#pragma once

#include <vector>

#include "skydrop/ui/menu.h"

namespace skydrop::app {

// One for each genus, in the atlas's order: a layer of the first site's weather, low, middle or high, as it
// usually is (weather/usual_layer.h). What of clouds.layers.0 departs from its defaults stays and acts on it.
std::vector<ui::GenusButton> genusButtons();

}  // namespace skydrop::app
