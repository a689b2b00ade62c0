// What the studies of assets/studies measure: docs/accuracy-studies.md lists each with its parameters.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "app/types/size.h"
#include "skydrop/accuracy/subject.h"

namespace skydrop::app {

// A subject that is made when it is first asked for.
class Subjects {
 public:
  // Of the pictures.
  explicit Subjects(Size size) : size_(size) {}

  // Null: there is none of this name.
  accuracy::Subject* find(std::string_view name);
  accuracy::SubjectSource source() {
    return [this](std::string_view name) { return find(name); };
  }

 private:
  Size size_;
  std::map<std::string, std::unique_ptr<accuracy::Subject>, std::less<>> made_;
};

// A picture of a scene: any setting of the program. Timed: frame, or a pass.
std::unique_ptr<accuracy::Subject> makePictureSubject(Size size);
// A rigid body that moves: body, integrator, rateHz, seconds. Positions, attitudes, energies.
std::unique_ptr<accuracy::Subject> makeMotionSubject();
// Where a package lands: solver, stepSeconds. Positions.
std::unique_ptr<accuracy::Subject> makeLandingSubject();
// Heights and normals of the land: what, finestWavelength, storage, normals, spacingM. Values, directions.
std::unique_ptr<accuracy::Subject> makeLandSubject();
// Land as it is streamed: what, cacheMiB, uploadMiBPerFrame. Values.
std::unique_ptr<accuracy::Subject> makeStreamingSubject();
// Noise far from the origin: arithmetic, distanceM. Values.
std::unique_ptr<accuracy::Subject> makeFarNoiseSubject();
// Depth buffers: format, distanceM. Values in metres.
std::unique_ptr<accuracy::Subject> makeDepthSubject();
// Targets that light is drawn into: format. Values.
std::unique_ptr<accuracy::Subject> makeTargetSubject();
// Noise from a texture: side, texels. Values.
std::unique_ptr<accuracy::Subject> makeNoiseTextureSubject();
// The sky's light: method, steps, quantity. Values.
std::unique_ptr<accuracy::Subject> makeSkySubject();
// The march through a smooth cloud in double: method, steps, sunSamples. Values.
std::unique_ptr<accuracy::Subject> makeMarchSubject();
// What clouds leave of the sun on what flies below and in them: samples, sunElevationDegrees. Values.
std::unique_ptr<accuracy::Subject> makeCloudShadeSubject();
// Light scattered in clouds, by model, against traced paths: model, source, scene, view. Values.
std::unique_ptr<accuracy::Subject> makeCloudLightSubject();
// What mountains leave of the sun on the land: method, detail, rayStepM, sunElevationDegrees,
// sunAzimuthDegrees. Values.
std::unique_ptr<accuracy::Subject> makeLandShadeSubject();
// The glitter of the sun on water: method, rows, sunElevationDegrees. Values.
std::unique_ptr<accuracy::Subject> makeGlitterSubject();

}  // namespace skydrop::app
