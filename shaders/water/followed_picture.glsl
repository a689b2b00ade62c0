// The picture through whose depths mirrored rays are followed: the scene's own, or with MIRRORED_SCENE one from the eye's
// mirror image (render::MirroredScene), in which nothing lies below the sea. Included after water/sea_pixel.glsl.
layout(binding = 6) uniform sampler2D pictureLight;

#ifdef MIRRORED_SCENE
layout(binding = 7) uniform sampler2D pictureDepth;
uniform mat4 toPicture;    // of places relative to the eye of the scene
uniform vec2 pictureSize;  // pixels

vec4 clipInPicture(vec4 relative) { return toPicture * relative; }

vec2 sizeOfPicture() { return pictureSize; }

float pictureViewZ(ivec2 pixel) { return viewZOfDepth(texelFetch(pictureDepth, pixel, 0).r, frame.eye.y); }

// How far a place of a ray is behind what the picture shows there.
float behindPicture(vec3 at) { return at.z - pictureViewZ(ivec2(at.xy)); }
#else
vec4 clipInPicture(vec4 relative) { return frame.viewProjection * relative; }

vec2 sizeOfPicture() { return frame.viewport.xy; }

float pictureViewZ(ivec2 pixel) { return sceneViewZ(pixel); }

// The sea, above which the ray is, hides nothing.
float behindPicture(vec3 at) {
  ivec2 pixel = ivec2(at.xy);
  float viewZ = pictureViewZ(pixel);
  return isSeaAt(pixel, viewZ, rayOf(pixel)) ? -1.0 : at.z - viewZ;
}
#endif
