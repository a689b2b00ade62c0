// A fragment of a building: plaster, wood or stone with windows and a door, tiles, planks.
#include "places/lit_place.glsl"
#include "shared/places.glsl"

uniform vec4 windowLight;  // rgb: radiance of a lit window, times the frame's exposure

struct HouseFace {
  vec3 local;
  vec3 normal;
  float part, use, bits;
  vec4 form;
  float litShare;   // of the windows
  float footprint;  // what a pixel covers, m
};

// What the surface is: albedo, the share that is glass, the share of that which is lit.
struct HouseSkin {
  vec3 albedo;
  float glass;
  float lit;
};

uint bitsOfFace(HouseFace face) { return placeBits(uint(face.bits), 5u, 6u); }

// A row of windows along a wall: x metres from its middle, y above the floor of that row.
HouseSkin windowsOn(HouseSkin skin, HouseFace face, float x, float y, float wide, float room, uint bits, vec3 shutters) {
  float count = max(floor(room / 2.7), 1.0);
  float period = room / count;
  float at = x / period + 0.5 * count;
  float number = floor(at);
  float inside = (at - number - 0.5) * period;
  float isOn = number >= 0.0 && number < count ? 1.0 : 0.0;
  float up = y - 1.55;
  float frameShare = stripCover(inside, 0.5 * wide + 0.12, face.footprint) * stripCover(up, 0.75, face.footprint) * isOn;
  float glass = stripCover(inside, 0.5 * wide, face.footprint) * stripCover(up, 0.63, face.footprint) * isOn;
  float boards = (stripCover(abs(inside) - 0.5 * wide - 0.36, 0.24, face.footprint)) * stripCover(up, 0.7, face.footprint) * isOn;
  uint own = placeBits(bits, uint(int(number) + 64), 11u);
  float isLit = byteOf(own, 1) < face.litShare ? 1.0 : 0.0;
  skin.albedo = mix(skin.albedo, shutters, boards);
  skin.albedo = mix(skin.albedo, vec3(0.62, 0.60, 0.56), frameShare);
  skin.albedo = mix(skin.albedo, vec3(0.028, 0.032, 0.038), glass);
  skin.glass = max(skin.glass, glass);
  skin.lit = mix(skin.lit, isLit, glass);
  return skin;
}

HouseSkin wallSkin(HouseFace face) {
  uint bits = bitsOfFace(face);
  float tone = byteOf(bits, 0), hue = byteOf(bits, 1);
  vec3 plaster = mix(vec3(0.58, 0.54, 0.46), vec3(0.50, 0.38, 0.22), smoothstep(0.45, 0.9, hue));
  plaster = mix(plaster, vec3(0.46, 0.27, 0.20), smoothstep(0.90, 0.97, hue));
  vec3 wood = mix(vec3(0.17, 0.105, 0.060), vec3(0.26, 0.20, 0.145), tone);
  bool isAlongWall = abs(face.normal.x) > abs(face.normal.z);
  float x = isAlongWall ? face.local.z : face.local.x;
  float room = (isAlongWall ? face.form.y : face.form.x) - 0.8;
  float boards = lineShare(x, 0.35, 0.06, face.footprint);
  HouseSkin skin = HouseSkin(plaster * mix(0.80, 1.08, tone), 0.0, 0.0);
  bool isBarn = face.use > 0.5 && face.use < 1.5, isChurch = face.use > 1.5 && face.use < 3.5, isDeck = face.use > 3.5;
  skin.albedo = isBarn ? wood * (1.0 - 0.5 * boards) : isChurch ? vec3(0.60, 0.57, 0.50) : skin.albedo;
  float upstairs = face.form.z > 4.5 ? 1.0 : 0.0;
  // Below: stone where walls go on, and what rain splashes.
  float base = saturate(0.5 - (face.local.y - 0.35) / max(face.footprint, 0.05));
  skin.albedo = mix(skin.albedo, vec3(0.21, 0.195, 0.175), isDeck ? 0.0 : base);
  skin.albedo *= mix(0.86, 1.0, saturate(face.local.y / 1.5 + 0.3));
  vec3 shutters = hue < 0.35 ? vec3(0.055, 0.12, 0.065) : hue < 0.65 ? vec3(0.20, 0.06, 0.04) : vec3(0.12, 0.16, 0.20);
  int rows = face.use < 0.5 ? 1 : 0;
  for (int row = 0; row < rows; ++row) {
    // Upstairs, or below the gable: one window there.
    bool isUp = face.local.y > 2.65 && (upstairs > 0.5 || (!isAlongWall && face.form.w > 2.8));
    uint side = (isAlongWall ? 7u : 3u) + (face.normal.x + face.normal.z > 0.0 ? 31u : 0u) + (isUp ? 100u : 0u);
    skin = windowsOn(skin, face, x, face.local.y - (isUp ? 2.65 : 0.1), 0.95, isUp && upstairs < 0.5 ? 2.7 : room, bits + side, shutters);
    // The door, on one of the long sides.
    float door = isAlongWall && face.normal.x > 0.0 ? stripCover(x - 0.18 * room, 0.55, face.footprint) * stripCover(face.local.y - 1.0, 1.1, face.footprint) : 0.0;
    skin.albedo = mix(skin.albedo, shutters * 0.8, door);
    skin.glass *= 1.0 - door;
  }
  // Tall windows of a nave, openings of a steeple, a barn's gate.
  float tall = isChurch ? stripCover(face.use > 2.5 ? x : (x / 4.0 - floor(x / 4.0) - 0.5) * 4.0, 0.5, face.footprint) *
                              stripCover(face.local.y - (face.use > 2.5 ? face.form.z - 1.8 : 3.6), face.use > 2.5 ? 1.0 : 1.7, face.footprint) *
                              (isAlongWall || face.use > 2.5 ? 1.0 : 0.0) : 0.0;
  skin.albedo = mix(skin.albedo, vec3(0.035), tall);
  float gate = isBarn && !isAlongWall ? stripCover(x, 1.8, face.footprint) * stripCover(face.local.y - 1.6, 1.7, face.footprint) : 0.0;
  skin.albedo = mix(skin.albedo, vec3(0.05, 0.035, 0.025), gate);
  skin.albedo = isDeck ? vec3(0.165, 0.135, 0.105) * mix(0.8, 1.15, tone) : skin.albedo;
  return skin;
}

HouseSkin roofSkin(HouseFace face) {
  uint bits = bitsOfFace(face);
  float tone = byteOf(bits, 2), hue = byteOf(bits, 3);
  vec3 tiles = mix(vec3(0.27, 0.105, 0.062), vec3(0.185, 0.092, 0.062), tone);
  tiles = hue > 0.70 ? mix(vec3(0.085, 0.086, 0.092), vec3(0.14, 0.13, 0.12), tone) : tiles;
  bool isChurch = face.use > 1.5 && face.use < 3.5;
  tiles = isChurch ? vec3(0.105, 0.110, 0.118) : tiles;
  tiles = face.use > 0.5 && face.use < 1.5 ? tiles * vec3(0.85, 0.9, 0.95) : tiles;
  float down = face.local.y;
  float courses = lineShare(down, 0.36, 0.10, face.footprint);
  float weather = byteOf(placeBits(bits, uint(int(face.local.z * 0.9) + 4096), uint(int(face.local.y * 1.3) + 4096)), 0) - 0.5;
  HouseSkin skin = HouseSkin(tiles * (1.0 - 0.35 * (courses - 0.28) + 0.22 * weather * saturate(1.5 - face.footprint)), 0.0, 0.0);
  // Planks across a deck.
  float planks = lineShare(face.local.z, 0.25, 0.03, face.footprint);
  vec3 deck = face.form.x > 4.0 ? vec3(0.118, 0.116, 0.112) : vec3(0.245, 0.205, 0.155) * (1.0 - 0.5 * planks);
  skin.albedo = face.use > 3.5 ? deck : skin.albedo;
  return skin;
}

vec3 houseColor(HouseFace face, vec3 worldNormal, vec3 relative, PlaceLight light, float passed) {
  bool isRoof = face.part > 1.5 && face.part < 3.5;
  // Loops that run once or not at all stand for branches: a software renderer runs both sides of a branch.
  HouseSkin skin = HouseSkin(vec3(0.2), 0.0, 0.0);
  int walls = isRoof ? 0 : 1, roofs = isRoof ? 1 : 0;
  for (int i = 0; i < walls; ++i) skin = wallSkin(face);
  for (int i = 0; i < roofs; ++i) skin = roofSkin(face);
  skin.albedo = face.part > 3.5 ? vec3(0.24, 0.16, 0.125) : skin.albedo;
  skin.glass = face.part > 3.5 ? 0.0 : skin.glass;
  // In the shade of the eaves; less sky at the foot.
  float overhang = isRoof || face.part > 3.5 || face.use > 3.5 ? 1.0
      : 1.0 - 0.45 * smoothstep(face.form.z - 0.9, face.form.z, face.local.y) * (face.part < 0.5 ? 1.0 : 0.0);
  float open = isRoof ? 1.0 : 0.92 * overhang * mix(0.72, 1.0, saturate(face.local.y / 3.0 + 0.2));
  vec3 color = placeRadiance(light, skin.albedo, worldNormal, open, overhang);
  // Glass mirrors the sky at grazing angles.
  vec3 toEye = -normalize(relative);
  float facing = saturate(dot(toEye, worldNormal));
  float mirror = 0.05 + 0.6 * pow(1.0 - facing, 4.0);
  color += skin.glass * (1.0 - skin.lit) * mirror * mix(light.below, light.above, 0.6);
  color += windowLight.rgb * (skin.glass * skin.lit * passed);
  return color;
}

// face: part, use, bits, ridge. The normal in the building's own frame follows from where on it the place is: sides are told
// apart by which wall is nearer.
HouseFace houseFace(vec3 local, vec3 relative, vec3 normal, vec4 face, vec4 form, float litShare) {
  vec2 past = abs(local.xz) - 0.5 * form.xy;
  vec3 own = past.x > past.y ? vec3(sign(local.x), 0.0, 0.0) : vec3(0.0, 0.0, sign(local.z));
  float distanceM = length(relative);
  float facing = abs(dot(normal, relative)) / distanceM;
  float footprint = distanceM * frame.depthToSea.w / sqrt(clamp(facing, 0.25, 1.0));
  return HouseFace(local, own, face.x, face.y, face.z, form, litShare, footprint);
}
