// What the shaders of the clouds share: the block of src/render/clouds/cloud_uniforms.h. Positions are relative to the eye, in
// world axes (metres); light is multiplied by exposure.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"

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
} clouds;
