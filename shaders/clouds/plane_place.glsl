// Where a cloud plane is, and where its texture lies on it.
#include "frame.glsl"

uniform float radiusM;
uniform float riseM;          // of the plane above the eye
uniform float texturesPerM;   // one over the texture's period
uniform vec2 textureAnchor;   // texture coordinates below the eye, wrapped to [0, 1)
uniform vec2 weatherAnchor;   // the same of the second copy, which makes cover change over a wider period
uniform vec4 weatherTurn;     // the columns of a matrix from the first copy's coordinates to the second's

uniform vec2 fineAnchor;       // the same of the third copy, which frays edges
uniform vec4 fineTurn;

vec3 planePoint(vec2 place) { return vec3(place.x * radiusM, riseM, place.y * radiusM); }
vec2 texturePlaceOf(vec2 fromEye) { return textureAnchor + fromEye * texturesPerM; }
vec2 weatherPlaceOf(vec2 fromEye) { return weatherAnchor + mat2(weatherTurn.xy, weatherTurn.zw) * (fromEye * texturesPerM); }
vec2 finePlaceOf(vec2 fromEye) { return fineAnchor + mat2(fineTurn.xy, fineTurn.zw) * (fromEye * texturesPerM); }
