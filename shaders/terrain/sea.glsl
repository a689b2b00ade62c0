// The sea: a level plane with small waves. After terrain/noise.glsl and shared/water.glsl.

uniform float seaFloorM;  // depth of the floor where none is drawn

const float kSeaSlope = 0.11;       // standard deviation of the waves' slope: a breeze of 1.5 m/s (Cox and Munk 1954)
const float kBrightest = 60000.0;   // what a half float keeps, with room for blending

// Corners of four triangles from below the eye to infinity, relative to the eye and in homogeneous coordinates.
vec4 seaCorner(int vertex) {
  int corner = vertex % 3, sector = vertex / 3;
  if (corner == 0) return vec4(0.0, -eyeFromBase.y, 0.0, 1.0);
  int direction = (sector + corner) & 3;
  return vec4(direction == 0 ? 1.0 : direction == 2 ? -1.0 : 0.0, 0.0,
              direction == 1 ? 1.0 : direction == 3 ? -1.0 : 0.0, 0.0);
}

// The waves' slope at a place, as far as pixels can show it; the rest of kSeaSlope is left to statistics.
vec2 seaRipples(vec2 place, float footprint) {
  vec2 drift = vec2(1.1, 0.7) * frame.eye.w;
  return (noiseAt(place + drift, 96) * resolved(10.0, footprint) +
          turnedNoiseAt(place - drift * 0.6, 80) * resolved(2.4, footprint)) * (0.8 * kSeaSlope);
}

struct SeaLight {
  vec3 own;     // reflected and sent back
  vec3 passed;  // share of the floor's light that comes through
};

// At a place of the surface `relative` to the eye, over a floor at a depth.
SeaLight seaLight(vec3 relative, float depthM) {
  float distanceM = length(relative);
  vec3 toEye = -relative / distanceM;
  vec2 slope = seaRipples(eyeFromBase.xz + relative.xz, distanceM * frame.depthToSea.w / max(toEye.y, 0.05));
  vec3 normal = normalize(vec3(slope.x, 1.0, slope.y));
  float cosView = max(dot(toEye, normal), 0.02);
  float reflectance = seaReflectance(cosView, kSeaSlope);

  vec3 mirrored = reflect(-toEye, normal);
  mirrored = normalize(vec3(mirrored.x, max(mirrored.y, 0.02), mirrored.z));
  SkySource source = skySource(frameColumn(), frameAtmosphere(), mirrored.y);
  vec3 sky = skyRadiance(source, dot(mirrored, frame.toSun.xyz), frame.airHaze.w) + frame.nightRadiance.xyz;

  // Waves that pixels do not show tilt the mirror: the slope that would send the sun here, against the ripples'.
  vec3 halfway = normalize(toEye + frame.toSun.xyz);
  vec3 tilted = normalize(vec3(halfway.x - normal.x * halfway.y, halfway.y, halfway.z - normal.z * halfway.y));
  vec3 glitter = frame.sunLight.xyz * (step(0.0, frame.toSun.y) *
                 sunGlitter(tilted, cosView, dot(halfway, toEye), kSeaSlope));

  vec3 through = throughWater(depthM);
  vec3 body = litByFrame(seaBodyAlbedo(), vec3(0.0, 1.0, 0.0), 1.0) * (1.0 - through);
  SeaLight light;
  light.own = min(sky * reflectance + glitter + body * (1.0 - reflectance), vec3(kBrightest));
  light.passed = through * (1.0 - reflectance);
  return light;
}

// What a pixel of the surface sees: where it is relative to the eye, and how much farther along the ray the floor is
// (a factor; 0: no floor is drawn there).
struct SeaSight {
  vec3 relative;
  float floorShare;
};

SeaSight seaSightOf(vec3 fragCoord) {
  vec2 ndc = fragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  float viewZ = eyeFromBase.y / max(-ray.y, 1e-7);
  float floorViewZ = landViewZ(ivec2(fragCoord.xy));
  SeaSight sight;
  sight.relative = ray * viewZ;
  sight.floorShare = floorViewZ < kFarMarker ? floorViewZ / viewZ : 0.0;
  return sight;
}

// As it reaches the eye, to be added to the picture of the floor times light.passed. The floor has its haze already,
// so the share that comes through brings its part of the haze along.
SeaLight seaAsSeen(SeaSight sight) {
  vec3 relative = sight.relative;
  SeaLight light = seaLight(relative, sight.floorShare > 0.0 ? eyeFromBase.y * (sight.floorShare - 1.0) : seaFloorM);
  float left = leftOfLight(relative);
  vec3 horizon = horizonRadiance(normalize(relative));
  if (sight.floorShare <= 0.0) light.passed = vec3(0.0);
  vec3 hazeAlone = mix(horizon, throughHaze(vec3(0.0), relative), left);
  vec3 withLight = mix(horizon, throughHaze(light.own, relative), left);
  light.own = withLight - hazeAlone * light.passed;
  return light;
}
