// The reflection of sun or moon in a sea of waves whose slopes are Gaussian (Cox and Munk 1954): their path of glitter at
// every height of the light, down to its setting. Directions are unit vectors from the water, y up.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

CONST Real kIndexOfWater = Real(1.34);

// Share of unpolarised light that water reflects, by the cosine of the angle of incidence: Fresnel.
FN Real waterReflectance(Real cosine) {
  Real outside = saturate(cosine);
  Real inside = sqrt(Real(1.0) - (Real(1.0) - outside * outside) / (kIndexOfWater * kIndexOfWater));
  // s-polarised a / b, p-polarised c / d: one division for both.
  Real a = outside - kIndexOfWater * inside;
  Real b = outside + kIndexOfWater * inside;
  Real c = kIndexOfWater * outside - inside;
  Real d = kIndexOfWater * outside + inside;
  Real s = a * d;
  Real p = c * b;
  return Real(0.5) * (s * s + p * p) / (b * b * d * d);
}

// Smith's function of how much waves hide of each other, times the sine of the elevation: a sea whose waves have the
// standard deviation of slope `slope` along each axis shows 1 / (1 + lambda) of itself. (Walter and others 2007 for
// Gaussian slopes, within 0.35 % of 1 + lambda; times the sine because lambda itself has no bound on level rays.)
FN Real hiddenByWaves(Real sine, Real slope) {
  // Its variable is the cotangent of the zenith angle over sqrt(2) slopes, s / level.
  Real s = saturate(sine);
  Real level = squareRoot(Real(1.0) - s * s) * slope * Real(1.4142135623730951);
  Real hidden = (level * level - s * (Real(1.259) * level - Real(0.396) * s)) / (Real(3.535) * level + Real(2.181) * s);
  // The fit falls below 0 a little before where it ends.
  return s < Real(1.6) * level ? max(hidden, Real(0.0)) : Real(0.0);
}

// Sine of the mean elevation of what is above the horizon of a disc, by that of its middle and its radius (radians):
// 0 once the disc has set. Within 1.4 % of the radius.
FN Real risenSine(Real sine, Real radius) {
  Real t = clamp(sine / radius, Real(-1.0), Real(1.0));
  return max(max(sine, Real(0.0)), radius * (Real(0.4244) + t * (Real(0.4744) + t * (Real(0.0756) + Real(0.0256) * t))));
}

// The waves that are drawn, in three sizes: their slopes are lattice noise times these and the slope of all waves.
CONST Real kSwellShare = Real(0.8);
CONST Real kWaveShare = Real(1.4);
CONST Real kRippleShare = Real(1.6);
CONST Real kLatticeNoiseVariance = Real(0.0801);  // of each component, turned or not

// Standard deviation of the slope of all other waves over that of all, by how much of each size is drawn, [0, 1].
FN Real hiddenShare(Real swell, Real wave, Real ripple) {
  Real drawn = kSwellShare * kSwellShare * swell * swell + kWaveShare * kWaveShare * wave * wave +
               kRippleShare * kRippleShare * ripple * ripple;
  return sqrt(Real(1.0) - kLatticeNoiseVariance * drawn);
}

// Radiance towards the eye per illuminance across the light's rays. `shown`: x and z of the normal of the waves that
// are drawn at this place, over y; `hidden`: standard deviation of the slope of those that are not, `slope` of all. Waves
// hide each other from eye and light, and what is seen of them is scaled to fill the view (Smith 1967; Ross, Dion, Potvin
// 2005). It all goes by the level sea, so that the mean over the waves that are drawn is that of a sea of which none is.
// Where eye and light both are low, the path is narrower than the light's disc: that is a second spread, across it.
FN Real sunGlitter(Vec3 toEye, Vec3 toLight, Real radius, Vec2 shown, Real hidden, Real slope) {
  Real eye = max(toEye.y, Real(1e-4));
  Real light = risenSine(toLight.y, radius);
  Real perRise = Real(1.0) / (eye + light);
  // Slopes along the light's azimuth and across it: the one that sends the light here, and that of the drawn waves.
  Real level = Real(1.0) / sqrt(max(toLight.x * toLight.x + toLight.z * toLight.z, Real(1e-12)));
  Real c = toLight.x * level;
  Real d = toLight.z * level;
  Real x = (toEye.x + toLight.x) * perRise;
  Real z = (toEye.z + toLight.z) * perRise;
  Real steep = x * c + z * d;
  Real along = steep - (shown.x * c + shown.y * d);
  Real drawnAcross = shown.x * d - shown.y * c;
  Real across = x * d - z * c - drawnAcross;
  Real variance = hidden * hidden;
  Real disc = Real(0.5) * radius * perRise;
  Real spread = variance + disc * disc;
  Real perBoth = Real(1.0) / (variance * spread);
  Real density = exp(Real(-0.5) * perBoth * (along * along * spread + across * across * variance)) * sqrt(perBoth);
  // Of the faces that do it: 1 / cosine^2 of their tilt.
  Real aside = drawnAcross + across * (variance * variance * perBoth);
  Real tilt = steep * steep + aside * aside;
  Real stretch = Real(1.0) + min(tilt, Real(1.0));
  Real incidence = sqrt(saturate(Real(0.5) + Real(0.5) * dot(toEye, toLight)));
  // cosine of the view times (1 + lambda of the view + lambda of the light), over the sine of the light.
  Real seen = light * (eye + hiddenByWaves(eye, slope)) + eye * hiddenByWaves(light, slope);
  return density * stretch * stretch * waterReflectance(incidence) * light / (Real(8.0) * kPi * max(seen, Real(1e-9)));
}
