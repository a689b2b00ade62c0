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
  vec4 toSun;         // xyz: unit, at least kLeastSunSine high; w: way of the samples towards the sun (m)
  vec4 sunLight;      // rgb: illuminance of the sun in the layer
  vec4 skyLight;      // rgb: illuminance by the sky on a level surface
  vec4 groundLight;   // rgb: illuminance from below
  vec4 march;         // step (m), emptyStepMultiplier, maxSegmentOpticalDepth, transmittanceCutoff
  vec4 cells;         // xz: the eye in cells of the occupancy; y: cells in a metre; w: rows in a metre
  vec4 sight;         // xyz: where steps begin to grow (m), half-width of a tile's ray at 1 m, tolerance
  vec4 nearGrid[3];   // rows: a place, 1 to a place in the texture
  vec4 farGrid[3];
} clouds;
