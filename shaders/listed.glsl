// Lists that one dispatch makes and a later, indirect one goes through (src/render/frame/list_groups.h): places of a picture
// in a word, and the rows of groups of such a dispatch.
const uint kGroupsARow = 1024u;

uint packedPlace(ivec2 at) { return uint(at.x) | uint(at.y) << 16u; }
ivec2 unpackedPlace(uint at) { return ivec2(at & 0xffffu, at >> 16u); }
