// Continues hunt_functions.inl: the parts that those functions are made of, each over the whole of its own contract,
// which is wider than what its callers ask of it.

// guards.glsl, tone_map.glsl, guard_marks.glsl, impostor.glsl
HUNTED(fractionOf, (in(-1e30, 1e30)), (out(0, 0.5, 0, 1e-6)),
       r[0] = abs(fractionOf(a[0]) - Real(0.5)))  // 0 and what is nearly 1 are alike
HUNTED(acesCurve, (in(0, 1e5)), (out(-4e-4, 1.02, 1e-5, 2e-7)), r[0] = acesCurve(Vec3(a[0], a[0], a[0])).y)
HUNTED(guardOfChannel, (in(-1e30, 1e30, {65504.0f, -65504.0f, 60000.0f})), (out(0, 3)), r[0] = guardOfChannel(a[0]))
HUNTED(hemiOctOf, (direction(), in(-1, 1), in(-1, 1)), (share(), share()),
       Vec2 s = hemiOctOf(Vec3(a[0], abs(a[1]), a[2])); r[0] = s.x; r[1] = s.y)
HUNTED(directionOfHemiOct, (direction(), in(-1, 1), in(-1, 1)), (out(-1, 1), out(0, 1), out(-1, 1)),
       Vec3 d = directionOfHemiOct(hemiOctOf(Vec3(a[0], abs(a[1]), a[2]))); r[0] = d.x; r[1] = d.y; r[2] = d.z)

// atmosphere.glsl, atmosphere_shell.glsl, atmospheric_optics.glsl
HUNTED(opticalDepthBetween, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), in(-1e30, 1e30), in(0, 1e30)),
       (out(0, 1e29, 2e-5, 1e-6), out(0, 1e29, 2e-5, 1e-6), out(0, 1e29, 2e-5, 1e-6)),
       Vec3 d = opticalDepthBetween(make_atmosphere(a[0], a[1], Real(0.7)), a[2], a[3], a[4]); r[0] = d.x; r[1] = d.y;
       r[2] = d.z)
HUNTED(opticalDepthAbove, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30)), (out(0, 400, 2e-5), out(0, 400, 2e-5), out(0, 400, 2e-5)),
       Vec3 d = opticalDepthAbove(make_atmosphere(a[0], a[1], Real(0.7)), a[2]); r[0] = d.x; r[1] = d.y; r[2] = d.z)
HUNTED(sunIlluminanceAt, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), signedUnit()),
       (out(0, 200, 1e-4, 1e-3), out(0, 200, 1e-4, 1e-3), out(0, 200, 1e-4, 1e-3)),
       Vec3 e = sunIlluminanceAt(make_atmosphere(a[0], a[1], Real(0.7)), a[2], a[3]); r[0] = e.x; r[1] = e.y; r[2] = e.z)
HUNTED(shellAirAt, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30, {10000.0f, 25000.0f, 40000.0f})),
       (out(0, 1e-4, 2e-5, 1e-10), out(0, 0.04, 2e-5, 1e-8), out(0, 0.041, 2e-5, 1e-8)),
       ShellAir here = shellAirAt(make_atmosphere(a[0], a[1], Real(0.7)), a[2]); r[0] = here.rayleigh.z; r[1] = here.haze;
       r[2] = here.extinction.y)
HUNTED(elevationOf, (direction(), in(-1, 1), in(-1, 1)), (out(-1.5707964, 1.5707964)),
       r[0] = elevationOf(Vec3(a[0], a[1], a[2])))

// cloud_medium.glsl, cloud_form.glsl
HUNTED(trapezium, (in(-1e30, 1e30), in(-10, 10), in(1e-3, 10), in(0, 10), in(1e-3, 10)), (share(1e-4)),
       r[0] = trapezium(a[0], a[1], a[1] + a[2], a[1] + a[2] + a[3], a[1] + a[2] + a[3] + a[4]))
HUNTED(coveredDensity, (unit(), unit()), (share(1e-4)), r[0] = coveredDensity(a[0], a[1]))
HUNTED(ownProfile, (in(-1e30, 1e30), unit(), in(1, 50), unit(), in(1, 50)), (share(5e-5)),
       CloudForm f; f.profile = Vec4(a[1], a[2], a[3], a[4]); r[0] = ownProfile(f, a[0]))
HUNTED(formedCover, (in(-1e30, 1e30), in(0.3, 2.5), in(1, 4), unit()), (out(0, 4, 1e-5, 1e-4)),
       CloudForm f; f.anvilBase = a[1]; f.spread = a[2]; f.taper = a[3]; r[0] = formedCover(f, a[0]))
HUNTED(formedMap, (in(-1e30, 1e30), in(0.3, 2.5), unit(), unit()), (share(1e-4)),
       CloudForm f; f.anvilBase = a[1]; r[0] = formedMap(f, a[0], a[2], a[3]))
HUNTED(formedLocalCoverage, (unit(), unit(), in(0, 10), unit()), (share(1e-4)),
       CloudMedium m; m.threshold = Real(0.2); m.coverage = a[0]; CloudForm f; f.contrast = a[2];
       r[0] = formedLocalCoverage(m, f, a[1], a[3]))
HUNTED(erodedDensity, (in(0, 0.9), in(-1e30, 1e30), unit(), unit()), (share(1e-4)),
       CloudMedium m; m.threshold = Real(0.2); m.coverage = Real(0.5); m.erosion = a[0]; m.typeShift = Real(0.0);
       r[0] = erodedDensity(m, a[1], a[2], a[3]))
HUNTED(cloudShapeEstimate, (in(0, 0.95), unit(), in(-1, 1), in(-1e30, 1e30), unit(), unit(), unit()), (out(-21, 1, 0, 2e-4)),
       CloudMedium m; m.threshold = a[0]; m.coverage = a[1]; m.typeShift = a[2]; m.erosion = Real(0.3);
       r[0] = cloudShapeEstimate(m, a[3], a[4], a[5], a[6]))

// cloud_light.glsl, cloud_noise.glsl, cloud_sheet.glsl
HUNTED(bentRayInLayer, (in(-500, 1e5), in(0, 12000), in(1, 12000), direction(), in(-1, 1), in(-1, 1), in(0, 1e6)),
       (out(0, 1e6, 1e-4, 5), out(0, 1e6, 1e-4, 5)),
       Vec3 d = Vec3(a[3], a[4], a[5]); Real bend = rayBend(d);
       RaySpan s = bentRayInLayer(bentRayUnder(a[0] - a[1] - a[2], d.y, bend), bentRayUnder(a[0] - a[1], d.y, bend), a[6]);
       bool some = s.end > s.begin; r[0] = some ? s.begin : Real(0.0); r[1] = some ? s.end - s.begin : Real(0.0))
HUNTED(scatteredSky, (in(-1e30, 1e30)), (out(0.039, 0.1592), out(0, 0.1592)),
       r[0] = scatteredSky(a[0]); r[1] = scatteredGround(a[0]))
HUNTED(cloudShapeNoise, (in(0, 0.99999994), in(0, 0.99999994), in(0, 0.99999994), whole(0, 16777216)),
       (share(4e-4), share(4e-4), share(4e-4), share(4e-4)),
       Vec4 n = cloudShapeNoise(Vec3(a[0], a[1], a[2]), Uint(a[3])); r[0] = n.x; r[1] = n.y; r[2] = n.z; r[3] = n.w)
HUNTED(worley2, (in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 16777216)), (out(0, 1, 0, 2e-5)),
       r[0] = worley2(Vec2(a[0], a[1]), Uint(a[2]), Uint(a[3])))
HUNTED(perlin3, (in(0, 0.99999994), in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 16777216)),
       (out(-1.2, 1.2, 0, 5e-5)), r[0] = perlin3(Vec3(a[0], a[1], a[2]), Uint(a[3]), Uint(a[4])))
HUNTED(sheetPath, (in(-1, 1, {0.3f, -0.3f})), (out(1, 3.3333335)), r[0] = sheetPath(a[0]))
HUNTED(sheetDepth, (unit(), unit(), in(1e-6, 0.999999)), (out(0, 3600, 1e-5, 1e-3)),
       r[0] = sheetDepth(a[0], a[1], sheetDepthPerNoise(a[2])))

// gradient_noise.glsl, lattice.glsl
HUNTED(gradientNoise2, (whole(0, 63), whole(0, 63), unit(), unit(), whole(0, 16777216)), (out(-1.5, 1.5, 0, 1e-5)),
       r[0] = gradientNoise2(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3]), Uint(64u), Uint(a[4])))
HUNTED(gradientNoise3, (whole(0, 63), whole(0, 63), whole(0, 63), unit(), unit(), unit(), whole(0, 16777216)),
       (out(-1.5, 1.5, 0, 1e-5)),
       r[0] = gradientNoise3(Uvec3(Uint(a[0]), Uint(a[1]), Uint(a[2])), Vec3(a[3], a[4], a[5]), Uint(64u), Uint(a[6])))
// Near its end the polynomial is up to a millionth beyond 1.
HUNTED(smoothStep5, (unit()), (out(0, 1.000002, 1e-5, 2e-6)), r[0] = smoothStep5(a[0]))

// ground_picture.glsl, grass_strip.glsl, sun_glitter.glsl, lamp.glsl, precipitation.glsl, marker.glsl
HUNTED(groundPictureShare, (unit(), in(0, 1e30), unit(), unit(), in(1, 1e4)), (share()),
       r[0] = groundPictureShare(a[0], a[1], a[2], a[3], a[4]))
HUNTED(groundPictureLevel, (in(1e-6, 1e30), in(1e-3, 1e3)), (out(0, 120, 1e-5, 2e-6)), r[0] = groundPictureLevel(a[0], a[1]))
HUNTED(stripCover, (in(-1e5, 1e5), in(0.1, 1e3), in(1e-3, 1e4)), (share(1e-4)), r[0] = stripCover(a[0], a[1], a[2]))
HUNTED(hiddenShare, (unit(), unit(), unit()), (share()), r[0] = hiddenShare(a[0], a[1], a[2]))
HUNTED(lampIlluminance, (in(-1e30, 1e30), in(-1e30, 1e30), in(-1e30, 1e30), direction(), in(-1, 1), in(-1, 1)),
       (out(0, 101, 1e-4, 1e-12)), r[0] = lampIlluminance(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])))
HUNTED(rainExtinction, (in(-1e30, 1000)), (out(0, 1)), r[0] = rainExtinction(a[0]) + snowExtinction(a[0]))
HUNTED(spheresExtinction, (in(-1e30, 1000), in(0.1, 200), in(0.1, 100), in(0.1, 1)), (out(0, 900)),
       r[0] = spheresExtinction(a[0], a[1], a[2], a[3]))
HUNTED(beamDensity, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), in(5, 1e3)), (share(1e-4)),
       r[0] = beamDensity(Vec3(a[0], a[1], a[2]), a[3]))
HUNTED(beamOpacity, (in(0, 1e30)), (out(0, 1, 1e-5, 2e-7)), r[0] = beamOpacity(a[0]))

// light_shafts.glsl
HUNTED(shaftPlace, (in(0, 2e14), in(0, 2e14), unit()), (out(0, 4.1e14, 1e-5, 1e-6)),
       r[0] = shaftPlace(Vec2(a[0], a[0] + a[1]), a[2]))
HUNTED(shaftLoss, (in(100, 5e5), in(50, 1e4), in(-1e30, 1e30), in(0, 62), in(-1e30, 1e30), signedUnit()),
       (out(-0.01, 2.5, 1e-4, 3e-7)),
       r[0] = shaftLoss(shellAirAt(make_atmosphere(a[0], a[1], Real(0.7)), a[2]), Vec2(Real(0.1), a[3]), shaftLight(a[4]),
                        a[5]).y)

// ice_clouds.glsl
HUNTED(cirrostratusDensity, (whole(0, 16777216), unit(), unit(), in(0, 20000), in(-5000, 5000), in(-1, 1), unit(), in(0, 1e30)),
       (out(0, 4, 0, 0.05)),
       IceForm f; f.trailM = a[3]; f.hookM = a[4]; f.threshold = a[5];
       r[0] = cirrostratusDensity(make_icePlace(Uvec2(Uint(a[0]), Uint(5u)), Vec2(a[1], a[2])), f, a[6], Vec2(a[7], a[7])))
HUNTED(cirrocumulusDensity, (whole(0, 16777216), unit(), unit(), in(0, 20000), in(-5000, 5000), in(-1, 1), unit(), in(0, 1e30)),
       (out(0, 1, 0, 0.05)),
       IceForm f; f.trailM = a[3]; f.hookM = a[4]; f.threshold = a[5];
       r[0] = cirrocumulusDensity(make_icePlace(Uvec2(Uint(a[0]), Uint(5u)), Vec2(a[1], a[2])), f, a[6], Vec2(a[7], a[7])))
HUNTED(iceShown, (in(0, 1e30), in(0, 1e30)), (share(1e-4)), r[0] = iceShown(Vec2(a[0], a[1]), Real(11.0), Real(113.0)))
HUNTED(icePlaceOnStretch, (in(5000, 13000), in(100, 2000), in(1, 20000), direction(), in(-1, 1), in(-1, 1), unit()),
       (out(0, 1e30, 1e-3, 5)),
       IceStretch w = iceStretch(a[2] - a[0], a[2] - a[0] - a[1], a[2], Vec3(a[3], a[4], a[5]));
       r[0] = w.end > w.begin ? icePlaceOnStretch(w, a[6]) : Real(0.0))

// places.glsl
HUNTED(blocksOf, (in(-1280, 1280), in(-1280, 1280), whole(0, 16777216)), (out(-9, 25, 0, 1e-4), out(-9, 25, 0, 1e-4)),
       Vec2 b = blocksOf(Vec2(a[0], a[1]), Uint(a[2]) * Uint(0x9e3779b1u)); r[0] = b.x; r[1] = b.y)
HUNTED(placeInBlocks, (in(0, 16), in(0, 16), whole(0, 16777216)), (out(-660, 660, 0, 2e-2), out(-660, 660, 0, 2e-2)),
       Vec2 p = placeInBlocks(Vec2(a[0], a[1]), Uint(a[2]) * Uint(0x9e3779b1u)); r[0] = p.x; r[1] = p.y)
HUNTED(borderKind, (whole(0, 16777216), whole(0, 15), whole(0, 15), whole(0, 1)), (out(0, 2)),
       r[0] = Real(borderKind(Uint(a[0]), int(a[1]), int(a[2]), int(a[3]))))
HUNTED(fieldPlotAt, (whole(0, 15), whole(0, 15), in(0.05, 0.95), in(0.05, 0.95), whole(0, 16777216)), (out(3.9, 40.1, 0, 1e-3)),
       r[0] = fieldPlotAt(Vec2(a[0] + a[2], a[1] + a[3]), Uint(a[4]), false).toBorder)
HUNTED(awayFromWay, (in(-1e4, 1e4), in(-1e4, 1e4), in(-1e4, 1e4), in(-1e4, 1e4), in(-60, 60), in(-60, 60)), (out(0, 3e4, 1e-5, 2e-2)),
       r[0] = awayFromWay(Vec2(a[0], a[1]), Vec2(a[2], a[3]), Vec2(a[2] + a[4], a[3] + a[5])))
HUNTED(lineShare, (in(-1280, 1280), in(0.2, 20), in(0.01, 1), in(1e-3, 1e4)), (share(2e-1)),
       r[0] = lineShare(a[0], a[1], a[1] * a[2], a[3]))
HUNTED(houseOf, (whole(0, 16777216), whole(0, 3)), (out(5, 12.1, 1e-5), out(5, 24.1, 1e-5), out(3, 14.1, 1e-5), out(2, 9.1, 1e-5)),
       House h = houseOf(Uint(a[0]) * Uint(0x9e3779b1u), int(a[1])); r[0] = h.widthM; r[1] = h.lengthM; r[2] = h.wallM;
       r[3] = h.roofM)

// land_material.glsl, woods.glsl
HUNTED(smoothRise, (in(-1e4, 1e4), in(1e-3, 1e4), in(-1e30, 1e30)), (share(1e-4)), r[0] = smoothRise(a[0], a[0] + a[1], a[2]))
HUNTED(bandWave, (in(-1e4, 1e4)), (out(-1, 1, 0, 1e-5), out(-8, 8, 0, 1e-4)), Vec2 w = bandWave(a[0]); r[0] = w.x; r[1] = w.y)
HUNTED(crownOf, (whole(0, 16777216), in(-1, 1), in(-1, 1)), (out(-20, 1, 0, 1e-4), out(-15, 15, 0, 1e-4), out(-15, 15, 0, 1e-4)),
       Crowns c = crownOf(Uint(a[0]) * Uint(0x9e3779b1u), Vec2(a[1], a[2])); r[0] = c.height; r[1] = c.slope.x;
       r[2] = c.slope.y)
HUNTED(crownsAt, (whole(0, 16777216), whole(0, 16777216), unit(), unit()), (out(-20, 1, 0, 1e-4)),
       r[0] = crownsAt(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3])).height)
HUNTED(beltHeight, (in(-1e4, 1e30), signedUnit(), signedUnit()), (out(-1.2e4, 1.2e30, 1e-5, 1e-3)),
       LandNoise n; n.region = Real(0.0); n.grove = a[1]; n.tuft = a[2]; r[0] = beltHeight(a[0], n))
HUNTED(leafiness, (in(-1e4, 1e30), signedUnit(), signedUnit()), (share(1e-5)),
       LandNoise n; n.region = a[1]; n.tuft = a[2]; r[0] = leafiness(a[0], n))
// 100 km away a float's step is a six thousandth of the finest cell.
HUNTED(chunkNoise, (whole(0, 1048575), whole(0, 1048575), in(-1e5, 1e5), in(-1e5, 1e5), whole(1, 24)),
       (out(-2, 2, 0, 5e-4), out(-2, 2, 0, 5e-4)),
       Vec2 n = chunkNoise(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3]), int(a[4])); r[0] = n.x; r[1] = n.y)
HUNTED(woodNoise, (whole(0, 1048575), whole(0, 1048575), in(-1e5, 1e5), in(-1e5, 1e5)),
       (out(-2, 2, 0, 5e-4), out(-2, 2, 0, 5e-4), out(-2, 2, 0, 5e-4)),
       LandNoise n = woodNoise(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3])); r[0] = n.region; r[1] = n.grove;
       r[2] = n.tuft)
HUNTED(treeStem, (whole(0, 16777216)), (out(-2.56, 2.56), out(-2.56, 2.56)),
       Vec2 s = treeStem(Uint(a[0]) * Uint(0x9e3779b1u)); r[0] = s.x; r[1] = s.y)
HUNTED(treeOf, (whole(0, 16777216), in(-1e4, 1e30), unit(), signedUnit(), signedUnit(), signedUnit(), unit()),
       (out(0, 26, 0, 1e-2), out(0, 5.4, 0, 1e-2), out(0, 1), out(0, 1, 0, 1e-4)),
       LandNoise n; n.region = a[3]; n.grove = a[4]; n.tuft = a[5]; n.clod = Real(0.0); n.grain = Real(0.0);
       Tree t = treeOf(Uint(a[0]) * Uint(0x9e3779b1u), a[1], a[2], n, a[6]); r[0] = t.heightM; r[1] = t.radiusM;
       r[2] = t.turn; r[3] = t.leafy)
HUNTED(treeWidthAt, (whole(0, 2), in(0, 26), in(0, 5.4), in(-1e30, 1e30)), (out(0, 5.4, 1e-4, 1e-3)),
       Tree t; t.kind = int(a[0]); t.heightM = a[1]; t.radiusM = a[2]; r[0] = treeWidthAt(t, a[3]))

// ground_cover.glsl
HUNTED(coverCellM, (whole(0, 3)), (out(0.6, 4.8, 1e-5)), r[0] = coverCellM(int(a[0])))
HUNTED(coverReach, (whole(0, 3), in(0, 1e4), in(-1, 1e4)), (out(0, 1e4, 1e-5)), r[0] = coverReach(int(a[0]), a[1], a[2]))
HUNTED(coverGrown, (in(0, 1e30), in(1, 1e4), unit()), (share(1e-4)), r[0] = coverGrown(a[0], a[1], a[2]))
HUNTED(coverStem, (whole(0, 16777216)), (out(0, 1), out(0, 1)),
       Vec2 s = coverStem(Uint(a[0]) * Uint(0x9e3779b1u)); r[0] = s.x; r[1] = s.y)
HUNTED(reedShare, (in(-1e4, 1e30), unit(), signedUnit(), signedUnit()), (share(1e-4)),
       CoverSite s; s.heightM = a[0]; s.normalUp = a[1]; s.tuft = a[2]; s.patches = Vec2(a[3], a[2]); r[0] = reedShare(s))
HUNTED(grassShare, (in(-1e4, 1e30), unit(), unit(), unit(), unit()), (share(1e-4)),
       CoverSite s; s.heightM = a[0]; s.normalUp = a[1]; s.wooded = a[2]; s.land.litter = a[3] * a[4];
       s.land.scree = Real(0.0); s.land.rock = a[4] * (Real(1.0) - a[3]); s.land.sand = Real(0.0);
       s.land.snow = Real(0.0); r[0] = grassShare(s))
// Its kind and size turn at borders between kinds: Q07 has their bounds.
HUNTED(coverOf, (whole(0, 16777216), whole(0, 3), signedUnit(), signedUnit(), signedUnit()), (out(0, 1), out(0, 1, 0, 1e-5)),
       CoverSite s; s.heightM = Real(40.0); s.normalUp = Real(1.0); s.wooded = Real(0.0); s.land.litter = Real(0.0);
       s.land.scree = Real(0.0); s.land.rock = Real(0.0); s.land.sand = Real(0.0); s.land.snow = Real(0.0);
       s.region = a[2]; s.tuft = a[3]; s.patches = Vec2(a[3], a[4]);
       Cover c = coverOf(Uint(a[0]) * Uint(0x9e3779b1u), int(a[1]), s); r[0] = c.turn; r[1] = c.dry)

// ground_detail.glsl
HUNTED(detailShare, (in(0, 1e30), in(0, 10)), (share(1e-4)), r[0] = detailShare(a[0], a[1]))
HUNTED(detailFootprint, (in(0, 1e9), in(1e-6, 1), signedUnit()), (out(0, 1e11, 1e-5)), r[0] = detailFootprint(a[0], a[1], a[2]))
HUNTED(detailPick, (unit(), unit(), unit(), unit(), unit(), unit()), (out(0, 0.5, 1e-5, 1e-6)),
       r[0] = detailPick(a[0], a[1], a[2], a[3], a[4], a[5]).share)
HUNTED(detailPlanes, (direction(), in(-1, 1), in(-1, 1)), (out(0, 0.5, 1e-3, 1e-4)),
       r[0] = detailPlanes(Vec3(a[0], a[1], a[2])).share)
HUNTED(detailPieces, (whole(0, 16777216), whole(0, 16777216), unit(), unit(), whole(0, 16777216)),
       (share(1e-4), share(1e-4), share(1e-4)),
       DetailPieces p = detailPieces(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3]), Uint(a[4])); r[0] = p.weights.x;
       r[1] = p.weights.y; r[2] = p.weights.z)
HUNTED(detailMip, (in(0, 120)), (out(0, 120, 1e-5, 2e-6)), r[0] = detailMip(a[0]))
HUNTED(rockBeds, (in(-1e4, 1e4), in(1, 100), whole(0, 16777216), in(0, 1e30)), (out(-1, 1, 0, 2e-3), out(-31, 31, 1e-2, 2e-2)),
       Vec2 b = rockBeds(a[0], a[1], Uint(a[2]), a[3]); r[0] = b.x; r[1] = b.y)
// How far a block is moved changes at once where the next begins.
HUNTED(rockFaults, (whole(0, 16777216), whole(0, 16777216), unit(), unit(), signedUnit()), (out(0, 96, 1e-4, 1e-3)),
       r[0] = rockFaults(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3]), a[4]).y)
HUNTED(rockLayers, (in(-1e4, 1e4), in(-16, 16), in(0, 96), signedUnit(), signedUnit(), signedUnit(), signedUnit(), in(0, 1e30)),
       (out(-1, 1, 0, 2e-2), out(-6, 6, 1e-2, 0.15), out(0, 0.8, 0, 5e-3)),
       LandNoise n; n.region = a[3]; n.grove = a[4]; n.tuft = a[5]; n.clod = a[6]; n.grain = Real(0.0);
       RockLayers l = rockLayers(a[0], Vec2(a[1], a[2]), n, a[7]); r[0] = l.tone; r[1] = l.ledge; r[2] = l.rubble)

// erosion_lines.glsl
HUNTED(erosionShown, (in(1, 1e3), in(0, 1e30)), (share(1e-5)), r[0] = erosionShown(a[0], a[1]))
HUNTED(erosionStrength, (unit(), signedUnit(), signedUnit()), (share(1e-4)),
       LandNoise n; n.region = Real(0.0); n.grove = a[1]; n.tuft = a[2]; n.clod = Real(0.0); n.grain = Real(0.0);
       r[0] = erosionStrength(a[0], n))
HUNTED(erosionCut, (whole(0, 16777216), whole(0, 16777216), unit(), unit(), signedUnit(), signedUnit(), whole(0, 16777216)),
       (share(2e-3), out(-15, 15, 0, 2e-2)),
       Vec2 c = erosionCut(Uvec2(Uint(a[0]), Uint(a[1])), Vec2(a[2], a[3]), Vec2(a[4], a[5]), Uint(a[6])); r[0] = c.x;
       r[1] = c.y)

// lab
HUNTED(blendOf, (in(-1e18, 1e18), in(-1e18, 1e18), unit()), (out(-1e18, 1e18, 1e-5)), r[0] = blendOf(a[0], a[1], a[2]))
HUNTED(planeDistance, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), direction(), in(-1, 1), in(-1, 1), in(-1e3, 1e3)),
       (out(-4e18, 4e18, 1e-5, 1e-5)),
       r[0] = planeDistance(Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5]), a[6]))
HUNTED(drilledBox, (in(-1e18, 1e18), in(-1e18, 1e18), in(-1e18, 1e18), unit()), (out(-3, 3e18, 1e-5, 1e-5)),
       r[0] = drilledBox(Vec3(a[0], a[1], a[2]), a[3]))
HUNTED(sceneDistance, (whole(0, 9), in(0, 1), in(-100, 100), in(-100, 100), in(-100, 100)), (out(-101, 200, 1e-5, 1e-5)),
       r[0] = sceneDistance(int(a[0]), a[1], Vec3(a[2], a[3], a[4])))
HUNTED(rayToFloor, (direction(), in(-1, 1), in(-1, 1), in(-1e6, 1e6)), (out(-1, 1e38, 1e-5)),
       r[0] = rayToFloor(Vec3(Real(0.0), a[3], Real(0.0)), Vec3(a[0], a[1], a[2])))
HUNTED(nextStep, (whole(0, 2), in(0, 10), in(0, 1), in(0, 1e30), in(-1e30, 1e30), in(0, 1e30), in(0, 10)),
       (out(-10, 3e30, 1e-5), out(0, 10), out(0, 2)),
       March m = make_march(a[6]); m.t = a[5]; m = nextStep(int(a[0]), make_marchLimits(a[1], a[2], a[3]), a[4], m);
       r[0] = m.t; r[1] = m.stride; r[2] = Real(m.state))
HUNTED(perlinSpace, (in(0, 0.99999994), in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 16777216)),
       (out(-1.5, 1.5, 0, 5e-5)), r[0] = perlinSpace(Vec3(a[0], a[1], a[2]), Uint(a[3]), Uint(a[4])))
HUNTED(perlinFractal, (in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 5), unit(), whole(0, 16777216)),
       (out(-1.5, 1.5, 0, 5e-4)), r[0] = perlinFractal(Vec2(a[0], a[1]), Uint(a[2]), Uint(a[3]), a[4], Uint(a[5])))
HUNTED(voronoiFractal, (in(0, 0.99999994), in(0, 0.99999994), whole(1, 64), whole(0, 5), unit(), whole(0, 16777216)),
       (out(0, 1.4142136, 0, 5e-4)), r[0] = voronoiFractal(Vec2(a[0], a[1]), Uint(a[2]), Uint(a[3]), a[4], Uint(a[5])))
HUNTED(cornerWeights, (unit(), unit()), (out(-2e-6, 1.000002, 0, 3e-6), out(-2e-6, 1.000002, 0, 3e-6), out(-2e-6, 1.000002, 0, 3e-6), out(-2e-6, 1.000002, 0, 3e-6)),
       Vec4 w = cornerWeights(Vec2(a[0], a[1]), true); r[0] = w.x; r[1] = w.y; r[2] = w.z; r[3] = w.w)
HUNTED(afterStep, (unit(), in(-1e30, 1e30), in(-1e30, 1e30)), (out(0, 1, 1e-5, 1e-30), out(0, 1, 1e-5, 1e-30), out(0, 1)),
       CubeLight l = make_cubeLight(); l.transmittance = a[0]; l = afterStep(l, a[1], a[2]); r[0] = l.sun; r[1] = l.sky;
       r[2] = l.transmittance)
