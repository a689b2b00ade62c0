#include "app/session/refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace skydrop::app {
namespace {

double pixelsOf(Size size, int pixelSize) {
  const auto along = [pixelSize](int pixels) { return (pixels + pixelSize - 1) / pixelSize; };
  return static_cast<double>(along(size.width)) * along(size.height);
}

}  // namespace

Refinement::Refinement(Size size, double partMs) : size_(size), partMs_(partMs) {
  if (size.width < 1 || size.height < 1) part_.pixelSize = 0;
}

void Refinement::beginRound(int pixelSize) {
  const double msPerPixel = std::max(roundMs_ / roundPixels_, 1e-9);
  int side = kLeastSide;
  while (side < kMostSide && msPerPixel * (2 * side) * (2 * side) <= partMs_) side *= 2;
  part_ = {{0, 0}, side, pixelSize};
  roundMs_ = roundPixels_ = 0;
}

void Refinement::drawn(double ms) {
  assert(!isDone());
  roundMs_ += ms;
  roundPixels_ += static_cast<double>(part_.side) * part_.side;
  const int width = part_.side * part_.pixelSize;
  part_.corner.x += width;
  if (part_.corner.x < size_.width) return;
  part_.corner = {0, part_.corner.y + width};
  if (part_.corner.y < size_.height) return;
  allPixels_ += pixelsOf(size_, part_.pixelSize);
  if (part_.pixelSize > 1) {
    beginRound(part_.pixelSize / 2);
  } else {
    part_.pixelSize = 0;
  }
}

double Refinement::share() const {
  double all = 0;
  for (int pixelSize = kCoarsest; pixelSize > 0; pixelSize /= 2) all += pixelsOf(size_, pixelSize);
  if (isDone()) return 1;
  const int width = part_.side * part_.pixelSize;
  const double rows = std::min(part_.corner.y, size_.height), ahead = std::min(part_.corner.x, size_.width);
  const double row = std::min(width, size_.height - part_.corner.y);
  const double ofRound = (rows * size_.width + row * ahead) / (part_.pixelSize * part_.pixelSize);
  return std::min(1.0, (allPixels_ + ofRound) / all);
}

}  // namespace skydrop::app
