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

double areaOf(int side) { return static_cast<double>(side) * side; }

}  // namespace

Refinement::Refinement(Size size, double partMs) : size_(size), partMs_(partMs) {
  if (size.width < 1 || size.height < 1) part_.pixelSize = 0;
  part_.corner = glm::ivec2(size.width, size.height) / 2;
}

void Refinement::probe(double ms) {
  if (probes_ == 1) smallMs_ = ms;
  if (++probes_ < kProbes) {
    part_.side = probes_ + 1 == kProbes ? kMostSideOfFirstRound : kLeastSide;
    return;
  }
  const double small = areaOf(kLeastSide);
  msPerPixel_ = std::max(0.0, (ms - smallMs_) / (areaOf(kMostSideOfFirstRound) - small));
  anywayMs_ = std::max(0.0, smallMs_ - small * msPerPixel_);
  beginRound(kCoarsest);
}

void Refinement::beginRound(int pixelSize) {
  if (roundPixels_ > 0) msPerPixel_ = std::max(0.0, roundMs_ - anywayMs_ * roundParts_) / roundPixels_;
  const double forPixels = std::max(partMs_ - anywayMs_, anywayMs_);
  const int most = pixelSize == kCoarsest ? kMostSideOfFirstRound : kMostSide;
  int side = kLeastSide;
  while (side < most && msPerPixel_ * areaOf(2 * side) <= forPixels) side *= 2;
  part_ = {{0, 0}, side, pixelSize};
  roundMs_ = roundPixels_ = roundParts_ = 0;
}

void Refinement::drawn(double ms) {
  assert(!isDone());
  if (probes_ < kProbes) return probe(ms);
  roundMs_ += ms;
  roundPixels_ += areaOf(part_.side);
  ++roundParts_;
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
  if (probes_ < kProbes) return 0;
  const int width = part_.side * part_.pixelSize;
  const double rows = std::min(part_.corner.y, size_.height), ahead = std::min(part_.corner.x, size_.width);
  const double row = std::min(width, size_.height - part_.corner.y);
  const double ofRound = (rows * size_.width + row * ahead) / (part_.pixelSize * part_.pixelSize);
  return std::min(1.0, (allPixels_ + ofRound) / all);
}

}  // namespace skydrop::app
