// Lamps that are looked at (render::LampGlow): a square of pixels around each.
#include "frame.glsl"

const int kMostGlows = 8;
uniform vec4 glowPlaces[kMostGlows];  // relative to the eye; where the veil ends (degrees)
uniform vec4 glowCores[kMostGlows];   // radiance of the lens; its spread (pixels)
uniform vec4 glowVeils[kMostGlows];   // times glareShape(); half the square's width (pixels)
