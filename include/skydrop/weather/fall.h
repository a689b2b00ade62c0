// What falls out of a state's clouds, at any height: who feeds it, what of it evaporates, where it freezes.
// Pure functions of plain values; any thread. Rates are mm/h of water.
//
// A state gives the rates on the ground (State::precipitation). Above it there is more, because falling rain
// evaporates in the air below the base: the drier that is, the higher the base (125 m for each degree between
// temperature and dew point, Espy 1841), and the warmer. A millimetre an hour below a base at 1250 m loses
// about one each kilometre (the order that Rosenfeld and Mintz 1988 measured by radar).
#pragma once

#include <optional>

#include "skydrop/core/shared_precipitation.h"
#include "skydrop/weather/state.h"

namespace skydrop::weather {

using FallField = core::shared::f64::FallField;

// The layer that precipitation falls from: the first that there is (cover > 0) of cumulonimbus, nimbostratus,
// altostratus, cumulus, stratocumulus, stratus and altocumulus. Null: none, and nothing falls.
const Layer* feedingLayer(const State& state);

// Whether it falls everywhere below the layer; else where the weather map of its clouds has rain.
bool fallsEverywhere(const Layer& layer);

// nullopt: it is dry.
std::optional<FallField> fallField(const State& state);

// At a height above the sea below a place that gets a share [0, 1] of the full rate. Above 0 degrees rain is
// liquid, below it is snow; sleet and hail stay what they are, and snow that the state has on the ground is
// snow everywhere.
Precipitation fallAt(const State& state, double heightM, double share = 1);

// Of all kinds together.
double rateOf(const Precipitation& fall);

}  // namespace skydrop::weather
