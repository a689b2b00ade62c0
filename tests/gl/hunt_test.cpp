// The hunt through shaders/shared as GLSL: every function that support/hunt_functions.inl lists, against the
// same statements in double. tests/stability has it in C++.
#include "support/hunt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader.h"
#include "support/gl_test.h"
#include "support/temporary_folder.h"

namespace skydrop::render::gl {
namespace {

constexpr std::size_t kGroup = 64;
constexpr std::uint64_t kSeed = 20;

// What Mesa's own functions are off by: its asin by 4e-4 (twice that here), its mix() by a rounding of the
// larger end.
double roomOf(const std::string& name) {
  if (name == "leastSunDogAzimuth") return 1e-3;
  if (name == "sunDogDegrees") return 0.03;
  return name == "cloudPhases" ? 1e-5 : 0;
}

class HuntGLTest : public test::GLTest {
 protected:
  // One function over `count` inputs from `first` on: how many fail, and the first of them.
  std::pair<std::uint64_t, std::string> huntOnGpu(const test::HuntedFunction& function, std::size_t count) {
    ComputeShader shader(context(), folder_.write("hunt.comp", R"(
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/atmospheric_optics.glsl"
#include "shared/cloud_form.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_noise.glsl"
#include "shared/cloud_sheet.glsl"
#include "shared/depth.glsl"
#include "shared/dialect.glsl"
#include "shared/flash.glsl"
#include "shared/gradient_noise.glsl"
#include "shared/grass_strip.glsl"
#include "shared/ground_detail.glsl"
#include "shared/erosion_lines.glsl"
#include "shared/ground_fog.glsl"
#include "shared/ground_picture.glsl"
#include "shared/guard_marks.glsl"
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/ice_clouds.glsl"
#include "shared/impostor.glsl"
#include "shared/lab/cloud.glsl"
#include "shared/lab/light.glsl"
#include "shared/lab/orbit.glsl"
#include "shared/lamp.glsl"
#include "shared/land_material.glsl"
#include "shared/light_shafts.glsl"
#include "shared/marker.glsl"
#include "shared/mirror_ray.glsl"
#include "shared/precipitation.glsl"
#include "shared/sea_waves.glsl"
#include "shared/spray.glsl"
#include "shared/sun_glitter.glsl"
#include "shared/terrain_lod.glsl"
#include "shared/tone_map.glsl"
#include "shared/places.glsl"
#include "shared/woods.glsl"
#include "shared/ground_cover.glsl"
#include "shared/water.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { float argumentsOf[]; };
layout(std430, binding = 1) writeonly buffer Out { float resultsOf[]; };
void main() {
  uint row = gl_GlobalInvocationID.x;
  float a[16];
  float r[4] = float[4](0.0, 0.0, 0.0, 0.0);
  for (uint i = 0u; i < 16u; ++i) a[i] = argumentsOf[row * 16u + i];
  )" + std::string(function.glsl) + R"(;
  for (uint i = 0u; i < 4u; ++i) resultsOf[row * 4u + i] = r[i];
}
)"));
    std::vector<float> arguments(count * test::kMostHuntArguments, 0.0f),
        results(count * test::kMostHuntResults);
    for (std::size_t i = 0; i < count; ++i) {
      const test::HuntInput input = huntInput(function, kSeed, i);
      std::ranges::copy(input, arguments.begin() + static_cast<std::ptrdiff_t>(i * test::kMostHuntArguments));
    }
    const Buffer in = Buffer::of(context(), std::span<const float>(arguments), Buffer::Use::fixed, "in");
    const Buffer out(context(), results.size() * sizeof(float), Buffer::Use::fixed, "out");
    in.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    out.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    shader.dispatch(static_cast<GLuint>(count / kGroup), 1);
    api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    out.read(0, std::as_writable_bytes(std::span(results)));
    std::uint64_t faults = 0;
    std::string first;
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<const float> input(arguments.data() + i * test::kMostHuntArguments,
                                         function.arguments.size());
      const std::span<const float> result(results.data() + i * test::kMostHuntResults,
                                          test::kMostHuntResults);
      const std::string fault = huntFault(function, input, result, roomOf(function.name));
      if (fault.empty()) continue;
      if (faults++ == 0)
        first = huntText(function, input) + ": " + fault + " (number " + std::to_string(i) + ")";
    }
    return {faults, first};
  }

  test::TemporaryFolder folder_;
};

TEST_F(HuntGLTest, sharedFunctionsKeepTheirContractAsGLSL) {
  // Results finite, in range, and those of double for the same inputs or inputs four units in the last place
  // away; what is no normal float may count as 0.
  const std::size_t count =
      (static_cast<std::size_t>(test::huntedInputs(512)) + kGroup - 1) / kGroup * kGroup;
  const char* only = std::getenv("SKYDROP_HUNT_ONLY");
  for (const test::HuntedFunction& function : test::huntedFunctions()) {
    if (only && std::string(only) != function.name) continue;
    const auto [faults, first] = huntOnGpu(function, count);
    EXPECT_EQ(faults, 0u) << first;
  }
}

}  // namespace
}  // namespace skydrop::render::gl
