#include "app/window/noise_tool_settings.h"

#include <algorithm>

namespace skydrop::app {
namespace {

constexpr int kSmallPlane = 128, kSmallVolume = 32;  // about a millisecond

NoiseOrder orderOf(const NoiseToolSettings& settings, int planeSide, int volumeSide) {
  NoiseOrder order;
  order.recipe.settings = settings.noise;
  if (settings.cut) order.recipe.postProcess = settings.clouds;
  if (settings.kind == NoiseKind::plane)
    order.size = {planeSide, planeSide, 0};
  else
    order.size = {volumeSide, volumeSide, volumeSide};
  return order;
}

int planeSideOf(const NoiseToolSettings& settings) { return 128 << static_cast<int>(settings.planeSide); }
int volumeSideOf(const NoiseToolSettings& settings) { return 32 << static_cast<int>(settings.volumeSide); }

}  // namespace

void describe(core::SettingsVisitor& v, NoiseToolSettings& s) {
  v.group("noise", s.noise, "The noise.");
  v.flag("cut", s.cut, {.help = "Cut to clouds: what lies below the cutoff is clear sky."});
  v.group("clouds", s.clouds, "The cut to clouds.");
  v.choice("kind", s.kind, kNoiseKindNames, {.help = "A 2D texture, or a volume."});
  v.choice("planeSide", s.planeSide, kPlaneSideNames, {.help = "Texels of a side of the 2D texture."});
  v.choice("volumeSide", s.volumeSide, kVolumeSideNames, {.help = "Texels of an edge of the volume."});
  v.flag("tiled", s.tiled, {.help = "Show the texture twice in both directions: it has no seam."});
  v.number("slice", s.slice,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Which slice of the volume is shown, as a share of its period."});
  v.flag("turns", s.turns, {.help = "Let the volume turn."});
  v.choice("texels", s.texels, kNoiseTexelsNames, {.help = "What a saved file holds."});
  v.choice("header", s.header, kNoiseHeaderNames,
           {.help = "Header of a saved DDS file; older programs read legacy alone."});
}

NoiseOrder fullOrder(const NoiseToolSettings& settings) {
  return orderOf(settings, planeSideOf(settings), volumeSideOf(settings));
}

NoiseOrder smallOrder(const NoiseToolSettings& settings) {
  return orderOf(settings, std::min(kSmallPlane, planeSideOf(settings)),
                 std::min(kSmallVolume, volumeSideOf(settings)));
}

core::TexelFormat texelsOf(NoiseTexels texels) {
  constexpr std::array kFormats = {core::TexelFormat::a8, core::TexelFormat::r8, core::TexelFormat::r16,
                                   core::TexelFormat::r32f};
  return kFormats[static_cast<std::size_t>(texels)];
}

void takeRecipe(NoiseToolSettings& settings, const noise::NoiseRecipe& recipe) {
  settings.noise = recipe.settings;
  settings.cut = recipe.postProcess.has_value();
  settings.clouds = recipe.postProcess.value_or(settings.clouds);
}

}  // namespace skydrop::app
