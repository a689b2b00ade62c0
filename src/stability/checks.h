// The live checks by what they are of. Each function is one row of live_check.cpp.
#pragma once

namespace skydrop::stability {

// Light (light_checks.cpp)
double phaseIntegralError();  // of Henyey-Greenstein and its mean cosine, g from -0.9 to 1
double rayleighIntegralError();
double phaseEndsErrorInFloat();  // relative, straight ahead and back, g to 0.95
double icePhaseIntegralError();
double stepOpacityError();  // relative to expm1 in double, depths from 1e-9 to 1e4
double stepOpacityErrorInFloat();
double depthRoundTripError();       // relative, 1 m to 1e7 m through a float depth
double bentRayHeightError();        // m over the sphere, to 60 km
double bentRayFloatError();         // m from doubles
double levelFogPathErrorInFloat();  // relative, down to rises that are no normal floats

// Land (land_checks.cpp)
double wrongChunkIndices();      // of 1e6 positions to 1e15 m
double fullestBucketOfHashes();  // of 441 neighbouring chunks in 1024

// Motion (motion_checks.cpp)
double freeBodyEnergyError();  // relative, after 10 s at 120 Hz
double freeBodyMomentumError();
double constantRotationError();  // of a unit quaternion, 1 to 20 rad a step
double exponentialStepError();   // of the terms' size, 1 ms to 1000 s, drags from 0 to 100 1/s
double manySmallStepsError();    // m, 7200 steps against one
double stepLengthError();        // s, after 1e7 s
double lostSteps();              // of 3 million frames

// Air and sky (air_checks.cpp)
double windTurnJump();           // degrees, from 350 to 10 degrees in thousandths
double gustCovarianceError();    // of one step, ways of 1e-12 to 2e3 scale lengths
double standardPressureError();  // relative to the standard's table
double standardTemperatureError();
double yearsEndMotion();  // degrees that sun and moon move in two seconds

}  // namespace skydrop::stability
