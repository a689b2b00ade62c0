// Rain, snow, ice pellets and hail: sizes, numbers, fall speeds, the extinction that follows, and how much falls where below
// a cloud. Rates in mm/h of water, diameters in mm, extinction in 1/m (visual range = 3.912 / extinction).
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Rain: N(D) = N0 exp(-L D), N0 = 8000 1/(m^3 mm), L = 4.1 R^-0.21 1/mm (Marshall and Palmer 1948).
CONST Real kRainDrops = Real(8000.0);
FN Real rainSlope(Real rate) { return Real(4.1) * pow(max(rate, Real(1e-6)), Real(-0.21)); }

// Twice the drops' cross section (van de Hulst 1957): pi N0 / L^3. 3.65e-4 R^0.63; Atlas (1953) measured 3.4e-4 R^0.63.
FN Real rainExtinction(Real rate) { return Real(3.6467e-4) * pow(max(rate, Real(0.0)), Real(0.63)); }

// Snow: N0 = 3800 R^-0.87, L = 2.55 R^-0.48 of the melted diameter (Gunn and Marshall 1958); flakes are of a tenth of the
// density of water, so 2.15 times as wide. In 1 mm/h one sees 1.2 km.
CONST Real kFlakeWidening = Real(2.1544);
FN Real snowSlope(Real rate) { return Real(2.55) * pow(max(rate, Real(1e-6)), Real(-0.48)); }
FN Real snowExtinction(Real rate) { return Real(3.3418e-3) * pow(max(rate, Real(0.0)), Real(0.57)); }

// Of spheres of one diameter and density (of water: 1) that fall at a speed, m/s: 3 R / (D v density).
FN Real spheresExtinction(Real rate, Real diameterMm, Real speedMps, Real density) {
  return Real(8.3333e-4) * max(rate, Real(0.0)) / (diameterMm * speedMps * density);
}

// Terminal speeds, m/s: drops (Atlas, Srivastava and Sekhon 1973), hail (Auer 1972).
FN Real dropSpeed(Real diameterMm) { return max(Real(9.65) - Real(10.3) * exp(Real(-0.6) * diameterMm), Real(0.1)); }
FN Real hailSpeed(Real diameterMm) { return Real(9.0) * pow(Real(0.1) * diameterMm, Real(0.8)); }

// What falls below a cloud, and out of which.
struct FallField {
  Real baseM;        // above the sea
  Real topM;         // nothing falls above it
  Real groundRate;   // at sea level, below the heart of the rain
  Real evaporation;  // mm/h of rain a metre of fall
  Real freezingM;    // height above which rain is snow; a few hundred metres wide
  Real snowShare;    // of what falls at sea level
};

// At a height, below a place where the cloud rains with a share of its full rate. Light rain ends on the way down.
FN Real fallRate(FallField field, Real heightM, Real share) {
  Real below = saturate((field.topM - heightM) / max(field.topM - field.baseM, Real(1.0)));
  Real fallen = clamp(field.baseM - heightM, Real(0.0), field.baseM);
  return max(share * (field.groundRate + field.evaporation * field.baseM) - field.evaporation * fallen, Real(0.0)) * below;
}

// Share of it that is snow.
FN Real snowAt(FallField field, Real heightM) {
  Real cold = saturate((heightM - field.freezingM) / Real(300.0) + Real(0.5));
  return max(field.snowShare, cold * cold * (Real(3.0) - Real(2.0) * cold));
}

FN Real fallExtinction(Real rate, Real snow) {
  return rainExtinction(rate * (Real(1.0) - snow)) + snowExtinction(rate * snow);
}

// Share of the full rate below a place of the weather map: its coverage and precipitation [0, 1], and the coverage of the
// layer (localCoverage() of cloud_medium.glsl). None where there is no cloud.
FN Real rainShareOfMap(Real mappedCoverage, Real mappedRain, Real layerCoverage) {
  Real cloud = saturate((saturate(Real(2.0) * mappedCoverage * layerCoverage) - Real(0.35)) / Real(0.25));
  return mappedRain * cloud * cloud * (Real(3.0) - Real(2.0) * cloud);
}

// The albedo of a matt surface under a film of water: light that it sends back is partly reflected into it again
// (Angstrom 1925; Lekner and Dorf 1988 measure the same darkening): a / (a + n^2 (1 - a)), n = 1.33.
FN Real wetAlbedo(Real dry) { return dry / (dry + Real(1.7689) * (Real(1.0) - dry)); }

// Share of level ground that stands under water, and of fallen snow on land above a line: it slides from what is steep.
// `drift` in [-1, 1]: noise of tens of metres.
FN Real puddleShare(Real wet, Real normalUp, Real drift) {
  return wet * saturate((normalUp - Real(0.985)) * Real(90.0)) * saturate(Real(0.35) + Real(1.2) * drift);
}
FN Real fallenSnow(Real amount, Real heightM, Real lineM, Real normalUp, Real drift) {
  Real above = saturate((heightM - lineM + Real(70.0) * drift) / Real(140.0) + Real(0.5));
  Real lies = saturate((normalUp - Real(0.62) + Real(0.08) * drift) / Real(0.16));
  Real thin = saturate(Real(2.2) * amount - Real(0.6) * (Real(1.0) - drift));
  return above * lies * thin;
}
