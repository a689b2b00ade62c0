// What the land is made of at a place: by height above the sea, by slope, and by noise that breaks the borders.
// Albedos are linear sRGB, after measured ones (grass .08 to .2 in green, conifers .04, sand .35, rock .2, snow .8).

// Noise at a place, each value in [-1, 1]: over kilometres, hundreds and tens of metres, and metres (faded out where
// a pixel cannot show it).
struct LandNoise {
  Real region;
  Real grove;
  Real tuft;
  Real grain;
};

FN Real smoothRise(Real low, Real high, Real x) {
  Real t = saturate((x - low) / (high - low));
  return t * t * (Real(3.0) - Real(2.0) * t);
}

FN Vec3 landAlbedo(Real heightM, Real normalUp, LandNoise noise) {
  Real mixed = noise.grove * Real(0.6) + noise.tuft * Real(0.4);
  Real height = heightM + mixed * (Real(4.0) + Real(0.1) * abs(heightM));

  Vec3 meadow = mix(Vec3(Real(0.070), Real(0.110), Real(0.028)), Vec3(Real(0.155), Real(0.150), Real(0.060)),
                    saturate(Real(0.45) + Real(0.35) * noise.region + Real(0.30) * mixed + height * Real(0.0004)));
  Vec3 forest = Vec3(Real(0.020), Real(0.040), Real(0.014)) * (Real(1.0) + Real(0.5) * noise.grain);
  Vec3 heath = Vec3(Real(0.120), Real(0.105), Real(0.060));
  Vec3 rock = mix(Vec3(Real(0.110), Real(0.100), Real(0.090)), Vec3(Real(0.210), Real(0.195), Real(0.175)),
                  saturate(Real(0.5) + Real(0.5) * noise.tuft + Real(0.25) * noise.grain));
  Vec3 sand = mix(Vec3(Real(0.340), Real(0.285), Real(0.190)), Vec3(Real(0.230), Real(0.195), Real(0.135)),
                  saturate(Real(0.5) + Real(0.5) * noise.tuft));
  Vec3 snow = Vec3(Real(0.780), Real(0.800), Real(0.830));

  Real wooded = smoothRise(Real(-0.05), Real(0.30), noise.region * Real(0.55) + mixed * Real(0.65)) *
                smoothRise(Real(8.0), Real(40.0), height) * smoothRise(Real(760.0), Real(560.0), height) *
                smoothRise(Real(0.74), Real(0.84), normalUp);
  Vec3 albedo = mix(meadow, heath, smoothRise(Real(500.0), Real(850.0), height));
  albedo = mix(albedo, forest, wooded);
  albedo = mix(albedo, rock, smoothRise(Real(0.86), Real(0.76), normalUp + Real(0.035) * mixed));
  albedo = mix(albedo, rock, smoothRise(Real(850.0), Real(1050.0), height) * Real(0.8));
  albedo = mix(albedo, sand, smoothRise(Real(3.6), Real(1.4), heightM + Real(1.5) * mixed) *
                                 smoothRise(Real(0.86), Real(0.95), normalUp));
  albedo = mix(albedo, snow, smoothRise(Real(930.0), Real(1060.0), height + Real(60.0) * noise.grove) *
                                 smoothRise(Real(0.66), Real(0.80), normalUp));
  // Below the water all turns to silt.
  albedo = mix(albedo, Vec3(Real(0.190), Real(0.170), Real(0.120)), smoothRise(Real(-1.0), Real(-8.0), heightM));
  return albedo * (Real(1.0) + Real(0.12) * noise.tuft + Real(0.10) * noise.grain);
}
