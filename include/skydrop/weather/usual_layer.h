// What a layer of each genus usually is like: heights of temperate latitudes (International Cloud Atlas, WMO
// 2017), whose etages overlap. Pure; any thread.
#pragma once

#include <cstddef>

#include "skydrop/weather/state.h"

namespace skydrop::weather {

Layer usualLayer(Genus genus);

// Which of the layers of a state it is by habit: 0 low, which the towering and the raining ones are too, 1
// middle, 2 high.
std::size_t usualPlace(Genus genus);

}  // namespace skydrop::weather
