// The sea with the waves of render::SeaWaves, whitecaps, and the shore: in place of seaLight() of terrain/sea.glsl, which
// includes it with WATER_DETAIL.
#include "terrain/sea_waves.glsl"
#include "terrain/sea_floor.glsl"

const float kShoreM = 900.0;    // so far away the ground below is asked for, and the shore shown
const float kFoamAlbedo = 0.55;  // of fresh foam (Koepke 1984)

// As Waves, of the drawn waves of the wind.
Waves wavesOf(SeaWaveSum sum, float gust) {
  float rough = seaState.x * gust;
  // Of both axes, waves that are drawn as their sum: what they have is not in the statistics a second time.
  float hidden2 = max(seaState.x * seaState.x - 0.5 * sum.variance, 1e-4) * gust * gust;
  Waves waves;
  waves.slope = sum.slope * gust;
  waves.hidden = sqrt(hidden2);
  waves.all = sqrt(hidden2 + 0.5 * sum.left * gust * gust);
  return waves;
}

// The ground below, asked for near the eye alone.
SeaFloor nearSeaFloor(vec2 place, float distanceM, float straightM) {
  SeaFloor asked = seaFloorAt(place, distanceM);
  float known = smoothstep(kShoreM, 0.75 * kShoreM, distanceM);
  SeaFloor ground = SeaFloor(max(mix(straightM, asked.depthM, known), 0.0), asked.fall * known);
  return ground;
}

// What the shore does: foam of bores and of the edge, and how much of the film of water there is.
struct Shore {
  float foam;
  float film;
  vec2 slope;
};

Shore shoreAt(SeaFloor ground, vec2 place, vec2 noise, float footprint) {
  Shore shore;
  float steep = max(length(ground.fall), 1e-4);
  float ragged = 0.6 * noise.x;
  float phase = surfPhase(ground.depthM, seaState.z + ragged);
  float shown = waveShown(pow(surfPhasePerMetre(ground.depthM) * steep * footprint, 2.0));
  float bores = saturate(1.0 - ground.depthM / kSurfDepthM);
  float lace = saturate(0.6 + 1.6 * noise.y);
  float inReach = smoothstep(0.8 * kShoreM, 0.4 * kShoreM, length(place - eyeFromBase.xz));
  shore.foam = surfFoam(phase, ground.depthM, shown) * mix(1.0, lace, shown);
  float edge = runUpDepth(seaState.z + ragged);
  float width = max(0.03, steep * footprint);
  float above = (ground.depthM - edge * shown) / width;
  shore.film = mix(1.0, saturate(above + 0.5), inReach);
  shore.foam = max(shore.foam, 0.9 * exp(-above * above * 0.2) * shown) * inReach;
  shore.slope = ground.fall / steep * (0.16 * bores * sqrt(bores) * shown * waveProfile(phase + 0.1).x * inReach);
  return shore;
}

// What decides the light of a place of the surface.
struct NearSea {
  vec3 toEye;
  Waves waves;
  float depthM;
  float foam, film;
  float reflectance;
  vec3 mirrored;  // direction
};

NearSea nearSeaAt(vec3 relative, float straightM) {
  NearSea sea;
  float distanceM = length(relative);
  sea.toEye = -relative / distanceM;
  vec2 place = eyeFromBase.xz + relative.xz;
  float footprint = distanceM * frame.depthToSea.w / max(sea.toEye.y, 0.05);
  SeaFloor ground = nearSeaFloor(place, distanceM, straightM);
  sea.depthM = ground.depthM;
  SeaGroups groups = seaGroupsAt(place);
  SeaWaveSum sum = seaWavesAt(relative.xz + groups.bend, seaFootprintOf(relative), ground.depthM, seaWaveCount);
  sum.slope *= groups.share;
  sea.waves = wavesOf(sum, gustiness(place, footprint));

  vec2 coarse = turnedNoiseAt(place - seaDrift() * 0.2, 192), fine = noiseAt(place - seaDrift() * 0.2, 4800);
  float fineShown = resolved(0.2, footprint);
  vec2 grain = coarse * 1.2 + fine * (1.7 * fineShown);
  Shore shore = shoreAt(ground, place, vec2(coarse.x, coarse.y + 0.8 * fine.y * fineShown), footprint);
  sea.waves.slope += shore.slope;
  float caps = whitecaps(sum.breaking, sum.unbroken, grain.x, resolved(1.0, footprint), seaState.y);
  sea.foam = saturate((caps + shore.foam) * seaState.w);
  sea.film = shore.film;

  vec3 normal = normalize(vec3(sea.waves.slope.x, 1.0, sea.waves.slope.y));
  sea.reflectance = seaReflectance(max(dot(sea.toEye, normal), 0.02), sea.waves.hidden);
  vec3 mirrored = reflect(-sea.toEye, normal);
  sea.mirrored = normalize(vec3(mirrored.x, max(mirrored.y, 0.02), mirrored.z));
  return sea;
}

vec3 skyMirroredBy(NearSea sea, vec3 shares) {
  return skyTowards(sea.mirrored) * shares.y + diffuseSunTowards(sea.mirrored, shares);
}

// Share of what comes along sea.mirrored that reaches the eye.
float mirrorOf(NearSea sea) { return sea.reflectance * (1.0 - sea.foam) * sea.film; }

// At a place of the surface `relative` to the eye, over a floor at a depth along the straight ray.
SeaLight seaLight(vec3 relative, float straightM, vec3 shares) {
  NearSea sea = nearSeaAt(relative, straightM);
  Waves waves = sea.waves;
  vec3 glitter = frame.sunLight.xyz * (shares.x * sunGlitter(sea.toEye, frame.toSun.xyz, frame.toSun.w, waves.slope,
                                                             waves.hidden, waves.all));
  vec3 onTop = shadeLambert(vec3(1.0), vec3(0.0, 1.0, 0.0), shares);
#ifdef FLASH_LIGHT
  for (int i = 0; i < kFlashLights; ++i)
    glitter += flashOnFrom(i, relative, flashTowards(i, relative)) *
               sunGlitter(sea.toEye, flashTowards(i, relative), kFlashGlitterRadius, waves.slope, waves.hidden, waves.all);
  onTop += flashOn(relative, vec3(0.0, 1.0, 0.0)) / kPi;
#endif
  vec3 through = exp(-waterExtinction(seaWater.x) *
                     (sea.depthM * (waterSlant(sea.toEye.y) + waterSlant(max(frame.toSun.y, 0.0)))));
  vec3 body = seaBodyAlbedo() * onTop * (1.0 - through);
  vec3 sky = skyMirroredBy(sea, shares);
  vec3 water = sky * sea.reflectance + glitter + body * (1.0 - sea.reflectance);

  SeaLight light;
  light.own = min(mix(water, kFoamAlbedo * onTop, sea.foam) * sea.film, vec3(kBrightest));
  // Sand that the film has left is wet.
  light.passed = mix(vec3(0.72), through * ((1.0 - sea.reflectance) * (1.0 - sea.foam)), sea.film);
#ifdef KEEPS_MIRROR
  light.mirror = vec4(sky, mirrorOf(sea));
#endif
  return light;
}
