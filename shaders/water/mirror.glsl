// What the sea mirrors of the scene in place of the sky, of pixels `spacing` apart (render::WaterReflectionPass).
#include "terrain/noise.glsl"
#include "terrain/sea_waves.glsl"
#include "shared/water.glsl"
#include "shared/mirror_ray.glsl"

uniform int spacing;      // pixels between two rays
uniform int mirrorSteps;  // along a ray
uniform int mirrorRays;   // of a pixel
uniform float mirrorM;    // how far they look
uniform float mirrorLeft;  // of it all, by the eye's height

#include "water/sea_pixel.glsl"
#include "water/followed_picture.glsl"

// A ray in homogeneous coordinates of the picture.
struct PictureRay {
  vec4 from, along;
};

PictureRay pictureRay(vec3 from, vec3 direction) {
  return PictureRay(clipInPicture(vec4(from, 1.0)), clipInPicture(vec4(direction, 0.0)));
}

// A place of a ray in the picture: pixels, and distance along the view axis.
vec3 inPicture(PictureRay ray, float alongM) {
  vec4 clip = ray.from + ray.along * alongM;
  return vec3((clip.xy / clip.w * 0.5 + 0.5) * sizeOfPicture(), clip.w);
}

bool isOutside(vec3 at) {
  return at.z < frame.eye.y || any(lessThan(at.xy, vec2(0.0))) || any(greaterThanEqual(at.xy, sizeOfPicture()));
}

vec4 sceneLight(vec3 at, float share) {
  ivec2 pixel = clamp(ivec2(at.xy), ivec2(0), ivec2(sizeOfPicture()) - 1);
  return vec4(texelFetch(pictureLight, pixel, 0).rgb, 1.0) * share;
}

// Of what a ray met there, by where it is in the picture.
float shareOf(float behindM, float stepM, vec3 at) {
  return mirrorShare(behindM, stepM, at.x / sizeOfPicture().x, at.y / sizeOfPicture().y);
}

// What is farther than rays are followed is met where the ray's direction points to in the picture.
vec4 sceneBeyond(vec3 direction, float endViewZ) {
  vec4 clip = clipInPicture(vec4(direction, 0.0));
  vec3 at = vec3((clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5) * sizeOfPicture(), clip.w);
  if (clip.w < 1e-3 || isOutside(vec3(at.xy, frame.eye.y))) return vec4(0.0);
  float viewZ = pictureViewZ(ivec2(at.xy));
  bool isMet = viewZ < kFarMarker && viewZ > 0.7 * endViewZ && behindPicture(vec3(at.xy, 2.0 * viewZ)) > 0.0;
  return sceneLight(at, isMet ? shareOf(0.0, 1.0, at) : 0.0);
}

// Light that comes along a mirrored ray in place of the sky's, and how much of the ray it has: 0 where the picture shows
// nothing there.
vec4 sceneAlong(vec3 from, vec3 direction) {
  float before = 0.0, endViewZ = 0.0;
  float hitM = -1.0;
  PictureRay ray = pictureRay(from, direction);
  for (int i = 0; i < mirrorSteps; ++i) {
    float alongM = mirrorStep(i + 1, mirrorSteps, mirrorM);
    vec3 at = inPicture(ray, alongM);
    endViewZ = at.z;
    if (isOutside(at)) break;
    if (behindPicture(at) > 0.0) {
      hitM = alongM;
      break;
    }
    before = alongM;
  }
  if (hitM < 0.0) return before < mirrorM ? vec4(0.0) : sceneBeyond(direction, endViewZ);
  float low = before, high = hitM;
  for (int i = 0; i < 5; ++i) {
    float middle = 0.5 * (low + high);
    vec3 at = inPicture(ray, middle);
    if (behindPicture(at) > 0.0) high = middle; else low = middle;
  }
  vec3 at = inPicture(ray, high);
  return sceneLight(at, shareOf(behindPicture(at), hitM - before, at));
}

// Light that a pixel's water gets from the scene in place of the sky, and how much of its mirrored rays that is.
vec4 mirroredScene(ivec2 pixel) {
  vec3 ray = rayOf(pixel);
  if (!isSeaAt(pixel, sceneViewZ(pixel), ray)) return vec4(0.0);
  vec3 relative = ray * (eyeFromBase.y / -ray.y);
  vec3 toEye = -relative / length(relative);
  SeaFootprint footprint = seaFootprintOf(relative);
  float wider = float(spacing * spacing);
  footprint.across2 *= wider;
  footprint.more2 *= wider;
  SeaGroups groups = seaGroupsAt(eyeFromBase.xz + relative.xz);
  SeaWaveSum waves = seaWavesAt(relative.xz + groups.bend, footprint, 1e3, seaWaveCount);
  waves.slope *= groups.share;
  float hidden = sqrt(max(seaState.x * seaState.x - 0.5 * waves.variance, 1e-4));
  vec2 level = relative.xz / max(length(relative.xz), 1e-6);
  ivec2 texel = pixel / spacing;
  int neighbour = (texel.x & 1) * 2 ^ (texel.y & 1) * 3;
  vec4 sum = vec4(0.0);
  float all = 1e-6;
  for (int i = 0; i < mirrorRays; ++i) {
    vec2 slope = waves.slope + level * (hidden * mirrorQuantile(i, mirrorRays, neighbour));
    vec3 normal = normalize(vec3(slope.x, 1.0, slope.y));
    vec3 mirrored = reflect(-toEye, normal);
    // What meets the water again leaves it about as steep.
    mirrored = normalize(vec3(mirrored.x, abs(mirrored.y) + 0.003, mirrored.z));
    float reflectance = seaReflectance(max(dot(toEye, normal), 0.02), hidden);
    sum += sceneAlong(relative, mirrored) * reflectance;
    all += reflectance;
  }
  return sum * (mirrorLeft / all);
}
