// One view of a unit tree, drawn into the impostors' atlas: seen from far away along a direction.
uniform vec4 bakeShape;   // radius over height; half the view's side over height; kind
uniform vec3 bakeRight;   // axes of the view, unit, in the tree's frame
uniform vec3 bakeUp;
uniform vec3 bakeTowards;  // the eye

vec4 bakedPosition(vec3 unitPlace) {
  vec3 at = unitPlace * vec3(bakeShape.x, 1.0, bakeShape.x) - vec3(0.0, 0.5, 0.0);
  return vec4(dot(at, bakeRight) / bakeShape.y, dot(at, bakeUp) / bakeShape.y, 0.5 + 0.4 * dot(at, bakeTowards), 1.0);
}
