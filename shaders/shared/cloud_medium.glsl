// The medium of a cloud layer: from what the noise textures hold at a place to a density in [0, 1].
// Sources: Schneider and Vos, "The Real-Time Volumetric Cloudscapes of Horizon Zero Dawn", 2015 (base shape, height
// gradients by type, erosion); coverage is used as a share of sky: clouds grow with it.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// How noise becomes density; ranges are described with clouds::CloudLayerSettings.
struct CloudMedium {
  Real threshold;  // least base density that is drawn, [0, 0.95]
  Real coverage;   // of the whole layer, [0, 1]: scales the weather map's
  Real typeShift;  // added to the weather map's type, [-1, 1]
  Real erosion;    // how much detail takes away at most, [0, 0.9]
};

// The shape texture's channels as one value in [0, 1]: Perlin-Worley, hollowed out by the Worley octaves.
FN Real cloudBase(Vec4 shape) {
  Real fbm = Real(0.625) * shape.y + Real(0.25) * shape.z + Real(0.125) * shape.w;
  return remapClamped(shape.x, fbm - Real(1.0), Real(1.0), Real(0.0), Real(1.0));
}

// The detail texture's channels as one value in [0, 1].
FN Real cloudDetail(Vec4 detail) { return Real(0.625) * detail.x + Real(0.25) * detail.y + Real(0.125) * detail.z; }

// Rises from `a` to `b`, stays 1, falls from `c` to `d`.
FN Real trapezium(Real x, Real a, Real b, Real c, Real d) {
  return remapClamped(x, a, b, Real(0.0), Real(1.0)) * remapClamped(x, c, d, Real(1.0), Real(0.0));
}

// The share of a type's density at a height fraction: 0 outside the open interval (0, 1), peak 1 for every type
// (0 stratus, 0.5 stratocumulus, 1 cumulus; between them a blend).
FN Real cloudProfile(Real heightFraction, Real type) {
  Real stratus = trapezium(heightFraction, Real(0.0), Real(0.1), Real(0.2), Real(0.3));
  Real stratocumulus = trapezium(heightFraction, Real(0.02), Real(0.2), Real(0.48), Real(0.625));
  Real cumulus = trapezium(heightFraction, Real(0.0), Real(0.1625), Real(0.88), Real(0.98));
  Real kind = saturate(type) * Real(2.0);
  return kind < Real(1.0) ? mix(stratus, stratocumulus, kind) : mix(stratocumulus, cumulus, kind - Real(1.0));
}

// What is left of a base density where a share `coverage` of the sky is to be covered.
FN Real coveredDensity(Real density, Real coverage) {
  return remapClamped(density, Real(1.0) - coverage, Real(1.0), Real(0.0), Real(1.0)) * coverage;
}

// What the weather map's coverage comes to in a medium.
FN Real localCoverage(CloudMedium medium, Real mapped) { return saturate(mapped * Real(2.0) * medium.coverage); }

// Density before erosion from a base density, a profile and a local coverage: never falls as any of the three grows, so
// bounds of them give a bound of it (clouds::Occupancy).
FN Real profiledDensity(CloudMedium medium, Real base, Real profile, Real coverage) {
  Real body = saturate((base - medium.threshold) / (Real(1.0) - medium.threshold));
  return coveredDensity(body * profile, coverage);
}

// Density before erosion: an upper bound of cloudDensity() whatever the detail, and all that a coarse sample needs.
// `base` is cloudBase(), `weather` the weather map's channels.
FN Real cloudShapeDensity(CloudMedium medium, Real heightFraction, Vec4 weather, Real base) {
  Real profile = cloudProfile(heightFraction, weather.z + medium.typeShift);
  return profiledDensity(medium, base, profile, localCoverage(medium, weather.x));
}

// The same without the bounds that make it a density: below 0 it tells how far a place is from cloud, and above 0 it is
// cloudShapeDensity() (to rounding). What the map says of coverage and type is given by itself.
FN Real cloudShapeEstimate(CloudMedium medium, Real heightFraction, Real mappedCoverage, Real mappedType, Real base) {
  Real body = min((base - medium.threshold) / (Real(1.0) - medium.threshold), Real(1.0));
  Real profile = cloudProfile(heightFraction, mappedType + medium.typeShift);
  return body * profile + localCoverage(medium, mappedCoverage) - Real(1.0);
}

// Detail erodes the edges: wisps near the base, billows above. `detail` is cloudDetail().
FN Real erodedDensity(CloudMedium medium, Real heightFraction, Real density, Real detail) {
  Real wear = mix(detail, Real(1.0) - detail, saturate(heightFraction * Real(10.0)));
  return remapClamped(density, medium.erosion * wear, Real(1.0), Real(0.0), Real(1.0));
}

FN Real cloudDensity(CloudMedium medium, Real heightFraction, Vec4 weather, Real base, Real detail) {
  return erodedDensity(medium, heightFraction, cloudShapeDensity(medium, heightFraction, weather, base), detail);
}
