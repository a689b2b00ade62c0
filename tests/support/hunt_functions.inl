// HUNTED(name, arguments, results, statements): what is hunted of shaders/shared, with the contract that stands there.
// Compiled three times, as the functions are: as C++ in float and in double, and as GLSL (the statements as a text).
// `a` are the arguments, `r` the results.

// guards.glsl
HUNTED(remapClamped,
       (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30)),
       (out(-1, 1, 0, 2e-5)),
       r[0] = remapClamped(a[0], a[1], a[2], a[3], a[4]) / max(max(abs(a[3]), abs(a[4])), Real(1e-30)))
HUNTED(squareRoot, (in(-1e30, 1e30)), (out(0, 1e15, 1e-6)), r[0] = squareRoot(a[0]))
HUNTED(directionOf, (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30)),
       (out(-1, 1, 1e-6), out(-1, 1, 1e-6), out(-1, 1, 1e-6)),
       Vec3 d = directionOf(Vec3(a[0], a[1], a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0)));
       r[0] = d.x; r[1] = d.y; r[2] = d.z)
HUNTED(oneMinusExpOverX, (in(0, 1e30, {0.5f})), (out(0, 1, 5e-6, 1e-30)), r[0] = oneMinusExpOverX(a[0]))

// depth.glsl
HUNTED(depthOfViewZ, (in(1e-3, 1e30), in(1e-3, 1e3)), (out(0, 1e6, 1e-6, 1e-37)), r[0] = depthOfViewZ(a[0], a[1]))
HUNTED(viewZOfDepth, (unit(), in(1e-3, 1e3)), (out(0, 1e30, 1e-6)), r[0] = viewZOfDepth(a[0], a[1]))
HUNTED(distanceOfDepth, (unit(), in(1e-3, 1e3), in(1, 10)), (out(0, 1e30, 1e-6)),
       r[0] = distanceOfDepth(a[0], a[1], a[2]))

// atmosphere.glsl: visibility, scale height, anisotropy; heights of any sign.
HUNTED(airMass, (signedUnit()), (out(1, 40.1, 5e-6)), r[0] = airMass(a[0]))
HUNTED(densityAt, (in(-1e30, 1e30), in(50, 1e4)), (out(0, 1, 2e-5)), r[0] = densityAt(a[0], a[1]))
HUNTED(ozoneTransmittance, (signedUnit()), (share(), share(), share()),
       Vec3 t = ozoneTransmittance(a[0]); r[0] = t.x; r[1] = t.y; r[2] = t.z)
HUNTED(sunTransmittance, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), signedUnit()), (share(), share(), share()),
       Vec3 t = sunTransmittance(make_atmosphere(a[0], a[1], Real(0.7)), a[2], a[3]); r[0] = t.x; r[1] = t.y;
       r[2] = t.z)
HUNTED(sunVisibleShare, (signedUnit()), (share()), r[0] = sunVisibleShare(a[0]))
HUNTED(twilight, (signedUnit(), in(50, 1e4)), (share()), r[0] = twilight(a[0], a[1]))
HUNTED(rayleighPhase, (signedUnit()), (out(0.05, 0.12)), r[0] = rayleighPhase(a[0]))
HUNTED(henyeyGreenstein, (signedUnit(), in(-1e30, 1e30, {0.95f, -0.95f})), (out(0, 62.1, 1e-5)),
       r[0] = henyeyGreenstein(a[0], a[1]))
HUNTED(skyRadiance, (in(100, 5e5), in(50, 1e4), in(-0.95, 0.95), in(-1e30, 1e30), signedUnit(), signedUnit(),
                     signedUnit()),
       (out(0, 100, 1e-4, 1e-5), out(0, 100, 1e-4, 1e-5), out(0, 100, 1e-4, 1e-5)),
       Atmosphere air = make_atmosphere(a[0], a[1], a[2]); SkyColumn column = make_skyColumn(air, a[3], a[4]);
       Vec3 light = skyRadiance(skySource(column, air, a[5]), a[6], a[2]); r[0] = light.x; r[1] = light.y;
       r[2] = light.z)
HUNTED(transmittanceBetween, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), in(-1e30, 1e30), in(0, 1e30)),
       (share(), share(), share()),
       Vec3 t = transmittanceBetween(make_atmosphere(a[0], a[1], Real(0.7)), a[2], a[3], a[4]); r[0] = t.x;
       r[1] = t.y; r[2] = t.z)
HUNTED(skyTransmittance, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), signedUnit()), (share(), share(), share()),
       SkyColumn column = make_skyColumn(make_atmosphere(a[0], a[1], Real(0.7)), a[2], Real(0.5));
       Vec3 t = skyTransmittance(column, a[3]); r[0] = t.x; r[1] = t.y; r[2] = t.z)

// atmosphere_shell.glsl
HUNTED(ozoneDensity, (in(-1e30, 1e30, {10000.0f, 25000.0f, 40000.0f})), (share()), r[0] = ozoneDensity(a[0]))
HUNTED(shellHeightAlong, (in(0, 1e6, {100000.0f}), signedUnit(), in(0, 1e30)), (out(-6.4e6, 2.1e30, 1e-5, 0.5)),
       r[0] = shellHeightAlong(a[0], a[1], a[2]))
HUNTED(shellCosineAlong, (in(0, 2e5, {100000.0f}), signedUnit(), in(0, 1e30)), (out(-1, 1, 0, 1e-5)),
       r[0] = shellCosineAlong(a[0], a[1], a[2]))
HUNTED(shellCrossing, (in(0, 1e6, {100000.0f}), signedUnit(), in(0, 1e6, {100000.0f})),
       (out(-2e7, 2e7, 1e-5, 20), out(-2e7, 2e7, 1e-5, 20)),
       Vec2 t = shellCrossing(a[0], a[1], a[2]); r[0] = t.x; r[1] = t.y)
HUNTED(horizonSine, (in(-1e30, 1e30)), (out(-1, 0, 1e-6)), r[0] = horizonSine(a[0]))
HUNTED(airEndsSine, (in(-1e30, 1e30, {100000.0f})), (out(-1, 1, 2e-6)), r[0] = airEndsSine(a[0]))
HUNTED(sunVisibleShareAt, (in(-1e30, 1e7), signedUnit()), (share(3e-4)), r[0] = sunVisibleShareAt(a[0], a[1]))
HUNTED(transmittanceTableAt, (in(-1e30, 1e30, {100000.0f}), signedUnit()), (share(2e-4), share()),
       Vec2 at = transmittanceTableAt(a[0], a[1]); r[0] = at.x; r[1] = at.y)
HUNTED(transmittanceTablePlace, (unit(), unit()), (out(0, 100000, 1e-6, 0.05), out(-1, 1, 0, 2e-4)),
       Vec2 at = transmittanceTablePlace(Vec2(a[0], a[1])); r[0] = at.x; r[1] = at.y)
HUNTED(skyTableRow, (signedUnit(), in(-1e30, 1e30, {100000.0f})), (out(0, 79, 0, 3e-2)),
       r[0] = skyTableRow(a[0], horizonSine(a[1]), airEndsSine(a[1])))
HUNTED(skyTableSlice, (in(0, 1e30)), (out(0, 4, 1e-6)), r[0] = skyTableSlice(a[0]))
HUNTED(skyTableColumn, (signedUnit()), (out(0, 15, 1e-6, 2e-6)), r[0] = skyTableColumn(a[0]))
HUNTED(airTableColumn, (in(-1.001, 1.001)), (out(0, 63, 1e-3, 3e-2)), r[0] = airTableColumn(a[0]))
HUNTED(airTableRow, (in(0, 79)), (out(0, 94, 1e-6, 1e-5)), r[0] = airTableRow(a[0]))

// tone_map.glsl
HUNTED(toneMap, (in(0, 65504), in(0, 65504), in(0, 65504)), (share(), share(), share()),
       Vec3 c = toneMap(Vec3(a[0], a[1], a[2])); r[0] = c.x; r[1] = c.y; r[2] = c.z)
HUNTED(srgbEncode1, (unit({0.0031308f})), (share()), r[0] = srgbEncode1(a[0]))
HUNTED(srgbDecode1, (unit({0.04045f})), (share()), r[0] = srgbDecode1(a[0]))

// terrain_lod.glsl
HUNTED(lodLambda, (in(0, 1e30, {200.0f, 400.0f, 204800.0f})), (out(0, 9.999, 0, 1e-5)),
       Real morph[kTopPatchLevel + 1]; Real at = Real(200.0); for (int l = 0; l <= kTopPatchLevel; ++l) {
         morph[l] = at; at = at * Real(2.0); } r[0] = lodLambda(a[0], morph))
HUNTED(meshHeight, (in(-500, 9000), in(-500, 9000), in(-500, 9000), in(-500, 9000), unit(), unit()),
       (out(-20000, 30000, 1e-6, 4e-3)), r[0] = meshHeight(a[0], a[1], a[2], a[3], a[4], a[5]))

// lattice_noise.glsl, gradient_noise.glsl, cloud_noise.glsl
HUNTED(latticeNoise, (whole(0, 16777216), whole(0, 16777216), unit(), unit()), (out(-2, 2, 0, 1e-5), out(-2, 2, 0, 1e-5)),
       Vec2 n = latticeNoise(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3])); r[0] = n.x; r[1] = n.y)
HUNTED(turnedLatticeNoise, (whole(0, 16777216), whole(0, 16777216), unit(), unit()),
       (out(-2, 2, 0, 1e-5), out(-2, 2, 0, 1e-5)),
       Vec2 n = turnedLatticeNoise(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3])); r[0] = n.x; r[1] = n.y)
HUNTED(simplexNoise, (whole(0, 16777216), whole(0, 16777216), in(-1000, 1000), in(-1000, 1000), in(-1000, 1000)),
       (out(-10, 10, 0, 5e-3), out(-10, 10, 0, 5e-3), out(-10, 10, 0, 5e-3), out(-1.3, 1.3, 0, 2e-3)),
       Vec4 n = simplexNoise(Uvec3(Uint(a[0]), Uint(a[1]), Uint(7u)), Vec3(a[2], a[3], a[4])); r[0] = n.x; r[1] = n.y;
       r[2] = n.z; r[3] = n.w)
HUNTED(octaveNoise2, (whole(0, 8191), whole(0, 8191), whole(0, 16777216), whole(1, 16), whole(1, 64), unit(), unit()),
       (share()),
       r[0] = octaveNoise2(Uvec2(Uint(a[0]), Uint(a[1])), Uvec2(Uint(8192u), Uint(8192u)),
                           Vec2(Real(0.00006103515625), Real(0.00006103515625)), Uint(a[2]), Uint(a[3]), Uint(a[4]),
                           a[5], a[6]))
HUNTED(cutToClouds, (unit(), unit(), in(-1e30, 0)), (share()), r[0] = cutToClouds(a[0], a[1], a[2]))
HUNTED(worley3, (in(0, 0.99999994), in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 16777216)), (share()),
       r[0] = worley3(Vec3(a[0], a[1], a[2]), Uint(a[3]), Uint(a[4])))
HUNTED(perlinFbm3, (in(0, 0.99999994), in(0, 0.99999994), in(0, 0.99999994), whole(1, 32), whole(0, 16777216)),
       (share(5e-5)), r[0] = perlinFbm3(Vec3(a[0], a[1], a[2]), Uint(a[3]), Uint(a[4])))
HUNTED(cloudWeatherNoise, (in(0, 0.99999994), in(0, 0.99999994), whole(0, 16777216)),
       (share(2e-4), share(2e-4), share(2e-4)),
       Vec4 n = cloudWeatherNoise(Vec2(a[0], a[1]), Uint(a[2])); r[0] = n.x; r[1] = n.y; r[2] = n.z)

// land_material.glsl, water.glsl, sun_glitter.glsl
// At 10 km half a float's step turns the finest band by 5e-4, the middle one that bends it by as much again.
HUNTED(rockStrata, (in(-1e4, 1e4), in(-100, 100), in(0, 1e30)), (out(-1, 1, 0, 2e-3), out(-1, 1, 0, 2e-3)),
       Vec2 s = rockStrata(a[0], a[1], a[2]); r[0] = s.x; r[1] = s.y)
HUNTED(alpineBeltHeight, (in(-1e30, 1e30)), (out(-1e30, 1e30, 1e-5, 1e-4)), r[0] = alpineBeltHeight(a[0]))
HUNTED(forestDensity, (in(-1e4, 1e30), unit({0.7f, 0.82f}), in(-1e30, 1e30), signedUnit(), signedUnit(), signedUnit()),
       (share(5e-5)),
       LandNoise n; n.region = a[3]; n.grove = a[4]; n.tuft = a[5]; n.clod = Real(0.0); n.grain = Real(0.0);
       r[0] = forestDensity(a[0], a[1], a[2], n))
HUNTED(landSurface, (in(-1e4, 1e30), unit(), in(-1e30, 1e30), signedUnit(), signedUnit(), signedUnit(), unit(),
                     in(-10, 1), unit()),
       (out(0, 1.2, 0, 2e-4), out(0, 1, 0, 2e-4), out(0, 1, 0, 2e-4), out(0, 1, 0, 2e-4)),
       LandNoise n; n.region = a[3]; n.grove = a[4]; n.tuft = a[5]; n.clod = a[4]; n.grain = a[3]; Crowns crown;
       crown.slope = Vec2(Real(0.0), Real(0.0)); crown.height = a[7]; crown.tree = a[6];
       LandSurface land = landSurface(a[0], a[1], a[2], n, a[5], crown, a[8]); r[0] = land.albedo.y;
       r[1] = land.roughness; r[2] = land.wooded; r[3] = land.open)
HUNTED(stripMarks, (in(-1e5, 1e5), in(-1e3, 1e3), in(100, 750), in(5, 60), in(1e-3, 1e4)), (share(2e-3)),
       r[0] = stripMarks(Vec2(a[0], a[1]), Vec2(a[2], a[3]), a[4]))
HUNTED(mownLand, (in(-900, 900), in(-200, 200), in(100, 750), in(5, 60), in(1e-3, 1e4), signedUnit(), signedUnit(),
                  unit(), unit()),
       (out(0, 1.2, 0, 2e-2), out(0, 1, 0, 2e-2), out(0, 1, 0, 2e-3), out(0, 1, 0, 2e-3)),
       LandNoise n; n.region = a[5]; n.grove = a[5]; n.tuft = a[6]; n.clod = a[5]; n.grain = a[6]; LandSurface land;
       land.albedo = Vec3(a[7], a[7], a[7]); land.roughness = a[8]; land.wooded = a[8]; land.open = a[7];
       land = mownLand(land, Vec2(a[0], a[1]), Vec2(a[2], a[3]), a[4], n); r[0] = land.albedo.y;
       r[1] = land.roughness; r[2] = land.wooded; r[3] = land.open)
HUNTED(seaReflectance, (in(-1, 1), in(0, 1)), (share()), r[0] = seaReflectance(a[0], a[1]))
HUNTED(throughWater, (in(-1e30, 1e30)), (share(), share(), share()),
       Vec3 t = throughWater(a[0]); r[0] = t.x; r[1] = t.y; r[2] = t.z)
HUNTED(waterReflectance, (in(-1e30, 1e30)), (share()), r[0] = waterReflectance(a[0]))
HUNTED(hiddenByWaves, (in(-1, 1), in(0, 1)), (out(0, 1, 0, 1e-5)), r[0] = hiddenByWaves(a[0], a[1]))
HUNTED(risenSine, (in(-1, 1), in(1e-3, 0.1)), (out(0, 1.1, 1e-5, 1e-7)), r[0] = risenSine(a[0], a[1]))
HUNTED(sunGlitter, (direction(), in(-1, 1), in(-1, 1), direction(), in(-1, 1), in(-1, 1), in(1e-3, 0.02),
                    in(0.01, 0.5)),
       (out(0, 1e9, 1e-3, 1e-3)),
       r[0] = sunGlitter(Vec3(a[0], abs(a[1]), a[2]), Vec3(a[3], a[4], a[5]), a[6], Vec2(Real(0.0), Real(0.0)),
                         a[7] * Real(0.8), a[7]))

// spray.glsl
HUNTED(sprayWay, (in(-60, 60), in(-60, 60), in(0, 100, {0.5f}), in(-3, 20), in(0, 100)),
       (out(-2e5, 2e5, 2e-5, 1e-3), out(-2e5, 2e5, 2e-5, 2e-2)),
       Vec3 p = sprayWay(Vec3(a[0], a[1], Real(0.0)), Vec3(Real(5.0), Real(0.0), Real(0.0)), a[2], a[3], a[4]); r[0] = p.x;
       r[1] = p.y)
HUNTED(impactWaveSlope, (in(0.5, 1e4), in(0, 20), in(0.3, 5)), (out(-4, 4, 0, 8e-2)), r[0] = impactWaveSlope(a[0], a[1], a[2]))

// sea_waves.glsl, mirror_ray.glsl
HUNTED(octaveVariance, (in(1e-3, 1e4), in(-10, 100)), (out(0, 1, 2e-5, 1e-12)), r[0] = octaveVariance(a[0], a[1]))
HUNTED(whitecapShare, (in(-10, 1e4)), (out(0, 0.33, 2e-5)), r[0] = whitecapShare(a[0]))
HUNTED(waveProfile, (in(-100, 100)), (out(-1, 1, 0, 2e-4), out(-1, 1, 0, 2e-4)),
       Vec2 p = waveProfile(a[0]); r[0] = p.x; r[1] = p.y)
HUNTED(waveLeftAt, (in(-1e30, 1e30), in(1e-3, 1e3)), (share()), r[0] = waveLeftAt(a[0], a[1]))
HUNTED(normalShare, (in(-1e30, 1e30, {6.0f, -6.0f})), (out(0, 1, 5e-5)), r[0] = normalShare(a[0]))
HUNTED(whitecaps, (in(-6, 6), in(0, 1), in(-3, 3), unit(), in(-8, 0)), (out(0, 1, 2e-4, 1e-9)),
       r[0] = whitecaps(a[0], a[1], a[2], a[3], a[4]))
HUNTED(surfFoam, (in(0, 100), in(0, 1e3), unit()), (out(0, 1, 0, 5e-3)), r[0] = surfFoam(a[0], a[1], a[2]))
HUNTED(waterSlant, (signedUnit()), (out(1, 1.6, 1e-5)), r[0] = waterSlant(a[0]))
HUNTED(intoWater, (direction(), in(-1, 1), in(-1, 1)), (out(-1, 1, 1e-5), out(-1, 0, 1e-5), out(-1, 1, 1e-5)),
       Vec3 d = intoWater(Vec3(a[0], -abs(a[1]), a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0))); r[0] = d.x;
       r[1] = d.y; r[2] = d.z)
HUNTED(caustic, (in(-1e3, 1e3), in(0, 1e3), in(-1e30, 1e30, {0.0f, 3.0f}), unit()), (out(0, 3, 1e-4)),
       r[0] = caustic(a[0], a[1], a[2], a[3]))
HUNTED(mirrorShare, (in(-1e4, 1e4), in(0, 1e4), in(-1, 2), in(-1, 2)), (share(1e-4)),
       r[0] = mirrorShare(a[0], a[1], a[2], a[3]))

// marker.glsl
HUNTED(ringCoverage, (in(0, 1e30), in(1, 1e4), in(0, 1e30)), (share(1e-4)), r[0] = ringCoverage(a[0], a[1], a[2]))
HUNTED(ringFade, (in(-1e30, 1e30), in(0, 1e4)), (share()), r[0] = ringFade(a[0], a[1]))
HUNTED(beamDepth, (direction(), in(-1, 1), in(-1, 1), in(-1e5, 1e5), in(-1e5, 1e5), in(-1e5, 1e5), in(5, 1e3)),
       (out(0, 250, 1e-2, 2e-2)),
       Vec3 d = Vec3(a[0], a[1], a[2]); Vec3 foot = Vec3(a[3], a[4], a[5]); Vec2 t = beamInterval(d, foot, a[6]);
       r[0] = t.y > t.x ? beamOpticalDepth(d, foot, a[6], t.x, t.y) : Real(0.0))

// cloud_medium.glsl, cloud_form.glsl: noise from textures is in [0, 1].
HUNTED(cloudBase, (unit(), unit(), unit(), unit()), (share()), r[0] = cloudBase(Vec4(a[0], a[1], a[2], a[3])))
HUNTED(cloudProfile, (in(-1e30, 1e30, {0.02f, 0.1f, 0.1625f, 0.2f, 0.3f, 0.48f, 0.625f, 0.88f, 0.98f}),
                      in(-1e30, 1e30, {0.5f})),
       (share()), r[0] = cloudProfile(a[0], a[1]))
HUNTED(cloudDensity, (in(0, 0.95), unit(), in(-1, 1), in(0, 0.9), in(-1e30, 1e30), unit(), unit(), unit(), unit()),
       (share(2e-4)),
       CloudMedium m; m.threshold = a[0]; m.coverage = a[1]; m.typeShift = a[2]; m.erosion = a[3];
       r[0] = cloudDensity(m, a[4], Vec4(a[5], Real(0.0), a[6], Real(1.0)), a[7], a[8]))
HUNTED(formedShapeDensity, (in(0, 0.95), unit(), in(-1, 1), in(-1e30, 1e30), unit(), unit(), unit(), unit(),
                            in(0.3, 2.5), in(1, 4), unit()),
       (share(2e-4)),
       CloudMedium m; m.threshold = a[0]; m.coverage = a[1]; m.typeShift = a[2]; m.erosion = Real(0.3);
       CloudForm f; f.profile = Vec4(Real(0.0), Real(20.0), Real(1.0), Real(6.0)); f.own = a[7]; f.anvilBase = a[8];
       f.spread = a[9]; f.anvilThreshold = Real(-0.02); f.taper = a[10]; f.contrast = Real(1.5);
       r[0] = formedShapeDensity(m, f, a[3], a[4], a[5], a[6]))
HUNTED(sunBelowLayers, (in(0, 1e30), in(-1, 1), unit()), (out(0, 1.3)), r[0] = sunBelowLayers(a[0], a[1], a[2]))
HUNTED(layerWeight, (in(-1e15, 1e15)), (out(0, 1)), r[0] = layerWeight(a[0]))

// cloud_light.glsl
HUNTED(raySpanBetween, (in(-1e9, 1e9), in(-1, 1, {1e-12f, -1e-12f}), in(-1e9, 1e9), in(-1e9, 1e9)),
       (out(0, 1e30, 1e-5, 1e-3), out(0, 1e30, 1e-5, 1e-3)),
       RaySpan s = raySpanBetween(a[0], a[1], a[2], a[3]); r[0] = s.begin; r[1] = s.end)
HUNTED(raySpanOfBox, (direction(), in(-1, 1), in(-1, 1), in(-1e7, 1e7), in(-1e7, 1e7), in(-1e7, 1e7), in(0, 1e6)),
       (out(0, 1e30, 1e-4, 2)),
       RaySpan s = raySpanOfBox(Vec3(a[3], a[4], a[5]), Vec3(a[0], a[1], a[2]), Vec3(-a[6], -a[6], -a[6]),
                                Vec3(a[6], a[6], a[6]));
       r[0] = s.end > s.begin ? s.end - s.begin : Real(0.0))
HUNTED(bentRayUnder, (in(-1e5, 1e5), direction(), in(-1, 1), in(-1, 1)), (out(-1e30, 1e30, 1e-4, 1), out(-1e30, 1e30, 1e-4, 1)),
       RaySpan s = bentRayUnder(a[0], a[2], rayBend(Vec3(a[1], a[2], a[3]))); bool some = s.end > s.begin;
       r[0] = some ? s.begin : Real(0.0); r[1] = some ? s.end - s.begin : Real(0.0))
HUNTED(placeOnBentRay, (direction(), in(-1, 1), in(-1, 1), in(0, 1e6)), (out(-2e6, 2e6, 1e-5, 0.5)),
       r[0] = placeOnBentRay(Vec3(a[0], a[1], a[2]), rayBend(Vec3(a[0], a[1], a[2])), a[3]).y)
HUNTED(stepOpacity, (in(-1e30, 1e30, {0.5f})), (out(0, 1, 1e-5, 1e-30)), r[0] = stepOpacity(a[0]))
HUNTED(cloudPhases, (signedUnit(), in(-1, 1), in(-1e30, 1e30)), (out(0, 62.1), out(0, 62.1), out(0, 62.1), out(0, 62.1)),
       Vec4 p = cloudPhases(a[0], a[1], a[2]); r[0] = p.x; r[1] = p.y; r[2] = p.z; r[3] = p.w)
HUNTED(scatteredSun, (in(-1e30, 1e30), signedUnit()), (out(0, 100)),
       r[0] = scatteredSun(cloudPhases(a[1], Real(0.6), Real(0.3)), a[0]))
HUNTED(volumePhases, (signedUnit(), in(-0.9, 0.95), in(-1e30, 1e30)), (out(0, 62.1), out(0, 62.1), out(0, 120), out(0, 1)),
       Vec4 p = volumePhases(a[0], a[1], a[2]); r[0] = p.x; r[1] = p.y; r[2] = p.z; r[3] = p.w)
HUNTED(scatteredSunOfVolume, (in(0, 62), in(-1e30, 1e30), unit(), in(0, 1), in(1, 1000)), (out(0, 200)),
       r[0] = scatteredSunOfVolume(Vec4(a[0], a[0], Real(2.0), Real(0.1)), a[1], a[2], a[3], a[4]))
HUNTED(groundOfVolume, (in(0, 0.3183594, {0.31830987f})), (out(0, 0.3183099)), r[0] = groundOfVolume(a[0]))
HUNTED(sunBelowCloud, (in(-1e30, 1e30)), (share()), r[0] = sunBelowCloud(a[0]))
HUNTED(sunPartBegin, (whole(0, 15), in(0, 1e6)), (out(0, 1e6)), r[0] = sunPartBegin(a[0], Real(16.0), a[1]))
HUNTED(cloudFade, (in(0, 1e30), in(1000, 1e6)), (share()), r[0] = cloudFade(a[0], a[1]))

// cloud_sheet.glsl
HUNTED(sheetCover, (unit(), unit(), unit(), in(1e-6, 0.999999)), (share(1e-4), share(1e-4)),
       SheetCover c = sheetCover(a[0], a[1], a[2], sheetDepthPerNoise(a[3])); r[0] = c.share;
       r[1] = sheetCoverOpacity(c, Real(1.5)))
HUNTED(sheetOpacity, (unit(), unit(), in(0.01, 0.99)), (share()),
       r[0] = sheetOpacity(a[0], a[1], sheetDepthPerNoise(a[2])))
HUNTED(sheetDriftShare, (in(-1e30, 1e30)), (out(0, 2)), r[0] = sheetDriftShare(a[0]))
HUNTED(domePlace, (direction(), in(-1, 1), in(-1, 1), unit()), (out(-10, 10), out(-10, 10), out(-10, 10)),
       Vec3 p = domeTurn(domePlace(Vec3(a[0], a[1], a[2]), a[3])); r[0] = p.x; r[1] = p.y; r[2] = p.z)
HUNTED(domeDistance, (signedUnit(), in(-1e30, 1e30)), (out(0, 1.1e31)), r[0] = domeDistance(a[0], a[1]))

// ground_fog.glsl
HUNTED(groundFogPath, (in(-1e6, 1e6), in(-1e6, 1e6), in(1, 1e4)), (out(0, 1e30, 2e-5, 1e-4)),
       r[0] = groundFogPath(a[0], a[1], abs(a[1]) * Real(1.25), a[2]))
HUNTED(groundFogOpacity, (in(0, 1e30)), (out(0, 1, 1e-5, 1e-30)), r[0] = groundFogOpacity(a[0]))
HUNTED(groundFogDistance, (in(-1e6, 1e6), in(-1, 1), in(1e-3, 10), in(1e-6, 1), in(1, 1e4)), (out(0, 1e13, 2e-4, 1e-3)),
       r[0] = groundFogDistance(a[0], a[1], a[2], a[3], a[4]))

// flash.glsl, lamp.glsl
HUNTED(flashIlluminance, (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30), in(1, 1e6)), (out(0, 1, 1e-5, 1e-20)),
       r[0] = flashIlluminance(Vec3(a[0], a[1], a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0)), a[3]))
HUNTED(flashAirlight, (direction(), in(-1, 1), in(-1, 1), in(-1e6, 1e6), in(-1e6, 1e6), in(-1e6, 1e6), in(1e-3, 1e30),
                       in(1, 1e6)),
       (out(0, 3.15, 1e-3, 1e-12)),
       r[0] = flashAirlight(Vec3(a[3], a[4], a[5]), Vec3(a[0], a[1], a[2]), a[6], a[7]))
HUNTED(flashCloudGlow, (in(0, 1e30), in(1, 1e6), in(1, 2e4)), (out(0, 1.1, 1e-4, 1e-12)),
       r[0] = flashCloudGlow(a[0], a[1], a[2]))
HUNTED(flashAlong, (in(-1e30, 1e30), in(0.1, 100)), (share()), r[0] = flashAlong(a[0], a[1]))
HUNTED(flashAtMost, (in(0, 1e30), in(1, 60000)), (out(0, 60000)), r[0] = flashAtMost(a[0], a[1]))
HUNTED(spotShare, (direction(), in(-1, 1), in(-1, 1), in(0.01, 1.5)), (share(1e-4)),
       r[0] = spotShare(Vec3(Real(0.0), Real(1.0), Real(0.0)), Vec3(a[0], a[1], a[2]), a[3]))
HUNTED(spotIlluminance, (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30), in(0.01, 1.5)), (out(0, 100.1, 1e-4, 1e-12)),
       r[0] = spotIlluminance(Vec3(a[0], a[1], a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0)),
                              Vec3(Real(0.0), Real(-1.0), Real(0.0)), a[3]))
HUNTED(glareShape, (in(0, 1e30), in(0.5, 60)), (out(0, 45)), r[0] = glareShape(a[0], a[1]))

// precipitation.glsl
HUNTED(rainSlope, (in(-1e30, 1e30)), (out(0, 100)), r[0] = rainSlope(a[0]))
HUNTED(fallExtinction, (in(0, 1000), unit()), (out(0, 1)), r[0] = fallExtinction(a[0], a[1]))
HUNTED(dropSpeed, (in(0, 100)), (out(0.1, 9.65)), r[0] = dropSpeed(a[0]))
HUNTED(hailSpeed, (in(0, 200)), (out(0, 100)), r[0] = hailSpeed(a[0]))
HUNTED(fallRate, (in(0, 15000), in(0, 15000), in(0, 500), in(0, 0.02), in(-1e30, 1e30), unit()), (out(0, 1000, 1e-5, 1e-4)),
       FallField f; f.baseM = a[0]; f.topM = a[0] + a[1]; f.groundRate = a[2]; f.evaporation = a[3];
       f.freezingM = Real(2000.0); f.snowShare = Real(0.0); r[0] = fallRate(f, a[4], a[5]))
HUNTED(snowAt, (in(-1e30, 1e30), in(-1e4, 1e4), unit()), (share(1e-4)),
       FallField f; f.baseM = Real(0.0); f.topM = Real(0.0); f.groundRate = Real(0.0); f.evaporation = Real(0.0);
       f.freezingM = a[1]; f.snowShare = a[2]; r[0] = snowAt(f, a[0]))
HUNTED(rainShareOfMap, (unit(), unit(), unit()), (share()), r[0] = rainShareOfMap(a[0], a[1], a[2]))
HUNTED(wetAlbedo, (unit()), (share()), r[0] = wetAlbedo(a[0]))
HUNTED(puddleShare, (unit(), unit({0.985f}), signedUnit()), (share(1e-4)), r[0] = puddleShare(a[0], a[1], a[2]))
HUNTED(fallenSnow, (unit(), in(-1e30, 1e30), in(-1e4, 1e4), unit(), signedUnit()), (share(1e-4)),
       r[0] = fallenSnow(a[0], a[1], a[2], a[3], a[4]))

// atmospheric_optics.glsl
HUNTED(angleBetween, (direction(), in(-1, 1), in(-1, 1), direction(), in(-1, 1), in(-1, 1)), (out(0, 3.1415927, 1e-5)),
       r[0] = angleBetween(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])))
HUNTED(texturePlace, (in(-1e30, 1e30)), (share()), r[0] = texturePlace(a[0], Real(0.35), Real(2.0), Real(256.0)))
HUNTED(iceSlant, (signedUnit(), in(-1e30, 1e5)), (out(1, 1800, 1e-4)), r[0] = iceSlant(a[0], a[1]))
HUNTED(iceScattering, (in(0, 1e30)), (out(0, 0.37)), r[0] = iceScattering(a[0]))
HUNTED(leastSunDogAzimuth, (signedUnit()), (out(0.3, 2.1, 1e-5)), r[0] = leastSunDogAzimuth(a[0]))
HUNTED(sunDogDegrees, (direction(), in(-1, 1), in(-1, 1), direction(), in(-1, 1), in(-1, 1)),
       (out(-180, 180, 1e-4, 1e-3), out(-180, 180, 1e-4, 1e-3), out(-90, 90, 1e-4, 1e-3)),
       Vec3 s = sunDogDegrees(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])); r[0] = s.x; r[1] = s.y; r[2] = s.z)
HUNTED(rainPath, (in(-500, 1e5), signedUnit(), in(0, 1e30), in(0, 1e4), in(0, 1e5), in(-500, 2e4)),
       (out(0, 2e14, 1e-5, 0.1), out(0, 1e5, 1e-4, 0.1)),
       Vec2 p = rainPath(a[0], a[1], a[2], a[3], a[4], a[5]); r[0] = p.x; r[1] = p.y)
HUNTED(rainScattering, (in(0, 1e30)), (out(0, 0.5, 1e-5)), r[0] = rainScattering(a[0]))
HUNTED(rainbowRow, (in(0, 1e30)), (share()), r[0] = rainbowRow(a[0]))

// light_shafts.glsl
HUNTED(shaftSpan, (in(-500, 1e5), signedUnit(), in(-500, 2e4), in(100, 1e5), in(0, 1e30)),
       (out(0, 2e14, 1e-4, 0.1), out(0, 2e14, 1e-4, 0.1)),
       Vec2 s = shaftSpan(a[0], a[1], a[2], a[3], a[4]); r[0] = s.x; r[1] = s.y)
HUNTED(shaftFade, (in(0, 1e30), in(100, 1e5)), (share()), r[0] = shaftFade(a[0], a[1]))
HUNTED(shaftLight, (in(-1e30, 1e30)), (share(), share()), Vec2 s = shaftLight(a[0]); r[0] = s.x; r[1] = s.y)

// ice_clouds.glsl
HUNTED(cirrusDensity, (whole(0, 16777216), unit(), unit(), in(0, 20000), in(-5000, 5000), in(-1, 1), unit(), in(0, 1e30)),
       (out(0, 3, 0, 0.05)),
       IceForm f; f.trailM = a[3]; f.hookM = a[4]; f.threshold = a[5];
       r[0] = cirrusDensity(make_icePlace(Uvec2(Uint(a[0]), Uint(5u)), Vec2(a[1], a[2])), f, a[6], Vec2(a[7], a[7])))
HUNTED(iceStretch, (in(5000, 13000), in(100, 2000), in(1, 20000), direction(), in(-1, 1), in(-1, 1)),
       (out(-1e30, 1e30, 1e-3, 5), out(-1e30, 1e30, 1e-3, 5)),
       IceStretch w = iceStretch(a[2] - a[0], a[2] - a[0] - a[1], a[2], Vec3(a[3], a[4], a[5]));
       bool some = w.end > w.begin; r[0] = some ? w.begin : Real(0.0); r[1] = some ? w.end - w.begin : Real(0.0))
HUNTED(icePhase, (signedUnit()), (out(0, 70)), r[0] = icePhase(a[0]))
HUNTED(iceSunLeft, (in(-1e30, 1e30)), (share(), share()), r[0] = iceSunLeft(a[0]); r[1] = iceSpread(a[0]))

// lab: lengths in edges of a picture's scene.
HUNTED(sphereDistance, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(0, 10)), (out(-10, 2e30, 1e-6, 2e-6)),
       r[0] = sphereDistance(Vec3(a[0], a[1], a[2]), a[3]))
HUNTED(boxDistance, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(0, 10), in(0, 10), in(0, 10)),
       (out(-10, 2e30, 1e-6, 2e-6)), r[0] = boxDistance(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])))
HUNTED(torusDistance, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(0, 10), in(0, 10)),
       (out(-10, 2e30, 1e-6, 2e-6)), r[0] = torusDistance(Vec3(a[0], a[1], a[2]), a[3], a[4]))
HUNTED(cylinderDistance, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(0, 10), in(0, 10)),
       (out(-10, 2e30, 1e-6, 2e-6)), r[0] = cylinderDistance(Vec3(a[0], a[1], a[2]), a[3], a[4]))
HUNTED(sphereGradient, (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30)),
       (out(-1, 1, 1e-6), out(-1, 1, 1e-6), out(-1, 1, 1e-6)),
       Vec3 g = sphereGradient(Vec3(a[0], a[1], a[2])); r[0] = g.x; r[1] = g.y; r[2] = g.z)
HUNTED(boxGradient, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(0, 10), in(0, 10), in(0, 10)),
       (out(-1, 1, 1e-6), out(-1, 1, 1e-6), out(-1, 1, 1e-6)),
       Vec3 g = boxGradient(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])); r[0] = g.x; r[1] = g.y; r[2] = g.z)
HUNTED(torusGradient, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(1e-3, 10)),
       (out(-1, 1, 1e-5), out(-1, 1, 1e-5), out(-1, 1, 1e-5)),
       Vec3 g = torusGradient(Vec3(a[0], a[1], a[2]), a[3]); r[0] = g.x; r[1] = g.y; r[2] = g.z)
HUNTED(smoothUnionOf, (in(-1e9, 1e9), in(-1e9, 1e9), in(0, 1e30)), (out(-1.3e9, 1e9, 1e-5, 1e-6)),
       r[0] = smoothUnionOf(a[0], a[1], a[2]))
HUNTED(rayToSphere, (direction(), in(-1, 1), in(-1, 1), in(-1e6, 1e6), in(-1e6, 1e6), in(-1e6, 1e6), in(1e-3, 10)),
       (out(-1, 2e6, 1e-5, 1e-3)),
       r[0] = rayToSphere(Vec3(a[3], a[4], a[5]), Vec3(a[0], a[1], a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0)), a[6]))
HUNTED(phongLight, (direction(), in(-1, 1), in(-1, 1), direction(), in(-1, 1), in(-1, 1), in(0, 1000)),
       (share(1e-3), share(1e-3)),
       PhongShares s; s.ambient = Real(0.1); s.diffuse = Real(1.0); s.specular = Real(1.0); s.shininess = a[6];
       Vec3 n = Vec3(a[0], a[1], a[2]); Vec2 p = phongLight(s, n, Vec3(a[3], a[4], a[5]), n); r[0] = p.x; r[1] = p.y)
HUNTED(opennessAt, (in(-100, 100), in(0, 100), in(-100, 100), in(0, 1), in(0, 10)), (share(1e-3)),
       r[0] = opennessAt(kSmoothScene, Real(0.3), Vec3(a[0], a[1], a[2]), Vec3(Real(0.0), Real(1.0), Real(0.0)), a[3], 5,
                         a[4]))
HUNTED(shadeAlong, (in(-10, 10), in(0, 10), in(-10, 10), in(0, 1), in(0, 1e30)), (share(1e-3)),
       r[0] = shadeAlong(kBallScene, Real(0.0), Vec3(a[0], a[1], a[2]), Vec3(Real(0.6), Real(0.8), Real(0.0)), a[3],
                         Real(20.0), a[4], 64).light)
HUNTED(orbitRay, (in(-10, 10), in(-1.57, 1.57), in(-2, 2), in(-1, 1), in(0.1, 10)),
       (out(-1, 1, 1e-5), out(-1, 1, 1e-5), out(-1, 1, 1e-5)),
       Vec3 d = orbitRay(make_orbit(Vec3(Real(0.0), Real(0.0), Real(0.0)), a[0], a[1], Real(5.0)), Vec2(a[2], a[3]), a[4]);
       r[0] = d.x; r[1] = d.y; r[2] = d.z)
HUNTED(heatColor, (in(-1e30, 1e30)), (share(), share(), share()),
       Vec3 c = heatColor(a[0]); r[0] = c.x; r[1] = c.y; r[2] = c.z)
HUNTED(perlinPlane, (in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 16777216)), (out(-1.5, 1.5, 0, 5e-5)),
       r[0] = perlinPlane(Vec2(a[0], a[1]), Uint(a[2]), Uint(a[3])))
HUNTED(tiledVoronoi, (in(-1e6, 1e6), in(-1e6, 1e6), whole(1, 64), whole(0, 16777216)), (out(0, 1.5, 0, 1e-5)),
       r[0] = tiledVoronoi(Vec2(a[0], a[1]), int(a[2]), Uint(a[3]), true))
// Of 27 cells: where the nearest point lies further, Worley noise has a step at the border of a cell, here of .025.
HUNTED(cubeNoises, (in(-1e6, 1e6), in(-1e6, 1e6), in(-1e6, 1e6), whole(1, 16), whole(0, 16777216)),
       (share(1e-4), out(-0.3, 1, 0, 5e-2)),
       CubeCloud c; c.cells = Uint(a[3]); c.seed = Uint(a[4]); c.perlinThreshold = Real(0.5);
       c.perlinMultiplier = Real(2.0); c.voronoiThreshold = Real(0.5); c.voronoiMultiplier = Real(2.0);
       Vec2 n = cubeNoises(c, Vec3(a[0], a[1], a[2])); r[0] = n.x; r[1] = n.y)
HUNTED(forwardedSun, (in(0, 1e30), in(0, 10), in(0, 100)), (share(1e-4)), r[0] = forwardedSun(a[0], a[1], a[2]))
#include "support/hunt_parts.inl"
