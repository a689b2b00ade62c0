// What the samples of the laboratory's clouds cost and miss, in double, over rays of a small picture.
// Deterministic but for times; any thread.
#pragma once

#include "skydrop/lab/knobs.h"
#include "skydrop/lab/page.h"

namespace skydrop::lab {

inline constexpr int kCloudVolumeSide = 40;

// The cube's two noises in float, as pictures sample them.
Volume cloudVolume(const CloudKnobs& knobs);

// Of so many samples along each ray, against 512: mean over the rays that meet the cube, of the
// transmittance.
struct SampleError {
  double meanError = 0, largestError = 0, samplesPerRay = 0;
};
SampleError sampleError(const CloudKnobs& knobs, int steps);

// Of the sun's light with so many steps and light samples, against the finest: in units of the sun's light.
struct LightError {
  double meanError = 0, meanLight = 0, msPerThousandRays = 0;
};
LightError lightError(const CloudKnobs& knobs, int steps, int lightSamples);

// The mean errors with 1 to `most` light samples, the finest march computed once.
std::vector<double> lightErrors(const CloudKnobs& knobs, int steps, int most);

// Sunlight that is forwarded by distance on the screen, where the cloud is dense (transmittance below a
// hundredth), in shares of the sun: plain, and times the transmittance.
struct ForwardError {
  double plain = 0, mended = 0;
};
ForwardError forwardError(const CloudKnobs& knobs);

}  // namespace skydrop::lab
