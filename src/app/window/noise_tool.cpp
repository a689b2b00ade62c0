#include "app/window/noise_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/message.h"

namespace skydrop::app {
namespace {

constexpr int kVolumePicture = 320;      // pixels: what a software renderer draws in a fraction of a frame
constexpr double kTurnRadPerS = 0.35;    // of the volume
constexpr double kPlainThreshold = 0.5;  // of a volume that is not cut: its upper half is seen

using Section = ui::NoiseToolContent::Section;

std::vector<Section> sectionsFor(const NoiseToolSettings& settings) {
  std::vector<Section> sections = {
      {"Noise", {"noise.octaves", "noise.frequency", "noise.amplitude", "noise.persistence", "noise.seed"}},
      {"Clouds", {"cut"}},
      {"View", {"kind"}},
      {"File format", {"texels", "header"}}};
  if (settings.cut) sections[1].rows.insert(sections[1].rows.end(), {"clouds.cutoff", "clouds.density"});
  if (settings.kind == NoiseKind::plane)
    sections[2].rows.insert(sections[2].rows.end(), {"planeSide", "tiled"});
  else
    sections[2].rows.insert(sections[2].rows.end(), {"volumeSide", "slice", "tiled", "turns"});
  return sections;
}

}  // namespace

NoiseTool::NoiseTool(render::gl::Context& context, Size size, const ui::InterfaceScale& scale)
    : interface_(size.width, size.height, scale),
      renderer_(context, {}, false),
      planeView_(context),
      volumeView_(context, kVolumePicture) {
  auto pass = std::make_unique<render::ImGuiPass>(context);
  pass_ = pass.get();
  renderer_.add(std::move(pass));
}

bool NoiseTool::isSettled() const { return shown_ && (opened_ || shown_->order == fullOrder(settings_)); }

bool NoiseTool::isCut() const { return shown_->order.recipe.postProcess.has_value(); }

void NoiseTool::draw(Size size, double seconds, const ui::InterfaceScale& scale,
                     const std::function<void()>& begun) {
  advance();
  if (shown_ && shown_->texture.isVolume()) {
    if (settings_.turns) angleRad_ += kTurnRadPerS * seconds;
    volumeView_.draw(angleRad_, isCut() ? 0 : kPlainThreshold);
  }
  if (build(size, seconds, scale, begun)) pass_->uploadFonts();
  render::View view;
  view.width = size.width;
  view.height = size.height;
  renderer_.draw({.view = view});
}

void NoiseTool::buildUnseen(Size size, const ui::InterfaceScale& scale, const std::function<void()>& begun) {
  if (build(size, 0, scale, begun)) pass_->uploadFonts();
}

// Orders what is missing, and takes what was made.
void NoiseTool::advance() {
  try {
    if (std::optional<NoiseSample> made = work_.take()) show(std::move(*made));
  } catch (const core::DataError& failure) {
    message_ = failure.what();
  }
  if (auto line = work_.takeSaved()) message_ = std::move(*line);
  const NoiseOrder full = fullOrder(settings_), small = smallOrder(settings_);
  const auto isThere = [this](const NoiseOrder& order) { return shown_ && shown_->order == order; };
  if (!opened_ && !isThere(full)) {
    const NoiseOrder& next = isThere(small) ? full : small;
    if (!(held_ && isThere(small)) && work_.current() != next) work_.make(next);
  }
  if (shown_ && shown_->texture.isVolume()) {
    const int depth = shown_->texture.depth;
    const int slice = std::min(static_cast<int>(settings_.slice * depth), depth - 1);
    if (slice != shownSlice_) uploadPlane();
  }
}

void NoiseTool::show(NoiseSample sample) {
  shown_ = std::move(sample);
  if (shown_->texture.isVolume()) volumeView_.show(shown_->texture);
  uploadPlane();
}

// The 2D texture, or the slice of the volume: grey, or white with the value as alpha where it is cut to
// clouds.
void NoiseTool::uploadPlane() {
  using Look = render::NoisePlaneView::Look;
  const core::TextureData& texture = shown_->texture;
  const std::size_t bytes =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  shownSlice_ = std::min(static_cast<int>(settings_.slice * texture.depth), std::max(texture.depth - 1, 0));
  planeView_.show(texture.width, texture.height,
                  std::span(texture.texels).subspan(static_cast<std::size_t>(shownSlice_) * bytes, bytes),
                  isCut() ? Look::alpha : Look::grey);
}

bool NoiseTool::build(Size size, double seconds, const ui::InterfaceScale& scale,
                      const std::function<void()>& begun) {
  const bool fontsChanged = interface_.beginFrame(size.width, size.height, seconds, scale);
  if (begun) begun();
  const std::vector<Section> sections = sectionsFor(settings_);
  std::vector<ui::ToolPicture> pictures;
  if (shown_) {
    pictures.push_back({planeView_.picture().id(), settings_.tiled, isCut(), false});
    if (shown_->texture.isVolume()) pictures.push_back({volumeView_.picture().id(), false, true, true});
  }
  const std::string status = statusText();
  ui::NoiseToolContent content{table_, sections, pictures};
  if (shown_) content.histogram = shown_->histogram;
  content.status = status;
  if (work_.current()) content.progress = work_.progress();
  content.message = message_;
  content.canSave = !work_.isSaving();
  content.canUseInSky = useInSky != nullptr;
  const ui::NoiseToolResult result = view_.draw(interface_, content);
  interface_.endFrame();
  serve(result);
  return fontsChanged;
}

void NoiseTool::serve(const ui::NoiseToolResult& result) {
  held_ = result.held;
  if (result.changed) opened_ = false;
  if (result.refusal) message_ = *result.refusal;
  if (result.save) save(*result.save);
  if (result.open) open(*result.open);
  if (result.useInSky && useInSky) useInSky(fullOrder(settings_).recipe, settings_.kind == NoiseKind::volume);
}

void NoiseTool::save(const std::string& file) {
  const core::DdsHeader header =
      settings_.header == NoiseHeader::legacy ? core::DdsHeader::legacy : core::DdsHeader::dx10;
  if (work_.save(fullOrder(settings_), texelsOf(settings_.texels), header, file))
    message_ = "Saving " + core::printable(file);
}

// The file's texels are shown until a row is changed. Where it tells what it was made from, the rows take
// that over, so that a change goes on from there.
void NoiseTool::open(const std::string& file) {
  try {
    const std::vector<std::byte> bytes = core::readFile(file);
    NoiseSample sample;
    sample.texture = viewable(core::decodeDds(bytes, file));
    sample.histogram = histogramOf(sample.texture);
    const std::optional<noise::NoiseRecipe> recipe = noise::recipeOf(bytes);
    if (recipe) {
      takeRecipe(settings_, *recipe);
      sample.order.recipe = *recipe;
    }
    settings_.kind = sample.texture.isVolume() ? NoiseKind::volume : NoiseKind::plane;
    opened_ = true;
    show(std::move(sample));
    message_ = "Opened " + core::printable(file) +
               (recipe ? ": " + noise::recipeText(*recipe) : ", which does not tell what it was made from");
  } catch (const core::DataError& refusal) {
    message_ = refusal.what();
  }
}

std::string NoiseTool::statusText() const {
  if (!shown_) return "making";
  const core::TextureData& texture = shown_->texture;
  std::string text = std::to_string(texture.width) + " x " + std::to_string(texture.height);
  if (texture.isVolume()) text += " x " + std::to_string(texture.depth);
  if (opened_) {
    text += ", of a file";
  } else if (showsTimes) {
    char time[32];
    std::snprintf(time, sizeof time, " in %.1f ms", 1000 * shown_->seconds);
    text += time;
  }
  if (texture.isVolume()) text += ", slice " + std::to_string(shownSlice_);
  return text;
}

}  // namespace skydrop::app
