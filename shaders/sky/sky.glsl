// The sky with the sun's disc; below the horizon an endless plain of average land at sea level. After frame.glsl.

// The largest radiance that a half float keeps with room for blending.
const float kBrightest = 60000.0;

// Angle across one pixel in the middle of the picture, in radians.
float pixelAngle() { return 2.0 * length(frame.ndcToRay[1].xyz) * frame.viewport.w; }

// The sun's disc, its edge smoothed over a pixel. `cosZenith` of the direction: the horizon cuts the disc.
vec3 sunDisc(vec3 direction) {
  float radius = sqrt(1.0 - frame.toSun.w * frame.toSun.w);
  float fromCentre = length(cross(direction, frame.toSun.xyz));
  float inDisc = clamp((radius - fromCentre) / pixelAngle() + 0.5, 0.0, 1.0) *
                 step(0.0, dot(direction, frame.toSun.xyz)) * clamp(direction.y / pixelAngle() + 0.5, 0.0, 1.0);
  float solidAngle = kPi * radius * radius;
  return frame.sunOutside.xyz * sunTransmittance(frameAtmosphere(), frame.eye.x, direction.y) * (inDisc / solidAngle);
}

vec3 skyInDirection(vec3 direction) {
  float cosSunAngle = dot(direction, frame.toSun.xyz);
  if (direction.y < 0.0) {
    vec3 plain = frame.groundLight.xyz / kPi;
    return throughHaze(plain, direction * (max(frame.eye.x, 1.0) / max(-direction.y, 1e-6)));
  }
  SkySource source = skySource(frameAtmosphere(), frame.eye.x, direction.y, frame.toSun.y);
  vec3 scattered = skyRadiance(source, cosSunAngle, frame.airHaze.w) * frame.sunOutside.xyz;
  return min(scattered + frame.nightRadiance.xyz + sunDisc(direction), vec3(kBrightest));
}
