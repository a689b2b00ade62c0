// Three ways to find where a ray meets a scene, each as one step that is repeated until it ends, so that a picture, a cut
// with the places of a single ray and a table of errors come from the same text.
// Sources: Thomann, "Procedural Cloud Shader", BFH 2020, sections 3.2 to 3.4; Hart, "Sphere Tracing", 1996.
#ifndef __cplusplus
#include "shared/lab/scenes.glsl"
#endif

CONST int kConstantStep = 0;
CONST int kHalving = 1;
CONST int kSphereTracing = 2;

CONST int kUnderWay = 0;
CONST int kHit = 1;
CONST int kMissed = 2;

// What a march must keep to.
struct MarchLimits {
  Real stride;     // length of a step, the first one where it is halved
  Real tolerance;  // sphere tracing: nearer is a hit; halving: a shorter step is one
  Real reach;      // no hit is looked for beyond
};

FN MarchLimits make_marchLimits(Real stride, Real tolerance, Real reach) {
  MarchLimits limits;
  limits.stride = stride;
  limits.tolerance = tolerance;
  limits.reach = reach;
  return limits;
}

struct March {
  Real t;         // where the ray is
  Real stride;    // the length of the next step
  Real distance;  // to the scene, where it was asked last
  int steps;      // how often the scene was asked
  int state;
};

FN March make_march(Real stride) {
  March march;
  march.t = Real(0.0);
  march.stride = stride;
  march.distance = Real(0.0);
  march.steps = 0;
  march.state = kUnderWay;
  return march;
}

// One question to the scene, and the step that follows from it. A step that leads nowhere (a stride of 0) ends as a miss.
FN March nextStep(int method, MarchLimits limits, Real distance, March march) {
  march.steps = march.steps + 1;
  march.distance = distance;
  if (method == kConstantStep) {
    if (distance <= Real(0.0)) march.state = kHit;
    else march.t += march.stride;
  } else if (method == kHalving) {
    // Inside: half the step, backwards, until it is short enough; outside: forwards.
    Real way = march.stride;
    if (distance <= Real(0.0)) {
      march.stride = march.stride * Real(0.5);
      way = -march.stride;
      if (march.stride < limits.tolerance || march.t <= Real(0.0)) march.state = kHit;
    }
    if (march.state == kUnderWay) march.t += way;
  } else {
    if (distance < limits.tolerance) march.state = kHit;
    else march.t += distance;
  }
  if (march.state == kUnderWay && (march.t > limits.reach || !(march.stride > Real(0.0)))) march.state = kMissed;
  return march;
}

// Until a hit, a miss, or `most` questions; then the state is still kUnderWay, which counts as a miss.
FN March marchAlong(int method, int scene, Real amount, Vec3 origin, Vec3 direction, MarchLimits limits, int most) {
  March march = make_march(limits.stride);
  for (int i = 0; i < most; ++i) {
    march = nextStep(method, limits, sceneDistance(scene, amount, origin + direction * march.t), march);
    if (march.state != kUnderWay) return march;
  }
  return march;
}
