// What the laboratory's noise is worth: random numbers between processors, noise without its fade or its
// neighbours, histograms and spectra. Deterministic but for times; any thread.
#pragma once

#include <cstdint>
#include <functional>

#include "skydrop/lab/knobs.h"
#include "skydrop/lab/page.h"

namespace skydrop::lab {

// Over 4096 whole numbers from `from` on.
struct RandomError {
  double sineApart =
      0;  // share of them whose sine-made number in float is another than in double, by over 0.01
  double sineDistinct = 0;  // share of distinct values in float
  double hashApart = 0;     // of bits that differ between float and double of the integer hash: none
  double hashDistinct = 0;
};
RandomError randomError(double from);

// Of a noise over [0, 1)^2 by fine steps across the lines of its grid.
struct Smoothness {
  double largestJump = 0;       // of the value
  double largestSlopeJump = 0;  // of its slope, per period
  double mean = 0, deviation = 0;
};
using NoisePlane = std::function<double(double x, double y)>;
Smoothness smoothnessOf(const NoisePlane& noise, int cells);

// Of 40000 places: where the own cell alone gives another distance than all nine, and by how much in the
// mean.
struct OwnCellError {
  double wrongShare = 0, meanError = 0;
};
OwnCellError ownCellError(const VoronoiKnobs& knobs);

// The largest difference between tiled noise at a place and one period further, for places of either sign, in
// float.
double tileError(const VoronoiKnobs& knobs, bool mended);

// Of values in [low, high]: how many are in each of kPlotPlaces parts, the most as 1.
Curve histogramOf(const NoisePlane& noise, double low, double high);
// Power over frequency 1 .. 64 a period, both by ratios: six decades from the strongest down.
Curve spectrumOf(const NoisePlane& noise);

// Time of a million samples on one thread, ms.
double megasampleMs(const NoisePlane& noise);

}  // namespace skydrop::lab
