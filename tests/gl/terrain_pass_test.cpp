#include "skydrop/render/terrain/terrain_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/core/shared.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/frame_test.h"
#include "support/hills_source.h"
#include "support/image_compare.h"
#include "support/margin.h"
#include "support/patch_mesh.h"
#include "support/paths.h"

namespace skydrop::render {
namespace {

// Raised above the sea, or lowered.
class RaisedSource final : public terrain::HeightSource {
 public:
  RaisedSource(std::shared_ptr<const terrain::HeightSource> source, double rise)
      : source_(source), rise_(rise) {}
  terrain::HeightSample sample(glm::dvec2 xz) const override {
    terrain::HeightSample s = source_->sample(xz);
    s.height += rise_;
    return s;
  }
  terrain::HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    return raised(source_->bounds(lo, hi));
  }
  terrain::HeightBounds range() const override { return raised(source_->range()); }

 private:
  terrain::HeightBounds raised(terrain::HeightBounds b) const {
    return {b.lowest + rise_, b.highest + rise_};
  }

  std::shared_ptr<const terrain::HeightSource> source_;
  double rise_;
};

// The hills stretched over all the heights of the earth's land, from the Dead Sea to Mount Everest.
class MountainSource final : public terrain::HeightSource {
 public:
  static constexpr terrain::HeightRange kEarth{-430, 8848};

  terrain::HeightSample sample(glm::dvec2 xz) const override {
    const terrain::HeightSample s = hills_->sample(xz);
    return {stretched(s.height), s.gradient * factor_};
  }
  terrain::HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    const terrain::HeightBounds b = hills_->bounds(lo, hi);
    return {stretched(b.lowest), stretched(b.highest)};
  }
  terrain::HeightBounds range() const override { return {kEarth.lowest, kEarth.highest}; }
  terrain::HeightRange storedRange() const override { return kEarth; }

 private:
  double stretched(double height) const {
    return kEarth.lowest + (height - hills_->range().lowest) * factor_;
  }

  std::shared_ptr<const terrain::HeightSource> hills_ = test::makeHillsSource();
  double factor_ = (kEarth.highest - kEarth.lowest) / (hills_->range().highest - hills_->range().lowest);
};

// A land and its pass, drawn settled.
class Land {
 public:
  Land(gl::Context& context, std::shared_ptr<const terrain::HeightSource> source,
       const terrain::TerrainStreamingSettings& settings = {})
      : source_(std::move(source)),
        pass_(std::make_unique<TerrainPass>(context)),
        terrain_(source_, pool_, settings) {}

  const terrain::HeightSource& source() const { return *source_; }
  TerrainPass& pass() { return handedOver_ != nullptr ? *handedOver_ : *pass_; }
  std::unique_ptr<Pass> handOver() {
    handedOver_ = pass_.get();
    return std::move(pass_);
  }
  const terrain::TerrainFrame& settle(const View& view) {
    const terrain::TerrainFrame& frame = terrain_.settle(viewVolume(view));
    pass().take(frame);
    return frame;
  }

 private:
  std::shared_ptr<const terrain::HeightSource> source_;
  core::JobPool pool_{2};
  std::unique_ptr<TerrainPass> pass_;
  TerrainPass* handedOver_ = nullptr;
  terrain::EndlessTerrain terrain_;
};

class TerrainGLTest : public test::FrameTest {
 protected:
  void useLand(std::shared_ptr<const terrain::HeightSource> source,
               const terrain::TerrainStreamingSettings& settings = {}) {
    land_ = std::make_unique<Land>(context(), std::move(source), settings);
    renderer().add(land_->handOver());
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<ToneMapPass>(context()));
  }
  core::Image drawLand(const View& view) {
    land_->settle(view);
    return draw(view);
  }
  // Reversed depth of the land, bottom row first.
  std::vector<float> landDepth() {
    const gl::Texture& depth = land_->pass().landDepth();
    std::vector<float> values(static_cast<std::size_t>(depth.width() * depth.height()));
    depth.read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(values)));
    return values;
  }

  std::unique_ptr<Land> land_;
};

// Distances along the view axis of the land drawn with a renderer of its own: depth alone.
class DepthFrames {
 public:
  DepthFrames(gl::Context& context, std::shared_ptr<const terrain::HeightSource> source,
              const terrain::TerrainStreamingSettings& settings)
      : renderer_(context, {}, false), land_(context, std::move(source), settings) {
    renderer_.add(land_.handOver());
  }
  std::vector<float> draw(const View& view) {
    land_.settle(view);
    renderer_.draw({.view = view});
    const gl::Texture& depth = land_.pass().landDepth();
    std::vector<float> values(static_cast<std::size_t>(depth.width() * depth.height()));
    depth.read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(values)));
    return values;
  }

 private:
  Renderer renderer_;
  Land land_;
};

TEST_F(TerrainGLTest, T07_noPixelShowsWhatLiesBehindTheMesh) {
  // 200 random poses over hills, low and high, at all headings and banks, with all levels in view: where the
  // mesh of full detail covers a pixel and all its neighbours at a distance of two with one surface, the
  // drawn mesh covers it with the same surface. A crack shows the background (the magenta of the row: depth
  // 0) or land far behind. The surface is the same if its distance lies between those around it, within 2 %
  // and 5 m (what the allowed error of 2 pixels makes of a distance on a slope).
  test::noFaults("T07", "inputs accepted");
  constexpr int kWidth = 128, kHeight = 72;
  terrain::TerrainStreamingSettings drawn, full;
  drawn.texelPixels = 1;  // as many chunk borders and levels as a small picture can have
  full.pixelError = 0.1;
  full.cellPixels = 2;
  full.texelPixels = 1;
  const auto source = std::make_shared<RaisedSource>(test::makeHillsSource(), 600);
  DepthFrames mesh(context(), source, drawn), reference(context(), source, full);
  core::RandomStream random{7, 0};
  int cracks = 0, judged = 0;
  for (int pose = 0; pose < 200; ++pose) {
    const glm::dvec2 at{random.nextUnit() * 3000, random.nextUnit() * 3000};
    const double altitude = 5 * std::pow(400.0, random.nextUnit());
    const View view = this->pose({at.x, source->height(at) + altitude, at.y}, 360 * random.nextUnit(),
                                 -45 * random.nextUnit() + 10, pose % 4 == 0 ? 360 * random.nextUnit() : 0,
                                 kWidth, kHeight);
    const std::vector<float> depth = mesh.draw(view), exact = reference.draw(view);
    for (int y = 2; y < kHeight - 2; ++y) {
      for (int x = 2; x < kWidth - 2; ++x) {
        float nearest = 1e30f, farthest = 0;  // of the full mesh around the pixel
        for (int dy = -2; dy <= 2; ++dy) {
          for (int dx = -2; dx <= 2; ++dx) {
            const float d = exact[static_cast<std::size_t>((y + dy) * kWidth + x + dx)];
            const float z = d > 0 ? static_cast<float>(view.nearM) / d : 1e30f;
            nearest = std::min(nearest, z);
            farthest = std::max(farthest, z);
          }
        }
        if (farthest > 1.5f * nearest) continue;  // a silhouette
        ++judged;
        const float d = depth[static_cast<std::size_t>(y * kWidth + x)];
        const float z = d > 0 ? static_cast<float>(view.nearM) / d : 1e30f;
        cracks += z > farthest * 1.02f + 5 || z < nearest * 0.98f - 5;
      }
    }
  }
  EXPECT_GT(judged, 200 * kWidth * kHeight / 4);
  EXPECT_EQ(cracks, 0) << "of " << judged << " pixels";
}

TEST_F(TerrainGLTest, T02_theFrameFarOutEqualsTheFrameAtTheOrigin) {
  // Land that repeats, seen from the same place of several repetitions: the mesh's depth is the same bits at
  // 1e6, 1e7 and 1e8 m. The picture, with colours from noise that does not repeat in reach, is compared at
  // 1e9 m: 2^20 chunks on, where the noise's lattice wraps.
  useLand(test::makeHillsSource());
  constexpr double kRepeat = 61440;
  const glm::dvec3 eye{700, 420, -1300};
  const core::Image here = drawLand(pose(eye, 30, -12, 5));
  const std::vector<float> depthHere = landDepth();
  for (const double repeats : {16.0, 163.0, -1628.0}) {
    drawLand(pose(eye + glm::dvec3(repeats * kRepeat, 0, -repeats * kRepeat), 30, -12, 5));
    EXPECT_EQ(landDepth(), depthHere) << repeats * kRepeat << " m";
  }
  const double far = 960.0 * (1 << 20);
  const core::Image there = drawLand(pose(eye + glm::dvec3(far, 0, far), 30, -12, 5));
  EXPECT_EQ(landDepth(), depthHere);
  std::size_t different = 0;
  for (std::size_t i = 0; i < here.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::abs(here.rgba[i + c] - there.rgba[i + c]) > 2) {
        ++different;
        break;
      }
    }
  }
  EXPECT_TRUE(test::holds("T02", different, test::below(here.rgba.size() / 4 / 1000), "pixels"));
}

// Draws every vertex of every patch of a view as a pixel of its own and compares it with the same mesh made
// on the CPU from the height source, within `meshM`. Where detail is full and not morphed that mesh is the
// stored height itself, within half of the format's step and 1 mm of the source.
void expectVerticesOfTheSource(gl::Context& context, Land& land, const View& view, double meshM) {
  const terrain::TerrainFrame frame = land.settle(view);
  constexpr int kVertices = test::PatchMesher::kSide * test::PatchMesher::kSide;
  const auto rows = static_cast<GLsizei>(frame.patches.size());
  gl::FrameBuffer target(context, kVertices, rows, {GL_RGBA32F, 0}, "vertices");
  gl::Shader shader(context, test::sourceDir() + "/tests/gl/shaders/vertices.vert",
                    test::sourceDir() + "/tests/gl/shaders/vertices.frag");
  context.setDefaultState();
  target.bind();
  shader.setVec2("targetSize", glm::vec2(kVertices, rows));
  land.pass().drawPatches(shader, view, GL_POINTS);
  target.unBind();
  const std::vector<glm::vec4> drawn = test::readFloats(target);

  test::PatchMesher mesher(land.source());
  int compared = 0, unmorphed = 0;
  for (std::size_t p = 0; p < frame.patches.size(); ++p) {
    const auto vertices = mesher.vertices(frame, frame.patches[p], view.position);
    for (std::size_t v = 0; v < vertices.size(); ++v, ++compared) {
      const glm::dvec3 gpu = glm::dvec3(drawn[p * kVertices + v]) + view.position;
      ASSERT_NEAR(gpu.y, vertices[v].y, meshM) << "patch " << p << " vertex " << v;
      ASSERT_NEAR(gpu.x, vertices[v].x, 1e-2);  // float metres at 60 km
      ASSERT_NEAR(gpu.z, vertices[v].z, 1e-2);
      if (frame.lod.lambda(glm::distance(vertices[v], view.position)) > 0) continue;
      ASSERT_NEAR(gpu.y, land.source().height({vertices[v].x, vertices[v].z}),
                  frame.heightRange.step() / 2 + 1e-3);
      ++unmorphed;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(unmorphed, 0);
}

TEST_F(TerrainGLTest, T06_theGpusVerticesAreTheHeightSourcesWithinTheFormatsStep) {
  // 2 mm: lambda is a float, 1e-6 of a level off, and meshes are up to hundreds of metres apart.
  test::noFaults("T06", "violations");
  Land land(context(), test::makeHillsSource());
  expectVerticesOfTheSource(context(), land,
                            pose({700, land.source().height({700, -1300}) + 5, -1300}, 30, -12, 0), 2e-3);
}

TEST_F(TerrainGLTest, T06_aSourceOfAnotherRangeIsDrawnAtItsOwnHeights) {
  // Mountains over -430 to 8848 m: the frame hands the source's range to the shader. Heights and their
  // differences between meshes are nine times those of the hills, and so is what is allowed.
  test::noFaults("T06", "violations");
  Land land(context(), std::make_shared<MountainSource>());
  const View view = pose({700, land.source().height({700, -1300}) + 5, -1300}, 30, -12, 0);
  EXPECT_EQ(land.settle(view).heightRange, MountainSource::kEarth);
  expectVerticesOfTheSource(context(), land, view, 2e-2);
}

TEST_F(TerrainGLTest, T16_theGpusNormalsAreTheGradientsWithinTwoDegrees) {
  // What the land's shader takes for the normal, at 10 000 places around the eye at full detail, against the
  // analytic gradient: mean under 0.5, largest under 2 degrees. The land is the shipped one.
  Land land(context(), terrain::makeNoiseHeightSource({}, 1));
  const glm::dvec2 at{5000, 3000};
  const View view = pose({at.x, land.source().height(at) + 300, at.y}, 30, -80, 0);
  land.settle(view);
  gl::FrameBuffer target(context(), 100, 100, {GL_RGBA32F, 0}, "normals");
  gl::Shader shader(context(), "fullscreen.vert", test::sourceDir() + "/tests/gl/shaders/normals.frag");
  context().setDefaultState();
  target.bind();
  land.pass().drawLand(shader, view);
  target.unBind();
  const std::vector<glm::vec4> normals = test::readFloats(target);
  double sum = 0, largest = 0;
  const glm::dvec2 base = terrain::chunkOrigin(terrain::chunkAt(at));
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      // As in normals.frag: samples of the chunk below, every other one.
      const glm::dvec2 place = base + glm::dvec2(column, row) * 8.0;
      const glm::dvec3 exact = terrain::normalOf(land.source().sample(place));
      const glm::dvec3 drawn(normals[static_cast<std::size_t>(row * 100 + column)]);
      const double angle =
          std::atan2(glm::length(glm::cross(exact, drawn)), glm::dot(exact, drawn)) * 180 / std::numbers::pi;
      sum += angle;
      largest = std::max(largest, angle);
    }
  }
  EXPECT_TRUE(test::holds("T16", sum / 1e4, test::below(0.5), "degrees"));
  EXPECT_TRUE(test::holds("T16", largest, test::below(2.0), "degrees"));
}

TEST_F(TerrainGLTest, T19_noEndOfTheWorldShowsFromTheGroundTo6Km) {
  // Upright pictures of the horizon from 2 m to 6 km, in four directions: where the land ends the picture has
  // turned into the haze of the horizon. So from the land's end to just above the horizon no pixel differs
  // from the one above it by more than 6/255 (the sky's own gradient at the horizon, seen from 6 km, has 4).
  // So it is with the closed form; with the shell the sea has a horizon of its own, which dips below the
  // level, and there each pixel beyond the land's end is that of the sky alone within 3/255.
  useLand(terrain::makeNoiseHeightSource({}, 1));
  const double end = terrain::TerrainStreamingSettings().farDistanceM;
  const auto skyAlone = [&](const View& view) {
    Renderer alone(context(), settings_, false);
    alone.add(std::make_unique<ToneMapPass>(context()));
    alone.add(std::make_unique<SkyPass>(context()));
    alone.draw({.view = view, .features = features_});
    return alone.readBack();
  };
  for (const double height : {2.0, 300.0, 2000.0, 6000.0}) {
    for (const double yaw : {20.0, 110.0, 200.0, 290.0}) {
      const double ground = std::max(land_->source().height({300, 300}), 0.0);
      const View view = pose({300, ground + height, 300}, yaw, 0, 0);
      settings_.sky.model = sky::SkyModel::shell;
      const core::Image withShell = drawLand(view);
      const core::Image sky = skyAlone(view);
      settings_.sky.model = sky::SkyModel::closedForm;
      const core::Image image = drawLand(view);
      const std::vector<float> depth = landDepth();
      const auto row = [&](int y) { return static_cast<std::size_t>(y) * 320; };
      const double radiansAPixel = view.fovYRad / 180;
      // Rows below the horizon (row 90) down to the land's end seen at the sea.
      const int last = 90 + static_cast<int>(std::atan(view.position.y / end) / radiansAPixel);
      for (int x = 0; x < 320; ++x) {
        for (int y = 90; y < last; ++y) {
          // Land that rises above the sea this far out hides the end; it has its own outline.
          if (depth[row(179 - y) + static_cast<std::size_t>(x)] > view.nearM / (0.97 * end)) break;
          for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t here = (row(y) + static_cast<std::size_t>(x)) * 4 + c;
            ASSERT_TRUE(test::holds("T19", test::apart(image.rgba[here], image.rgba[here - 320 * 4]),
                                    test::atMost(6), "of 255"))
                << height << " m, " << yaw << " deg, " << x;
            ASSERT_TRUE(test::holds("T19", test::apart(withShell.rgba[here], sky.rgba[here]), test::atMost(3),
                                    "of 255"))
                << height << " m, " << yaw << " deg, " << x << ' ' << y;
          }
        }
      }
    }
  }
}

TEST_F(TerrainGLTest, farLandDoesNotShimmer) {
  // 1500 m up, looking 20 degrees down over hills, in steps of 0.4 m along the view, each a small part of a
  // pixel from 3 km on: the far land of one frame differs from that of the last by 1/255 in the mean and by
  // less than 1 % of its pixels by more than 6/255 (outlines of hills). Noise that is not faded out changes
  // pixels by its whole contrast, 20/255 and more; so does noise with a seam where the eye crosses z = 0.
  useLand(std::make_shared<RaisedSource>(test::makeHillsSource(), 200));
  core::Image last = drawLand(pose({700, 1500, 0.6}, 90, -20, 0));
  for (int step = 1; step <= 4; ++step) {
    const core::Image now = drawLand(pose({700, 1500, 0.6 - 0.4 * step}, 90, -20, 0));
    double sum = 0;
    std::size_t counted = 0, jumped = 0;
    for (std::size_t i = 320 * 40 * 4; i < 320 * 100 * 4; ++i, ++counted) {  // from above the horizon to 3 km
      const int change = std::abs(now.rgba[i] - last.rgba[i]);
      sum += change;
      jumped += change > 6;
    }
    EXPECT_LT(sum / static_cast<double>(counted), 1.0) << step;
    EXPECT_LT(jumped, counted / 100) << step;
    last = now;
  }
}

TEST_F(TerrainGLTest, theSeaLiesAtHeightZeroAndHidesItsFloor) {
  // Straight down over deep water: the scene's depth is that of the plane y = 0, whatever the floor does.
  class DepthProbe final : public Pass {
   public:
    explicit DepthProbe(std::vector<float>& depth) : depth_(depth) {}
    std::string_view name() const override { return "probe"; }
    RenderStage stage() const override { return RenderStage::clouds; }
    void draw(FrameContext& context) override {
      depth_.resize(static_cast<std::size_t>(context.sceneDepth.width() * context.sceneDepth.height()));
      context.sceneDepth.read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(depth_)));
    }

   private:
    std::vector<float>& depth_;
  };
  std::vector<float> depth;
  useLand(std::make_shared<RaisedSource>(test::makeHillsSource(), -800));
  renderer().add(std::make_unique<DepthProbe>(depth));
  const View view = pose({0, 500, 0}, 0, -90, 0);
  drawLand(view);
  for (const float d : depth)
    ASSERT_NEAR(static_cast<float>(view.nearM) / d, 500, 0.05);  // float depth: 1e-4
}

TEST_F(TerrainGLTest, wireframeAndNormalsAreDrawnInPlaceOfOrOnTopOfTheLand) {
  // Both change the picture; wireframe lets the sky through, normals leave most of the land as it was.
  useLand(test::makeHillsSource());
  const View view = pose({700, 420, -1300}, 30, -12, 0);
  const core::Image plain = drawLand(view);
  settings_.terrainNormals = true;
  const core::Image normals = drawLand(view);
  settings_.terrainNormals = false;
  settings_.wireframe = true;
  const core::Image wires = drawLand(view);
  const auto share = [&](const core::Image& image) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      changed += !std::equal(image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                             image.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                             plain.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return static_cast<double>(changed) / (static_cast<double>(image.rgba.size()) / 4);
  };
  EXPECT_GT(share(normals), 0.05);
  EXPECT_LT(share(normals), 0.6);
  EXPECT_GT(share(wires), 0.3);
}

}  // namespace
}  // namespace skydrop::render
