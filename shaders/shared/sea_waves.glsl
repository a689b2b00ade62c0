// Waves of the sea near the eye, their breaking, and what is seen through them; shaders/shared/water.glsl and
// sun_glitter.glsl have the sea as statistics. Winds are 10 m above the sea, m/s; phases are in turns.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/sun_glitter.glsl"
#endif

// Mean square slope of all waves, both axes together (Cox and Munk 1954, clean sea).
FN Real seaSlopeVariance(Real windMps) { return Real(0.003) + Real(0.00512) * max(windMps, Real(0.0)); }

// Share of the sea that whitecaps cover (Monahan and O'Muircheartaigh 1980), at most a third.
FN Real whitecapShare(Real windMps) {
  return min(Real(3.84e-6) * pow(max(windMps, Real(1e-3)), Real(3.41)), Real(0.33));
}

// Length of the longest waves that a wind raises where it blows long enough, m (Pierson and Moskowitz 1964).
FN Real peakWaveM(Real windMps) {
  Real wind = max(windMps, Real(0.0));
  return Real(6.283185307179586) / (Real(0.731) * Real(9.80665)) * wind * wind;
}

CONST Real kShortestWaveM = Real(0.002);  // below it water is smooth

// Part of the slope's variance that waves of one octave of lengths around `lengthM` have: each octave from the shortest
// to the peak as much (a saturated spectrum, Phillips 1958), beyond it none (Pierson and Moskowitz' cut).
FN Real octaveVariance(Real lengthM, Real windMps) {
  Real peak = max(peakWaveM(windMps), Real(0.008));
  Real beyond = lengthM / peak;
  Real octaves = max(log(peak / kShortestWaveM) * Real(1.4426950408889634), Real(2.0));
  return seaSlopeVariance(windMps) / octaves * exp(Real(-0.74) * min(beyond * beyond, Real(80.0)));
}

// Turns a second of a wave on deep water.
FN Real waveTurnsPerSecond(Real lengthM) {
  return sqrt(Real(9.80665) / (Real(6.283185307179586) * max(lengthM, Real(1e-4))));
}

// A wave's profile at a phase and a quarter turn before: arcs of parabolas in place of sine and cosine (within .057; no
// polynomial of a library), amplitude 1, mean 0.
CONST Real kProfileVariance = Real(0.5333333333333333);
FN Vec2 waveProfile(Real turns) {
  Real sine = turns - floor(turns + Real(0.5));
  Real quarter = turns + Real(0.25);
  Real cosine = quarter - floor(quarter + Real(0.5));
  return Vec2(Real(16.0) * sine * (Real(0.5) - abs(sine)), Real(16.0) * cosine * (Real(0.5) - abs(cosine)));
}

// How much of a wave is shown that takes so many turns a pixel, squared: all below a sixth, none from a half on.
FN Real waveShown(Real turnsPerPixel2) { return saturate((Real(0.25) - turnsPerPixel2) * Real(4.5)); }

// What is left of a wave over shallow ground: it breaks and dies out where water is not deep beside its length.
FN Real waveLeftAt(Real depthM, Real lengthM) {
  Real deep = Real(8.0) * max(depthM, Real(0.0));
  return deep / (deep + lengthM);
}

// A sum of waves at a place.
struct SeaWaveSum {
  Vec2 slope;      // x and z of the normal over y
  Real variance;   // of the slope, both axes, of what is shown
  Real left;       // the same of what shallow ground leaves of it
  Real breaking;   // how near to breaking, in standard deviations of all waves that can break
  Real unbroken;   // share of that variance that is not shown
  Real curvature;  // how much the surface curves: minus the height's Laplacian, 1/m
};

FN SeaWaveSum noSeaWaves() {
  SeaWaveSum sum;
  sum.slope = Vec2(Real(0.0), Real(0.0));
  sum.variance = Real(0.0);
  sum.left = Real(0.0);
  sum.breaking = Real(0.0);
  sum.unbroken = Real(1.0);
  sum.curvature = Real(0.0);
  return sum;
}

// How a pixel lies on the sea: the unit vector away from the eye, how many metres the pixel covers across it, squared,
// and how much more along it.
struct SeaFootprint {
  Vec2 along;
  Real across2, more2;
};

// relative: of the place to the eye; sine of the ray's dip, > 0; radians of a pixel.
FN SeaFootprint seaFootprint(Vec2 relative, Real distanceM, Real dip, Real pixelAngle) {
  SeaFootprint at;
  at.along = relative / max(length(relative), Real(1e-6));
  Real across = distanceM * pixelAngle;
  Real along = across / max(dip, Real(1e-3));
  at.across2 = across * across;
  at.more2 = along * along - at.across2;
  return at;
}

// Adds a wave. way: turns a metre along x and z, phase at the eye, amplitude of the slope; shape: length (m), amplitude of
// breaking in the unit of SeaWaveSum, 2 pi over the length, 0.
FN SeaWaveSum withWave(SeaWaveSum sum, Vec4 way, Vec4 shape, Vec2 relative, SeaFootprint at, Real depthM) {
  Vec2 k = Vec2(way.x, way.y);
  Real q = dot(k, at.along);
  Real shown = waveShown(dot(k, k) * at.across2 + q * q * at.more2);
  Real kept = shown * waveLeftAt(depthM, shape.x);
  Vec2 profile = waveProfile(dot(k, relative) + way.z);
  Real slope = way.w * kept;
  sum.slope = sum.slope + k * (shape.x * slope * profile.x);
  sum.curvature = sum.curvature + shape.z * slope * profile.y;
  Real breaks = shape.y * shown;
  sum.breaking = sum.breaking + shape.y * kept * profile.y;
  sum.unbroken = sum.unbroken - kProfileVariance * breaks * breaks;
  Real variance = kProfileVariance * way.w * way.w;
  sum.variance = sum.variance + variance * shown * shown;
  sum.left = sum.left + variance * kept * kept;
  return sum;
}

// The distribution function of the normal distribution (Page 1977 as refined by Bowling and others 2009, within 1.5e-4).
FN Real normalShare(Real x) {
  Real t = clamp(x, Real(-6.0), Real(6.0));
  return Real(1.0) / (Real(1.0) + exp(-t * (Real(1.5976) + Real(0.07056) * t * t)));
}

// Where that is `share`, [1e-8, .5]: the root of the cubic (Cardano), exact for the form above.
FN Real normalQuantile(Real share) {
  Real y = log(clamp(share, Real(1e-8), Real(0.5)));
  y = y - log(Real(1.0) - exp(y));
  Real p = Real(1.5976) / Real(0.07056) / Real(3.0);
  Real q = -y / Real(0.07056) * Real(0.5);
  Real root = sqrt(q * q + p * p * p);
  Real a = pow(q + root, Real(0.3333333333333333));
  return p / a - a;
}

// Share of a pixel's water that whitecaps cover, whose mean over the waves is that of the sea, whatever part of the waves is
// shown. `threshold`: normalQuantile() of the mean share, in standard deviations; `grain`: of foam's own pattern, standard
// deviation kFoamGrain where it is shown.
CONST Real kFoamGrain = Real(0.6);
FN Real whitecaps(Real breaking, Real unbroken, Real grain, Real grainShown, Real threshold) {
  Real grain2 = kFoamGrain * kFoamGrain;
  Real blur = max(unbroken, Real(0.0)) + grain2 * (Real(1.0) - grainShown * grainShown) + Real(0.06);
  Real all = sqrt(Real(1.06) + grain2);
  return normalShare((breaking + grain * grainShown + threshold * all) / sqrt(blur));
}

// Foam on a beach: bores run up it, one each `kSurfSeconds`, the slower the shallower (sqrt(g depth)); in turns, for a
// beach that falls by kBeachSlope.
CONST Real kSurfSeconds = Real(5.0);
CONST Real kBeachSlope = Real(0.09);
CONST Real kSurfDepthM = Real(1.1);  // from here on waves break
FN Real surfPhase(Real depthM, Real clock) {
  return Real(2.0) / (kSurfSeconds * kBeachSlope) * sqrt(max(depthM, Real(0.0)) / Real(9.80665)) + clock;
}
// How fast it turns with depth, turns a metre.
FN Real surfPhasePerMetre(Real depthM) {
  return Real(1.0) / (kSurfSeconds * kBeachSlope * sqrt(max(depthM, Real(0.02)) * Real(9.80665)));
}

// Share of foam that a bore leaves: a front, and behind it lace that dissolves. `shown`: how much of single bores pixels
// show; their mean remains.
CONST Real kSurfMean = Real(0.3333333333333333);
FN Real surfFoam(Real phase, Real depthM, Real shown) {
  Real behind = phase - floor(phase);
  Real front = saturate((behind - Real(0.9)) * Real(10.0));
  Real tail = Real(1.0) - behind / Real(0.9);
  Real foam = max(front * front, tail > Real(0.0) ? tail * tail : Real(0.0));
  Real deep = saturate(Real(1.0) - depthM / kSurfDepthM);
  return (kSurfMean + (foam - kSurfMean) * shown) * sqrt(deep) * saturate(Real(0.35) + deep);
}

// How high the last of a bore runs, m above the level of the sea's edge that dries: the water's film lies below it.
CONST Real kRunUpM = Real(0.12);
FN Real runUpDepth(Real clock) {
  Vec2 swing = waveProfile(clock);
  return kRunUpM * (Real(0.5) + Real(0.5) * swing.x);
}

// Absorption of pure water, 1/m, at 620, 550 and 465 nm (Pope and Fry 1997).
FN Vec3 pureWaterAbsorption() { return Vec3(Real(0.2755), Real(0.0565), Real(0.0101)); }

// Extinction with so much of the matter of a coast in it: 1 is seaExtinction() of water.glsl, 0 pure water.
FN Vec3 waterExtinction(Real turbidity) {
  return pureWaterAbsorption() + Vec3(Real(0.1445), Real(0.0535), Real(0.0799)) * max(turbidity, Real(0.0));
}

// Way of light through water per metre of depth, by the sine of its elevation in air: Snell.
FN Real waterSlant(Real sine) {
  Real inside = (Real(1.0) - sine * sine) / (kIndexOfWater * kIndexOfWater);
  return Real(1.0) / sqrt(max(Real(1.0) - inside, Real(0.1)));
}

// The direction of a ray in water that came down on a surface with the unit normal `normal`: Snell. Unit vectors.
FN Vec3 intoWater(Vec3 ray, Vec3 normal) {
  Real eta = Real(1.0) / kIndexOfWater;
  Real cosine = clamp(-dot(ray, normal), Real(0.0), Real(1.0));
  Real inside = sqrt(Real(1.0) - eta * eta * (Real(1.0) - cosine * cosine));
  return ray * eta + normal * (eta * cosine - inside);
}

// Light that waves gather on the ground below them, over that without waves; mean 1 where the curvature is Gaussian.
// curvature: of the surface, 1/m; variance: of it. A thin lens: focal length n / ((n - 1) curvature).
FN Real caustic(Real curvature, Real variance, Real depthM, Real strength) {
  Real lens = strength * min(max(depthM, Real(0.0)), Real(3.0)) * ((kIndexOfWater - Real(1.0)) / kIndexOfWater);
  Real gathered = clamp(lens * curvature, Real(-3.0), Real(1.2));
  return min(exp(gathered - Real(0.5) * min(lens * lens * variance, Real(2.0))), Real(3.0));
}
