// The frame's sky and haze. Shaders ask these functions alone, so that the model of the atmosphere can be replaced here:
// with SKY_SHELL that of shared/atmosphere_shell.glsl by tables (render/frame/sky_tables.h), without it the closed form of
// shared/atmosphere.glsl. Included by frame.glsl after the block; directions are unit vectors, light is multiplied by
// exposure.
Atmosphere frameAtmosphere() {
  Atmosphere air;
  air.rayleigh = frame.airRayleigh.xyz;
  air.rayleighHeight = frame.airRayleigh.w;
  air.haze = frame.airHaze.x;
  air.hazeHeight = frame.airHaze.y;
  air.hazeAlbedo = frame.airHaze.z;
  air.hazeAnisotropy = frame.airHaze.w;
  air.ozone = vec3(0.0);  // below 10 km, where light between places is looked at, there is none
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

// Transmittance of the air between the eye and a place that is higher by riseM and distanceM away.
vec3 airTransmittance(float riseM, float distanceM) {
  return transmittanceBetween(frameAtmosphere(), frame.eye.x, frame.eye.x + riseM, distanceM);
}

// What air of any opacity sends below an even deck of clouds: it sees the deck from above and the land from below, and no
// sun; as much as one half of all directions at E / pi each (E: illuminance of level ground).
vec3 airBelowDeck() {
  vec3 ground = frame.sunLight.xyz * max(frame.toSun.y, 0.0) + frame.skyLight.xyz + frame.groundLight.xyz;
  return ground * (frame.overcast.y * 0.5 / kPi) + frame.nightRadiance.xyz;
}

// Air as it is below the clouds of the frame.
vec3 airBelowClouds(vec3 open) {
#ifdef OVERCAST
  return mix(open, airBelowDeck(), frame.overcast.x);
#else
  return open;
#endif
}

// Of light that arrives on level ground, what is left where the clouds are those around the eye.
float leftBelowClouds() {
#ifdef OVERCAST
  return mix(1.0, frame.overcast.y, frame.overcast.x);
#else
  return 1.0;
#endif
}

// The open sky beyond the end of a deck, through the dark air below that.
vec3 behindDeck(vec3 sky, vec3 direction) {
#ifdef OVERCAST
  float deckM = frame.overcast.z / max(direction.y, 1e-3);
  vec3 left = airTransmittance(frame.overcast.z, deckM);
  return mix(sky, mix(airBelowDeck(), sky, left), frame.overcast.x);
#else
  return sky;
#endif
}

#ifdef SKY_SHELL
// Of the whole sky (sky::SkyLayer): light by itself, light to be multiplied by the haze's phase function, and
// transmittance.
layout(binding = 15) uniform sampler2DArray skyTables;
const float kSkyEven = 0.0, kSkyHaze = 1.0, kSkyLeft = 2.0;
// Of the air up to a distance, a slice each: mean light along the ray, the haze's phase function included.
layout(binding = 14) uniform sampler3D airTable;

// Cosine of the azimuth from the glow, and row of skyTableRow().
vec2 skyTableAngles(vec3 direction) {
  float cosAzimuth = dot(direction.xz, frame.skyTable.zw) * inversesqrt(max(dot(direction.xz, direction.xz), 1e-12));
  return vec2(cosAzimuth, skyTableRow(direction.y, frame.skyTable.x, frame.skyTable.y));
}

vec3 airTablePlace(vec3 direction, float distanceM) {
  vec2 angles = skyTableAngles(direction);
  vec3 at = vec3(airTableColumn(angles.x), airTableRow(angles.y), skyTableSlice(distanceM));
  return (at + 0.5) / vec3(float(kAirColumns), float(kAirRows), float(kSkySlices));
}

// The sky's own layers have texels between those of the tables, but none across the horizon (src/render/frame/sky_tables.cpp).
const float kFinerColumns = 6.0, kFinerRows = 3.0;

vec2 skyLayerPlace(vec3 direction) {
  vec2 angles = skyTableAngles(direction), at = vec2(skyTableColumn(angles.x), angles.y);
  float acrossHorizon = float(kSkyRowsBelow) - 0.5;
  at.y = at.y * kFinerRows - (at.y > acrossHorizon ? kFinerRows - 1.0 : 0.0);
  return (vec2(at.x * kFinerColumns, at.y) + 0.5) /
         vec2(float(kSkyColumns - 1) * kFinerColumns + 1.0, float(kSkyRows - 2) * kFinerRows + 2.0);
}

vec3 skyByTable(vec3 direction, float anisotropy) {
  vec2 place = skyLayerPlace(direction);
  return textureLod(skyTables, vec3(place, kSkyEven), 0.0).xyz +
         textureLod(skyTables, vec3(place, kSkyHaze), 0.0).xyz *
             henyeyGreenstein(dot(direction, frame.skyGlow.xyz), anisotropy);
}

// Radiance of all the air in a direction, the night's included, without the sun's disc; a direction that meets the sea ends
// there.
vec3 skyTowards(vec3 direction) { return skyByTable(direction, frame.airHaze.w); }

// The same without the glow of the haze around the sun, as a surface that blurs its mirror image shows it.
vec3 skyWithoutGlow(vec3 direction) { return skyByTable(direction, 0.0); }

// What air of any opacity sends towards the eye, up to a distance, is its opacity times this: the mean along the ray.
vec3 airRadiance(vec3 direction, float distanceM) {
  return airBelowClouds(textureLod(airTable, airTablePlace(direction, distanceM), 0.0).xyz);
}

// Light of the air before something at a distance that the sky is seen behind, by the air's transmittance.
vec3 airBeforeSky(vec3 direction, float distanceM, vec3 transmittance) {
  return airRadiance(direction, distanceM) * (1.0 - transmittance);
}

// Transmittance of all the air in a direction.
vec3 skyTransmittance(vec3 direction) {
  return textureLod(skyTables, vec3(skyLayerPlace(direction), kSkyLeft), 0.0).xyz;
}

vec3 airTransmittanceTowards(vec3 direction) { return skyTransmittance(direction); }

// Sine of the elevation at which a level sea ends.
float seaEndsSine() { return frame.skyTable.x; }

// The light of a plain of average land at sea level, without what lies before it: none above its horizon, where it begins
// over half a degree, as land that is not level would.
vec3 plainLight(vec3 direction) {
  return frame.groundLight.xyz * (leftBelowClouds() / kPi) * saturate((seaEndsSine() - direction.y) / 0.01);
}

// Sky and plain as they reach the eye.
vec3 skyAndPlain(vec3 direction) {
#ifdef HAZE
  return behindDeck(skyTowards(direction), direction) + plainLight(direction) * skyTransmittance(direction);
#else
  return direction.y < seaEndsSine() ? frame.groundLight.xyz * (leftBelowClouds() / kPi) : skyTowards(direction);
#endif
}

#else
// Radiance of the sky in a direction, the night's included, without the sun's disc; below the horizon that of the
// horizon, which is what haze sends towards the eye.
vec3 skyTowards(vec3 direction) {
  SkySource source = skySource(frameColumn(), frameAtmosphere(), direction.y);
  return skyRadiance(source, dot(direction, frame.skySun.xyz), frame.airHaze.w) + frame.nightRadiance.xyz;
}

// The same without the glow of the haze around the sun, as a surface that blurs its mirror image shows it.
vec3 skyWithoutGlow(vec3 direction) {
  SkySource source = skySource(frameColumn(), frameAtmosphere(), direction.y);
  return skyRadiance(source, dot(direction, frame.skySun.xyz), 0.0) + frame.nightRadiance.xyz;
}

// What air of any opacity sends towards the eye is its opacity times this: the radiance of the sky at the horizon below a
// direction.
vec3 airRadiance(vec3 direction, float distanceM) {
  float c = dot(direction, frame.skySun.xyz);
  return airBelowClouds(frame.horizonRayleigh.xyz * rayleighPhase(c) +
                        frame.horizonHaze.xyz * henyeyGreenstein(c, frame.airHaze.w) + frame.horizonIsotropic.xyz);
}

// Light of the air before something at a distance that the sky is seen behind, by the air's transmittance: what is far
// away becomes that sky.
vec3 airBeforeSky(vec3 direction, float distanceM, vec3 transmittance) {
  vec3 leftOfSky = skyTransmittance(frameColumn(), direction.y);
  vec3 open = skyTowards(direction) * min((1.0 - transmittance) / max(1.0 - leftOfSky, vec3(1e-6)), vec3(1.0));
#ifdef OVERCAST
  return mix(open, airBelowDeck() * (1.0 - transmittance), frame.overcast.x);
#else
  return open;
#endif
}

// Transmittance of all the air in a direction; below the horizon as at the horizon.
vec3 airTransmittanceTowards(vec3 direction) { return skyTransmittance(frameColumn(), direction.y); }

// Sine of the elevation at which a level sea ends: here the earth is flat.
float seaEndsSine() { return 0.0; }

// Sky, and below the horizon a plain of average land at sea level, as they reach the eye.
vec3 skyAndPlain(vec3 direction) {
#ifdef HAZE
  vec3 sky = behindDeck(skyTowards(direction), direction);
  vec3 left = exp(frame.depthToSea.xyz / min(direction.y, -1e-9));
#else
  vec3 sky = skyTowards(direction);
  vec3 left = vec3(1.0);
#endif
  return mix(sky, frame.groundLight.xyz * (leftBelowClouds() / kPi), direction.y < 0.0 ? left : vec3(0.0));
}
#endif

// A surface's light as it reaches the eye from a place `relative` to it. Without the feature HAZE: as it is.
vec3 applyAerialPerspective(vec3 light, vec3 relative) {
#ifdef HAZE
  float distanceM = length(relative);
  vec3 direction = relative / max(distanceM, 1e-6);
  vec3 transmittance = airTransmittance(relative.y, distanceM);
  return light * transmittance + airRadiance(direction, distanceM) * (1.0 - transmittance);
#else
  return light;
#endif
}

// The same of land and sea, of whose own light a share is left towards their end: there they turn into what is seen beyond
// them, with the shell into sky or plain behind all the air, with the closed form into the haze at the horizon.
vec3 endingLandThroughAir(vec3 light, vec3 relative, float left) {
#if defined(SKY_SHELL) && defined(HAZE)
  float distanceM = length(relative);
  vec3 direction = relative / max(distanceM, 1e-6);
  vec3 transmittance = mix(skyTransmittance(direction), airTransmittance(relative.y, distanceM), left);
  return mix(plainLight(direction), light, left) * transmittance +
         airRadiance(direction, distanceM / max(left, 1e-4)) * (1.0 - transmittance);
#elif defined(SKY_SHELL)
  return mix(skyAndPlain(normalize(relative)), light, left);
#else
  return mix(airRadiance(normalize(relative), 0.0), applyAerialPerspective(light, relative), left);
#endif
}
