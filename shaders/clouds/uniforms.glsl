// What the shaders of the clouds share: the block of src/render/clouds/cloud_uniforms.h. Positions are relative to the eye, in
// world axes (metres); light is multiplied by exposure. LAYERS: so many layers at once, each with its own medium and light;
// the fields of the one layer are then not read. Without it there is one, of the plain form.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"

#ifdef LAYERS
#include "shared/cloud_form.glsl"

struct CloudLayer {
  vec4 shapePlace;    // xyz: the eye in periods of the texture, [0, 1)
  vec4 shapeScale;    // xyz: periods in a metre
  vec4 detailPlace;   // as below
  vec4 weatherPlace;
  vec4 shell;         // base above the eye (m), thickness (m), 1 / thickness, extinction (1/m)
  vec4 medium;        // as below
  vec4 profile;       // as in CloudForm
  vec4 form;          // own, anvilBase, spread, anvilThreshold
  vec4 strides;       // xyz: as below; w: what wears edges in the far field
  vec4 cells;         // as below
  vec4 sunLight;      // rgb: as below; w: taper
  vec4 skyLight;      // w: contrast
  vec4 groundLight;
};
#endif

layout(std140, binding = 1) uniform Clouds {
  vec4 shapePlace;    // xyz: the eye in periods of the texture, [0, 1); w: periods in a metre
  vec4 detailPlace;
  vec4 weatherPlace;  // xz: likewise; w: periods in a metre
  vec4 layer;         // base above the eye (m), thickness (m), distance at which clouds have faded (m), extinction (1/m)
  vec4 medium;        // threshold, coverage, type's shift, erosion
  vec4 scattering;    // xyz: g, share of the forward lobe, mean of the detail texture
  vec4 toSun;         // xyz: unit, at least kLeastSunSine high
  vec4 sunLight;      // rgb: illuminance of the sun in the layer
  vec4 skyLight;      // rgb: illuminance by the sky on a level surface
  vec4 groundLight;   // rgb: illuminance from below
  vec4 march;         // step (m), where steps begin to grow (m), least opacity of a segment, transmittanceCutoff
  vec4 strides;       // of clear air: shape up to which there is none but that; m of it for a unit of shape less: to the eye, to the sun
  vec4 sunSteps;      // towards the sun: the first (m), growth, m longer with a unit of optical depth
  vec4 exact;         // of the exact march: maxSegmentOpticalDepth
  vec4 cells;         // xz: the eye in cells of the occupancy; y: cells in a metre; w: rows in a metre
  vec4 farField;      // where it begins (m), steps and tolerances there (times those nearer), what wears edges there
  vec4 sight;         // half-width of a tile's ray at 1 m; tolerances: between rays 4 pixels apart, 2 pixels apart
#ifdef LAYERS
  vec4 shells;        // of all layers: top above the eye (m)
  CloudLayer layers[LAYERS];
#endif
} clouds;
