// What villages consist of: fields in plots, ways, houses. Where a village is, which blocks of its fields there are and where
// its ways lead terrain::Places finds on the processor, by the land (include/skydrop/terrain/places.h); what follows from
// those for a single place is here, for drawing, clearing and collision alike.
#ifndef __cplusplus
#include "shared/land_material.glsl"
#endif

CONST int kFieldBlocks = 16;            // along a side of a village's land
CONST Real kFieldBlockM = Real(80.0);   // side of a block
CONST int kNoBlock = 0;                 // kinds of blocks
CONST int kCropBlock = 1;
CONST int kGardenBlock = 2;

CONST int kStreet = 0;                  // kinds of ways: in a village, between villages, to farms and shores
CONST int kRoad = 1;
CONST int kTrack = 2;
CONST Real kVergeM = Real(3.5);         // beside a way, without trees
CONST Real kWidestWayM = Real(2.75);    // half of its width
CONST Real kTreesFromWayM = Real(6.0);  // no stem nearer to what is driven on

FN Uint placeBits(Uint seed, Uint a, Uint b) {
  return latticeBits(seed + a * Uint(0x9e3779b1u), seed + b * Uint(0x85ebca77u));
}

// A byte of some bits, [0, 1).
FN Real byteOf(Uint bits, int which) { return Real((bits >> Uint(8 * which)) & Uint(0xffu)) * Real(3.90625e-3); }

// Borders of blocks are no straight lines: what to add to a place in blocks.
FN Vec2 fieldBend(Vec2 blocks, Uint village) {
  return Vec2(bandWave(blocks.y * Real(0.31) + byteOf(village, 0)).x, bandWave(blocks.x * Real(0.27) + byteOf(village, 1)).x) *
         Real(0.09);
}

// In blocks, of a place along and to the right of a village's middle, m; blocks are whole numbers from 0 to kFieldBlocks.
FN Vec2 blocksOf(Vec2 local, Uint village) {
  Vec2 straight = local / kFieldBlockM + Vec2(Real(8.0), Real(8.0));
  return straight + fieldBend(straight, village);
}

// The place of a point in blocks, m: the inverse of blocksOf within 2 cm.
FN Vec2 placeInBlocks(Vec2 blocks, Uint village) {
  Vec2 straight = blocks - fieldBend(blocks, village);
  straight = blocks - fieldBend(straight, village);
  straight = blocks - fieldBend(straight, village);
  straight = blocks - fieldBend(straight, village);
  straight = blocks - fieldBend(straight, village);
  straight = blocks - fieldBend(straight, village);
  return (straight - Vec2(Real(8.0), Real(8.0))) * kFieldBlockM;
}

// What stands on a border of a block: the one on its low side across the given axis (0: of columns, 1: of rows).
CONST int kBalk = 0;
CONST int kHedge = 1;
CONST int kFieldTrack = 2;
FN int borderKind(Uint village, int column, int row, int axis) {
  Real chance = byteOf(placeBits(village, Uint(column * 64 + row), Uint(40 + axis)), 0);
  return chance < Real(0.42) ? kHedge : (chance < Real(0.62) ? kFieldTrack : kBalk);
}

// A place in the fields.
struct FieldPlot {
  Uint bits;      // of the plot
  Real along;     // m along its furrows
  Real across;    // m across them, from the plot's edge
  Real toEdge;    // m to the plot's nearest edge within the block
  Real toBorder;  // m to the block's nearest border
  int border;     // which kind that is
};

// Of a place in blocks, inside the fields. garden: plots of houses instead of fields.
FN FieldPlot fieldPlotAt(Vec2 blocks, Uint village, bool garden) {
  Vec2 whole = floor(blocks);
  Vec2 inside = blocks - whole;
  int column = int(whole.x);
  int row = int(whole.y);
  Uint block = placeBits(village, Uint(column * 64 + row), Uint(3u));
  bool turned = (block & Uint(1u)) != Uint(0u);
  Vec2 at = turned ? Vec2(inside.y, inside.x) : inside;
  Real chance = byteOf(block, 1);
  Real count = garden ? Real(4.0) : (chance < Real(0.35) ? Real(1.0) : (chance < Real(0.75) ? Real(2.0) : Real(3.0)));
  Real ends = garden ? Real(3.0) : Real(1.0);
  Real strip = min(floor(at.y * count), count - Real(1.0));
  Real part = min(floor(at.x * ends), ends - Real(1.0));
  FieldPlot plot;
  plot.bits = (block ^ (Uint(int(strip)) * Uint(0x9e3779b1u))) * Uint(0x27d4eb2fu) + Uint(int(part)) * Uint(0x85ebca6bu);
  plot.bits = plot.bits ^ (plot.bits >> Uint(15u));
  plot.along = at.x * kFieldBlockM;
  plot.across = (at.y - strip / count) * kFieldBlockM;
  Real wide = kFieldBlockM / count;
  Real long_ = kFieldBlockM / ends;
  Real inPart = plot.along - part * long_;
  plot.toEdge = min(min(plot.across, wide - plot.across), min(inPart, long_ - inPart));
  Real west = inside.x;
  Real north = inside.y;
  Real acrossX = min(west, Real(1.0) - west);
  Real acrossY = min(north, Real(1.0) - north);
  plot.toBorder = min(acrossX, acrossY) * kFieldBlockM;
  bool isColumn = acrossX < acrossY;
  plot.border = borderKind(village, column + (isColumn && west > Real(0.5) ? 1 : 0),
                           row + (!isColumn && north > Real(0.5) ? 1 : 0), isColumn ? 0 : 1);
  return plot;
}

// What a place of a village's land looks like, as far as it is not the land itself.
struct PlaceLook {
  Vec3 albedo;
  Real share;      // of the ground that is painted so, [0, 1]
  Real paved;      // share that is driven on or trodden
  Real roughness;  // as of LandSurface
};

// Lines of a period and a width that a pixel shows as their mean where it is wide: the share that is line.
FN Real lineShare(Real x, Real period, Real wide, Real footprint) {
  Real at = x / period;
  Real single = stripCover((at - floor(at) - Real(0.5)) * period, Real(0.5) * wide, footprint);
  return mix(wide / period, single, saturate(Real(1.6) - footprint * Real(1.6) / period));
}

// Crops, by the plot: albedos of ripe and green corn, rape, stubble, ploughed earth, roots, hay and pasture.
FN PlaceLook cropLook(FieldPlot plot, Real footprint, LandNoise noise) {
  Real chance = byteOf(plot.bits, 0);
  Real tone = byteOf(plot.bits, 1) - Real(0.5);
  Real mottle = Real(0.5) * noise.tuft + Real(0.5) * noise.grain;
  Vec3 pasture = Vec3(Real(0.060), Real(0.094), Real(0.030));
  Vec3 hay = Vec3(Real(0.100), Real(0.130), Real(0.040));
  Vec3 wheat = Vec3(Real(0.265), Real(0.210), Real(0.098));
  Vec3 green = Vec3(Real(0.085), Real(0.128), Real(0.030));
  Vec3 rape = Vec3(Real(0.270), Real(0.240), Real(0.045));
  Vec3 stubble = Vec3(Real(0.245), Real(0.195), Real(0.105));
  Vec3 earth = Vec3(Real(0.100), Real(0.077), Real(0.054));
  Vec3 roots = Vec3(Real(0.052), Real(0.084), Real(0.028));
  bool isPasture = chance < Real(0.27);
  bool isCorn = chance >= Real(0.27) && chance < Real(0.475);
  bool isMown = chance >= Real(0.475) && chance < Real(0.71);
  Vec3 corn = chance < Real(0.34) ? green : (chance < Real(0.44) ? wheat : rape);
  Vec3 mown = chance < Real(0.62) ? hay : stubble;
  Vec3 tilled = chance < Real(0.83) ? earth : roots;
  Vec3 albedo = isPasture ? pasture : (isCorn ? corn : (isMown ? mown : tilled));
  // Hay lies in swathes, earth and roots in rows; the wheels of sprayers go through all corn, in pairs.
  Real period = isCorn ? Real(18.0) : (isMown ? Real(6.0) : Real(1.5));
  Real lane = plot.across / period;
  Real inLane = abs(lane - floor(lane) - Real(0.5)) * period;
  Real line = stripCover(isCorn ? inLane - Real(0.9) : inLane, isCorn ? Real(0.25) : Real(0.25) * period, footprint);
  Real shown = saturate(Real(1.6) - footprint * Real(1.6) / (isCorn ? Real(6.0) : period));
  Real lines = shown * (isCorn ? Real(-0.5) * line : (isPasture ? Real(0.0) : (isMown ? Real(0.26) : Real(0.34)) * (line - Real(0.5))));
  PlaceLook look;
  look.albedo = albedo * (Real(1.0) + Real(0.30) * tone + lines + (isPasture ? Real(0.30) : Real(0.13)) * mottle);
  look.share = Real(1.0);
  look.paved = Real(0.0);
  look.roughness = isPasture ? Real(0.35) : (chance >= Real(0.71) ? Real(0.5) : Real(0.25));
  return look;
}

// The land around houses: lawns, orchards' grass, beds, yards.
FN PlaceLook gardenLook(FieldPlot plot, Real footprint, LandNoise noise) {
  Real chance = byteOf(plot.bits, 0);
  Real mottle = Real(0.5) * noise.tuft + Real(0.5) * noise.grain;
  bool isBeds = chance < Real(0.16);
  bool isYard = chance > Real(0.94);
  Real rows = lineShare(plot.across, Real(2.4), Real(1.3), footprint);
  Vec3 lawn = mix(Vec3(Real(0.056), Real(0.094), Real(0.027)), Vec3(Real(0.092), Real(0.108), Real(0.040)), byteOf(plot.bits, 1));
  Vec3 beds = mix(Vec3(Real(0.096), Real(0.074), Real(0.052)), Vec3(Real(0.055), Real(0.088), Real(0.028)), rows);
  Vec3 yard = Vec3(Real(0.150), Real(0.132), Real(0.102));
  PlaceLook look;
  look.albedo = (isBeds ? beds : (isYard ? yard : lawn)) * (Real(1.0) + Real(0.22) * mottle);
  Real hedge = stripCover(plot.toEdge, Real(0.6), footprint) * (byteOf(plot.bits, 2) < Real(0.6) ? Real(1.0) : Real(0.0));
  look.albedo = mix(look.albedo, Vec3(Real(0.026), Real(0.046), Real(0.014)), hedge);
  look.share = Real(1.0);
  look.paved = isYard ? Real(0.8) : Real(0.0);
  look.roughness = Real(0.3);
  return look;
}

// With what lies between plots and on the borders of blocks. below: of the plot, by cropLook or gardenLook.
FN PlaceLook fieldLook(PlaceLook below, FieldPlot plot, bool garden, Real footprint, LandNoise noise) {
  PlaceLook look = below;
  Real ragged = Real(0.5) * noise.grain + Real(0.3) * noise.clod;
  Vec3 rough = mix(Vec3(Real(0.060), Real(0.088), Real(0.028)), Vec3(Real(0.130), Real(0.122), Real(0.052)),
                   saturate(Real(0.4) + Real(0.5) * noise.tuft + Real(0.4) * noise.grain));
  Real wide = plot.border == kHedge ? Real(2.1) : (plot.border == kFieldTrack ? Real(2.6) : Real(1.2));
  Real toBalk = garden ? Real(1e3) : plot.toEdge - Real(0.7);
  Real past = min(toBalk, plot.toBorder - wide) - Real(0.4) * ragged;
  look.albedo = mix(look.albedo, rough, saturate(Real(0.5) - past / max(footprint, Real(0.05))));
  // A hedge, or two ruts.
  bool isHedge = plot.border == kHedge;
  Real line = plot.border == kBalk ? Real(0.0)
                                   : stripCover(isHedge ? plot.toBorder : plot.toBorder - Real(0.85),
                                                (isHedge ? Real(1.3) : Real(0.4)) + Real(0.25) * ragged, footprint);
  look.albedo = mix(look.albedo, isHedge ? Vec3(Real(0.024), Real(0.042), Real(0.013)) : Vec3(Real(0.195), Real(0.163), Real(0.116)), line);
  look.paved = max(look.paved, isHedge ? Real(0.0) : line);
  return look;
}

// From a place to a piece of a way, m.
FN Real awayFromWay(Vec2 place, Vec2 from, Vec2 to) {
  Vec2 way = to - from;
  Real t = saturate(dot(place - from, way) / max(dot(way, way), Real(1e-6)));
  return length(place - from - way * t);
}

// Half of what is driven on, m.
FN Real wayHalfM(int kind) { return kind == kRoad ? Real(2.75) : (kind == kStreet ? Real(2.4) : Real(1.5)); }

// A way over what there is: asphalt with worn lanes, or two ruts in grass; rough grass beside it, or what grows on the land.
FN PlaceLook withWay(PlaceLook below, LandSurface land, Real away, int kind, Real footprint, LandNoise noise) {
  Real ragged = Real(0.35) * noise.grain + Real(0.25) * noise.clod;
  Real half_ = wayHalfM(kind);
  Vec3 rough = mix(Vec3(Real(0.062), Real(0.092), Real(0.028)), Vec3(Real(0.128), Real(0.120), Real(0.050)),
                   saturate(Real(0.4) + Real(0.6) * noise.tuft + Real(0.4) * noise.grain));
  rough = mix(land.albedo, rough, max(max(below.share, land.wooded), Real(0.3)));
  Real verge = stripCover(away, half_ + (kind == kTrack ? Real(1.0) : kVergeM) + Real(1.2) * ragged, footprint);
  PlaceLook look = below;
  look.albedo = mix(below.albedo, rough, verge * (kind == kStreet ? Real(0.5) : Real(0.9)));
  look.share = max(below.share, verge);
  Real lanes = stripCover(away - Real(1.35), Real(0.45), footprint);
  Vec3 asphalt = Vec3(Real(0.118), Real(0.116), Real(0.112)) *
                 (Real(1.0) + Real(0.22) * lanes + Real(0.10) * noise.grain + Real(0.08) * noise.tuft);
  Vec3 gravel = Vec3(Real(0.235), Real(0.200), Real(0.148)) * (Real(1.0) + Real(0.18) * noise.grain);
  Real shoulder = stripCover(away, half_ + Real(0.55) + Real(0.3) * ragged, footprint);
  Real driven = stripCover(away, half_ + Real(0.05) * ragged, footprint);
  Real grass = kind == kTrack ? Real(0.8) * stripCover(away, Real(0.45) + Real(0.3) * ragged, footprint) : Real(0.0);
  look.albedo = mix(look.albedo, gravel, shoulder * (kind == kTrack ? Real(0.0) : Real(0.75)));
  look.albedo = mix(look.albedo, mix(kind == kTrack ? gravel : asphalt, rough, grass), driven);
  look.paved = max(below.paved * (Real(1.0) - verge), max(driven, shoulder) * (Real(1.0) - grass));
  look.roughness = mix(below.roughness, Real(0.05), driven);
  return look;
}

FN PlaceLook noPlace() {
  PlaceLook look;
  look.albedo = Vec3(Real(0.0), Real(0.0), Real(0.0));
  look.share = Real(0.0);
  look.paved = Real(0.0);
  look.roughness = Real(0.3);
  return look;
}

// The land with a place over it.
FN LandSurface settledLand(LandSurface land, PlaceLook look) {
  Real left = Real(1.0) - look.share;
  land.albedo = mix(land.albedo, look.albedo, look.share);
  land.wooded = land.wooded * left;
  land.litter = land.litter * left;
  land.scree = land.scree * left;
  land.rock = land.rock * left;
  land.sand = land.sand * left;
  land.snow = land.snow * left;
  land.open = mix(land.open, Real(1.0), look.share);
  land.roughness = mix(land.roughness, look.roughness, look.share);
  return land;
}

// A building's measures, by its bits: kinds of use as below.
CONST int kDwelling = 0;
CONST int kBarn = 1;
CONST int kNave = 2;
CONST int kTower = 3;
CONST int kDeck = 4;  // of jetties and bridges
struct House {
  Real widthM;   // across the ridge
  Real lengthM;  // along it
  Real wallM;    // up to the eaves
  Real roofM;    // from there to the ridge
  Real ridge;    // length of the ridge, of the roof's: 1 a gable, less a hip, 0 a point
};
FN House houseOf(Uint bits, int use) {
  Real a = byteOf(bits, 0);
  Real b = byteOf(bits, 1);
  Real c = byteOf(bits, 2);
  House house;
  house.widthM = mix(Real(7.0), Real(9.5), a);
  house.lengthM = house.widthM * mix(Real(1.1), Real(1.7), b);
  house.wallM = c < Real(0.55) ? Real(3.0) : Real(5.4);
  house.roofM = house.widthM * mix(Real(0.36), Real(0.55), byteOf(bits, 3));
  house.ridge = b > Real(0.72) ? Real(0.45) : Real(1.0);
  if (use == kBarn) {
    house.widthM = mix(Real(9.0), Real(12.0), a);
    house.lengthM = mix(Real(15.0), Real(24.0), b);
    house.wallM = mix(Real(3.6), Real(5.0), c);
    house.roofM = house.widthM * Real(0.36);
    house.ridge = Real(1.0);
  }
  if (use == kNave) {
    house.widthM = Real(9.0);
    house.lengthM = Real(18.0);
    house.wallM = Real(7.0);
    house.roofM = Real(6.0);
    house.ridge = Real(1.0);
  }
  if (use == kTower) {
    house.widthM = Real(5.2);
    house.lengthM = Real(5.2);
    house.wallM = Real(14.0);
    house.roofM = Real(9.0);
    house.ridge = Real(0.0);
  }
  return house;
}
