// What one sees of a grass strip: mown in lanes, worn where wheels touch down, marked in white.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/land_material.glsl"
#endif

CONST Real kStripRaggedM = Real(6.0);  // by which the edge of the woods around wanders
CONST Real kStripReachM = Real(41.0);  // beyond what is mown, within which the land looks other than without

// The share of white marks at a place `local` (along and to the right of the middle, m): a row of bars at each
// threshold, and boards of 4 x 1 m beside the mown ground every 50 m, at its corners at right angles too.
FN Real stripMarks(Vec2 local, Vec2 half_, Real footprint) {
  Real along = abs(local.x), right = abs(local.y);
  // Bars, one to 5 m of width, that begin 6 m inside.
  Real lane = right / Real(5.0);
  Real bars = stripCover(along - (half_.x - Real(12.0)), Real(6.0), footprint) *
              mix(Real(0.3), stripCover((lane - floor(lane) - Real(0.5)) * Real(5.0), Real(0.75), footprint),
                  saturate(Real(2.0) - footprint / Real(2.5))) *
              stripCover(right, half_.y - Real(2.0), footprint);
  Real board = along / Real(50.0);
  Real nearest = (board - floor(board + Real(0.5))) * Real(50.0);
  Real edge = stripCover(right - half_.y, Real(0.5), footprint) * stripCover(nearest, Real(2.0), footprint) *
              stripCover(along, half_.x, footprint);
  Real corner = stripCover(along - half_.x, Real(0.5), footprint) *
                stripCover(right - (half_.y - Real(2.0)), Real(2.0), footprint);
  return saturate(bars * Real(0.8) + edge + corner);
}

// The land at a place `local`, with a strip of these halves of its length and width, m. footprint: what a pixel covers,
// m, > 0. Beyond kStripReachM of what is mown the land is as it was.
FN LandSurface mownLand(LandSurface land, Vec2 local, Vec2 half_, Real footprint, LandNoise noise) {
  Real past = max(abs(local.x) - half_.x, abs(local.y) - half_.y);  // m, > 0 outside
  Real fine = noise.clod * Real(0.4) + noise.grain * Real(0.6);

  // Woods are cleared around it.
  Real cleared = smoothRise(kStripReachM - kStripRaggedM, Real(20.0), past + kStripRaggedM * noise.tuft);
  Vec3 rough = mix(Vec3(Real(0.070), Real(0.094), Real(0.030)), Vec3(Real(0.125), Real(0.120), Real(0.050)),
                   saturate(Real(0.5) + Real(0.5) * noise.tuft + Real(0.3) * fine));
  land.albedo = mix(land.albedo, rough, cleared * land.wooded);
  land.wooded = land.wooded * (Real(1.0) - cleared);
  land.open = mix(land.open, Real(1.0), cleared);

  // Turf, in lanes 5 m wide whose blades lie to and fro.
  Real mownShare = saturate(Real(0.5) - (past + Real(0.8) * fine) / max(footprint, Real(1.5)));
  Real lane = local.y / Real(10.0);
  Real side = saturate((abs(lane - floor(lane) - Real(0.5)) - Real(0.25)) * Real(10.0) / max(footprint, Real(0.4)) + Real(0.5));
  Real lanes = (Real(2.0) * side - Real(1.0)) * saturate(Real(1.6) - footprint / Real(6.0));
  Vec3 turf = Vec3(Real(0.082), Real(0.136), Real(0.036)) *
              (Real(1.0) + Real(0.16) * lanes + Real(0.16) * noise.grain + Real(0.08) * noise.clod + Real(0.10) * noise.tuft);

  // Earth where most wheels touch down and where aircraft turn.
  Real fromEnd = half_.x - abs(local.x);
  Real used = smoothRise(Real(0.0), Real(25.0), fromEnd) * smoothRise(Real(190.0), Real(60.0), fromEnd);
  Real track = abs(local.y) / (Real(3.5) + Real(2.0) * noise.tuft);
  Real worn = saturate(used * (Real(1.0) - track) * (Real(0.85) + Real(0.9) * fine + Real(0.6) * noise.tuft));
  turf = mix(turf, Vec3(Real(0.150), Real(0.112), Real(0.070)), worn * Real(0.85));

  land.albedo = mix(land.albedo, turf, mownShare);
  land.litter = land.litter * (Real(1.0) - mownShare);
  land.scree = land.scree * (Real(1.0) - mownShare);
  land.rock = land.rock * (Real(1.0) - mownShare);
  land.sand = land.sand * (Real(1.0) - mownShare);
  land.roughness = mix(land.roughness, Real(0.18), mownShare);
  Real marks = stripMarks(local, half_, footprint);
  land.albedo = mix(land.albedo, Vec3(Real(0.74), Real(0.74), Real(0.70)), marks);
  land.roughness = land.roughness * (Real(1.0) - marks);
  return land;
}
