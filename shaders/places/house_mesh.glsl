// Vertices of a building: one mesh of walls, roof and chimney, as wide, long and high as its instance.
#include "frame.glsl"
#include "shared/places.glsl"
#include "places/attributes.glsl"

layout(location = 0) in vec4 unitCorner;  // x and z in [-1, 1]; level (kLevel..); part (kPart..)
layout(location = 1) in vec4 unitNormal;

const float kSkirt = 0.0, kEaves = 2.0, kRidge = 3.0;
const float kWallPart = 0.0, kGablePart = 1.0, kSlopePart = 2.0, kHipPart = 3.0, kChimneyPart = 4.0;
const float kEavesM = 0.45, kVergeOutM = 0.35;  // roofs reach so far beyond walls, down the slope and at gables

struct HouseVertex {
  vec3 relative;
  vec3 normal;
  vec3 local;  // m; x across, z along
  float part;
};

HouseVertex houseVertex() {
  vec4 form = placeForm;
  float part = unitCorner.w, level = unitCorner.z;
  float ridge = placeTurn.z, use = placeTurn.w;
  vec2 halves = 0.5 * form.xy;
  bool isDeck = use > 3.5;
  bool isRoof = part > 1.5 && part < 3.5;
  float over = isRoof && !isDeck ? kEavesM : 0.0;
  float verge = isRoof && !isDeck ? (ridge >= 1.0 ? kVergeOutM : kEavesM) : 0.0;
  vec3 local = vec3(unitCorner.x * (halves.x + over), 0.0, unitCorner.y * (halves.y + verge));
  float pitch = form.w / halves.x;
  local.y = level < 0.5 ? -placeFoot.w : form.z - over * pitch;
  if (level > 2.5) local = vec3(0.0, form.z + form.w, unitCorner.y * (halves.y * min(ridge, 1.0) + (ridge >= 1.0 ? verge : 0.0)));
  // Gables have no hip, hips no gable.
  bool isNone = (part == kHipPart && ridge >= 1.0) || (part == kGablePart && ridge < 1.0 && !isDeck) ||
                (part == kChimneyPart && use > 0.5);
  if (part == kChimneyPart)
    local = vec3(0.22 * form.x + 0.35 * unitCorner.x, level < 0.5 ? form.z : form.z + form.w + 0.7,
                 0.18 * form.y + 0.35 * unitCorner.y);
  if (isNone) local = vec3(0.0, form.z, 0.0);
  vec3 normal = unitNormal.xyz;
  if (part == kSlopePart) normal = normalize(vec3(unitNormal.x * form.w, halves.x, 0.0));
  if (part == kHipPart) normal = normalize(vec3(0.0, halves.y * (1.0 - ridge) + 1e-3, unitNormal.z * form.w));
  HouseVertex made;
  made.local = local;
  made.relative = placeFoot.xyz + ofPlace(local);
  made.normal = ofPlace(normal);
  made.part = part;
  return made;
}
