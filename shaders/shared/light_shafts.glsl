// Shafts of light: what a ray loses of the light that air scatters once, where clouds or land hide the sun from that air.
// The integral along the ray of (scattering * phase) * transmittance to the eye * illuminance * (visibility - 1); see
// docs/light-shafts.md. Lengths and heights in metres above the sea; the earth is flat, as the shades are.
// C++ uses it through include/skydrop/core/light_shafts.h.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/cloud_light.glsl"
#endif

// Heights, evenly from the sea to the top of the shade, that the sun's light on the air is known for.
CONST int kShaftHeights = 16;

// Share of the distance up to which shade counts, over which it fades to none.
CONST Real kShaftFade = Real(0.25);

// Clouds that let less through hide what is behind them: it is not marched.
CONST Real kShaftOpaque = Real(0.01);

// Where shade can be on a ray, as lengths (x <= y; equal: nowhere): below topM, above the sea for an eye above it, before
// what the ray meets (sceneM, up to kFarMarker), and within reachM of the eye, measured on the level. slope: rise a
// metre, [-1, 1].
FN Vec2 shaftSpan(Real eyeM, Real slope, Real topM, Real reachM, Real sceneM) {
  Real steep = max(abs(slope), Real(1e-9));
  Real toTop = (topM - eyeM) / steep;
  Real level = sqrt(max(Real(1.0) - slope * slope, Real(1e-12)));
  Real begin = slope < Real(0.0) ? max(-toTop, Real(0.0)) : Real(0.0);
  Real end = min(sceneM, reachM / level);
  if (slope >= Real(0.0)) end = min(end, toTop);
  if (slope < Real(0.0) && eyeM > Real(0.0)) end = min(end, eyeM / steep);
  return Vec2(begin, max(end, begin));
}

// Length at a share of a span, [0, 1]: the root of the length grows evenly, so steps are short near the eye, where a
// shadow's edge is seen under a wide angle, and even on a span that begins far away.
FN Real shaftPlace(Vec2 span, Real share) {
  Real atBegin = sqrt(span.x);
  Real root = atBegin + (sqrt(span.y) - atBegin) * share;
  return root * root;
}

// What counts of the shade at a level distance from the eye: all, and from 1 - kShaftFade of the reach on less and less.
FN Real shaftFade(Real levelM, Real reachM) {
  Real t = saturate((Real(1.0) - levelM / reachM) / kShaftFade);
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// Of the sun's light below a cloud of an optical depth: what comes straight through (x), and what the base scatters out
// of it (y), together as sunBelowCloud but for what a thin cloud bends aside.
FN Vec2 shaftLight(Real depth) {
  Real through = exp(-max(depth, Real(0.0)));
  return Vec2(through, max(sunBelowCloud(depth) - through, Real(0.0)));
}

// Phase functions of molecules and haze for light that is the same towards all azimuths, as the sky's tables hold what has
// no direction there: Rayleigh's mean over the azimuths between directions of two slopes, the haze's over all directions.
FN Vec2 shaftMeanPhases(Real slope, Real sunSine) {
  Real across = (Real(1.0) - slope * slope) * (Real(1.0) - sunSine * sunSine);
  Real square = slope * slope * sunSine * sunSine + Real(0.5) * across;
  return Vec2(Real(3.0) / (Real(16.0) * kPi) * (Real(1.0) + square), Real(1.0) / (Real(4.0) * kPi));
}

// What a metre of air at a place scatters less towards the eye than air in the sun, for an illuminance of 1 on a surface
// that faces the sun. phases: Rayleigh's and the haze's, 1/sr; light: shares of the sun's light that arrive straight, and
// out of the base of clouds, which shines on the air evenly from above: its radiance is its illuminance / pi from half of
// all directions. Below 0 where that adds more than the shade takes.
FN Vec3 shaftLoss(ShellAir here, Vec2 phases, Vec2 light, Real sunSine) {
  Vec3 once = here.rayleigh * phases.x + Vec3(here.haze, here.haze, here.haze) * phases.y;
  Vec3 all = here.rayleigh + Vec3(here.haze, here.haze, here.haze);
  return once * (Real(1.0) - light.x) - all * (light.y * max(sunSine, Real(0.0)) / (Real(2.0) * kPi));
}
