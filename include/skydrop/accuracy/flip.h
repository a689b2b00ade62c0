// FLIP: how different two pictures look when one flips between them. Source: Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020
// (LDR-FLIP, with the paper's constants). Pure functions; any thread.
#pragma once

#include <span>
#include <vector>

#include "skydrop/core/image.h"

namespace skydrop::accuracy {

// Of the paper: a monitor 0.7 m wide with 3840 pixels, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.0206432765823;

// A picture as it is seen: sRGB-encoded red, green and blue of each pixel in [0, 1], row by row from the top.
// width * height * 3 values that outlive it.
struct SeenPicture {
  int width = 0, height = 0;  // at least 1
  std::span<const double> values;
};

// The error of every pixel, [0, 1], row by row from the top. The pictures have the same size (asserted).
std::vector<double> flipMap(const SeenPicture& picture, const SeenPicture& reference,
                            double pixelsPerDegree = kPixelsPerDegree);

// Mean of the map: 0 for equal pictures.
double flip(const SeenPicture& picture, const SeenPicture& reference,
            double pixelsPerDegree = kPixelsPerDegree);

// A map of errors as a picture, from black (0) over purple and orange to pale yellow (1).
core::Image heatMap(const std::vector<double>& errors, int width, int height);

}  // namespace skydrop::accuracy
