// The mark of a target: a ring on the ground and a beam of light that stands on its middle. Positions are relative to
// the eye, in world axes, metres; `foot` is the target's place on the ground. Nothing here has a singular place: the
// eye may stand in the beam, straight above it or below its foot.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Across the ring, whose middle line is the target's radius: thin against 100 m, four pixels wide from 1 km.
CONST Real kRingWidth = Real(4.0);

// The beam ends here above its foot; from 6 km it is 0.1 rad tall.
CONST Real kBeamHeight = Real(600.0);
// Where the beam's light ends aside; it falls to half at 0.54 of this.
CONST Real kBeamRadius = Real(5.0);
// The least radius in pixels: the beam is then 2.4 pixels wide where its light falls to half.
CONST Real kBeamPixels = Real(2.2);
// Optical depth straight through the beam where it is densest; more makes it solid.
CONST Real kBeamDepth = Real(2.0);
// The beam never hides more than this of what is behind it, also where one looks along it.
CONST Real kBeamOpacity = Real(0.9);

// Share of a pixel that the ring covers: the pixel sees the ground from distanceM - footprintM / 2 to
// distanceM + footprintM / 2 away from the middle. So edges are smooth, and a ring thinner than a pixel fades.
FN Real ringCoverage(Real distanceM, Real radiusM, Real footprintM) {
  Real width = max(footprintM, Real(1e-3));
  // By each edge of the ring: the ends of what a small pixel sees are one number at a distance.
  Real fromMiddle = distanceM - radiusM;
  Real within = saturate(Real(0.5) + (Real(0.5) * kRingWidth - fromMiddle) / width);
  Real beyond = saturate(Real(0.5) - (Real(0.5) * kRingWidth + fromMiddle) / width);
  return saturate(within - beyond);
}

// The ring lies on land up to this many radii above or below the foot (slopes of 60 degrees), and fades over the last
// quarter of that.
CONST Real kRingReach = Real(2.0);
FN Real ringFade(Real heightM, Real radiusM) {
  return saturate(Real(4.0) * (Real(1.0) - abs(heightM) / max(kRingReach * radiusM, Real(1e-3))));
}

FN Real beamRadius(Real distanceM, Real pixelAngleRad) {
  return max(kBeamRadius, kBeamPixels * pixelAngleRad * distanceM);
}

// Density of the beam's light at a place relative to its foot: 1 where it is densest, on the axis a third up; 0 at
// the foot, at the top and from the radius on. A polynomial of degree 4 aside and 3 upwards.
FN Real beamDensity(Vec3 place, Real radiusM) {
  Real core = max(Real(1.0) - (place.x * place.x + place.z * place.z) / (radiusM * radiusM), Real(0.0));
  Real up = saturate(place.y / kBeamHeight);
  return core * core * (Real(6.75) * up * (Real(1.0) - up) * (Real(1.0) - up));
}

// Where a ray from the eye in a unit direction is inside the beam: distances (begin, end), begin >= 0. A miss has
// end <= begin.
FN Vec2 beamInterval(Vec3 direction, Vec3 foot, Real radiusM) {
  Vec2 miss = Vec2(Real(0.0), Real(0.0));
  Real begin = Real(0.0);
  Real end = kFarMarker;
  // Aside: |t d - f| < r. A ray that strays less than 1e-6 of its length is upright.
  Real square = direction.x * direction.x + direction.z * direction.z;
  if (square > Real(1e-12)) {
    Real along = direction.x * foot.x + direction.z * foot.z;
    Real aside = direction.x * foot.z - direction.z * foot.x;
    Real root = square * radiusM * radiusM - aside * aside;
    if (root <= Real(0.0)) return miss;
    root = sqrt(root);
    begin = max(begin, (along - root) / square);
    end = min(end, (along + root) / square);
  } else if (foot.x * foot.x + foot.z * foot.z >= radiusM * radiusM) {
    return miss;
  }
  // Upwards: from the foot to the top.
  Real top = foot.y + kBeamHeight;
  if (abs(direction.y) > Real(1e-9)) {
    Real atFoot = foot.y / direction.y;
    Real atTop = top / direction.y;
    begin = max(begin, min(atFoot, atTop));
    end = min(end, max(atFoot, atTop));
  } else if (foot.y >= Real(0.0) || top <= Real(0.0)) {
    return miss;
  }
  return Vec2(begin, end);
}

FN Real beamDensityAt(Vec3 direction, Vec3 foot, Real radiusM, Real distanceM) {
  return beamDensity(direction * distanceM - foot, radiusM);
}

// Optical depth of the beam from distance `begin` to `end` along a ray, within beamInterval. Four points after Gauss
// and Legendre are exact for the seventh degree, which is the density's. A wide beam is as deep as a narrow one.
FN Real beamOpticalDepth(Vec3 direction, Vec3 foot, Real radiusM, Real begin, Real end) {
  Real middle = Real(0.5) * (begin + end);
  Real reach = Real(0.5) * (end - begin);
  Real nearer = Real(0.339981043584856) * reach;
  Real farther = Real(0.861136311594053) * reach;
  Real sum = Real(0.652145154862546) * (beamDensityAt(direction, foot, radiusM, middle - nearer) +
                                        beamDensityAt(direction, foot, radiusM, middle + nearer)) +
             Real(0.347854845137454) * (beamDensityAt(direction, foot, radiusM, middle - farther) +
                                        beamDensityAt(direction, foot, radiusM, middle + farther));
  // Straight through the axis the density's integral is 16 / 15 of the radius.
  return max(kBeamDepth * Real(0.9375) * reach * sum / radiusM, Real(0.0));
}

FN Real beamOpacity(Real opticalDepth) { return kBeamOpacity * (Real(1.0) - exp(-opticalDepth)); }
