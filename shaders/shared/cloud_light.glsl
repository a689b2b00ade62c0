// How light goes through a cloud layer: spans of rays, the integral over a step, scattering. Lengths in metres, extinction in 1/m.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/atmosphere.glsl"
#include "shared/cloud_medium.glsl"
#endif

// An interval of a ray, in lengths along its direction; empty where end <= begin.
struct RaySpan {
  Real begin;
  Real end;
};

FN RaySpan make_raySpan(Real begin, Real end) {
  RaySpan span;
  span.begin = begin;
  span.end = end;
  return span;
}

// The interval ahead of the start (t >= 0) where one coordinate lies in [low, high]. A ray that runs along the planes is
// inside for all its length or not at all; on a plane counts as inside. low > high: empty.
FN RaySpan raySpanBetween(Real at, Real direction, Real low, Real high) {
  if (low > high) return make_raySpan(Real(0.0), Real(0.0));
  if (abs(direction) < Real(1e-12)) {
    return make_raySpan(Real(0.0), at >= low && at <= high ? Real(1e30) : Real(0.0));
  }
  Real toLow = (low - at) / direction;
  Real toHigh = (high - at) / direction;
  Real first = toLow < toHigh ? toLow : toHigh;
  Real last = toLow < toHigh ? toHigh : toLow;
  return make_raySpan(max(first, Real(0.0)), max(last, Real(0.0)));
}

FN RaySpan overlap(RaySpan a, RaySpan b) {
  return make_raySpan(a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end);
}

FN RaySpan raySpanOfBox(Vec3 origin, Vec3 direction, Vec3 low, Vec3 high) {
  RaySpan span = raySpanBetween(origin.x, direction.x, low.x, high.x);
  span = overlap(span, raySpanBetween(origin.y, direction.y, low.y, high.y));
  return overlap(span, raySpanBetween(origin.z, direction.z, low.z, high.z));
}

// The earth's mean radius, m.
CONST Real kEarthRadiusM = Real(6371000.0);

// A layer of clouds is a shell around the earth; its field is flat. Seen from the eye the shell falls away by d^2 / 2R at
// a level distance d, so in the field a straight ray rises by as much: by rayBend() t^2 at a length t along it. (Exact to
// .6 m at 60 km and 12 km up: the next term is d^2 h / 2R^2.)
FN Real rayBend(Vec3 direction) {
  return (direction.x * direction.x + direction.z * direction.z) / (Real(2.0) * kEarthRadiusM);
}

// The place on a ray, relative to the eye, in the field.
FN Vec3 placeOnBentRay(Vec3 direction, Real bend, Real t) {
  return Vec3(direction.x * t, (direction.y + bend * t) * t, direction.z * t);
}

// Where a bent ray that starts `above` a level (negative: below it) runs under it: above + directionY t + bend t^2 < 0, for
// t of any sign; begin > end where it never does. bend >= 0. Neither root is a difference of numbers that are alike.
FN RaySpan bentRayUnder(Real above, Real directionY, Real bend) {
  Real square = directionY * directionY - Real(4.0) * bend * above;
  if (!(square > Real(0.0))) {
    // Only a ray that keeps its height can be under the level and not cross it. (One that bends and starts less than
    // 1e-30 m below has a product that is 0.)
    Real far = above < Real(0.0) && !(bend > Real(0.0)) ? Real(1e30) : Real(-1e30);
    return make_raySpan(-far, far);
  }
  Real root = sqrt(square);
  Real q = Real(-0.5) * (directionY < Real(0.0) ? directionY - root : directionY + root);
  Real away = q / max(bend, Real(1e-30));
  Real near = above / q;
  return make_raySpan(min(away, near), max(away, near));
}

// The part between the start and a length that holds all that a bent ray has of a layer, from what it has under the top and
// under the base. A ray that dips through the layer and rises again leaves the base twice: the air between counts too.
FN RaySpan bentRayInLayer(RaySpan underTop, RaySpan underBase, Real lengthM) {
  Real begin = max(underTop.begin, Real(0.0));
  Real end = min(underTop.end, lengthM);
  bool isUnderAtBegin = underBase.begin <= begin && underBase.end > begin;
  bool isUnderAtEnd = underBase.begin < end && underBase.end >= end;
  if (isUnderAtBegin) begin = underBase.end;
  if (isUnderAtEnd) end = underBase.begin;
  return make_raySpan(begin, end);
}

// What a step of this optical depth takes from the light behind it, in [0, 1]: 1 - exp(-depth) without cancellation
// (relative error below 5e-6 for depths of 1e-9 and more; 1 for infinite depth; 0 for a depth that is not positive).
FN Real stepOpacity(Real depth) {
  // Asked for what is positive: a compiler may read "not greater" as "less or equal", which NaN is not.
  if (depth > Real(0.0)) return depth < Real(0.5) ? depth * oneMinusExpOverX(depth) : Real(1.0) - exp(-depth);
  return Real(0.0);
}

// Scattering many times, as a sum of octaves of single scattering: each has less light, meets less extinction and
// scatters more evenly (Wrenninge, "Art-directable multiple volumetric scattering", 2015).
CONST Real kOctaveLight = Real(0.55);
CONST Real kOctaveDepth = Real(0.35);
CONST Real kOctaveAnisotropy = Real(0.6);

// g of the forward lobe: the silver edge of a cloud against the sun.
CONST Real kForwardAnisotropy = Real(0.85);

// Phase function times light of the four octaves, for the cosine between view ray and sun ray; the same all along a
// ray. forwardShare of the light, [0, 1], goes into the forward lobe, the rest into one of mean cosine g.
FN Vec4 cloudPhases(Real cosAngle, Real g, Real forwardShare) {
  Real share = saturate(forwardShare);
  Vec4 phases = Vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  Real light = Real(1.0);
  Real narrow = Real(1.0);
  for (int octave = 0; octave < 4; ++octave) {
    Real wide = henyeyGreenstein(cosAngle, g * narrow);
    phases[octave] = light * mix(wide, henyeyGreenstein(cosAngle, kForwardAnisotropy * narrow), share);
    light *= kOctaveLight;
    narrow *= kOctaveAnisotropy;
  }
  return phases;
}

// Light that reaches a place through an optical depth towards the sun and turns into the view ray there, per
// illuminance of the sun: 1/sr.
FN Real scatteredSun(Vec4 phases, Real sunDepth) {
  Real depth = max(sunDepth, Real(0.0));
  return phases.x * exp(-depth) + phases.y * exp(-kOctaveDepth * depth) +
         phases.z * exp(-kOctaveDepth * kOctaveDepth * depth) +
         phases.w * exp(-kOctaveDepth * kOctaveDepth * kOctaveDepth * depth);
}

// Light of sky and ground at a height fraction, scattered evenly, per illuminance of a level surface that faces them
// (half of all directions each): less of the sky deeper in the layer, less of the ground higher up.
FN Real scatteredSky(Real heightFraction) {
  return (Real(0.25) + Real(0.75) * saturate(heightFraction)) / (Real(2.0) * kPi);
}

FN Real scatteredGround(Real heightFraction) { return (Real(1.0) - saturate(heightFraction)) / (Real(2.0) * kPi); }

// The same where a light volume (clouds::LightVolume) has the mean radiance that the sun's light comes to after it was
// scattered: light scattered once is exact; the volume's is what is scattered again, of which coarse cells know too little
// near the lit side of dense cloud; and what the forward lobe has scattered twice or more is still narrow. Constants: least
// squares against traced paths (docs/cloud-light.md).
CONST Real kVolumeLight = Real(1.157);
CONST Real kVolumeNearSun = Real(1.635);
CONST Real kVolumeNearDepth = Real(0.35);
CONST Real kVolumeForward = Real(2.2);
CONST Real kVolumeForwardAnisotropy = Real(0.65);
CONST Real kVolumeDenseM = Real(60.0);
CONST Real kVolumeRowM = Real(112.5);

// What is the same all along a ray: the phase function; that of light scattered onwards more than once, times its share;
// what the volume's light counts, which is solved with (1 - g) of the extinction; what light near the lit side is, 1/sr.
FN Vec4 volumePhases(Real cosAngle, Real g, Real forwardShare) {
  Real share = saturate(forwardShare);
  Real once = mix(henyeyGreenstein(cosAngle, g), henyeyGreenstein(cosAngle, kForwardAnisotropy), share);
  Real onwards = kVolumeForward * share * share * henyeyGreenstein(cosAngle, kVolumeForwardAnisotropy);
  Real many = kVolumeLight / (Real(1.0) - mix(g, kForwardAnisotropy, share));
  return Vec4(once, onwards, many, kVolumeNearSun * (Real(1.0) - share) / (Real(4.0) * kPi));
}

// phases: volumePhases(). rowM: height of the volume's rows; what thin ones do not resolve is less.
FN Real scatteredSunOfVolume(Vec4 phases, Real sunDepth, Real meanLight, Real extinction, Real rowM) {
  Real depth = max(sunDepth, Real(0.0));
  Real dense = Real(1.0) - exp(-kVolumeDenseM * sqrt(rowM / kVolumeRowM) * extinction);
  Real direct = exp(-depth);
  Real near = exp(-kVolumeNearDepth * depth);
  return phases.x * direct + phases.y * (near - direct) + phases.z * meanLight + phases.w * dense * near;
}

// Of even light of the sky and the ground a place in cloud has as much as outside: what is not the sky's is the ground's.
// meanSky: 1/sr; of half precision, which may round it above all there is.
FN Real groundOfVolume(Real meanSky) { return max(Real(0.0), Real(1.0) / kPi - meanSky); }

// What is left of the sun's light below a cloud of an optical depth: some of it straight through; some scattered out of
// the base, which thins as a two-stream layer of droplets (asymmetry 0.85) does.
FN Real sunBelowCloud(Real depth) {
  Real x = max(depth, Real(0.0));
  return Real(0.65) * exp(-x) + Real(0.35) / (Real(1.0) + Real(0.11) * x);
}

// Of it, what comes straight through (Beer and Lambert); the rest is scattered and comes from all of the sky.
FN Real sunStraightThroughCloud(Real depth) { return exp(-max(depth, Real(0.0))); }

// The way towards the sun is cut into n parts that grow with the distance: part i, 0 .. n - 1, begins here and ends
// where the next begins.
FN Real sunPartBegin(Real i, Real n, Real wayM) {
  Real share = i / n;
  return wayM * share * share;
}

// The least sine of the sun's elevation that light in clouds is worked out for (2 degrees): below, the way through a
// layer of the flat earth would grow without bound.
CONST Real kLeastSunSine = Real(0.035);

// What is left of a cloud's density at a distance from the eye: all up to 0.6 of the distance where clouds have faded.
FN Real cloudFade(Real distanceM, Real fadeDistanceM) {
  Real t = saturate((fadeDistanceM - distanceM) / (Real(0.4) * fadeDistanceM));
  return t * t * (Real(3.0) - Real(2.0) * t);
}
