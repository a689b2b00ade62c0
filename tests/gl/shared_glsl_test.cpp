// shaders/shared as GLSL against the same files as C++ float.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/shared_ground_detail.h"
#include "skydrop/core/shared_woods.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader.h"
#include "support/gl_test.h"
#include "support/margin.h"
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
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/depth.glsl"
#include "shared/dialect.glsl"
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/land_material.glsl"
#include "shared/ground_detail.glsl"
#include "shared/marker.glsl"
#include "shared/tone_map.glsl"
#include "shared/woods.glsl"
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
      "Atmosphere air = Atmosphere(vec3(5.802e-6, 13.558e-6, 33.1e-6), 8000.0, 5e-5, 1200.0, 0.94, 0.76, "
      "vec3(0.0));\n";

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
    ASSERT_TRUE(test::holds("C01",
                            test::apart(result_[i].x / shared::henyeyGreenstein(rows[i].x, rows[i].y), 1),
                            test::atMost(1e-5f), "relative"));
    ASSERT_TRUE(test::holds("C01", test::apart(result_[i].y / shared::rayleighPhase(rows[i].x), 1),
                            test::atMost(1e-6f), "relative"));
  }
}

TEST_F(SharedGLTest, C14_distanceComesBackFromDepth) {
  // On the GPU from 1 m to 1e7 m, corners included, within 1e-4 relative; depth 0 is the far marker.
  std::vector<glm::vec4> rows = randomRows(6);
  for (glm::vec4& row : rows) row = {std::pow(10.0f, row.x * 7), 1 + 0.6f * row.y, 0, 0};
  run(rows,
      "r.x = distanceOfDepth(depthOfViewZ(a.x / a.y, 0.1), 0.1, a.y); r.y = distanceOfDepth(0.0, 0.1, a.y);");
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(
        test::holds("C14", test::apart(result_[i].x / rows[i].x, 1), test::atMost(1e-4f), "relative"));
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

TEST_F(SharedGLTest, placesInTheSkysTablesAgree) {
  // Every direction from 0 to 20 km: rows and columns within 1e-3 of a texel (the root beside the horizon
  // doubles rounding), slices within 1e-5.
  const std::vector<glm::vec4> rows = randomRows(8);
  run(rows,
      "float horizon = horizonSine(a.x * 20000.0);\n"
      "r = vec4(skyTableRow(a.y * 2.0 - 1.0, horizon, 1.0), skyTableColumn(a.z * 2.0 - 1.0), "
      "skyTableSlice(a.w * 1e5), horizon);");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const float horizon = shared::horizonSine(a.x * 20000);
    ASSERT_NEAR(result_[i].x, shared::skyTableRow(a.y * 2 - 1, horizon, 1), 1e-3f);
    ASSERT_NEAR(result_[i].y, shared::skyTableColumn(a.z * 2 - 1), 1e-5f);
    ASSERT_NEAR(result_[i].z, shared::skyTableSlice(a.w * 1e5f), 1e-5f);
    ASSERT_NEAR(result_[i].w, horizon, 1e-6f);
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
      "r.x = t.y > t.x ? beamOpacity(beamOpticalDepth(d, foot, 4.0, t.x, t.y)) : 0.0;");
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
  }
  EXPECT_GT(hits, static_cast<int>(kCount / 4));
  std::vector<glm::vec4> rings = rows;
  for (glm::vec4& ring : rings) ring = {94 + ring.x * 12, 100, ring.y * 9, 0};
  run(rings, "r.x = ringCoverage(a.x, a.y, a.z);");
  for (std::size_t i = 0; i < kCount; ++i)
    ASSERT_NEAR(result_[i].x, shared::ringCoverage(rings[i].x, rings[i].y, rings[i].z), 1e-6f);
}

TEST_F(SharedGLTest, C03_C04_opacityOfAStepDoesNotCancel) {
  // Within 1e-5 relative of expm1 in double, for depths from 1e-9 to 1e4 (Mesa's exp is good to 3e-6); 0 for
  // what is no depth, 1 for an endless one.
  std::vector<glm::vec4> rows = randomRows(7);
  for (glm::vec4& row : rows) row.x = std::pow(10.0f, row.x * 13 - 9);
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  const std::array<std::pair<float, float>, 6> edges = {{{0.0f, 0.0f},
                                                         {-1.0f, 0.0f},
                                                         {-kEndless, 0.0f},
                                                         {kEndless, 1.0f},
                                                         {1e30f, 1.0f},
                                                         {std::nanf(""), 0.0f}}};
  for (std::size_t i = 0; i < edges.size(); ++i) rows[i].x = edges[i].first;
  run(rows, "r.x = stepOpacity(a.x);");
  for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_EQ(result_[i].x, edges[i].second) << edges[i].first;
  for (std::size_t i = edges.size(); i < kCount; ++i) {
    ASSERT_TRUE(test::holds("C03 C04",
                            test::apart(result_[i].x / -std::expm1(-static_cast<double>(rows[i].x)), 1),
                            test::atMost(1e-5), "relative"))
        << rows[i].x;
  }
}

TEST_F(SharedGLTest, C05_C06_cloudDensityAgreesAndIsAShare) {
  // Noise far out of range, coverage from below 0 to beyond 1: density in [0, 1], none without coverage, and
  // that of floats on the processor within 2e-5 (remaps divide by as little as 0.05).
  std::vector<glm::vec4> rows = randomRows(8);
  for (std::size_t i = 0; i < kCount; ++i) {
    if (i % 4 == 0) rows[i] = rows[i] * 20.0f - 10.0f;
    if (i % 16 == 1) rows[i].y = 0;
    if (i % 16 == 2) rows[i].y = 1;
  }
  run(rows,
      "CloudMedium m = CloudMedium(0.4, a.y, 0.1, 0.35);\n"
      "r.x = cloudShapeDensity(m, a.x, vec4(a.z, 0.0, a.w, 1.0), a.w * 0.7 + 0.4);\n"
      "r.y = cloudDensity(m, a.x, vec4(a.z, 0.0, a.w, 1.0), a.w * 0.7 + 0.4, fract(a.z));\n"
      "r.z = remapClamped(a.x, a.w, a.w, 0.25, 0.75);\n"
      "r.w = cloudProfile(a.x, a.w);");
  int clouds = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4 &a = rows[i], &r = result_[i];
    const shared::CloudMedium medium{0.4f, a.y, 0.1f, 0.35f};
    const shared::Vec4 weather(a.z, 0, a.w, 1);
    ASSERT_TRUE(test::holds(
        "C05 C06", test::apart(r.x, shared::cloudShapeDensity(medium, a.x, weather, a.w * 0.7f + 0.4f)),
        test::atMost(2e-5f), "density"));
    ASSERT_TRUE(test::holds("C05 C06",
                            test::apart(r.y, shared::cloudDensity(medium, a.x, weather, a.w * 0.7f + 0.4f,
                                                                  a.z - std::floor(a.z))),
                            test::atMost(2e-5f), "density"));
    ASSERT_EQ(r.z, a.x < a.w ? 0.25f : 0.75f) << "equal bounds are a step";
    ASSERT_TRUE(test::holds("C05 C06", test::apart(r.w, shared::cloudProfile(a.x, a.w)), test::atMost(2e-5f),
                            "density"));
    for (const float share : {r.x, r.y, r.w}) ASSERT_TRUE(share >= 0 && share <= 1);
    ASSERT_TRUE(a.y * a.z > 0 || (r.x == 0 && r.y == 0)) << "cloud without coverage";
    clouds += r.y > 0;
  }
  EXPECT_GT(clouds, static_cast<int>(kCount / 20));
}

TEST_F(SharedGLTest, C09_stretchInABoxIsThatOfDoubles) {
  // Rays around boxes of a metre to 100 km, and rays between the points of a lattice that holds a box's
  // faces, edges and corners: hit or not as in double, and where within 1e-4 of the scale. Turned inside out
  // a box is empty.
  core::RandomStream random{10, 0};
  const auto unit = [&] { return static_cast<float>(random.nextUnit() * 2 - 1); };
  const auto vector = [&] { return glm::vec3(unit(), unit(), unit()); };
  const std::array<float, 7> lattice = {-2, -1, -0.5f, 0, 0.5f, 1, 2};
  const auto onLattice = [&] { return lattice[static_cast<std::size_t>(random.next() % lattice.size())]; };
  std::vector<glm::vec4> rows(kCount);  // in pairs: origin and scale, direction
  for (std::size_t i = 0; i < kCount; i += 2) {
    glm::vec3 origin(onLattice(), onLattice(), onLattice()), direction(0);
    float scale = 1;
    if (i % 4 == 0) {
      scale = std::pow(10.0f, static_cast<float>(i / 4 % 6));
      origin = vector() * (2 * scale);
      direction = glm::normalize(vector() * (1.3f * scale) - origin);
    }
    while (direction == glm::vec3(0)) direction = glm::floor(vector() * 1.5f + 0.5f);
    rows[i] = glm::vec4(origin, scale);
    rows[i + 1] = glm::vec4(direction, 0);
  }
  run(rows,
      "vec3 direction = rowsIn[gl_GlobalInvocationID.x | 1u].xyz;\n"
      "RaySpan s = raySpanOfBox(a.xyz, direction, vec3(-a.w), vec3(a.w));\n"
      "RaySpan none = raySpanOfBox(a.xyz, direction, vec3(a.w), vec3(-a.w));\n"
      "r = vec4(s.begin, s.end, none.end > none.begin ? 1.0 : 0.0, 0.0);");
  int hits = 0;
  for (std::size_t i = 0; i < kCount; i += 2) {
    const double scale = rows[i].w;
    const auto exact = core::shared::f64::raySpanOfBox(glm::dvec3(rows[i]), glm::dvec3(rows[i + 1]),
                                                       glm::dvec3(-scale), glm::dvec3(scale));
    const bool isHit = exact.end > exact.begin;
    ASSERT_EQ(result_[i].y > result_[i].x, isHit) << i;
    ASSERT_EQ(result_[i].z, 0);
    hits += isHit;
    if (!isHit) continue;
    ASSERT_TRUE(test::holds("C09", test::apart(result_[i].x, exact.begin), test::atMost(1e-4 * scale), "m"));
    ASSERT_TRUE(test::holds("C09", test::apart(result_[i].y, exact.end), test::atMost(1e-4 * scale), "m"));
  }
  EXPECT_TRUE(hits > 500 && hits < 1600) << hits;
}

TEST_F(SharedGLTest, forestDensityAgrees) {
  // Trees that the CPU plants stand in the woods that the GPU paints: within 2e-5 (smooth steps multiply
  // rounding by 15).
  const std::vector<glm::vec4> rows = randomRows(13);
  run(rows,
      "LandNoise noise = LandNoise(a.w * 2.0 - 1.0, a.x - 0.5, a.y - 0.5, 0.0, 0.0);\n"
      "r.x = forestDensity(a.x * 900.0, 0.6 + 0.4 * a.y, a.z - 0.5, noise);");
  int wooded = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const float exact = shared::forestDensity(a.x * 900, 0.6f + 0.4f * a.y, a.z - 0.5f,
                                              {a.w * 2 - 1, a.x - 0.5f, a.y - 0.5f, 0, 0});
    ASSERT_NEAR(result_[i].x, exact, 2e-5f);
    wooded += exact > 0.1f;
  }
  EXPECT_GT(wooded, 500);
}

TEST_F(SharedGLTest, treesAgree) {
  // A tree that is drawn is the tree that is flown into: the same stem, kind, turn and tint bit by bit, sizes
  // and hues within rounding. The noise that decides about woods, over cells of both signs, within 1e-5.
  const std::vector<glm::vec4> rows = randomRows(17);
  const auto cellOf = [](const glm::vec4& a) {
    return shared::Uvec2(static_cast<std::uint32_t>(static_cast<int>(a.x * 2e6f) - 1000000),
                         static_cast<std::uint32_t>(static_cast<int>(a.y * 2e6f) - 1000000));
  };
  const std::string tree =
      "uint bits = treeBits(uvec2(uint(int(a.x * 2e6) - 1000000), uint(int(a.y * 2e6) - 1000000)));\n"
      "LandNoise noise = LandNoise(a.w * 2.0 - 1.0, a.x - 0.5, a.y - 0.5, 0.0, 0.0);\n"
      "Tree tree = treeOf(bits, a.z * 800.0, 0.7 + 0.3 * a.w, noise, 0.9);\n";
  run(rows, tree +
                "r = vec4(tree.heightM, tree.radiusM, tree.leafy, treeWidthAt(tree, a.y * tree.heightM));\n"
                "u = uvec4(uint(tree.kind), floatBitsToUint(tree.turn), floatBitsToUint(tree.tint), bits);");
  std::array<int, shared::kTreeKinds> kinds{};
  int stand = 0, apart = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::Uint bits = shared::treeBits(cellOf(a));
    const shared::Tree exact =
        shared::treeOf(bits, a.z * 800, 0.7f + 0.3f * a.w, {a.w * 2 - 1, a.x - 0.5f, a.y - 0.5f, 0, 0}, 0.9f);
    ASSERT_EQ(bits_[i].w, bits);
    ASSERT_EQ(bits_[i].y, std::bit_cast<std::uint32_t>(exact.turn));
    ASSERT_EQ(bits_[i].z, std::bit_cast<std::uint32_t>(exact.tint));
    if (bits_[i].x != static_cast<std::uint32_t>(exact.kind)) {  // a place on the border of two kinds
      ++apart;
      continue;
    }
    ASSERT_NEAR(result_[i].x, exact.heightM, 1e-2f);
    ASSERT_NEAR(result_[i].y, exact.radiusM, 3e-3f);
    ASSERT_NEAR(result_[i].z, exact.leafy, 1e-5f);
    ASSERT_NEAR(result_[i].w, shared::treeWidthAt(exact, a.y * exact.heightM), 0.02f);
    stand += exact.heightM > 0;
    if (exact.heightM > 0) ++kinds[static_cast<std::size_t>(exact.kind)];
  }
  EXPECT_LE(apart, 2);
  EXPECT_GT(stand, 800);
  for (const int count : kinds) EXPECT_GT(count, 25);

  run(rows,
      "uvec2 chunk = uvec2(uint(int(a.x * 2000.0) - 1000), uint(int(a.y * 2000.0) - 1000));\n"
      "LandNoise noise = woodNoise(chunk, a.zw * 4000.0 - 2000.0);\n"
      "vec2 stem = treeStem(treeBits(chunk));\n"
      "r = vec4(noise.region, noise.grove, noise.tuft, stem.x);");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::Uvec2 chunk(static_cast<std::uint32_t>(static_cast<int>(a.x * 2000) - 1000),
                              static_cast<std::uint32_t>(static_cast<int>(a.y * 2000) - 1000));
    const shared::LandNoise exact = shared::woodNoise(chunk, {a.z * 4000 - 2000, a.w * 4000 - 2000});
    ASSERT_NEAR(result_[i].x, exact.region, 1e-5f);
    ASSERT_NEAR(result_[i].y, exact.grove, 1e-4f);
    ASSERT_NEAR(result_[i].z, exact.tuft, 1e-4f);
    ASSERT_NEAR(result_[i].w, shared::treeStem(shared::treeBits(chunk)).x, 1e-6f);
  }
}

TEST_F(SharedGLTest, groundDetailAgrees) {
  // Pieces are those of C++ in every bit where none of two is as near as the other, their weights and the
  // layers of rock within 1e-4 (Mesa's quotients), picks and planes within 1e-5.
  const std::vector<glm::vec4> rows = randomRows(21);
  run(rows,
      "DetailPieces p = detailPieces(uvec2(uint(int(a.x * 2e6) - 1000000), uint(int(a.y * 2e6) - 1000000)), "
      "a.zw, 3u);\n"
      "r = vec4(p.weights, detailMip(groundPictureLevel(a.x * 2.0 + 1e-3, 0.03)));\n"
      "u = uvec4(p.first, p.second, p.third, 0u);");
  const auto cellOf = [](const glm::vec4& a) {
    return shared::Uvec2(static_cast<std::uint32_t>(static_cast<int>(a.x * 2e6f) - 1000000),
                         static_cast<std::uint32_t>(static_cast<int>(a.y * 2e6f) - 1000000));
  };
  int apart = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::DetailPieces exact = shared::detailPieces(cellOf(a), {a.z, a.w}, 3);
    apart += bits_[i].x != exact.first || bits_[i].y != exact.second || bits_[i].z != exact.third;
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(result_[i][c], exact.weights[c], 1e-4f);
    ASSERT_NEAR(result_[i].w, shared::detailMip(shared::groundPictureLevel(a.x * 2 + 1e-3f, 0.03f)), 1e-4f);
  }
  EXPECT_LE(apart, 2);
  run(rows,
      "DetailPick pick = detailPick(a.x, a.y, a.z, a.w, a.x * a.y, a.z * a.w);\n"
      "DetailPlanes planes = detailPlanes(normalize(a.xyz - vec3(0.5, 0.0, 0.5)));\n"
      "r = vec4(pick.share, planes.share, detailShare(a.x, 1.0), detailFootprint(a.y * 100.0, 3e-3, a.z));\n"
      "u = uvec4(uint(pick.first), uint(pick.second), uint(planes.first), uint(planes.second));");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::DetailPick pick = shared::detailPick(a.x, a.y, a.z, a.w, a.x * a.y, a.z * a.w);
    const shared::DetailPlanes planes =
        shared::detailPlanes(glm::normalize(glm::vec3(a) - glm::vec3(0.5f, 0, 0.5f)));
    ASSERT_EQ(bits_[i].x, static_cast<std::uint32_t>(pick.first));
    ASSERT_EQ(bits_[i].y, static_cast<std::uint32_t>(pick.second));
    ASSERT_EQ(bits_[i].z, static_cast<std::uint32_t>(planes.first));
    ASSERT_NEAR(result_[i].x, pick.share, 1e-6f);
    ASSERT_NEAR(result_[i].y, planes.share, 1e-4f);
    ASSERT_NEAR(result_[i].z, shared::detailShare(a.x, 1), 1e-5f);
    ASSERT_NEAR(result_[i].w, shared::detailFootprint(a.y * 100, 3e-3f, a.z), 1e-5f);
  }
  run(rows,
      "LandNoise noise = LandNoise(a.w * 2.0 - 1.0, a.x - 0.5, a.y - 0.5, a.z - 0.5, 0.0);\n"
      "vec2 faults = rockFaults(uvec2(uint(a.x * 1e6), uint(a.y * 1e6)), a.zw, a.x);\n"
      "RockLayers rock = rockLayers(a.z * 900.0, faults, noise, 0.2);\n"
      "r = vec4(faults.x, rock.tone, rock.ledge, rock.rubble);");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::LandNoise noise{a.w * 2 - 1, a.x - 0.5f, a.y - 0.5f, a.z - 0.5f, 0};
    const shared::Vec2 faults = shared::rockFaults(
        {static_cast<std::uint32_t>(a.x * 1e6f), static_cast<std::uint32_t>(a.y * 1e6f)}, {a.z, a.w}, a.x);
    const shared::RockLayers rock = shared::rockLayers(a.z * 900, faults, noise, 0.2f);
    ASSERT_NEAR(result_[i].x, faults.x, 1e-4f);
    ASSERT_NEAR(result_[i].y, rock.tone, 2e-3f);  // a float's step at 900 m turns the thinnest bed by that
    ASSERT_NEAR(result_[i].z, rock.ledge, 2e-2f);
    ASSERT_NEAR(result_[i].w, rock.rubble, 2e-3f);
  }
}

TEST_F(SharedGLTest, cloudLightAgrees) {
  // Phases, octaves and the fading: within 2e-5 relative (six of Mesa's exponentials).
  const std::vector<glm::vec4> rows = randomRows(11);
  run(rows,
      "vec4 p = cloudPhases(a.x * 2.0 - 1.0, a.y * 1.8 - 0.9, a.z);\n"
      "r = vec4(p.x, scatteredSun(p, a.w * 30.0), cloudFade(a.w * 30000.0, 24000.0), scatteredSky(a.x) + "
      "scatteredGround(a.y));");
  for (std::size_t i = 0; i < kCount; ++i) {
    const glm::vec4& a = rows[i];
    const shared::Vec4 phases = shared::cloudPhases(a.x * 2 - 1, a.y * 1.8f - 0.9f, a.z);
    ASSERT_NEAR(result_[i].x / phases.x, 1, 2e-5f);
    ASSERT_NEAR(result_[i].y / shared::scatteredSun(phases, a.w * 30), 1, 2e-5f);
    ASSERT_NEAR(result_[i].z, shared::cloudFade(a.w * 30000, 24000), 1e-6f);
    ASSERT_NEAR(result_[i].w, shared::scatteredSky(a.x) + shared::scatteredGround(a.y), 1e-6f);
  }
}

}  // namespace
}  // namespace skydrop::render::gl
