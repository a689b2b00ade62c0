// The gradients of periodic gradient noise, in scalars alone (lattice.glsl says why).
// Source: Perlin, "Improving Noise", SIGGRAPH 2002: the sixteen gradients in space.
#ifndef __cplusplus
#include "shared/lattice.glsl"
#endif

// A node's coordinates are added up to one number, which latticeBits() mixes.
CONST Uint kColumnStride = Uint(0x9e3779b1u);
CONST Uint kRowStride = Uint(0x85ebca77u);
CONST Uint kSliceStride = Uint(0xc2b2ae3du);

// By the lowest bit.
FN Real signOf(Uint bits) { return (bits & Uint(1u)) == Uint(0u) ? Real(1.0) : Real(-1.0); }

// Components of the gradient at a node of a plane's lattice: eight directions, 45 degrees apart, of length sqrt(2).
FN Real planeGradientX(Uint bits) {
  bool diagonal = (bits & Uint(0x20000000u)) != Uint(0u);
  Real along = (bits & Uint(0x80000000u)) == Uint(0u) ? Real(1.41421356) : Real(0.0);
  return signOf(bits >> Uint(30u)) * (diagonal ? Real(1.0) : along);
}
FN Real planeGradientY(Uint bits) {
  bool diagonal = (bits & Uint(0x20000000u)) != Uint(0u);
  Real along = (bits & Uint(0x80000000u)) == Uint(0u) ? Real(0.0) : Real(1.41421356);
  return signOf(bits >> (diagonal ? Uint(31u) : Uint(30u))) * (diagonal ? Real(1.0) : along);
}

// Of a lattice in space: to the middles of a cube's twelve edges, four of them twice.
FN Real spaceGradientX(Uint bits) {
  Uint h = bits >> Uint(28u);
  Real second = (h & Uint(13u)) == Uint(12u) ? signOf(h >> Uint(1u)) : Real(0.0);
  return h < Uint(8u) ? signOf(h) : second;
}
FN Real spaceGradientY(Uint bits) {
  Uint h = bits >> Uint(28u);
  Real second = h < Uint(4u) ? signOf(h >> Uint(1u)) : Real(0.0);
  return h < Uint(8u) ? second : signOf(h);
}
FN Real spaceGradientZ(Uint bits) {
  Uint h = bits >> Uint(28u);
  Real second = signOf(h >> Uint(1u));
  return h < Uint(4u) || (h & Uint(13u)) == Uint(12u) ? Real(0.0) : second;
}
