// An instance as vertex attributes (places/instance.glsl).
layout(location = 2) in vec4 placeFoot;
layout(location = 3) in vec4 placeForm;
layout(location = 4) in vec4 placeTurn;
layout(location = 5) in vec4 placeSun;
layout(location = 6) in vec4 placeAbove;
layout(location = 7) in vec4 placeBelow;
layout(location = 8) in vec4 placeAir;

// Of a building's frame, x across the ridge to the right of its way, z against it, in the world's axes.
vec3 ofPlace(vec3 local) {
  vec2 along = placeTurn.xy, right = vec2(-along.y, along.x);
  vec2 level = along * local.z + right * local.x;
  return vec3(level.x, local.y, level.y);
}
