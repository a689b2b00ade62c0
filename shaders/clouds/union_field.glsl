// The media of several layers at a place relative to the eye, in the field: their extinctions add, and the light is that
// of the layers whose shells hold the place. A layer is worked out for places in its shell alone.
// Part of clouds/field.glsl, of variants with LAYERS.

// Do X(i) for each layer; a loop would have to be unrolled for its layer to be known.
#if LAYERS == 1
#define EACH_LAYER(X) X(0)
#elif LAYERS == 2
#define EACH_LAYER(X) X(0) X(1)
#elif LAYERS == 3
#define EACH_LAYER(X) X(0) X(1) X(2)
#else
#define EACH_LAYER(X) X(0) X(1) X(2) X(3)
#endif

// Added to how steeply a ray approaches a shell: it bends by less on the way.
const float kSteeper = 1e-3;

CloudMedium mediumOf(CloudLayer l) { return CloudMedium(l.medium.x, l.medium.y, l.medium.z, l.medium.w); }

CloudForm formOf(CloudLayer l) {
  return CloudForm(l.profile, l.form.x, l.form.y, l.form.z, l.form.w, l.sunLight.w, l.skyLight.w);
}

float heightIn(CloudLayer l, vec3 place) { return (place.y - l.shell.x) * l.shell.z; }

bool isInShell(float height) { return height > 0.0 && height < 1.0; }

// How far a ray that rises so much a metre goes before it enters a shell that it is outside of.
float wayToShell(CloudLayer l, float height, float rise) {
  float gap = height < 0.5 ? -height * l.shell.y : (height - 1.0) * l.shell.y;
  return max(gap, 0.0) / (max(height < 0.5 ? rise : -rise, 0.0) + kSteeper);
}

float shapeIn(CloudLayer l, vec3 place, float height) {
  vec2 map = l.weatherPlace.xz + place.xz * l.weatherPlace.w;
  vec3 weather = textureLod(weatherMap, map, 0.0).xyz;  // coverage, type, reach of anvils
  weather.x = formedMap(formOf(l), height, weather.x, weather.z);
  float base = textureLod(baseNoise, l.shapePlace.xyz + place * l.shapeScale.xyz, 0.0).x;
  return formedShapeEstimate(mediumOf(l), formOf(l), height, weather.x, weather.y, base);
}

// detailShare: detailLeft().
float extinctionIn(CloudLayer l, vec3 place, float height, float shape, float detailShare) {
#ifdef DETAIL
  float detail = textureLod(detailNoise, l.detailPlace.xyz + place * l.detailPlace.w, 0.0).x;
  detail = mix(l.strides.w, detail, detailShare);
#else
  float detail = clouds.scattering.z;
#endif
  return erodedDensity(mediumOf(l), height, max(shape, 0.0), detail) * l.shell.w;
}

// In the far field: eroded everywhere alike.
float farExtinctionIn(CloudLayer l, float height, float shape) {
  return erodedDensity(mediumOf(l), height, max(shape, 0.0), l.strides.w) * l.shell.w;
}

// At a place on a ray.
struct MediumSample {
  float extinction;  // 1/m; not faded with distance
  float clear;       // how far on there is no cloud, about (m)
};

// How a ray runs there, and for what.
struct Passage {
  vec3 place;
  float rise;         // m a metre
  float detailShare;  // detailLeft()
};

// What a layer adds at a place in its shell.
void meetShell(CloudLayer l, inout MediumSample medium, Passage p, float height, const bool isFar, const bool isToSun) {
  precise float shape = shapeIn(l, p.place, height);
  precise float extinction =
      isFar ? farExtinctionIn(l, height, shape) : extinctionIn(l, p.place, height, shape, p.detailShare);
  medium.extinction += extinction;
  float clear = (l.strides.x - shape) * (isToSun ? l.strides.z : l.strides.y);
  medium.clear = min(medium.clear, extinction > 0.0 ? 0.0 : clear);
}

#if defined(FLAT_LOOPS) && LAYERS > 1 && !defined(OVERLAPS)
// A software renderer does not leave branches out. Shells that do not overlap: the layer is chosen, and its medium is
// worked out once.
struct Choice {
  CloudLayer layer;
  float height;
  bool isIn;
};

void choose(CloudLayer l, inout Choice choice, inout MediumSample medium, Passage p) {
  float height = heightIn(l, p.place);
  bool isIn = isInShell(height);
  medium.clear = isIn ? medium.clear : min(medium.clear, wayToShell(l, height, p.rise));
  if (isIn) choice = Choice(l, height, true);
}

MediumSample meet(Passage p, const bool isFar, const bool isToSun) {
  MediumSample medium = MediumSample(0.0, 1e9);
  Choice choice = Choice(clouds.layers[0], 0.5, false);
#define CHOOSE(i) choose(clouds.layers[i], choice, medium, p);
  EACH_LAYER(CHOOSE)
#undef CHOOSE
  MediumSample within = medium;
  meetShell(choice.layer, within, p, choice.height, isFar, isToSun);
  return MediumSample(choice.isIn ? within.extinction : 0.0, choice.isIn ? within.clear : medium.clear);
}
#else
void meetLayer(CloudLayer l, inout MediumSample medium, Passage p, const bool isFar, const bool isToSun) {
  float height = heightIn(l, p.place);
  if (isInShell(height))
    meetShell(l, medium, p, height, isFar, isToSun);
  else
    medium.clear = min(medium.clear, wayToShell(l, height, p.rise));
}

MediumSample meet(Passage p, const bool isFar, const bool isToSun) {
  MediumSample medium = MediumSample(0.0, 1e9);
#define MEET(i) meetLayer(clouds.layers[i], medium, p, isFar, isToSun);
  EACH_LAYER(MEET)
#undef MEET
  return medium;
}
#endif

// On a ray from the eye that rises so much a metre there; in the far field; and on the way to the sun.
MediumSample sampleAt(vec3 place, float detailShare, float rise) {
  return meet(Passage(place, rise, detailShare), false, false);
}

MediumSample farSampleAt(vec3 place, float rise) { return meet(Passage(place, rise, 0.0), true, false); }

MediumSample sampleToSun(vec3 place, float detailShare) {
  return meet(Passage(place, clouds.toSun.y, detailShare), false, true);
}

// Extinction of one layer, 1/m, 0 outside its shell; not faded with distance.
float extinctionAt(CloudLayer l, vec3 place) {
  float height = heightIn(l, place);
  return isInShell(height) ? extinctionIn(l, place, height, shapeIn(l, place, height), 1.0) : 0.0;
}

// Top above the eye of the highest shell that holds a place; without any, so high that nothing is above.
float topOfOwnShell(vec3 place) {
  float top = -1e9;
#define TOP(i) top = isInShell(heightIn(clouds.layers[i], place)) ? max(top, clouds.layers[i].shell.x + clouds.layers[i].shell.y) : top;
  EACH_LAYER(TOP)
#undef TOP
  return top < -1e8 ? 1e9 : top;
}

// Light at a place in clouds: illuminance of the sun, and radiance scattered from sky and ground.
struct SourceLight {
  vec3 sun;
  vec3 ambient;
};

SourceLight sourceLightAt(vec3 place) {
  SourceLight light = SourceLight(vec3(0.0), vec3(0.0));
  float sum = 0.0;
#define LIGHT(i)                                                                             \
  {                                                                                          \
    float height = heightIn(clouds.layers[i], place);                                                       \
    float weight = layerWeight(height);                                                      \
    sum += weight;                                                                           \
    light.sun += weight * clouds.layers[i].sunLight.xyz;                                     \
    light.ambient += weight * (clouds.layers[i].skyLight.xyz * scatteredSky(height) +        \
                               clouds.layers[i].groundLight.xyz * scatteredGround(height));  \
  }
  EACH_LAYER(LIGHT)
#undef LIGHT
  return SourceLight(light.sun / sum, light.ambient / sum);
}
