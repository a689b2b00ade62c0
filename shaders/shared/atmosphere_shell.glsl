// The air as a spherical shell around the earth: geometry, densities, and how tables of its light are laid out (after
// Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", 2020; the table of transmittance
// is laid out as Bruneton and Neyret 2008). C++ makes the tables (include/skydrop/sky/air_tables.h, sky_view.h);
// shaders read those of the sky (shaders/sky/atmosphere.glsl).
//
// Heights in metres above the sea, lengths in metres; `cosine` is that of a direction's zenith angle.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/atmosphere.glsl"
#endif

CONST Real kEarthRadius = Real(6.371e6);
CONST Real kShellTop = Real(100000.0);  // above it there is no air

// The ozone layer: a tent about its middle (Bruneton 2017).
CONST Real kOzoneMiddle = Real(25000.0);
CONST Real kOzoneHalfWidth = Real(15000.0);

// Heights and lengths beyond count as this, from where the earth is a point: their squares would be no floats.
CONST Real kFarthestShell = Real(1e12);

// Share of the middle's density, [0, 1].
FN Real ozoneDensity(Real heightM) {
  return max(Real(1.0) - abs(heightM - kOzoneMiddle) / kOzoneHalfWidth, Real(0.0));
}

// What the air does to light at a height, 1/m.
struct ShellAir {
  Vec3 rayleigh;    // scattered by molecules
  Real haze;        // scattered by aerosol
  Vec3 extinction;  // scattered or absorbed by anything
};

FN ShellAir shellAirAt(Atmosphere air, Real heightM) {
  Real hazeHere = air.haze * densityAt(heightM, air.hazeHeight);
  ShellAir here;
  here.rayleigh = air.rayleigh * densityAt(heightM, air.rayleighHeight);
  here.haze = hazeHere * air.hazeAlbedo;
  here.extinction = here.rayleigh + Vec3(hazeHere, hazeHere, hazeHere) + air.ozone * ozoneDensity(heightM);
  return here;
}

// The height that a ray reaches after a length. Factored, so that a planet's radius cancels nowhere: 0.01 m in float
// where radius - kEarthRadius is off by half a metre.
FN Real shellHeightAlong(Real heightM, Real cosine, Real lengthM) {
  Real h = min(heightM, kFarthestShell);
  Real l = min(lengthM, kFarthestShell);
  Real r = kEarthRadius + h;
  Real d = l * (l + Real(2.0) * r * cosine);
  return h + d / (r + squareRoot(r * r + d));
}

// The cosine there.
FN Real shellCosineAlong(Real heightM, Real cosine, Real lengthM) {
  Real h = min(heightM, kFarthestShell);
  Real l = min(lengthM, kFarthestShell);
  Real there = max(kEarthRadius + shellHeightAlong(h, cosine, l), Real(1.0));  // a ray through the middle: no 0
  return clamp(((kEarthRadius + h) * cosine + l) / there, Real(-1.0), Real(1.0));
}

// Where a ray from a height meets the sphere of another height: lengths of entry and exit, x > y where it misses. With
// c = (h - H) (2 R + h + H) instead of a difference of squares, and the root that does not cancel.
FN Vec2 shellCrossing(Real heightM, Real cosine, Real sphereM) {
  Real b = (kEarthRadius + heightM) * cosine;
  Real c = (heightM - sphereM) * (Real(2.0) * kEarthRadius + heightM + sphereM);
  Real square = b * b - c;
  if (square < Real(0.0)) return Vec2(Real(1.0), Real(-1.0));
  Real q = b > Real(0.0) ? -b - sqrt(square) : -b + sqrt(square);
  Real other = q == Real(0.0) ? Real(0.0) : c / q;
  return q < other ? Vec2(q, other) : Vec2(other, q);
}

// Sine of the elevation at which a level sea ends, seen from a height: 0 at the sea, negative above. (Below: 0.)
FN Real horizonSine(Real heightM) {
  Real h = clamp(heightM, Real(0.0), kFarthestShell);
  return -sqrt(h * (Real(2.0) * kEarthRadius + h)) / (kEarthRadius + h);
}

// Sine of the elevation above which a ray from a height meets no air; 1 within the air.
FN Real airEndsSine(Real heightM) {
  if (heightM <= kShellTop) return Real(1.0);
  Real h = min(heightM, kFarthestShell);
  return -sqrt((h - kShellTop) * (Real(2.0) * kEarthRadius + h + kShellTop)) / (kEarthRadius + h);
}

// Share of the sun's disc above the horizon of a height, [0, 1].
FN Real sunVisibleShareAt(Real heightM, Real cosine) {
  Real dip = horizonSine(heightM);
  // The angle between both, exact where it matters: within some degrees of the horizon.
  // The dip's cosine is R / (R + h); 1 - dip^2 is nothing from 1e11 m on.
  Real h = clamp(heightM, Real(0.0), kFarthestShell);
  return sunVisibleShare((cosine - dip) * ((kEarthRadius + h) / kEarthRadius));
}

// The table of transmittance to the end of the air, of rays that miss the ground: x along kTransmittanceSines, y along
// kTransmittanceHeights, both in [0, 1] from the first texel's middle to the last one's.
CONST int kTransmittanceSines = 256;
CONST int kTransmittanceHeights = 64;

FN Vec2 transmittanceTableAt(Real heightM, Real cosine) {
  Real h = clamp(heightM, Real(0.0), kShellTop);
  Real most = sqrt(kShellTop * (Real(2.0) * kEarthRadius + kShellTop));
  Real toHorizon = sqrt(h * (Real(2.0) * kEarthRadius + h));
  Real shortest = kShellTop - h;
  Real longest = toHorizon + most;
  Real length = shellCrossing(h, max(cosine, horizonSine(h)), kShellTop).y;
  return Vec2(saturate((length - shortest) / (longest - shortest)), toHorizon / most);
}

// Height (x) and cosine (y) of a place of the table.
FN Vec2 transmittanceTablePlace(Vec2 at) {
  Real most = sqrt(kShellTop * (Real(2.0) * kEarthRadius + kShellTop));
  Real toHorizon = at.y * most;
  Real h = toHorizon * toHorizon / (kEarthRadius + sqrt(kEarthRadius * kEarthRadius + toHorizon * toHorizon));
  // (R + top)^2 - (R + h)^2, and from that the way straight up: neither is a difference of numbers that are alike.
  Real c = most * most * (Real(1.0) - at.y) * (Real(1.0) + at.y);
  Real shortest = c / (Real(2.0) * kEarthRadius + kShellTop + h);
  Real length = shortest + at.x * (toHorizon + most - shortest);
  // From the triangle of both radii and the length.
  Real cosine = length > Real(0.0) ? (c - length * length) / (Real(2.0) * (kEarthRadius + h) * length) : Real(1.0);
  return Vec2(h, clamp(cosine, Real(-1.0), Real(1.0)));
}

// The tables of a sky seen from one height under one light. Columns go by the cosine of the azimuth between view and
// light, in which the light in the air is smooth: from -1 to 1, so that there is no seam. Rows go by the root of the
// sine above and below the horizon, which lies between two rows: nothing is interpolated across it.
CONST int kSkyColumns = 16;
CONST int kSkyRowsAbove = 64;
CONST int kSkyRowsBelow = 16;
CONST int kSkyRows = kSkyRowsBelow + kSkyRowsAbove;

// Row as a number: k + 0 is the middle of row k. horizon, airEnds: sines, -1 <= horizon <= airEnds <= 1.
FN Real skyTableRow(Real sine, Real horizon, Real airEnds) {
  bool isAbove = sine >= horizon;
  // From so far away that both are one float, or -1: all is the last row of its side.
  Real reach = max(isAbove ? airEnds - horizon : horizon + Real(1.0), Real(1e-30));
  Real share = sqrt(saturate(abs(sine - horizon) / reach));
  return isAbove ? Real(kSkyRowsBelow) + share * Real(kSkyRowsAbove - 1) : Real(kSkyRowsBelow - 1) * (Real(1.0) - share);
}

// The sine that a row is made for; between rows of one side of the horizon too.
FN Real skyTableSine(Real row, Real horizon, Real airEnds) {
  if (row >= Real(kSkyRowsBelow)) {
    Real above = (row - Real(kSkyRowsBelow)) / Real(kSkyRowsAbove - 1);
    return horizon + (airEnds - horizon) * above * above;
  }
  Real below = Real(1.0) - row / Real(kSkyRowsBelow - 1);
  return horizon - (horizon + Real(1.0)) * below * below;
}

// Distances up to which the air's mean radiance along a ray is known: slices by d / (d + kSkySliceLength), from the place of
// the eye to the end of the ray.
CONST int kSkySlices = 5;
CONST Real kSkySliceLength = Real(16000.0);

// As skyTableRow.
FN Real skyTableSlice(Real distanceM) {
  return distanceM / (distanceM + kSkySliceLength) * Real(kSkySlices - 1);
}

// The distance that a slice before the last is made for.
FN Real skyTableDistance(int slice) {
  Real share = Real(slice) / Real(kSkySlices - 1);
  return kSkySliceLength * share / (Real(1.0) - share);
}

// As skyTableRow.
FN Real skyTableColumn(Real cosAzimuth) {
  return (cosAzimuth * Real(0.5) + Real(0.5)) * Real(kSkyColumns - 1);
}

// The table of the air on the GPU has the haze's phase function in it, which is steep towards the light: columns by the
// sine of half the azimuth from there, and below the horizon a row between any two.
CONST int kAirColumns = 64;
CONST int kAirRows = 2 * kSkyRowsBelow - 1 + kSkyRowsAbove;

// As skyTableRow: from towards the light, 0, to away from it.
FN Real airTableColumn(Real cosAzimuth) {
  return sqrt(saturate(Real(0.5) - Real(0.5) * cosAzimuth)) * Real(kAirColumns - 1);
}

// The cosine of the azimuth that a column is made for.
FN Real airTableCosAzimuth(int column) {
  Real share = Real(column) / Real(kAirColumns - 1);
  return Real(1.0) - Real(2.0) * share * share;
}

// Of a row of skyTableRow.
FN Real airTableRow(Real skyRow) { return skyRow + min(skyRow, Real(kSkyRowsBelow - 1)); }

// The row of skyTableRow that a row is made for.
FN Real airTableSkyRow(int row) {
  return row < 2 * kSkyRowsBelow - 1 ? Real(0.5) * Real(row) : Real(row - (kSkyRowsBelow - 1));
}
