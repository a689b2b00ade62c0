// The sea: a level plane with small waves.
#include "terrain/noise.glsl"
#include "terrain/light_shares.glsl"
#include "shared/water.glsl"
#include "shared/sun_glitter.glsl"
#include "flash_light.glsl"

uniform float seaFloorM;  // depth of the floor where none is drawn

// Standard deviation of the waves' slope along each axis: a breeze of 7 m/s (Cox and Munk 1954: mean square of both
// axes together 0.003 + 0.00512 m/s of wind).
const float kSeaSlope = 0.14;

// Corners of four triangles from below the eye to infinity, relative to the eye and in homogeneous coordinates.
vec4 seaCorner(int vertex) {
  int corner = vertex % 3, sector = vertex / 3;
  if (corner == 0) return vec4(0.0, -eyeFromBase.y, 0.0, 1.0);
  int direction = (sector + corner) & 3;
  return vec4(direction == 0 ? 1.0 : direction == 2 ? -1.0 : 0.0, 0.0,
              direction == 1 ? 1.0 : direction == 3 ? -1.0 : 0.0, 0.0);
}

// The waves at a place.
struct Waves {
  vec2 slope;    // as far as pixels can show it
  float hidden;  // standard deviation of what is left to statistics
  float all;     // the same of both together
};

// Three sizes of waves, which together have most of the slope; gusts over kilometres and hundreds of metres roughen
// the sea by a fifth and leave slicks between them, so that the sun's glitter is not one even sheet from high above.
vec2 seaDrift() { return vec2(1.1, 0.7) * frame.eye.w; }

float gustiness(vec2 place, float footprint) {
  vec2 drift = seaDrift();
  vec2 gusts = noiseAt(place + drift * 3.0, 1) * 0.7 + turnedNoiseAt(place + drift * 3.0, 1) * resolved(192.0, footprint);
  return clamp(1.0 + 0.28 * gusts.x, 0.75, 1.35);
}

Waves wavesAt(vec2 place, float footprint) {
  vec2 drift = seaDrift();
  float swell = resolved(40.0, footprint), wave = resolved(10.0, footprint), ripple = resolved(2.4, footprint);
  float rough = kSeaSlope * gustiness(place, footprint);
  Waves waves;
  waves.slope = (noiseAt(place + drift * 2.0, 24) * (kSwellShare * swell) +
                 noiseAt(place + drift, 96) * (kWaveShare * wave) +
                 turnedNoiseAt(place - drift * 0.6, 80) * (kRippleShare * ripple)) * rough;
  waves.all = rough;
  waves.hidden = rough * hiddenShare(swell, wave, ripple);
  return waves;
}

struct SeaLight {
  vec3 own;     // reflected and sent back
  vec3 passed;  // share of the floor's light that comes through
#ifdef KEEPS_MIRROR
  vec4 mirror;  // the sky's light that is mirrored; share of what comes along the mirrored ray
#endif
};

#ifdef WATER_DETAIL
#include "terrain/near_sea.glsl"
#else
// At a place of the surface `relative` to the eye, over a floor at a depth; `shares` of the light reach it.
SeaLight seaLight(vec3 relative, float depthM, vec3 shares) {
  float distanceM = length(relative);
  vec3 toEye = -relative / distanceM;
  Waves waves = wavesAt(eyeFromBase.xz + relative.xz, distanceM * frame.depthToSea.w / max(toEye.y, 0.05));
  vec3 normal = normalize(vec3(waves.slope.x, 1.0, waves.slope.y));
  float cosView = max(dot(toEye, normal), 0.02);
  float reflectance = seaReflectance(cosView, waves.hidden);

  vec3 mirrored = reflect(-toEye, normal);
  mirrored = normalize(vec3(mirrored.x, max(mirrored.y, 0.02), mirrored.z));
  vec3 sky = skyTowards(mirrored) * shares.y + diffuseSunTowards(mirrored, shares);

  vec3 glitter = frame.sunLight.xyz * (shares.x * sunGlitter(toEye, frame.toSun.xyz, frame.toSun.w, waves.slope,
                                                             waves.hidden, waves.all));

#ifdef FLASH_LIGHT
  for (int i = 0; i < kFlashLights; ++i)
    glitter += flashOnFrom(i, relative, flashTowards(i, relative)) *
               sunGlitter(toEye, flashTowards(i, relative), kFlashGlitterRadius, waves.slope, waves.hidden, waves.all);
#endif

  vec3 through = throughWater(depthM);
  vec3 body = shadeLambert(seaBodyAlbedo(), vec3(0.0, 1.0, 0.0), shares) * (1.0 - through);
#ifdef FLASH_LIGHT
  body += seaBodyAlbedo() / kPi * flashOn(relative, vec3(0.0, 1.0, 0.0)) * (1.0 - through);
#endif
  SeaLight light;
  light.own = min(sky * reflectance + glitter + body * (1.0 - reflectance), vec3(kBrightest));
  light.passed = through * (1.0 - reflectance);
  return light;
}
#endif

// What a pixel of the surface sees: where it is relative to the eye, and how much farther along the ray the floor is
// (a factor; 0: no floor is drawn there).
struct SeaSight {
  vec3 relative;
  float floorShare;
  vec3 shares;  // of the light that shadows leave, told by the floor's
};

SeaSight seaSightOf(vec3 fragCoord) {
  vec2 ndc = fragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float viewZ = eyeFromBase.y / max(-ray.y, 1e-7);
  float floorViewZ = landViewZ(ivec2(fragCoord.xy));
  SeaSight sight;
  sight.relative = ray * viewZ;
  sight.floorShare = floorViewZ < kFarMarker ? floorViewZ / viewZ : 0.0;
  sight.shares = lightSharesAt(ivec2(fragCoord.xy), sight.relative);
  return sight;
}

// As it reaches the eye, to be added to the picture of the floor times light.passed. The floor has its haze already,
// so the share that comes through brings its part of the haze along.
SeaLight seaAsSeen(SeaSight sight) {
  vec3 relative = sight.relative;
  SeaLight light = seaLight(relative, sight.floorShare > 0.0 ? eyeFromBase.y * (sight.floorShare - 1.0) : seaFloorM,
                            sight.shares);
  float left = leftOfLight(relative);
  if (sight.floorShare <= 0.0) light.passed = vec3(0.0);
  vec3 hazeAlone = endingLandThroughAir(vec3(0.0), relative, left);
  vec3 withLight = endingLandThroughAir(light.own, relative, left);
  light.own = withLight - hazeAlone * light.passed;
#ifdef KEEPS_MIRROR
  light.mirror.rgb = endingLandThroughAir(light.mirror.rgb, relative, left);
#endif
  return light;
}
