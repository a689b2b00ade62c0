// The frame's sky and haze. Shaders ask these functions alone, so that the model of the atmosphere
// (shared/atmosphere.glsl) can be replaced here. Included by frame.glsl after the block; directions are unit vectors,
// light is multiplied by exposure.
Atmosphere frameAtmosphere() {
  Atmosphere air;
  air.rayleigh = frame.airRayleigh.xyz;
  air.rayleighHeight = frame.airRayleigh.w;
  air.haze = frame.airHaze.x;
  air.hazeHeight = frame.airHaze.y;
  air.hazeAlbedo = frame.airHaze.z;
  air.hazeAnisotropy = frame.airHaze.w;
  return air;
}

// The air above the eye; its light is the sun's own, so radiances come out of it without another factor.
SkyColumn frameColumn() {
  SkyColumn column;
  column.depth = frame.columnDepth.xyz;
  column.sunMass = frame.columnDepth.w;
  column.airHere = frame.columnHere.xyz;
  column.hazeHere = frame.columnHere.w;
  column.airLight = frame.airLight.xyz;
  column.hazeLight = frame.hazeLight.xyz;
  column.overhead = frame.overhead.xyz;
  return column;
}

// Radiance of the sky in a direction, the night's included, without the sun's disc; below the horizon that of the
// horizon, which is what haze sends towards the eye.
vec3 skyTowards(vec3 direction) {
  SkySource source = skySource(frameColumn(), frameAtmosphere(), direction.y);
  return skyRadiance(source, dot(direction, frame.toSun.xyz), frame.airHaze.w) + frame.nightRadiance.xyz;
}

// The same without the glow of the haze around the sun, as a surface that blurs its mirror image shows it.
vec3 skyWithoutGlow(vec3 direction) {
  SkySource source = skySource(frameColumn(), frameAtmosphere(), direction.y);
  return skyRadiance(source, dot(direction, frame.toSun.xyz), 0.0) + frame.nightRadiance.xyz;
}

// Radiance of the sky at the horizon below a direction: what haze sends towards the eye.
vec3 horizonRadiance(vec3 direction) {
  float c = dot(direction, frame.toSun.xyz);
  return frame.horizonRayleigh.xyz * rayleighPhase(c) + frame.horizonHaze.xyz * henyeyGreenstein(c, frame.airHaze.w) +
         frame.horizonIsotropic.xyz;
}

// Transmittance of the air between the eye and a place that is higher by riseM and distanceM away.
vec3 airTransmittance(float riseM, float distanceM) {
  return transmittanceBetween(frameAtmosphere(), frame.eye.x, frame.eye.x + riseM, distanceM);
}

// Transmittance of all the air in a direction; below the horizon as at the horizon.
vec3 airTransmittanceTowards(vec3 direction) { return skyTransmittance(frameColumn(), direction.y); }

// Transmittance of the air down to sea level in a direction below the horizon.
vec3 airTransmittanceToSea(vec3 direction) { return exp(frame.depthToSea.xyz / min(direction.y, -1e-9)); }

// A surface's light as it reaches the eye from a place `relative` to it. Without the feature HAZE: as it is.
vec3 applyAerialPerspective(vec3 light, vec3 relative) {
#ifdef HAZE
  float distanceM = length(relative);
  vec3 direction = relative / max(distanceM, 1e-6);
  vec3 transmittance = airTransmittance(relative.y, distanceM);
  return light * transmittance + horizonRadiance(direction) * (1.0 - transmittance);
#else
  return light;
#endif
}
