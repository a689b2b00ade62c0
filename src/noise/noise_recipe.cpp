#include "skydrop/noise/noise_recipe.h"

#include <bit>
#include <limits>

#include "skydrop/core/dds_note.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/noise/noise_generator.h"

namespace skydrop::noise {
namespace {

constexpr std::uint32_t kMark = 0x314e4453;  // "SDN1"

template <class Settings>
std::string textOf(Settings settings) {
  std::string text;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields())
    text += (text.empty() ? "" : ", ") + field.name + " " + core::fieldText(field);
  return text;
}

void putNumber(core::DdsNote& note, std::size_t word, double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  note[word] = static_cast<std::uint32_t>(bits);
  note[word + 1] = static_cast<std::uint32_t>(bits >> 32);
}

double numberAt(const core::DdsNote& note, std::size_t word) {
  return std::bit_cast<double>(note[word] | std::uint64_t{note[word + 1]} << 32);
}

}  // namespace

std::string recipeText(const NoiseRecipe& recipe) {
  return textOf(recipe.settings) + (recipe.postProcess ? ", " + textOf(*recipe.postProcess) : "");
}

// The mark; octaves and frequency; the seed; amplitude, persistence, cutoff and density as doubles, the last
// two not numbers where nothing is cut.
void putRecipe(std::span<std::byte> dds, const NoiseRecipe& recipe) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const NoiseSettings& s = recipe.settings;
  core::DdsNote note = {kMark, static_cast<std::uint32_t>(s.octaves << 16 | s.frequency),
                        static_cast<std::uint32_t>(s.seed)};
  putNumber(note, 3, s.amplitude);
  putNumber(note, 5, s.persistence);
  putNumber(note, 7, recipe.postProcess ? recipe.postProcess->cutoff : kNone);
  putNumber(note, 9, recipe.postProcess ? recipe.postProcess->density : kNone);
  core::putNote(dds, note);
}

std::optional<NoiseRecipe> recipeOf(std::span<const std::byte> dds) {
  const core::DdsNote note = core::noteOf(dds);
  if (note[0] != kMark) return std::nullopt;
  NoiseRecipe recipe;
  recipe.settings = {.octaves = note[1] >> 16,
                     .frequency = note[1] & 0xffff,
                     .amplitude = numberAt(note, 3),
                     .persistence = numberAt(note, 5),
                     .seed = note[2]};
  const PostProcess cut{numberAt(note, 7), numberAt(note, 9)};
  if (cut.cutoff == cut.cutoff) recipe.postProcess = cut;
  try {
    requireSettings(recipe.settings);
    if (recipe.postProcess) requirePostProcess(*recipe.postProcess);
  } catch (const core::RangeError&) {
    return std::nullopt;
  }
  return recipe;
}

}  // namespace skydrop::noise
