// A land with a closed form for tests: hills of three sizes, 770 m high at most, with sea between them. It
// repeats every 7680 m, exactly: a place 61 440 m away (or a multiple) has the same bits.
#pragma once

#include <memory>

#include "skydrop/terrain/height_source.h"

namespace skydrop::test {

// Its bounds are conservative and close: the slope of a sum of sines is known.
std::shared_ptr<const terrain::HeightSource> makeHillsSource();

}  // namespace skydrop::test
