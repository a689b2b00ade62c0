// High clouds of ice as thin layers: how dense they are at a place, where a ray runs through one, and how ice scatters.
// Genera and species after the International Cloud Atlas (WMO 2017). Strands are fall streaks: crystals leave generating
// cells at the top and lag behind them, because the air below moves otherwise; in a linear shear the path is a parabola
// (Ludlam 1956; Harimaya 1968). Lengths are in metres, in the layer's own axes: u along the shear, v across it.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/cloud_light.glsl"
#endif

// Side of the widest lattice. All others divide it, so that one anchor, wrapped in double, places them all: exact 1e9 m out.
CONST Real kIceCellM = Real(65536.0);

// A place in the layer: a cell of that lattice, and where in it, [0, 1).
struct IcePlace {
  Uvec2 cell;
  Vec2 inside;
};

// The form of a layer.
struct IceForm {
  Real trailM;     // how far a streak has lagged behind its head along u at the base
  Real hookM;      // and across, along v
  Real threshold;  // of the noise, above which there is cloud
};

FN IcePlace make_icePlace(Uvec2 cell, Vec2 inside) {
  IcePlace place;
  Vec2 whole = floor(inside);
  place.cell = cell + Uvec2(Uint(int(whole.x)), Uint(int(whole.y)));
  place.inside = inside - whole;
  return place;
}

FN IcePlace iceMoved(IcePlace place, Vec2 byM) { return make_icePlace(place.cell, place.inside + byM / kIceCellM); }

// Noise of a lattice that has so many cells (whole numbers) across the widest one's: two values, mean 0, standard
// deviation about .3.
FN Vec2 iceNoise(IcePlace place, Real timesU, Real timesV, Uint stream) {
  Vec2 at = Vec2(place.inside.x * timesU, place.inside.y * timesV);
  Vec2 whole = floor(at);
  Uvec2 cell = Uvec2(place.cell.x * Uint(timesU) + Uint(whole.x) + stream * Uint(0x3504f333u),
                     place.cell.y * Uint(timesV) + Uint(whole.y) + stream * Uint(0x1b873593u));
  return latticeNoise(cell, at - whole);
}

// What is left of such noise where a pixel covers `extent` (m, along u and v): none from three quarters of a cell on.
FN Real iceShown(Vec2 extent, Real timesU, Real timesV) {
  return saturate(Real(1.5) - Real(2.0) / kIceCellM * max(extent.x * timesU, extent.y * timesV));
}

// A soft step at 0, `soft` to each side.
FN Real iceEdge(Real x, Real soft) {
  Real t = saturate(Real(0.5) + Real(0.5) * x / soft);
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// Where the head is whose streak passes a place at a depth below the top (0) as a share of the layer (1 at the base).
FN IcePlace iceHead(IcePlace place, IceForm form, Real depth) {
  Real d2 = depth * depth;
  return iceMoved(place, Vec2(form.trailM * d2, form.hookM * d2 * depth));
}

// Cirrus: patches of strands that start in denser heads, thin out downwards and end at different depths.
FN Real cirrusDensity(IcePlace place, IceForm form, Real depth, Vec2 extent) {
  IcePlace head = iceHead(place, form, depth);
  Vec2 wide = iceNoise(head, Real(2.0), Real(2.0), Uint(1u));
  Vec2 mid = iceNoise(head, Real(7.0), Real(11.0), Uint(2u)) * iceShown(extent, Real(7.0), Real(11.0));
  // Strands are not straight: the wind waves.
  IcePlace bent = iceMoved(head, Vec2(Real(1500.0) * mid.y, Real(3000.0) * wide.y + Real(1100.0) * mid.y));
  Vec2 band = iceNoise(bent, Real(5.0), Real(37.0), Uint(3u)) * iceShown(extent, Real(5.0), Real(37.0));
  Real coarseShown = iceShown(extent, Real(11.0), Real(113.0));
  Real middleShown = iceShown(extent, Real(17.0), Real(283.0));
  Real fineShown = iceShown(extent, Real(29.0), Real(701.0));
  Vec2 coarse = iceNoise(bent, Real(11.0), Real(113.0), Uint(4u)) * coarseShown;
  Vec2 middle = iceNoise(bent, Real(17.0), Real(283.0), Uint(5u)) * middleShown;
  Vec2 fine = iceNoise(bent, Real(29.0), Real(701.0), Uint(6u)) * fineShown;
  Real area = wide.x + Real(0.9) * mid.x + Real(0.6) * band.x;
  Real strands = Real(0.9) * coarse.x + Real(0.8) * middle.x + Real(0.7) * fine.x;
  Real inside = iceEdge(area - form.threshold + Real(0.5) * strands - Real(0.3) * depth, Real(0.5));
  // Filaments: light between dark.
  Real filament = saturate(Real(0.34) + Real(1.2) * strands + Real(0.6) * band.y);
  // Heads: tufts at the top, where ice forms.
  Real tuft = saturate(Real(2.5) * (mid.x + Real(1.2) * coarse.y)) * saturate(Real(1.0) - Real(4.0) * depth);
  // Each streak ends where its crystals have evaporated.
  Real reach = saturate(Real(0.6) + Real(1.1) * (coarse.y + middle.y));
  Real tail = saturate((reach + Real(0.2) - depth) * Real(3.0));
  return inside * filament * (filament * tail + Real(1.5) * tuft);
}

// Cirrostratus: an even veil with faint long fibres; at its edge it thins over tens of kilometres.
FN Real cirrostratusDensity(IcePlace place, IceForm form, Real depth, Vec2 extent) {
  IcePlace head = iceHead(place, form, Real(0.3) * depth);
  Vec2 wide = iceNoise(head, Real(1.0), Real(1.0), Uint(7u));
  Vec2 mid = iceNoise(head, Real(5.0), Real(7.0), Uint(8u)) * iceShown(extent, Real(5.0), Real(7.0));
  IcePlace bent = iceMoved(head, Vec2(Real(0.0), Real(5000.0) * wide.y + Real(900.0) * mid.y));
  Vec2 band = iceNoise(bent, Real(2.0), Real(19.0), Uint(9u)) * iceShown(extent, Real(2.0), Real(19.0));
  Vec2 coarse = iceNoise(bent, Real(5.0), Real(71.0), Uint(10u)) * iceShown(extent, Real(5.0), Real(71.0));
  Vec2 middle = iceNoise(bent, Real(13.0), Real(211.0), Uint(11u)) * iceShown(extent, Real(13.0), Real(211.0));
  Real area = wide.x + Real(0.35) * mid.x + Real(0.2) * band.x;
  Real inside = iceEdge(area - form.threshold, Real(0.7));
  Real even = Real(1.0) + Real(0.25) * band.y + Real(0.22) * coarse.x + Real(0.2) * middle.x + Real(0.3) * mid.y;
  return inside * max(even, Real(0.0));
}

// Cirrocumulus: patches of grains of about 100 m, in ripples of 290 m across the shear, with holes and ragged edges.
FN Real cirrocumulusDensity(IcePlace place, IceForm form, Real depth, Vec2 extent) {
  IcePlace head = iceHead(place, form, Real(0.02) * depth);
  Vec2 wide = iceNoise(head, Real(3.0), Real(5.0), Uint(12u));
  Vec2 mid = iceNoise(head, Real(13.0), Real(19.0), Uint(13u)) * iceShown(extent, Real(13.0), Real(19.0));
  Vec2 small = iceNoise(head, Real(61.0), Real(73.0), Uint(14u)) * iceShown(extent, Real(61.0), Real(73.0));
  IcePlace bent = iceMoved(head, Vec2(Real(420.0) * mid.y + Real(110.0) * small.y, Real(160.0) * small.x));
  Real grainShown = iceShown(extent, Real(401.0), Real(331.0));
  Real fineShown = iceShown(extent, Real(907.0), Real(809.0));
  Real rippleShown = iceShown(extent, Real(227.0), Real(0.0));
  Vec2 grain = iceNoise(bent, Real(401.0), Real(331.0), Uint(15u)) * grainShown;
  Vec2 fine = iceNoise(bent, Real(907.0), Real(809.0), Uint(16u)) * fineShown;
  Real phase = bent.inside.x * Real(227.0);
  Real share = phase - floor(phase);
  Real ripple = (Real(4.0) * share * (Real(1.0) - share) - Real(0.667)) * rippleShown;
  Real area = wide.x + Real(0.7) * mid.x + Real(0.4) * small.x;
  Real rippled = saturate(Real(0.5) + Real(1.6) * mid.y);
  Real grains = Real(1.1) * grain.x + Real(0.55) * fine.x + Real(0.75) * rippled * ripple;
  // Where grains are finer than a pixel their mean is left, by the same step over all that they spread.
  Real lost = Real(0.45) * (Real(1.0) - grainShown) + Real(0.12) * (Real(1.0) - fineShown);
  Real inside = iceEdge(area - form.threshold + Real(0.25) * grains, Real(0.35));
  return inside * iceEdge(grains - Real(0.12) + Real(0.4) * small.y, Real(0.3) + lost) *
         (Real(1.0) - depth * depth);
}

// What a ray has of a layer, counted without the gap in which it has dipped below the base: from begin to end (m), the gap
// left out at gapAt. end <= begin where there is none of it.
struct IceStretch {
  Real begin;
  Real end;
  Real gapAt;
  Real gapM;
};

// Of a ray from an eye at these heights above base, top and sea, on the shell as bent in cloud_light.glsl. A ray that meets
// the sea ends there.
FN IceStretch iceStretch(Real aboveBaseM, Real aboveTopM, Real eyeM, Vec3 direction) {
  Real bend = max(rayBend(direction), Real(1e-12));
  RaySpan underTop = bentRayUnder(aboveTopM, direction.y, bend);
  RaySpan underBase = bentRayUnder(aboveBaseM, direction.y, bend);
  RaySpan underSea = bentRayUnder(eyeM, direction.y, bend);
  bool meetsSea = underSea.end > underSea.begin && underSea.end > Real(0.0);
  IceStretch way;
  way.begin = max(underTop.begin, Real(0.0));
  way.end = min(underTop.end, meetsSea ? max(underSea.begin, Real(0.0)) : Real(1e6));
  way.gapAt = Real(1e30);
  way.gapM = Real(0.0);
  if (underBase.begin <= way.begin) {
    way.begin = max(way.begin, underBase.end);
  } else if (underBase.begin < way.end) {
    bool returns = underBase.end < way.end;
    way.gapAt = returns ? underBase.begin : Real(1e30);
    way.gapM = returns ? underBase.end - underBase.begin : Real(0.0);
    way.end = returns ? way.end - way.gapM : underBase.begin;
  }
  return way;
}

// From the count without the gap to the distance from the eye, and back.
FN Real iceDistance(IceStretch way, Real count) { return count > way.gapAt ? count + way.gapM : count; }
FN Real iceCount(IceStretch way, Real distanceM) {
  return distanceM > way.gapAt ? max(distanceM - way.gapM, way.gapAt) : distanceM;
}

// Where a share [0, 1] of the samples of a stretch has been taken: even for a layer far away, denser near the eye within it,
// half of them on each side of a gap.
FN Real icePlaceOnStretch(IceStretch way, Real share) {
  bool gap = way.gapM > Real(0.0);
  Real lengthM = (gap ? way.gapAt : way.end) - way.begin;
  Real even = way.begin / max(way.begin + Real(0.25) * lengthM, Real(1e-3));
  Real before = gap ? saturate(Real(2.0) * share) : share;
  Real behind = gap ? saturate(Real(2.0) * share - Real(1.0)) * (way.end - way.gapAt) : Real(0.0);
  return way.begin + lengthM * before * (before * (Real(1.0) - even) + even) + behind;
}

// What ice scatters once, per steradian. Crystals scatter .75 to .85 forward in the mean, two fifths of it by
// diffraction within a degree, which counts as not scattered at all (Macke 1996; Baum 2011): what is left has a mean
// cosine of .65. Optical depths are those without that peak.
FN Real icePhase(Real cosAngle) {
  return Real(0.5) * henyeyGreenstein(cosAngle, Real(0.93)) + Real(0.38) * henyeyGreenstein(cosAngle, Real(0.55)) +
         Real(0.12) * henyeyGreenstein(cosAngle, Real(-0.2));
}

// Shares of the sun's light below a layer of an optical depth along its rays: what comes on from the sun's direction or
// close to it, and what comes from all of the sky.
FN Real iceSunLeft(Real depth) {
  Real x = exp(-max(depth, Real(0.0)));
  return x + Real(0.45) * (Real(1.0) - x);
}
FN Real iceSpread(Real depth) { return Real(0.4) * (Real(1.0) - exp(-max(depth, Real(0.0)))); }
