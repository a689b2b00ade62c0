// Stars as points. toWorld turns from the equator of J2000 to the world; light comes as illuminance.
#include "frame.glsl"
#include "shared/hash.glsl"

// Spread of a star's light over pixels: the standard deviation, and how far it is drawn.
const float kSpreadPixels = 0.7;
const float kReachPixels = 3.0;

uniform mat3 toWorld;
uniform float brightness;  // times exposure
uniform float twinkle;
#ifdef MOON
uniform vec4 moon;  // direction, cosine of its radius
#endif

// A unit direction as refraction raises it: Saemundsson (1986), in degrees, as sky/refraction.h has it above the horizon.
vec3 raised(vec3 direction) {
  float elevation = degrees(asin(clamp(direction.y, -1.0, 1.0)));
  float h = max(elevation, -1.0);
  float lifted = radians(elevation + 1.02 / 60.0 / tan(radians(h + 10.3 / (h + 5.11))));
  vec2 level = direction.xz / max(length(direction.xz), 1e-6);
  return vec3(level.x * cos(lifted), sin(lifted), level.y * cos(lifted));
}

// Scintillation: grows with the air on the way, a different rhythm for each star. Times wrap at whole hours, at which
// whole numbers of swings end.
float twinkling(uint star, float rise) {
  uint bits = hash2(uvec2(star, 17u)).x;
  float rate = float(3u + bits % 7u);
  float phase = unitOf(bits);
  float swing = sin(6.2831853 * (fract(rate * frame.eye.w) + phase)) *
                sin(6.2831853 * (fract((rate + 4.0) * frame.eye.w) + phase * 7.0));
  return 1.0 + twinkle * swing / (1.0 + 4.0 * rise);
}

bool isHidden(vec3 direction) {
#ifdef MOON
  if (dot(direction, moon.xyz) > moon.w) return true;
#endif
  return direction.y < seaEndsSine();
}

// Peak radiance of a star whose light is spread over pixels; 0 where it cannot be seen.
vec3 starRadiance(vec3 direction, vec3 light, float cosFromAxis, uint star) {
  if (isHidden(direction)) return vec3(0.0);
  float pixelAngle = frame.depthToSea.w;
  float pixelSolidAngle = pixelAngle * pixelAngle * cosFromAxis * cosFromAxis * cosFromAxis;
  float share = 1.0 / (6.2831853 * kSpreadPixels * kSpreadPixels * pixelSolidAngle);
  return light * airTransmittanceTowards(direction) * (brightness * share * twinkling(star, direction.y));
}

vec3 starAt(vec3 peak, vec2 pixelsAside) {
  float spread = exp(-dot(pixelsAside, pixelsAside) / (2.0 * kSpreadPixels * kSpreadPixels));
  return min(peak * spread, vec3(kBrightest));
}
