#include "skydrop/noise/noise_recipe.h"

#include <gtest/gtest.h>

#include <vector>

#include "skydrop/core/dds.h"
#include "skydrop/core/dds_note.h"

namespace skydrop::noise {
namespace {

std::vector<std::byte> file(core::DdsHeader header) {
  return core::encodeDds(core::TextureData(core::TexelFormat::a8, 4, 4, 2), header);
}

TEST(NoiseRecipe, goesWithTheFileAndChangesNothingElse) {
  // What comes back is what was put in, to the last bit; the texture reads as before.
  const NoiseRecipe recipes[] = {
      {{.octaves = 16, .frequency = 512, .amplitude = 0.1, .persistence = 1.0 / 3, .seed = 4294967295}, {}},
      {{}, PostProcess{0.45, 0.999}}};
  for (const NoiseRecipe& recipe : recipes) {
    for (const core::DdsHeader header : {core::DdsHeader::legacy, core::DdsHeader::dx10}) {
      std::vector<std::byte> bytes = file(header);
      EXPECT_EQ(recipeOf(bytes), std::nullopt);
      const core::TextureData before = core::decodeDds(bytes, "a.dds");
      putRecipe(bytes, recipe);
      EXPECT_EQ(recipeOf(bytes), recipe);
      EXPECT_EQ(core::decodeDds(bytes, "a.dds"), before);
    }
  }
}

TEST(NoiseRecipe, ofADamagedFileThereIsNone) {
  // Short files, other programs' notes, values out of range.
  std::vector<std::byte> bytes = file(core::DdsHeader::legacy);
  putRecipe(bytes, {});
  const core::DdsNote good = core::noteOf(bytes);
  const auto with = [&](std::size_t word, std::uint32_t value) {
    core::DdsNote note = good;
    note[word] = value;
    core::putNote(bytes, note);
    return recipeOf(bytes);
  };
  EXPECT_NE(with(2, 7), std::nullopt);
  EXPECT_EQ(with(0, 1), std::nullopt) << "another mark";
  EXPECT_EQ(with(1, 0), std::nullopt) << "no octaves";
  EXPECT_EQ(with(1, 17u << 16 | 6), std::nullopt) << "17 octaves";
  EXPECT_EQ(with(4, 0x7ff80000), std::nullopt) << "an amplitude that is not a number";
  putRecipe(bytes, {{}, PostProcess{}});
  core::DdsNote cut = core::noteOf(bytes);
  cut[10] = 0x40000000;
  core::putNote(bytes, cut);
  EXPECT_EQ(recipeOf(bytes), std::nullopt) << "a density of 2";
  core::putNote(bytes, good);
  for (std::size_t size = 0; size < 76; ++size)
    EXPECT_EQ(recipeOf(std::span(bytes).first(size)), std::nullopt);
}

TEST(NoiseRecipe, isALineOfText) {
  EXPECT_EQ(recipeText({{}, PostProcess{0.5, 0.96}}),
            "octaves 6, frequency 6, amplitude 0.7, persistence 0.5, seed 0, cutoff 0.5, density 0.96");
  EXPECT_EQ(recipeText({{.seed = 3}, {}}), "octaves 6, frequency 6, amplitude 0.7, persistence 0.5, seed 3");
}

}  // namespace
}  // namespace skydrop::noise
