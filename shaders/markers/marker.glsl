// The light of a target's marker. After frame.glsl.

// A warm orange, as bright as white paper in the frame's light: it stands out from grass, snow, sea and sky.
vec3 markerColor() { return vec3(1.0, 0.20, 0.015) * (frame.sunLight.xyz + frame.skyLight.xyz + 0.05) / kPi; }

// Premultiplied: a glow of `share` over what is behind, dimmed by the haze in front of it.
vec4 markerGlow(float share, vec3 relative) {
#ifdef HAZE
  vec3 transmittance =
      exp(-opticalDepthBetween(frameAtmosphere(), frame.eye.x, frame.eye.x + relative.y, length(relative)));
#else
  vec3 transmittance = vec3(1.0);
#endif
  // It carries through haze further than a surface would: it must be found.
  return vec4(markerColor() * (share * sqrt(transmittance)), share * 0.85);
}

// A band of a width around the circle, its edge smoothed over a pixel's breadth on the ground, with a faint fill inside.
float ringShare(float fromMiddleM, float radiusM, float widthM, float pixelM) {
  float edge = max(pixelM, 0.3);
  float inBand = clamp((0.5 * widthM - abs(fromMiddleM - radiusM)) / edge + 0.5, 0.0, 1.0);
  // Thinner than a pixel it gets fainter instead.
  inBand *= min(widthM / edge, 1.0);
  float inside = clamp((radiusM - fromMiddleM) / edge + 0.5, 0.0, 1.0);
  return max(0.75 * inBand, 0.07 * inside);
}

// across: -1..1 over the beam; up: 0..1. Soft at the sides, fading towards the top and close to the eye.
float beamShare(float across, float up, float distanceM) {
  float profile = exp(-4.0 * across * across) - exp(-4.0);
  float fade = (1.0 - up) * (1.0 - up);
  return 0.8 * profile * fade * smoothstep(20.0, 250.0, distanceM);
}
