// The march as the thesis describes it, as a baseline: 128 steps over the ray's way through the layer, each with six
// samples of full detail on the way to the sun, no skipping, one ray a pixel. Same medium, same integral, same light.
#include "frame.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/field.glsl"
#include "clouds/occupancy.glsl"
#include "clouds/sun_depth.glsl"
#include "clouds/view.glsl"
#include "clouds/tiles.glsl"
#include "clouds/exact_march.glsl"
#include "clouds/resolve.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform writeonly image2D light;

const int kSteps = 128;
uniform int steps;  // kSteps: a constant bound would be unrolled

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= viewSize().x || pixel.y >= viewSize().y) return;
  vec3 ray = rayThrough(vec2(pixel) + 0.5);
  vec3 direction = normalize(ray);
  RaySpan span = spanOfRay(direction, sceneDistance(texelFetch(sceneDepth, pixel, 0).x, ray), Task(0u, 0.0, clouds.layer.z, 0u));
  Gathered march = Gathered(0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
  if (span.end > span.begin) {
    vec4 phases = cloudPhases(dot(direction, frame.toSun.xyz), clouds.scattering.x, clouds.scattering.y);
    float step = (span.end - span.begin) / float(steps);
    for (int i = 0; i < steps; ++i) {
      float middle = span.begin + (float(i) + 0.5) * step;
      vec3 place = placeOnBentRay(direction, rayBend(direction), middle);
      float height = heightFraction(place);
      float gain = march.transmittance *
                   stepOpacity(extinctionAt(place) * cloudFade(middle, clouds.layer.z) * step);
      march.sun += gain * scatteredSun(phases, sunDepth(place, height));
      march.sky += gain * scatteredSky(height);
      march.ground += gain * scatteredGround(height);
      march.weight += gain;
      march.distance += gain * middle;
      march.transmittance -= gain;
    }
  }
  imageStore(light, pixel, seenCloud(march, direction));
}
