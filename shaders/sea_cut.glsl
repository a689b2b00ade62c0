// Cuts off what lies below the plane of the sea, in programs of mirrored views (render::SeaCut). Called by vertex shaders with
// the place of the vertex relative to the eye.
#ifdef MIRRORED_VIEW
void cutBelowSea(vec3 relative) { gl_ClipDistance[0] = relative.y + frame.eye.x; }
#else
void cutBelowSea(vec3 relative) {}
#endif
