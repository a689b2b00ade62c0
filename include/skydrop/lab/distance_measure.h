// How exact the laboratory's distances, normals, shadows and occlusion are. Deterministic; any thread.
#pragma once

#include "skydrop/lab/knobs.h"

namespace skydrop::lab {

// What is left between a place outside and the surface after a way of the distance along its gradient against
// it, in shares of that distance: 0 of an exact distance. Short: the surface is not reached. Beyond: it is
// passed, which must not be. Over random places in the air around a scene (shaders/shared/lab/scenes.glsl),
// in double; where the gradient has a kink is left out.
struct FootError {
  double meanShort = 0, mostShort = 0, mostBeyond = 0;
};
FootError footError(int scene, double amount);

// Of sphere tracing to 1e-3, over a small picture from the usual place.
double stepsPerRay(int scene, double amount);

// Largest angle between central differences and the torus's analytic gradient over its surface, rad; 2 where
// no direction is left.
struct NormalError {
  double inDouble = 0, inFloat = 0;
};
NormalError normalError(double epsilon);

// Of the shadow of ball and box on the floor, against rays in closed form. Shares of the floor's places.
struct ShadowError {
  double stepsPerRay = 0, meanLight = 0;
  double falseShade = 0;  // dark, although the ray is free
  double falseLight = 0;  // any light, although it is not
};
ShadowError shadowError(const ShadowKnobs& knobs, double hardness);

// Of the box with holes and its floor, against the share of a cosine-weighted hemisphere that is free over
// the same reach.
struct OcclusionError {
  double meanOpenness = 0, meanReference = 0, rmsDifference = 0;
};
OcclusionError occlusionError(const OcclusionKnobs& knobs);

}  // namespace skydrop::lab
