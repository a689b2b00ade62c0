// What the genus of a cloud layer adds to its medium (shared/cloud_medium.glsl): a profile of its own instead of that of
// the weather map's type, and for towers an anvil: from a height on, cover spreads and the least density falls. The plain
// form (own 0, an anvil above the top) gives the medium as it is, bit for bit.
// Source of heights and shapes: WMO, International Cloud Atlas, 2017, sections 2.3.1 to 2.3.10.
#ifndef __cplusplus
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#endif

// Ranges are described with clouds::CloudForm.
struct CloudForm {
  Vec4 profile;         // density rises from height fraction x by y a unit, and has fallen at z, by w a unit
  Real own;             // share of that profile, [0, 1]; the rest is the type's
  Real anvilBase;       // height fraction from which the anvil is whole; 2 and more: there is none
  Real spread;          // cover in the anvil, times that below
  Real anvilThreshold;  // added to the least density there
  Real taper;           // share of its cover that a tower would have lost at the top
  Real contrast;        // how much steeper cover rises with the map about kTowerCover; 0: as it is
};

// Local coverage about which contrast draws towers apart from the air between them.
CONST Real kTowerCover = Real(0.35);

// How much more contrast an anvil has than the tower below.
CONST Real kAnvilContrast = Real(2.0);

// The anvil is whole an eighth of the height above where it begins.
CONST Real kAnvilSlope = Real(8.0);

FN Real ownProfile(CloudForm form, Real heightFraction) {
  return saturate((heightFraction - form.profile.x) * form.profile.y) *
         saturate((form.profile.z - heightFraction) * form.profile.w);
}

// How much a height is of the anvil's.
FN Real anvilShare(CloudForm form, Real heightFraction) {
  return saturate((heightFraction - form.anvilBase) * kAnvilSlope + Real(1.0));
}

// Coverage of the map as a form takes it at a height: in the anvil that of the nearest tower, less the way from there
// (clouds::anvilReach()), so an anvil hangs together with its tower.
FN Real formedMap(CloudForm form, Real heightFraction, Real mapped, Real reached) {
  return mix(mapped, reached, anvilShare(form, heightFraction));
}

FN Real formedProfile(CloudForm form, Real heightFraction, Real type) {
  return mix(cloudProfile(heightFraction, type), ownProfile(form, heightFraction), form.own);
}

// Times that the cover of a column has at a height.
FN Real formedCover(CloudForm form, Real heightFraction) {
  Real anvil = anvilShare(form, heightFraction);
  Real tower = Real(1.0) - form.taper * saturate(heightFraction);
  return tower + (form.spread - tower) * anvil;
}

FN CloudMedium formedMedium(CloudMedium medium, CloudForm form, Real heightFraction) {
  CloudMedium there = medium;
  there.coverage = medium.coverage * formedCover(form, heightFraction);
  there.threshold = medium.threshold + form.anvilThreshold * anvilShare(form, heightFraction);
  return there;
}

// As localCoverage(). anvil: anvilShare(); the reach of an anvil falls slowly with the way, and its edge is drawn the
// sharper, or noise would leave shreds of it.
FN Real formedLocalCoverage(CloudMedium there, CloudForm form, Real mapped, Real anvil) {
  Real coverage = mapped * Real(2.0) * there.coverage;
  Real contrast = form.contrast * (Real(1.0) + kAnvilContrast * anvil);
  return saturate(coverage + contrast * (coverage - kTowerCover));
}

// As cloudShapeDensity().
FN Real formedShapeDensity(CloudMedium medium, CloudForm form, Real heightFraction, Real mappedCoverage, Real mappedType,
                           Real base) {
  CloudMedium there = formedMedium(medium, form, heightFraction);
  Real profile = formedProfile(form, heightFraction, mappedType + medium.typeShift);
  return profiledDensity(there, base, profile, formedLocalCoverage(there, form, mappedCoverage, anvilShare(form, heightFraction)));
}

// As cloudShapeEstimate().
FN Real formedShapeEstimate(CloudMedium medium, CloudForm form, Real heightFraction, Real mappedCoverage, Real mappedType,
                            Real base) {
  CloudMedium there = formedMedium(medium, form, heightFraction);
  Real body = min((base - there.threshold) / (Real(1.0) - there.threshold), Real(1.0));
  Real profile = formedProfile(form, heightFraction, mappedType + medium.typeShift);
  return body * profile + formedLocalCoverage(there, form, mappedCoverage, anvilShare(form, heightFraction)) - Real(1.0);
}

// What is left of the sun's light below layers of an optical depth along its ray, direct and scattered: below scattered
// clouds as sunBelowCloud() has it, below an overcast sky that of an even layer of droplets (asymmetry 0.85, nothing
// absorbed) over dark ground by Eddington's approximation (Shettle and Weinman 1970). overcast: [0, 1].
FN Real sunBelowLayers(Real depth, Real sunSine, Real overcast) {
  Real x = max(depth, Real(0.0));
  Real sine = saturate(sunSine);
  Real twoThirds = Real(2.0) / Real(3.0);
  Real even = (twoThirds + sine + (twoThirds - sine) * exp(-x)) / (Real(2.0) * twoThirds + Real(0.15) * x * sine);
  return mix(sunBelowCloud(x), even, overcast);
}

// How much a layer counts for the light of sky and ground at a height fraction, where several overlap: most in its
// middle, hardly outside. Continuous, so layers overlap without a seam.
FN Real layerWeight(Real heightFraction) {
  return max(heightFraction * (Real(1.0) - heightFraction), Real(1e-5) / (Real(1.0) + abs(heightFraction)));
}
