// The ground from a few metres: which materials' squares (terrain::GroundRelief) a place shows, where in them, and how
// rock lies in layers. All means are 0: what is drawn from afar is what it was.
// Sources: Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(3), 2022: pieces of one texture moved by a hash, blended
// in narrow seams; Heitz and Neyret, "High-Performance By-Example Noise", 2018: blends that keep the variance;
// Quilez, "Biplanar mapping", 2020: the two of three projections that count.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/land_material.glsl"
#include "shared/ground_picture.glsl"
#endif

CONST Real kDetailSeam = Real(0.22);        // width of the seams between pieces, in shares of a piece
CONST Real kDetailFadedM = Real(0.90);     // detail is gone where a pixel covers this, m ...
CONST Real kDetailWholeM = Real(0.50);     // ... and whole up to this
CONST Real kReliefBytes = Real(2.007874);  // a byte's share of 255 in units of 127: 128 is 0
CONST Real kReliefZero = Real(1.0078740157480315);

// What of the detail is drawn where a pixel covers footprintM, [0, 1]; reach: >= 0, 0 for none.
FN Real detailShare(Real footprintM, Real reach) {
  Real f = footprintM / max(reach, Real(1e-6));
  Real t = saturate((kDetailFadedM - f) / (kDetailFadedM - kDetailWholeM));
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// What a pixel covers for the detail, m: that of a place at distanceM seen with the cosine `facing`, with a part of how
// it is drawn out along the view. pixelM: at a metre, m.
FN Real detailFootprint(Real distanceM, Real pixelM, Real facing) {
  Real f = max(facing, Real(0.05));
  return distanceM * pixelM / sqrt(f * sqrt(f));
}

// The two materials that count most at a place: numbers of layers, and the share of the second, [0, 0.5].
struct DetailPick {
  Real first;
  Real second;
  Real share;
};

// Of grass, litter, scree, rock, sand and snow, each >= 0.
FN DetailPick detailPick(Real grass, Real litter, Real scree, Real rock, Real sand, Real snow) {
  Real best = grass, next = Real(0.0), first = Real(0.0), second = Real(0.0);
  // Each goes before, between or behind the two that lead.
  bool leads = litter > best;
  next = leads ? best : litter, second = leads ? first : Real(1.0);
  best = leads ? litter : best, first = leads ? Real(1.0) : first;
  leads = scree > best;
  second = leads ? first : (scree > next ? Real(2.0) : second), next = leads ? best : max(next, scree);
  best = leads ? scree : best, first = leads ? Real(2.0) : first;
  leads = rock > best;
  second = leads ? first : (rock > next ? Real(3.0) : second), next = leads ? best : max(next, rock);
  best = leads ? rock : best, first = leads ? Real(3.0) : first;
  leads = sand > best;
  second = leads ? first : (sand > next ? Real(4.0) : second), next = leads ? best : max(next, sand);
  best = leads ? sand : best, first = leads ? Real(4.0) : first;
  leads = snow > best;
  second = leads ? first : (snow > next ? Real(5.0) : second), next = leads ? best : max(next, snow);
  best = leads ? snow : best, first = leads ? Real(5.0) : first;
  DetailPick pick;
  pick.first = first;
  pick.second = second;
  pick.share = next / max(best + next, Real(1e-6));
  return pick;
}

FN DetailPick detailPickOf(LandSurface land) {
  Real grass = max(Real(1.0) - land.litter - land.scree - land.rock - land.sand - land.snow, Real(0.0));
  return detailPick(grass, land.litter, land.scree, land.rock, land.sand, land.snow);
}

// The two axes (0 to 2: x, y, z) along which a surface of a unit normal is looked at, and the share of the second,
// [0, 0.5]: continuous in the normal.
struct DetailPlanes {
  Real first;
  Real second;
  Real share;
};

FN DetailPlanes detailPlanes(Vec3 normal) {
  Vec3 n = abs(normal);
  DetailPlanes planes;
  planes.first = n.y >= n.x && n.y >= n.z ? Real(1.0) : (n.x >= n.z ? Real(0.0) : Real(2.0));
  Real longest = max(n.y, max(n.x, n.z));
  Real middle = max(min(n.x, n.y), min(max(n.x, n.y), n.z));
  planes.second = planes.first == Real(1.0) ? (n.x >= n.z ? Real(0.0) : Real(2.0))
                  : planes.first == Real(0.0) ? (n.y >= n.z ? Real(1.0) : Real(2.0))
                                              : (n.y >= n.x ? Real(1.0) : Real(0.0));
  // 1 / sqrt(3): where the third begins to count as much as the second.
  Real a = max(longest - Real(0.57735), Real(0.0)), b = max(middle - Real(0.57735), Real(0.0));
  planes.share = b * b / max(a * a + b * b, Real(1e-9));
  return planes;
}

// The pieces that meet at a place, the nearest first: bits of each, and their weights, whose squares have the sum 1.
// Weights of 0 come last.
struct DetailPieces {
  Uint first;
  Uint second;
  Uint third;
  Vec3 weights;
};

FN Real seamWeight(Real share, Real most) {
  Real t = saturate((share - most) / kDetailSeam + Real(1.0));
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// Of a lattice cut into triangles: `cell` (whole numbers, wrapped at 2^32), `inside` [0, 1] in the cell. `salt` tells
// planes and sizes apart.
FN DetailPieces detailPieces(Uvec2 cell, Vec2 inside, Uint salt) {
  Real sum = inside.x + inside.y;
  bool upper = sum > Real(1.0);
  Real a = upper ? sum - Real(1.0) : Real(1.0) - sum;
  Real b = upper ? Real(1.0) - inside.y : inside.x;
  Real c = upper ? Real(1.0) - inside.x : inside.y;
  Uint west = cell.x * Uint(0x9e3779b1u) + salt;
  Uint north = cell.y * Uint(0x85ebca77u);
  Uint east = west + Uint(0x9e3779b1u);
  Uint south = north + Uint(0x85ebca77u);
  Uint bitsA = upper ? latticeBits(east, south) : latticeBits(west, north);
  Uint bitsB = latticeBits(east, north);
  Uint bitsC = latticeBits(west, south);
  Real most = max(a, max(b, c));
  Vec3 w = Vec3(seamWeight(a, most), seamWeight(b, most), seamWeight(c, most));
  w = w / sqrt(dot(w, w));
  DetailPieces pieces;
  bool bLeads = b > a;
  Uint high = bLeads ? bitsB : bitsA, low = bLeads ? bitsA : bitsB;
  Real wHigh = bLeads ? w.y : w.x, wLow = bLeads ? w.x : w.y;
  bool cLeads = w.z > wHigh, cSecond = w.z > wLow;
  pieces.first = cLeads ? bitsC : high;
  pieces.second = cLeads ? high : (cSecond ? bitsC : low);
  pieces.third = cSecond ? low : bitsC;
  pieces.weights = Vec3(cLeads ? w.z : wHigh, cLeads ? wHigh : (cSecond ? w.z : wLow), cSecond ? wLow : w.z);
  return pieces;
}

// How far a piece is moved within its square, in shares of it, [0, 1).
FN Vec2 pieceOffset(Uint bits) {
  return Vec2(Real(bits & Uint(0xffffu)), Real(bits >> Uint(16u))) * Real(1.52587890625e-5);
}

// The level of detail to fetch with, by one as of groundPictureLevel, >= 0: whole but for the middle third between two, so
// that a software renderer, which fetches a second level where any pixel at hand is between two, mostly fetches one.
FN Real detailMip(Real level) {
  Real whole = floor(level);
  return whole + smoothRise(Real(0.3333333), Real(0.6666667), level - whole);
}

// Beds of about thickM at a height in the rock: hard and soft in [-1, 1] (x) and how that changes with the height, 1/m
// (y). Each bed has a thickness (0.3 to 1.7 times that) and a hardness of its own, by its number; 0 where a pixel covers
// half of it (footprintM: height, m). |h| <= 1e5 m.
FN Vec2 rockBeds(Real h, Real thickM, Uint salt, Real footprintM) {
  Real x = h / thickM;
  Real k = floor(x);
  Real t = x - k;
  Uint number = Uint(int(k)) * Uint(0x9e3779b1u) + salt;
  Uint belowBits = latticeBits(number - Uint(0x9e3779b1u), salt);
  Uint bits = latticeBits(number, salt);
  Uint aboveBits = latticeBits(number + Uint(0x9e3779b1u), salt);
  // The border of a bed to the one below lies within 0.35 of its number.
  Real lower = Real(bits & Uint(0xffu)) * Real(0.0027) - Real(0.35);
  Real upper = Real(1.0) + Real(aboveBits & Uint(0xffu)) * Real(0.0027) - Real(0.35);
  bool atUpper = t - lower > upper - t;
  Real below = Real((atUpper ? bits : belowBits) >> Uint(24u)) * Real(0.0078431373) - Real(1.0);
  Real above = Real((atUpper ? aboveBits : bits) >> Uint(24u)) * Real(0.0078431373) - Real(1.0);
  Real width = clamp(footprintM / thickM, Real(0.05), Real(0.14));
  Real s = saturate((t - (atUpper ? upper : lower)) / (Real(2.0) * width) + Real(0.5));
  Real share = saturate(Real(1.5) - Real(3.0) * footprintM / thickM);
  return Vec2(mix(below, above, s * s * (Real(3.0) - Real(2.0) * s)) * share,
              (above - below) * (Real(3.0) * s * (Real(1.0) - s) / (width * thickM)) * share);
}

// Faults: blocks of rock that slid along each other. How far the beds of a place are moved (x, m, +-16) and how far the
// next fault is (y, m). `cell`, `inside`: of a lattice of 960 m; bend: [-1, 1], by which faults wander.
FN Vec2 rockFaults(Uvec2 cell, Vec2 inside, Real bend) {
  Real u = Real(3.0) * inside.x + Real(4.0) * inside.y + Real(0.30) * bend;
  Real v = Real(3.0) * inside.y - Real(4.0) * inside.x + Real(0.22) * bend;
  Real wholeU = floor(u), wholeV = floor(v);
  Uint along = cell.x * Uint(3u) + cell.y * Uint(4u) + Uint(int(wholeU));
  Uint across = cell.y * Uint(3u) - cell.x * Uint(4u) + Uint(int(wholeV));
  Real throwU = Real(latticeBits(along * Uint(0x9e3779b1u), Uint(17u)) >> Uint(24u)) * Real(0.0078431373) - Real(1.0);
  Real throwV = Real(latticeBits(across * Uint(0x85ebca77u), Uint(91u)) >> Uint(24u)) * Real(0.0078431373) - Real(1.0);
  Real partU = u - wholeU, partV = v - wholeV;
  return Vec2(Real(11.0) * throwU + Real(5.0) * throwV,
              Real(192.0) * min(min(partU, Real(1.0) - partU), min(partV, Real(1.0) - partV)));
}

// How rock looks at a place: hard and soft, [-1, 1]; the slope of ledges and ribs by height, 1; and the share that
// rubble covers, [0, 1].
struct RockLayers {
  Real tone;
  Real ledge;
  Real rubble;
};

// Beds dip by region and grove (up to a fifth), are moved at faults, and lie bare here and under rubble there.
FN RockLayers rockLayers(Real heightM, Vec2 faults, LandNoise noise, Real footprintM) {
  Real h = heightM + Real(150.0) * noise.region + Real(14.0) * noise.grove + faults.x;
  Vec2 thick = rockBeds(h, Real(31.0), Uint(5u), footprintM);
  Vec2 middle = rockBeds(h + Real(2.0) * noise.tuft, Real(7.3), Uint(6u), footprintM);
  Vec2 thin = rockBeds(h + Real(2.0) * noise.tuft + Real(0.3) * noise.clod, Real(1.9), Uint(7u), footprintM);
  Real bare = saturate(Real(0.55) + Real(0.9) * noise.tuft + Real(0.5) * noise.clod + Real(0.35) * thick.x +
                       Real(0.25) * middle.x);
  Real gap = saturate(Real(1.0) - faults.y / max(Real(2.0), footprintM)) * saturate(Real(1.2) - footprintM / Real(3.0));
  RockLayers layers;
  layers.tone = clamp((Real(0.50) * thick.x + Real(0.36) * middle.x + Real(0.24) * thin.x) * (Real(0.35) + Real(0.65) * bare) -
                      Real(0.45) * gap, Real(-1.0), Real(1.0));
  layers.ledge = (Real(1.3) * thick.y + Real(0.75) * middle.y + Real(0.26) * thin.y) * bare;
  layers.rubble = (Real(1.0) - bare) * Real(0.8);
  return layers;
}
