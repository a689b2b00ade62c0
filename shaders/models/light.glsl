// Light of a model's surface.
#include "sky/sky.glsl"
#include "models/light_shares.glsl"
#include "models/material.glsl"
#ifdef MODEL_LAMPS
#include "models/lamps.glsl"
#endif
#include "flash_light.glsl"

// Fresnel's equations for a polished surface (Schlick 1994); a matt one hides most of it at grazing angles.
vec3 fresnel(vec3 reflectance, float cosine, float gloss) {
  float rise = 1.0 - clamp(cosine, 0.0, 1.0);
  float rise2 = rise * rise;
  return reflectance + (max(vec3(gloss), reflectance) - reflectance) * (rise2 * rise2 * rise);
}

// What a mirror would show: sky above, land below, without the sun's disc. Matt surfaces see it blurred, which is
// near the light of the half space.
vec3 surroundings(vec3 direction, float gloss) {
  vec3 sharp = mix(skyWithoutGlow(direction), frame.groundLight.xyz / kPi, smoothstep(0.02, -0.10, direction.y));
  vec3 blurred = mix(frame.groundLight.xyz, frame.skyLight.xyz, 0.5 + 0.5 * direction.y) / kPi;
  return mix(blurred, sharp, gloss);
}

// The sun's highlight: Blinn's normalised lobe (Blinn 1977; normalisation: Lafortune and Willems 1994).
float highlight(vec3 normal, vec3 toEye, float gloss) {
  float power = exp2(1.0 + 9.0 * gloss);
  float cosine = max(dot(normal, normalize(frame.toSun.xyz + toEye)), 0.0);
  return pow(cosine, power) * (power + 8.0) / (8.0 * kPi);
}

vec3 modelLight(Material material, vec3 normal, vec3 relative) {
  vec3 toEye = -normalize(relative);
  vec3 mirrored = reflect(-toEye, normal);
  float facing = max(dot(normal, frame.toSun.xyz), 0.0);
  vec3 shine = fresnel(material.reflectance, dot(normal, toEye), material.gloss);
  vec3 light = shadeLambert(material.albedo * (1.0 - shine), normal, lightShares) +
               shine * (surroundings(mirrored, material.gloss) * lightShares.y +
                        diffuseSunTowards(mirrored, lightShares) * smoothstep(-0.10, 0.02, mirrored.y)) +
               shine * frame.sunLight.xyz * (lightShares.x * facing * highlight(normal, toEye, material.gloss));
#ifdef MODEL_LAMPS
  light += material.albedo / kPi * lampsOn(relative, normal);
#endif
#ifdef FLASH_LIGHT
  light += material.albedo / kPi * flashOn(relative, normal);
#endif
#ifdef CLOTH
  // Thin cloth lets a third of the light through: the side in the shade glows.
  light += shadeLambert(material.albedo * material.albedo, -normal, lightShares) * 0.35;
#endif
  return applyAerialPerspective(min(light, vec3(kBrightest)), relative);
}
