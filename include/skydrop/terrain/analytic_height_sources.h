// Lands with a closed form: for tests, and for scenes that need a plain ground. Heights in metres above the
// sea, slopes in metres a metre; all finite (not checked), and inside what chunks store
// (HeightSource::storedRange), or chunks cut them off there. Immutable: any thread.
#pragma once

#include <memory>

#include "skydrop/terrain/height_source.h"

namespace skydrop::terrain {

// The same height everywhere.
std::shared_ptr<const HeightSource> makeFlatSource(double height);

// height = heightAtOrigin + dot(gradient, xz), held to the range that its chunks store.
std::shared_ptr<const HeightSource> makeTiltedPlaneSource(double heightAtOrigin, glm::dvec2 gradient,
                                                          const HeightRange& stored = {});

// A ridge along z: height = crest - slope * |x - crestX|, not below `foot`. The gradient on the crest line is
// 0.
std::shared_ptr<const HeightSource> makeRidgeSource(double crestX, double crest, double slope, double foot);

// A step along z: `low` where x < edgeX, `high` elsewhere. The gradient is 0 everywhere.
std::shared_ptr<const HeightSource> makeStepSource(double edgeX, double low, double high);

}  // namespace skydrop::terrain
