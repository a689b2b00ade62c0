// shaders/shared as GLSL against the same files as C++ float.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader.h"
#include "support/gl_test.h"
#include "support/temporary_folder.h"

namespace skydrop::render::gl {
namespace {

namespace shared = core::shared::f32;

constexpr std::size_t kCount = 4096;

class SharedGLTest : public test::GLTest {
 protected:
  // Runs `body` for each of kCount rows: `vec4 a` is the row's input, `vec4 r` and `uvec4 u` its results.
  void run(const std::vector<glm::vec4>& input, const std::string& body) {
    ComputeShader shader(context(), folder_.write("run.comp", R"(
#include "shared/dialect.glsl"
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/depth.glsl"
#include "shared/atmosphere.glsl"
#include "shared/tone_map.glsl"
#include "shared/marker.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { vec4 rowsIn[]; };
layout(std430, binding = 1) writeonly buffer Floats { vec4 rowsOut[]; };
layout(std430, binding = 2) writeonly buffer Uints { uvec4 rowsBits[]; };
void main() {
  vec4 a = rowsIn[gl_GlobalInvocationID.x];
  vec4 r = vec4(0.0);
  uvec4 u = uvec4(0u);
)" + body + R"(
  rowsOut[gl_GlobalInvocationID.x] = r;
  rowsBits[gl_GlobalInvocationID.x] = u;
}
)"));
    const Buffer in = Buffer::of(context(), std::span<const glm::vec4>(input), Buffer::Use::fixed, "in");
    const Buffer floats(context(), kCount * sizeof(glm::vec4), Buffer::Use::fixed, "floats");
    const Buffer bits(context(), kCount * sizeof(glm::uvec4), Buffer::Use::fixed, "bits");
    in.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    floats.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    bits.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    shader.dispatch(kCount / 64, 1);
    api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    floats.read(0, std::as_writable_bytes(std::span(result_)));
    bits.read(0, std::as_writable_bytes(std::span(bits_)));
  }

  // Uniform in [0, 1) in every component.
  static std::vector<glm::vec4> randomRows(std::uint64_t seed) {
    core::RandomStream random{seed, 0};
    std::vector<glm::vec4> rows(kCount);
    for (glm::vec4& row : rows) {
      for (int c = 0; c < 4; ++c) row[c] = static_cast<float>(random.nextUnit());
    }
    return rows;
  }

  static shared::Atmosphere air() {
    shared::Atmosphere air{};
    air.rayleigh = {5.802e-6f, 13.558e-6f, 33.1e-6f};
    air.rayleighHeight = 8000;
    air.haze = 5e-5f;
    air.hazeHeight = 1200;
    air.hazeAlbedo = 0.94f;
    air.hazeAnisotropy = 0.76f;
    return air;
  }
  static constexpr const char* kAir =
      "Atmosphere air = Atmosphere(vec3(5.802e-6, 13.558e-6, 33.1e-6), 8000.0, 5e-5, 1200.0, 0.94, 0.76);\n";

  test::TemporaryFolder folder_;
  std::vector<glm::vec4> result_ = std::vector<glm::vec4>(kCount);
  std::vector<glm::uvec4> bits_ = std::vector<glm::uvec4>(kCount);
};

TEST_F(SharedGLTest, hashesAreEqualInEveryBit) {
  // Integer hashes of lattice points, negative ones included (as two's complement).
  std::vector<glm::vec4> rows = randomRows(1);
  for (glm::vec4& row : rows) row = glm::floor(row * 20000.0f - 10000.0f);
  run(rows, "uvec3 p = uvec3(ivec3(a.xyz)); u = uvec4(hash3(p), hash2(p.xy).x); r = vec4(unitOf(u.x));");
  int different = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::u32vec3 p(glm::ivec3(rows[i]));
    const glm::u32vec3 h = shared::hash3(p);
    different += glm::uvec4(h.x, h.y, h.z, shared::hash2({p.x, p.y}).x) != bits_[i];
    different +=
        std::bit_cast<std::uint32_t>(shared::unitOf(h.x)) != std::bit_cast<std::uint32_t>(result_[i].x);
  }
  EXPECT_EQ(different, 0);
}

TEST_F(SharedGLTest, guardsAndDepthAgree) {
  // Remap, depth and its inverse within two roundings (1.2e-7 relative); the series within what Mesa's exp
  // gives (5e-6).
  std::vector<glm::vec4> rows = randomRows(2);
  for (glm::vec4& row : rows) row.w = std::exp(row.w * 25.0f - 12.0f);
  run(rows,
      "r = vec4(remapClamped(a.x, a.y, a.z, 1.0, 3.0), depthOfViewZ(a.w, 0.1), distanceOfDepth(a.x, 0.1, 1.0 "
      "+ a.y), "
      "oneMinusExpOverX(a.w));");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    ASSERT_NEAR(result_[i].x, shared::remapClamped(a.x, a.y, a.z, 1, 3), 3e-6f);
    ASSERT_NEAR(result_[i].y / shared::depthOfViewZ(a.w, 0.1f), 1, 2.5e-7f);
    ASSERT_NEAR(result_[i].z / shared::distanceOfDepth(a.x, 0.1f, 1 + a.y), 1, 5e-7f);
    ASSERT_NEAR(result_[i].w / shared::oneMinusExpOverX(a.w), 1, 5e-6f);
  }
}

TEST_F(SharedGLTest, C01_phaseFunctionAgreesUpToItsLimit) {
  // g to 0.95 and beyond, cosines to +-1: within 1e-5 relative, and never infinite.
  std::vector<glm::vec4> rows = randomRows(3);
  for (std::size_t i = 0; i < kCount; ++i) {
    rows[i].x = i % 8 == 0 ? 1.0f : i % 8 == 1 ? -1.0f : rows[i].x * 2 - 1;
    rows[i].y = i % 16 < 2 ? 0.9999f : rows[i].y * 1.9f - 0.95f;
  }
  run(rows, "r = vec4(henyeyGreenstein(a.x, a.y), rayleighPhase(a.x), 0.0, 0.0);");
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_NEAR(result_[i].x / shared::henyeyGreenstein(rows[i].x, rows[i].y), 1, 1e-5f);
    ASSERT_NEAR(result_[i].y / shared::rayleighPhase(rows[i].x), 1, 1e-6f);
  }
}

TEST_F(SharedGLTest, C14_distanceComesBackFromDepth) {
  // On the GPU from 1 m to 1e7 m, corners included, within 1e-4 relative; depth 0 is the far marker.
  std::vector<glm::vec4> rows = randomRows(6);
  for (glm::vec4& row : rows) row = {std::pow(10.0f, row.x * 7), 1 + 0.6f * row.y, 0, 0};
  run(rows,
      "r.x = distanceOfDepth(depthOfViewZ(a.x / a.y, 0.1), 0.1, a.y); r.y = distanceOfDepth(0.0, 0.1, a.y);");
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_NEAR(result_[i].x / rows[i].x, 1, 1e-4f);
    ASSERT_EQ(result_[i].y, 1e30f);
  }
}

TEST_F(SharedGLTest, skyAgrees) {
  // Every direction, sun and height: within 5e-5 of the brightest channel. Mesa's exp is good to 3e-6, and
  // the earth's shadow multiplies rounding by its exponent.
  const std::vector<glm::vec4> rows = randomRows(4);
  run(rows, std::string(kAir) +
                "SkySource s = skySource(make_skyColumn(air, a.x * 5000.0, a.z * 1.3 - 0.3), air, a.y);\n"
                "r.xyz = skyRadiance(s, a.w * 2.0 - 1.0, 0.76);\n"
                "r.w = opticalDepthBetween(air, a.x * 3000.0, a.y * 3000.0, a.w * 1e5).y;");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const glm::vec3 expected = shared::skyRadiance(
        shared::skySource(shared::make_skyColumn(air(), a.x * 5000, a.z * 1.3f - 0.3f), air(), a.y),
        a.w * 2 - 1, 0.76f);
    const float scale = std::max({expected.x, expected.y, expected.z, 1e-6f});
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(result_[i][c], expected[c], 5e-5f * scale);
    const float depth = shared::opticalDepthBetween(air(), a.x * 3000, a.y * 3000, a.w * 1e5f).y;
    ASSERT_NEAR(result_[i].w, depth, 1e-5f * depth + 1e-7f);
  }
}

TEST_F(SharedGLTest, toneMapAndEncodingAgree) {
  // From darkness to the sun: within a fiftieth of a step of 8 bits.
  std::vector<glm::vec4> rows = randomRows(5);
  for (glm::vec4& row : rows) row = glm::exp(row * 20.0f - 10.0f);
  run(rows, "r.xyz = srgbEncode(toneMap(a.xyz)); r.w = srgbDecode1(fract(a.w));");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec3 expected = shared::srgbEncode(shared::toneMap(glm::vec3(rows[i])));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(result_[i][c], expected[c], 0.02f / 255);
    ASSERT_NEAR(result_[i].w, shared::srgbDecode1(rows[i].w - std::floor(rows[i].w)), 0.02f / 255);
  }
}

TEST_F(SharedGLTest, markerAgrees) {
  // Rays that pass a beam 20 to 620 m away, from below its foot to above its top: the ring's share of a pixel
  // within 1e-6; the beam's opacity within 1e-4 (the rounding of a ray at 600 m against a radius of 4 m).
  const std::vector<glm::vec4> rows = randomRows(6);
  run(rows,
      "vec3 foot = vec3(20.0 + a.x * 600.0, a.y * 700.0 - 600.0, 0.0);\n"
      "vec3 d = normalize(foot + vec3(0.0, a.z * 500.0, a.w * 12.0 - 6.0));\n"
      "vec2 t = beamInterval(d, foot, 4.0);\n"
      "r.x = t.y > t.x ? beamOpacity(beamOpticalDepth(d, foot, 4.0, t.x, t.y)) : 0.0;\n"
      "r.y = ringCoverage(94.0 + a.x * 12.0, 100.0, a.y * 9.0);");
  int hits = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const glm::vec3 foot(20 + a.x * 600, a.y * 700 - 600, 0);
    const glm::vec3 d = glm::normalize(foot + glm::vec3(0, a.z * 500, a.w * 12 - 6));
    const glm::vec2 t = shared::beamInterval(d, foot, 4);
    const float opacity =
        t.y > t.x ? shared::beamOpacity(shared::beamOpticalDepth(d, foot, 4, t.x, t.y)) : 0.0f;
    hits += opacity > 0.1f;
    ASSERT_NEAR(result_[i].x, opacity, 1e-4f);
    ASSERT_NEAR(result_[i].y, shared::ringCoverage(94 + a.x * 12, 100, a.y * 9), 1e-6f);
  }
  EXPECT_GT(hits, static_cast<int>(kCount / 4));
}

}  // namespace
}  // namespace skydrop::render::gl
