// Borders of chunks do not show: what the land's material reads, and the picture, are the same on both sides.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/frame_test.h"
#include "support/paths.h"

namespace skydrop::render {
namespace {

constexpr int kPlaces = 961;  // along a border: four to a sample

// A border of two chunks of a level: the east edge or the south edge of `here`.
struct Border {
  terrain::ChunkKey here;
  bool east;

  terrain::ChunkKey there() const { return {here.x + (east ? 1 : 0), here.z + (east ? 0 : 1), here.level}; }
};

class TerrainBorderGLTest : public test::FrameTest {
 protected:
  struct Inputs {
    std::vector<glm::vec4> normals;  // and curvature
    std::vector<glm::vec4> texels;
  };

  Border randomBorder(int level) {
    const auto index = [&] { return static_cast<std::int64_t>(random_.next() % 400) - 200; };
    return {{index(), index(), level}, random_.next() % 2 == 0};
  }

  // Makes these chunks the ones that shaders find.
  void take(TerrainPass& pass, const std::vector<terrain::ChunkKey>& keys) {
    terrain::TerrainFrame frame;
    frame.layerCount = 4;
    for (const terrain::ChunkKey& key : keys) {
      const auto layer = static_cast<terrain::ArrayLayer>(frame.chunks.size());
      frame.uploads.push_back(
          {layer, std::make_shared<terrain::ChunkData>(terrain::makeChunk(*source_, key))});
      frame.chunks.push_back({key, layer});
    }
    pass.take(frame);
  }

  // Along a border, asked of the chunk at hand on one side.
  Inputs inputsBeside(TerrainPass& pass, const Border& border, bool onFarSide) {
    const terrain::ChunkKey key = onFarSide ? border.there() : border.here;
    const int level = key.level, last = (1 << level) - 1;
    glm::ivec2 chunk{static_cast<int>(key.x) << level, static_cast<int>(key.z) << level};
    glm::vec2 start{0.0f, 0.0f}, stride{0.0f, 0.0f};
    const int across = border.east ? 0 : 1, along = 1 - across;
    if (!onFarSide) {
      chunk[across] += last;
      start[across] = static_cast<float>(terrain::kChunkMetres);
    }
    stride[along] = static_cast<float>(terrain::chunkMetres(level) / (kPlaces - 1));

    gl::FrameBuffer target(context(), kPlaces, 2, {GL_RGBA32F, 0}, "land inputs");
    gl::Shader shader(context(), "fullscreen.vert", test::sourceDir() + "/tests/gl/shaders/land_inputs.frag");
    context().setDefaultState();
    target.bind();
    shader.setIvec2("chunk", chunk);
    shader.setVec2("start", start);
    shader.setVec2("stride", stride);
    shader.setInt("level", level);
    pass.drawLand(shader, pose({0, 100, 0}, 0, 0, 0));
    target.unBind();
    std::vector<glm::vec4> texels = test::readFloats(target);
    Inputs inputs;
    inputs.normals.assign(texels.begin(), texels.begin() + kPlaces);
    inputs.texels.assign(texels.begin() + kPlaces, texels.end());
    return inputs;
  }

  // Of whole pictures.
  void addPasses() {
    auto pass = std::make_unique<TerrainPass>(context());
    pass_ = pass.get();
    renderer().add(std::move(pass));
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<ToneMapPass>(context()));
  }
  core::Image drawSettled(const View& view) {
    pass_->take(land_.settle(viewVolume(view)));
    return draw(view);
  }

  std::shared_ptr<const terrain::HeightSource> source_ = terrain::makeNoiseHeightSource({}, 1);
  core::JobPool pool_{2};
  terrain::EndlessTerrain land_{source_, pool_, {}};
  TerrainPass* pass_ = nullptr;
  core::RandomStream random_{9, 0};
};

TEST_F(TerrainBorderGLTest, bothSidesOfABorderGiveTheMaterialTheSameBits) {
  // Normal, slope, curvature and level at 961 places of random borders of every level on both axes, their
  // corners included, from the chunk on each side. They have the same samples and filter them with the same
  // weights: nothing is left to tolerate.
  TerrainPass pass(context());
  for (int level = 0; level <= terrain::kMaxChunkLevel; ++level) {
    for (int round = 0; round < 4; ++round) {
      const Border border = randomBorder(level);
      take(pass, {border.here, border.there()});
      const Inputs here = inputsBeside(pass, border, false), there = inputsBeside(pass, border, true);
      for (std::size_t i = 0; i < kPlaces; ++i) {
        ASSERT_EQ(here.normals[i], there.normals[i])
            << "level " << level << (border.east ? ", east of " : ", south of ") << border.here.x << " "
            << border.here.z << ", place " << i;
        ASSERT_EQ(here.texels[i], there.texels[i]);
        ASSERT_EQ(here.texels[i].x, terrain::cellMetres(level));
      }
    }
  }
}

TEST_F(TerrainBorderGLTest, whereOneSideIsCoarserTheMaterialsInputsAgreeAsFarAsItsSamplesDo) {
  // Beside a chunk that is missing lies its parent. At the samples that both have, levels 0 and 1 hold the
  // same normals and take the curvature over the same 24 m: the same bits. Level 2 and 3 leave out octaves
  // that their samples cannot carry (docs/terrain-noise.md), and take it between samples or over 32 m: there
  // the curvature, whose root mean square is 0.06 to 0.1, is off by 0.02 to 0.03. A curvature that lost a
  // half at the border would be off by as much as it is itself.
  TerrainPass pass(context());
  for (int level = 0; level < 3; ++level) {
    double difference = 0, power = 0;
    for (int round = 0; round < 6; ++round) {
      const Border border = randomBorder(level);
      take(pass, {border.here, border.there()});
      const Inputs fine = inputsBeside(pass, border, false);
      take(pass, {border.here, terrain::parentOf(border.there())});
      const Inputs coarse = inputsBeside(pass, border, true);
      for (std::size_t i = 0; i < kPlaces; i += 8) {  // four places to a sample
        ASSERT_EQ(fine.texels[i].x, terrain::cellMetres(level));
        ASSERT_EQ(coarse.texels[i].x, terrain::cellMetres(level + 1));
        if (level == 0) {
          ASSERT_EQ(fine.normals[i], coarse.normals[i]) << "place " << i;
        }
        const double d = fine.normals[i].w - coarse.normals[i].w;
        difference += d * d;
        power += double{fine.normals[i].w} * fine.normals[i].w;
      }
    }
    EXPECT_LT(difference, 0.25 * power) << "level " << level;
  }
}

// How much an edge along the middle of a picture stands out: the energy of the steps in brightness between
// the two middle columns, over that between other columns near by. Steps count as the mean of a few rows, so
// that what is straight counts and detail averages out.
double edgeInTheMiddle(const core::Image& image, int firstRow) {
  constexpr int kRows = 6, kColumnsBeside = 24;
  const auto brightness = [&](int x, int y) {
    const auto i = static_cast<std::size_t>(y * image.width + x) * 4;
    return image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2];
  };
  const auto energy = [&](int column) {
    double sum = 0;
    for (int block = firstRow; block + kRows <= image.height; block += kRows) {
      int step = 0;
      for (int y = block; y < block + kRows; ++y) step += brightness(column, y) - brightness(column - 1, y);
      sum += static_cast<double>(step) * step;
    }
    return sum;
  };
  const int middle = image.width / 2;
  std::vector<double> beside;
  for (int i = 2; i <= kColumnsBeside; ++i) {
    beside.push_back(energy(middle - i));
    beside.push_back(energy(middle + i));
  }
  std::nth_element(beside.begin(), beside.begin() + kColumnsBeside, beside.end());
  return energy(middle) / beside[kColumnsBeside];
}

TEST_F(TerrainBorderGLTest, thePictureStaysWhereTheEyeCrossesABorder) {
  // Places are counted from the corner of the chunk below the eye: half a millimetre before and behind a
  // border, and a corner, where it is another, the picture is the same but for rounding: of the pixels one in
  // a thousand differs by more than 2/255 (grains of noise on the edge of a pixel).
  addPasses();
  const double line = 3 * terrain::kChunkMetres;
  const std::pair<glm::dvec2, glm::dvec2> crossings[] = {
      {{line, 5321}, {1, 0}}, {{1234, line}, {0, 1}}, {{line, line}, {1, 1}}};
  for (const auto& [at, across] : crossings) {
    const double height = std::max(source_->height(at), 0.0) + 80;
    const auto drawFrom = [&](double side) {
      const glm::dvec2 eye = at + across * (side * 0.0005);
      return drawSettled(pose({eye.x, height, eye.y}, 40, -15, 0));
    };
    const core::Image before = drawFrom(-1), behind = drawFrom(1);
    std::size_t different = 0;
    for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (std::abs(before.rgba[i + c] - behind.rgba[i + c]) > 2) {
          ++different;
          break;
        }
      }
    }
    EXPECT_LT(different, before.rgba.size() / 4 / 1000);
  }
}

TEST_F(TerrainBorderGLTest, noBorderShowsInThePicture) {
  // Pictures along random borders of both axes, from 60 m above the ground to 1200 m: the border, whatever
  // the relief, lies between the two middle columns. Half of the borders are those of level 0, half of all
  // levels at once. No edge there has kStandsOut times the energy of those beside it; in 72 such pictures the
  // largest had 3.0 times.
  constexpr double kStandsOut = 5;
  constexpr std::array kPoses{std::pair(60.0, -25.0), std::pair(250.0, -30.0), std::pair(1200.0, -25.0)};
  addPasses();
  std::string shown;
  for (int i = 0; i < 24; ++i) {
    const auto [height, pitch] = kPoses[static_cast<std::size_t>(i) % kPoses.size()];
    const bool alongZ = i / 3 % 2 == 0;
    const double spacing = terrain::chunkMetres(i / 6 % 2 == 0 ? 0 : terrain::kMaxChunkLevel);
    glm::dvec2 at;
    do {
      const double line = spacing * (std::floor(random_.nextUnit() * 64) - 32);
      const double along = (random_.nextUnit() - 0.5) * 60000;
      at = alongZ ? glm::dvec2(line, along) : glm::dvec2(along, line);
    } while (source_->height(at) < 20);
    const View view = pose({at.x, source_->height(at) + height, at.y}, alongZ ? 90 : 0, pitch, 0, 160, 120);
    const double edge = edgeInTheMiddle(drawSettled(view), 30);
    if (edge < kStandsOut) continue;
    shown += (alongZ ? "\nx = " : "\nz = ") + std::to_string(alongZ ? at.x : at.y) + " from " +
             std::to_string(height) + " m: " + std::to_string(edge);
  }
  EXPECT_EQ(shown, "");
}

}  // namespace
}  // namespace skydrop::render
