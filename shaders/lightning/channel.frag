#include "lightning/channel.glsl"

in vec2 pixels;
flat in float pixelsLong;
flat in vec3 radiance;
flat in float spread;
flat in float distanceM;
flat in float most;
out vec4 color;

void main() {
  discardIfHidden();
  color = vec4(channelAt(pixels, pixelsLong, radiance, spread, distanceM, most), 0.0);
}
