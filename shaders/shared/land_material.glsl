// What the land is made of at a place: by height above the sea, slope, curvature and noise.
// Albedos are linear sRGB, after measured ones (grass .08 to .2 in green, conifers .04, sand .35, rock .2, snow .8).
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/lattice_noise.glsl"
#endif

// Noise at a place, each in [-1, 1] and faded out where a pixel cannot show it.
struct LandNoise {
  Real region;  // over kilometres
  Real grove;   // hundreds of metres
  Real tuft;    // tens of metres
  Real clod;    // 8 m
  Real grain;   // 1.3 m
};

// The top of a wood at a place.
struct Crowns {
  Vec2 slope;   // of the crown along x and z, per cell
  Real height;  // 1 at the top of a tall tree, 0 and below between the trees
  Real tree;    // [0, 1): the same all over a tree
};

// What a pixel of land is made of and how rough that is.
struct LandSurface {
  Vec3 albedo;
  Real roughness;  // share of the detail's slope, [0, 1]
  Real wooded;     // share of the crowns' slope, [0, 1]
  Real open;       // share of the sky's light that reaches the surface, [0, 1]
  // Shares of what it consists of below trees, each [0, 1] and 1 at most together; the rest is grass.
  Real litter;
  Real scree;
  Real rock;
  Real sand;
  Real snow;
};

FN Real smoothRise(Real low, Real high, Real x) {
  Real t = saturate((x - low) / (high - low));
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// The share of a pixel `footprint` wide around x, both in metres, that |x| < half covers.
FN Real stripCover(Real x, Real half_, Real footprint) {
  Real around = Real(0.5) * footprint, away = abs(x);  // both sides from x: far from 0 the ends' difference would cancel
  return saturate((min(around, half_ - away) + min(around, half_ + away)) / footprint);
}

// One tree: a dome around a place near its node of the lattice. `offset` is from the node, in cells.
FN Crowns crownOf(Uint bits, Vec2 offset) {
  Vec2 stem = Vec2(Real(bits & Uint(0xffu)), Real((bits >> Uint(8u)) & Uint(0xffu))) * Real(0.0025) -
              Vec2(Real(0.32), Real(0.32));
  Vec2 aside = offset - stem;
  Real size = Real((bits >> Uint(16u)) & Uint(0xffu)) * Real(3.9215686e-3);
  Real radius = Real(0.50) + Real(0.22) * size;
  Real tall = Real(0.6) + Real(0.4) * size;
  Crowns crown;
  crown.height = tall * (Real(1.0) - dot(aside, aside) / (radius * radius));
  crown.slope = aside * (Real(-2.0) * tall / (radius * radius));
  crown.tree = Real(bits >> Uint(24u)) * Real(3.90625e-3);
  return crown;
}

FN Crowns tallerCrown(Crowns a, Crowns b) {
  Real second = b.height > a.height ? Real(1.0) : Real(0.0);
  Crowns crown;
  crown.slope = mix(a.slope, b.slope, second);
  crown.height = max(a.height, b.height);
  crown.tree = mix(a.tree, b.tree, second);
  return crown;
}

// Trees on a lattice of one to a cell: the tallest crown at a position [0, 1] in a cell.
FN Crowns crownsAt(Uvec2 cell, Vec2 inside) {
  Uint west = cell.x * Uint(0x9e3779b1u);
  Uint east = west + Uint(0x9e3779b1u);
  Uint north = cell.y * Uint(0x85ebca77u);
  Uint south = north + Uint(0x85ebca77u);
  Vec2 back = inside - Vec2(Real(1.0), Real(1.0));
  return tallerCrown(tallerCrown(crownOf(latticeBits(west, north), inside),
                                 crownOf(latticeBits(east, north), Vec2(back.x, inside.y))),
                     tallerCrown(crownOf(latticeBits(west, south), Vec2(inside.x, back.y)),
                                 crownOf(latticeBits(east, south), back)));
}

// A wave of period 1 in [-1, 1] (x) and its slope (y): two parabolas a period.
FN Vec2 bandWave(Real x) {
  Real t = Real(2.0) * (x - floor(x)) - Real(1.0);
  return Vec2(Real(4.0) * t * (Real(1.0) - abs(t)), Real(8.0) - Real(16.0) * abs(t));
}

// Layers of rock at a height: hard and soft in [-1, 1] (x), and how it changes with height, 1/m (y). `warpM` bends the
// layers; footprintM is the height that a pixel covers. Heights below 1e5 m of either sign.
FN Vec2 rockStrata(Real heightM, Real warpM, Real footprintM) {
  Real h = heightM + warpM;
  Vec2 thick = bandWave(h / Real(47.0)) * saturate(Real(1.5) - footprintM / Real(12.0));
  Vec2 middle = bandWave(h / Real(17.3) + Real(0.35) * thick.x) * saturate(Real(1.5) - footprintM / Real(4.3));
  Vec2 thin = bandWave(h / Real(5.9) + Real(0.45) * middle.x) * saturate(Real(1.5) - footprintM / Real(1.5));
  return Vec2(Real(0.42) * thick.x + Real(0.34) * middle.x + Real(0.24) * thin.x,
              Real(0.42) / Real(47.0) * thick.y + Real(0.34) / Real(17.3) * middle.y + Real(0.24) / Real(5.9) * thin.y);
}

// Drifts of hundreds and tens of metres, which bend every border on the land, [-1, 1].
FN Real driftNoise(LandNoise noise) { return noise.grove * Real(0.6) + noise.tuft * Real(0.4); }

// Hollows and ridges by the land's curvature, [0, 1].
FN Real hollowness(Real curvature) { return saturate(-curvature * Real(4.0)); }
FN Real ridgeness(Real curvature) { return saturate(curvature * Real(4.0)); }

// The height by which the belts of vegetation, rock and snow go, m: borders between them are not contour lines.
FN Real beltHeight(Real heightM, LandNoise noise) {
  return heightM + driftNoise(noise) * (Real(4.0) + Real(0.1) * abs(heightM));
}

// Land of the earth, whose belts lie higher than those of the endless land: the height at which that has what grows
// at heightM in the Alps. Woods end at 2260 m (780 m there), snow lies from 2800 m on (960 m); the shore stays. Rises
// everywhere.
FN Real alpineBeltHeight(Real heightM) {
  Real land = max(heightM, Real(0.0));
  return min(heightM, Real(0.0)) + Real(0.3335) * land + Real(26.66) * (Real(1.0) - exp(-land / Real(40.0)));
}

// Density of the woods at a place, [0, 1]: the share of the ground that crowns cover. Woods stand in patches of
// hundreds of metres to kilometres (region and drifts of the noise; clod and grain do not count), rather in moist
// hollows than on dry ridges, from 6 m above the sea up to the tree line (thinner from 540 m, none above 780 m), and
// not on slopes steeper than 35 (thinner) to 46 degrees. heightM: above the sea; normalUp: upward part of the land's
// normal, [0, 1]; curvature: as of landSurface. A pure function of the place: planting and shading that ask it agree.
FN Real forestDensity(Real heightM, Real normalUp, Real curvature, LandNoise noise) {
  Real height = beltHeight(heightM, noise);
  return smoothRise(Real(-0.10), Real(0.34),
                    noise.region * Real(0.5) + driftNoise(noise) * Real(0.75) + Real(0.5) * hollowness(curvature) -
                        Real(0.2) * ridgeness(curvature)) *
         smoothRise(Real(6.0), Real(30.0), height) * smoothRise(Real(780.0), Real(540.0), height) *
         smoothRise(Real(0.70), Real(0.82), normalUp);
}

// The hue of the foliage at a place, [0, 1]: dark conifers high up, leaves below. belt: as of beltHeight.
FN Real leafiness(Real belt, LandNoise noise) {
  return saturate(Real(0.45) + Real(0.7) * noise.region - belt * Real(0.0009) + Real(0.3) * noise.tuft);
}

// The colour of foliage by its hue.
FN Vec3 foliageAlbedo(Real leafy) {
  return mix(Vec3(Real(0.018), Real(0.036), Real(0.014)), Vec3(Real(0.042), Real(0.066), Real(0.018)), leafy);
}

// The land at a height, with the upward part of its normal, its curvature (how much the normals 24 m apart diverge:
// ridges positive, hollows negative), noise, strata in [-1, 1], the wood's crowns and how far a pixel tells trees apart.
FN LandSurface landSurface(Real heightM, Real normalUp, Real curvature, LandNoise noise, Real strata, Crowns crowns,
                           Real treeShare) {
  Real mixed = driftNoise(noise);
  Real fine = noise.clod * Real(0.55) + noise.grain * Real(0.45);
  Real hollow = hollowness(curvature);
  Real ridge = ridgeness(curvature);
  Real height = beltHeight(heightM, noise);

  // Grass: lush in hollows, dry on ridges, in drifts of tens of metres and tussocks.
  Real dry = saturate(Real(0.42) + Real(0.45) * noise.region + Real(0.40) * mixed + height * Real(0.0004) +
                      Real(0.35) * (ridge - hollow) + Real(0.22) * fine);
  Vec3 meadow = mix(Vec3(Real(0.046), Real(0.088), Real(0.020)), Vec3(Real(0.165), Real(0.148), Real(0.058)), dry);
  Vec3 heath = mix(Vec3(Real(0.095), Real(0.088), Real(0.045)), Vec3(Real(0.125), Real(0.088), Real(0.062)),
                   saturate(Real(0.5) + Real(0.8) * noise.tuft + Real(0.4) * noise.clod));
  Vec3 rock = mix(Vec3(Real(0.088), Real(0.080), Real(0.074)), Vec3(Real(0.235), Real(0.212), Real(0.182)),
                  saturate(Real(0.48) + Real(0.42) * strata + Real(0.25) * noise.tuft + Real(0.38) * fine));
  Vec3 scree = mix(Vec3(Real(0.120), Real(0.112), Real(0.102)), Vec3(Real(0.205), Real(0.190), Real(0.168)),
                   saturate(Real(0.5) + Real(0.5) * noise.tuft + Real(0.6) * noise.grain));
  Vec3 sand = mix(Vec3(Real(0.350), Real(0.290), Real(0.195)), Vec3(Real(0.235), Real(0.198), Real(0.138)),
                  saturate(Real(0.4) + Real(0.4) * noise.tuft + Real(0.3) * noise.grain));
  // A tint of its own for each tree.
  Vec3 foliage = foliageAlbedo(leafiness(height, noise)) *
                 (Real(1.0) + (Real(0.9) * crowns.tree + Real(0.8) * saturate(crowns.height) - Real(0.85)) * treeShare + Real(0.25) * noise.grain);

  // Near by each tree stands or does not.
  Real density = forestDensity(heightM, normalUp, curvature, noise);
  Real stands = smoothRise(Real(-0.05), Real(0.05), density * Real(1.1) - Real(0.05) - crowns.tree) *
                smoothRise(Real(-0.05), Real(0.10), crowns.height);
  Real wooded = mix(density, stands, treeShare);
  Real under = density * density;  // shade and moss between the trees

  Real cliff = smoothRise(Real(0.80), Real(0.68), normalUp + Real(0.05) * mixed + Real(0.05) * fine + Real(0.03) * strata);
  Real stony = smoothRise(Real(0.90), Real(0.80), normalUp + Real(0.06) * mixed + Real(0.04) * fine - Real(0.06) * hollow);
  Real bare = smoothRise(Real(800.0), Real(1020.0), height + Real(90.0) * ridge + Real(60.0) * fine);

  Vec3 albedo = mix(meadow, heath, smoothRise(Real(480.0), Real(820.0), height));
  albedo = albedo * (Real(1.0) + Real(0.42) * noise.grain + Real(0.20) * noise.clod + Real(0.10) * noise.tuft);
  Real strewn = max(stony * smoothRise(Real(60.0), Real(420.0), height), bare * Real(0.9));
  albedo = mix(albedo, scree, strewn);
  albedo = mix(albedo, Vec3(Real(0.020), Real(0.030), Real(0.012)), under * Real(0.75) * (Real(1.0) - cliff));
  albedo = mix(albedo, rock, cliff);
  albedo = mix(albedo, foliage, wooded * (Real(1.0) - cliff));

  // The beach, dark where the water wets it.
  Real shore = smoothRise(Real(4.2), Real(1.8), heightM + Real(1.3) * mixed + Real(0.5) * fine) *
               smoothRise(Real(0.84), Real(0.94), normalUp);
  Real wet = smoothRise(Real(1.1), Real(0.3), heightM + Real(0.35) * mixed);
  albedo = mix(albedo, sand * (Real(1.0) - Real(0.5) * wet), shore);
  // Below the water all turns to silt.
  Real silted = smoothRise(Real(-1.0), Real(-8.0), heightM);
  albedo = mix(albedo, Vec3(Real(0.190), Real(0.170), Real(0.120)), silted);

  // Snow lies above a line, deep in hollows, thin on ridges and ledges, and slides from what is steep.
  Real line = (height - Real(960.0)) / Real(110.0) + Real(0.9) * hollow - Real(0.5) * ridge + Real(0.45) * noise.grove +
              Real(0.45) * noise.clod + Real(0.30) * noise.grain - Real(0.30) * strata -
              Real(5.0) * max(Real(0.86) - normalUp, Real(0.0));
  Real snowed = smoothRise(Real(-0.10), Real(0.14), line) * smoothRise(Real(0.56), Real(0.70), normalUp + Real(0.06) * fine);
  Vec3 snow = Vec3(Real(0.760), Real(0.790), Real(0.830)) * (Real(1.0) + Real(0.05) * noise.tuft + Real(0.03) * noise.clod);
  albedo = mix(albedo, snow, snowed);

  LandSurface land;
  land.wooded = wooded * (Real(1.0) - cliff) * (Real(1.0) - shore) * (Real(1.0) - snowed);
  land.roughness = mix(mix(mix(Real(0.35), Real(0.7), max(stony, bare)), Real(1.0), cliff), Real(0.22), max(snowed, shore));
  land.open = (Real(1.0) - Real(0.45) * hollow) *
              (Real(1.0) - under * (Real(1.0) - cliff) * treeShare * Real(0.65) * saturate(Real(1.0) - crowns.height * Real(1.4)));
  land.albedo = albedo;
  land.snow = snowed;
  Real left = Real(1.0) - snowed;
  land.sand = left * (Real(1.0) - (Real(1.0) - shore) * (Real(1.0) - silted));
  left = left - land.sand;
  land.rock = left * cliff;
  left = left - land.rock;
  land.litter = left * under;
  left = left - land.litter;
  land.scree = left * strewn;
  return land;
}
