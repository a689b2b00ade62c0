#include "skydrop/render/frame/renderer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "render/frame/moon_view.h"
#include "render/frame/stretch.h"
#include "render/gl/device_check.h"
#include "skydrop/core/error.h"
#include "skydrop/core/quantile.h"
#include "skydrop/render/frame/eye_adaptation.h"
#include "skydrop/render/frame/sea_cut.h"

namespace skydrop::render {
namespace {

constexpr gl::FrameBufferFormat kSceneFormat{GL_RGBA16F, GL_DEPTH_COMPONENT32F};
constexpr gl::FrameBufferFormat kOutputFormat{GL_RGBA8, 0};

// Of the sky's tables that later frames will need, made in each frame: 0.4 ms.
constexpr int kSkyRowsAhead = 16;

// What is timed beside the passes; no pass has such a name.
constexpr std::string_view kBegin = "begin of the frame", kBeginLayer = "begin of the layer";

// Of the newest `count`.
double median(const std::vector<double>& all, std::size_t count) {
  return core::quantileOf(std::span(all).last(std::min(count, all.size())), 0.5);
}

}  // namespace

Renderer::Renderer(gl::Context& context, const RenderSettings& settings, bool measuring)
    : context_(context),
      settings_(settings),
      shaders_(context),
      timer_(context, measuring),
      moon_(std::make_unique<MoonOfFrame>()),
      uniforms_(context, sizeof(FrameUniforms), gl::Buffer::Use::write, "frame uniforms") {}

Renderer::~Renderer() = default;

void Renderer::add(std::unique_ptr<Pass> pass) {
  const auto comesBefore = [&](const Entry& other) {
    return std::pair(other.pass->stage(), other.group.order) <= std::pair(pass->stage(), group_.order);
  };
  const auto after = std::ranges::find_if_not(passes_, comesBefore);
  passes_.insert(after, Entry{std::move(pass), group_, holds_});
}

void Renderer::releaseHeld() {
  holds_ = false;
  for (Entry& entry : passes_) entry.held = false;
}

void Renderer::removeGroup(std::string_view name) {
  if (std::erase_if(passes_, [&](const Entry& entry) { return entry.group.name == name; }) > 0)
    screen_.sceneColorOnly = {};
}

void Renderer::setLayer(std::unique_ptr<StageLayer> layer) {
  assert(!layer || layer->stage() <= RenderStage::models);
  layer_ = std::move(layer);
}

void Renderer::resize(const View& scene, const View& picture) {
  Targets& t = *targets_;
  const auto isOf = [](const gl::FrameBuffer& target, const View& view) {
    return target && target.width() == view.width && target.height() == view.height;
  };
  if (isOf(t.scene, scene) && isOf(t.output, picture)) return;
  if (!t.scene) {
    t.scene = gl::FrameBuffer(context_, scene.width, scene.height, kSceneFormat, "scene");
    t.output = gl::FrameBuffer(context_, picture.width, picture.height, kOutputFormat, "output");
    t.output.setClearColor(0, 0, 0, 1);
  } else {
    if (!isOf(t.scene, scene)) t.scene.resize(scene.width, scene.height);
    if (!isOf(t.output, picture)) t.output.resize(picture.width, picture.height);
  }
  t.sceneColorOnly = {};  // made where a pass needs it
}

void Renderer::bindTarget(RenderStage stage) {
  Targets& t = *targets_;
  const bool readsDepth = stage >= RenderStage::clouds && stage <= RenderStage::edges;
  if (readsDepth && !t.sceneColorOnly) {
    t.sceneColorOnly = gl::FrameBuffer(context_, &t.scene.colorTexture(), nullptr, "scene colour");
  }
  gl::FrameBuffer& target = readsDepth ? t.sceneColorOnly : stage <= RenderStage::models ? t.scene : t.output;
  target.bind(gl::FrameBuffer::Clear::no);
}

bool Renderer::beginLayer(const FrameInput& input, Which which) {
  PixelBox all;
  for (const Entry& entry : passes_) {
    if (entry.held && which == Which::drawn) continue;
    const Pass& pass = *entry.pass;
    if (pass.stage() == layer_->stage() && !pass.skipReason(input)) all = unite(all, pass.extent(input));
  }
  if (const std::optional<std::string> reason = layer_->skipReason(settings_, all)) {
    skipped_.insert_or_assign(std::string(layer_->name()), *reason);
    return false;
  }
  timer_.begin(kBeginLayer);
  layer_->begin(context_, input.view, all);
  timer_.end();
  return true;
}

void Renderer::composeLayer(FrameContext& context, std::exception_ptr& failure) {
  skipped_.erase(std::string(layer_->name()));
  bindTarget(layer_->stage());
  context_.setDefaultState();
  tried(layer_->name(), {}, failure, [&] { layer_->compose(context); });
}

void Renderer::settle(const FrameInput& input) {
  context_.makeCurrent();
  air_.settle();
  sky_.settle();
  for (const Entry& entry : passes_) entry.pass->settle(input);
}

void Renderer::draw(const FrameInput& asked) { drawPasses(asked, Which::drawn, nullptr, {}); }

bool Renderer::unseen(double budgetMs, const std::function<void()>& work) {
  targets_ = &unseen_;
  timer_.setPaused(true);
  using Clock = gl::ShaderCache::Clock;
  const std::chrono::duration<double, std::milli> budget(budgetMs);
  shaders_.limitCompiling(Clock::now() + std::chrono::duration_cast<Clock::duration>(budget));
  auto skippedInDraw = std::exchange(skipped_, {});
  const auto restore = [&] {
    targets_ = &screen_;
    timer_.setPaused(false);
    shaders_.limitCompiling(std::nullopt);
    skipped_ = std::move(skippedInDraw);
  };
  try {
    work();
    restore();
    return true;
  } catch (const gl::ShaderCache::CompileLater&) {
    restore();
    return false;
  } catch (...) {
    restore();
    throw;
  }
}

bool Renderer::warmUp(const FrameInput& asked, double budgetMs, std::size_t& drawn) {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t before = drawn;
  const auto goesOn = [&](std::size_t count) {
    drawn = count;
    if (count <= before) return true;
    context_.api().Finish();  // a software renderer compiles when it draws
    const auto passed = std::chrono::steady_clock::now() - begin;
    return std::chrono::duration<double, std::milli>(passed).count() < budgetMs;
  };
  bool complete = false;
  return unseen(budgetMs, [&] { complete = drawPasses(asked, Which::all, goesOn, {}); }) && complete;
}

std::optional<std::vector<float>> Renderer::drawUnseen(const FrameInput& input) {
  std::vector<float> radiance;
  const bool complete = unseen(0, [&] {
    drawPasses(input, Which::drawn, nullptr, {.last = RenderStage::edges});
    radiance = radianceOf(unseen_);
  });
  return complete ? std::optional(std::move(radiance)) : std::nullopt;
}

bool Renderer::drawInset(const FrameInput& input) {
  return unseen(0, [&] { drawPasses(input, Which::drawn, nullptr, {.last = RenderStage::toneMap}); });
}

void Renderer::showInset(int left, int bottom) {
  if (unseen_.output && screen_.output) unseen_.output.copyTo(screen_.output, left, bottom);
}

void Renderer::drawOverlays(const FrameInput& input, std::string_view reason) {
  drawPasses(input, Which::drawn, nullptr, {.first = RenderStage::hud, .others = reason});
}

std::vector<View> Renderer::viewsBeside(const View& view) const {
  std::vector<View> views;
  for (const Entry& entry : passes_) {
    if (const std::optional<View> other = entry.pass->alsoShows(view)) views.push_back(*other);
  }
  return views;
}

bool Renderer::isLit() const {
  return std::ranges::any_of(passes_,
                             [](const Entry& entry) { return entry.pass->stage() < RenderStage::edges; });
}

// The darkest that any pass makes of it.
Overcast Renderer::overcastOf(const FrameInput& frame, Which which) {
  Overcast darkest;
  for (const Entry& entry : passes_) {
    if (!frame.features.overcast || (entry.held && which == Which::drawn)) continue;
    const Overcast overcast = entry.pass->overcast(frame);
    if (overcast.light() < darkest.light()) darkest = overcast;
  }
  return darkest;
}

bool Renderer::drawPasses(const FrameInput& asked, Which which, const GoesOn& goesOn, const Stages& stages) {
  requireValid(asked.view);
  context_.makeCurrent();
  gl::requireDevice(context_);
  RenderSettings lit = settings_;
  if (!isLit()) lit.sky.model = sky::SkyModel::closedForm;  // has no tables to make
  lit.atmosphere = air_.of(lit, asked);
  const std::optional<SkyPlaces> tables =
      targets_ == &screen_ ? sky_.of(lit, asked, moon_.get()) : std::nullopt;
  const SkyLight light = skyLight(lit, asked.view.position.y, asked.simulatedSeconds, asked.adaptedLevel,
                                  overcastOf(asked, which), tables ? &*tables : nullptr, moon_.get());
  if (targets_ == &screen_) levelInView_ = levelInView(light, asked.view);
  FrameInput picture = asked;  // of what is drawn over the scene, which may have fewer pixels
  picture.toSun = light.direct.toSun;
  picture.sunSine = light.toSun.y;
  picture.lightOverNight = lightOverNight(light);
  picture.moon = moon_.get();
  FrameInput input = picture;
  input.view = scaled(asked.view, settings_.scale);
  resize(input.view, picture.view);
  const FrameUniforms uniforms = frameUniforms(input.view, light, input.simulatedSeconds);
  std::vector<std::string> defines = definesOf(input.features);
  if (light.isShell()) defines.emplace_back(kSkyShellDefine);

  gl::GpuResourceTracker& resources = context_.resources();
  resources.clearPasses();
  timer_.beginFrame();
  noteTimes();
  timer_.begin(kBegin);
  uniforms_.writeValue(0, uniforms);
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kFrameUniformsBinding);
  if (light.isShell())
    skyTables_.bind(context_, light);
  else
    skyTables_ = {};
  if (stages.first <= RenderStage::models) targets_->scene.clear();
  targets_->output.clear();
  timer_.end();
  FrameResources made;
  std::string_view owner;  // of the pass that is drawn
  const DrawMirrored mirrored = [&](const View& view, gl::FrameBuffer& target, FrameResources& seen) {
    FrameInput of = input;
    of.view = view;
    of.isMirrored = true;
    const FrameUniforms ofView = frameUniforms(view, light, of.simulatedSeconds);
    std::vector<std::string> meshDefines = defines;
    meshDefines.emplace_back(SeaCut::kDefine);
    FrameContext frame{context_,
                       shaders_,
                       of,
                       light,
                       ofView,
                       lit,
                       defines,
                       meshDefines,
                       seen,
                       target.colorTexture(),
                       target.depthTexture(),
                       mirrored};
    drawMirrored(frame, target, which, uniforms);
    resources.setOwner(owner);
  };
  const auto contextOf = [&](const FrameInput& of) {
    return FrameContext{context_,
                        shaders_,
                        of,
                        light,
                        uniforms,
                        lit,
                        defines,
                        defines,
                        made,
                        targets_->scene.colorTexture(),
                        targets_->scene.depthTexture(),
                        mirrored};
  };
  FrameContext sceneFrame = contextOf(input), pictureFrame = contextOf(picture);
  skipped_.clear();
  if (layer_) {
    const bool left = !stages.contains(layer_->stage());
    skipped_.emplace(layer_->name(),
                     left ? std::string(stages.others) : layer_->skipReason(settings_, {}).value_or(""));
  }
  bool layered = false;  // the layer is the target
  bool complete = true;
  std::size_t count = 0;
  std::exception_ptr failure;
  for (const Entry& entry : passes_) {
    if (entry.held && which == Which::drawn) continue;
    Pass& pass = *entry.pass;
    if (!stages.contains(pass.stage())) {
      skipped_.emplace(pass.name(), stages.others);
      continue;
    }
    const bool isOfScene = pass.stage() < RenderStage::toneMap;
    const FrameInput& of = isOfScene ? input : picture;
    std::optional<std::string> reason = pass.skipReason(of);
    if (!reason) reason = pass.skipReasonAfter(of, made);
    if (reason) {
      skipped_.emplace(pass.name(), *reason);
      continue;
    }
    if (layered && pass.stage() > layer_->stage()) {
      composeLayer(sceneFrame, failure);
      layered = false;
    }
    if (!layered && layer_ && pass.stage() == layer_->stage()) layered = beginLayer(input, which);
    if (!layered) bindTarget(pass.stage());
    context_.setDefaultState();
    owner = entry.group.name;
    tried(pass.name(), entry.group, failure, [&] { pass.draw(isOfScene ? sceneFrame : pictureFrame); });
    if (goesOn && !goesOn(++count) && &entry != &passes_.back()) {
      complete = false;
      break;
    }
  }
  if (layered) composeLayer(sceneFrame, failure);
  if (failure) std::rethrow_exception(failure);
  if (light.isShell() && targets_ == &screen_)
    light.views->prepare(light.heightM, light.toSun.y, kSkyRowsAhead);
  return complete;
}

// Each pass pays for what it makes, as in the frame itself; draws and time are those of whoever asked.
void Renderer::drawMirrored(FrameContext& frame, gl::FrameBuffer& target, Which which,
                            const FrameUniforms& after) {
  uniforms_.writeValue(0, frame.uniforms);
  const auto restore = [&] { uniforms_.writeValue(0, after); };
  try {
    for (const Entry& entry : passes_) {
      Pass& pass = *entry.pass;
      if (!pass.isMirrored() || (entry.held && which == Which::drawn)) continue;
      if (pass.skipReason(frame.frame) || pass.skipReasonAfter(frame.frame, frame.resources)) continue;
      target.bind(gl::FrameBuffer::Clear::no);
      context_.setDefaultState();
      context_.resources().setOwner(entry.group.name);
      pass.draw(frame);
    }
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

void Renderer::tried(std::string_view name, const Group& group, std::exception_ptr& failure,
                     const std::function<void()>& draw) {
  try {
    measured(name, group, draw);
  } catch (const core::DataError& error) {
    skipped_.insert_or_assign(std::string(name), error.what());
    if (!failure) failure = std::current_exception();
  }
}

void Renderer::measured(std::string_view name, const Group& group, const std::function<void()>& draw) {
  gl::GpuResourceTracker& resources = context_.resources();
  const auto end = [&] {
    resources.setOwner("");
    timer_.end();
    resources.endPass();
  };
  resources.beginPass(name);
  timer_.begin(name);
  resources.setOwner(group.name);
  try {
    draw();
  } catch (...) {
    end();
    throw;
  }
  end();
}

void Renderer::noteTimes() {
  for (const auto& [pass, ms] : timer_.takeMilliseconds()) {
    std::vector<double>& times = times_[pass];
    if (times.size() >= kKeptTimes) times.erase(times.begin());
    times.push_back(ms);
  }
}

core::Image Renderer::readBack() {
  const gl::FrameBuffer& output = screen_.output;
  if (!output) return core::Image(1, 1);
  core::Image image(output.width(), output.height());
  std::vector<std::uint8_t> bottomUp(image.rgba.size());
  output.colorTexture().read(GL_RGBA, GL_UNSIGNED_BYTE, std::as_writable_bytes(std::span(bottomUp)));
  const std::size_t row = static_cast<std::size_t>(image.width) * 4;
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const auto from = bottomUp.begin() +
                      static_cast<std::ptrdiff_t>((static_cast<std::size_t>(image.height) - 1 - y) * row);
    std::copy(from, from + static_cast<std::ptrdiff_t>(row),
              image.rgba.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

std::vector<float> Renderer::readRadiance() { return radianceOf(screen_); }

std::vector<float> Renderer::radianceOf(const Targets& targets) {
  const gl::FrameBuffer& scene = targets.scene;
  if (!scene) return {};
  const std::size_t row = static_cast<std::size_t>(scene.width()) * 3;
  std::vector<float> bottomUp(row * static_cast<std::size_t>(scene.height())), radiance;
  scene.colorTexture().read(GL_RGB, GL_FLOAT, std::as_writable_bytes(std::span(bottomUp)));
  radiance.reserve(bottomUp.size());
  for (std::size_t y = bottomUp.size(); y > 0; y -= row)
    radiance.insert(radiance.end(), bottomUp.begin() + static_cast<std::ptrdiff_t>(y - row),
                    bottomUp.begin() + static_cast<std::ptrdiff_t>(y));
  if (scene.width() == targets.output.width() && scene.height() == targets.output.height()) return radiance;
  return stretched({scene.width(), scene.height(), radiance},
                   {targets.output.width(), targets.output.height()});
}

void Renderer::present(int width, int height) {
  if (screen_.output) screen_.output.drawToScreen(width, height);
}

void Renderer::finish() {
  context_.api().Finish();
  timer_.finish();
  noteTimes();
}

std::vector<std::pair<std::string_view, double>> Renderer::newestTimes() const {
  std::vector<std::pair<std::string_view, double>> newest;
  for (const Entry& entry : passes_) {
    const std::string_view name = entry.pass->name();
    const auto times = times_.find(name);
    if (entry.held || skipped_.contains(name) || times == times_.end() || times->second.empty()) continue;
    newest.emplace_back(name, times->second.back());
  }
  return newest;
}

void Renderer::clearTimes() {
  finish();
  times_.clear();
}

void Renderer::fillStatistics(core::FrameStatistics& statistics, std::size_t frames) {
  const gl::GpuResourceTracker& resources = context_.resources();
  statistics.clock = timer_.clockName();
  statistics.renderer = context_.renderer();
  statistics.passes.clear();
  const auto addRow = [&](const std::string& name, const std::string& group) {
    core::PassStatistics row;
    row.group = group;
    if (const auto times = times_.find(name); times != times_.end()) row.ms = median(times->second, frames);
    if (const auto counts = resources.passes().find(name); counts != resources.passes().end()) {
      row.draws = static_cast<std::int64_t>(counts->second.draws);
      row.dispatches = static_cast<std::int64_t>(counts->second.dispatches);
    }
    if (const auto reason = skipped_.find(name); reason != skipped_.end()) row.skipped = reason->second;
    statistics.passes.emplace_back(name, row);
  };
  bool hasLayered = false;
  for (const Entry& entry : passes_) {
    if (entry.held) continue;
    addRow(std::string(entry.pass->name()), entry.group.name);
    hasLayered = hasLayered || (layer_ && entry.pass->stage() == layer_->stage());
  }
  if (hasLayered) addRow(std::string(layer_->name()), "");
  const auto medianOf = [&](std::string_view name) {
    const auto times = times_.find(name);
    return times == times_.end() ? 0 : median(times->second, frames);
  };
  statistics.beginMs = medianOf(kBegin);
  const bool layered = hasLayered && !skipped_.contains(layer_->name());
  if (layered) statistics.beginMs += medianOf(kBeginLayer);
  statistics.gl.textures = resources.live(gl::ObjectKind::texture);
  statistics.gl.buffers = resources.live(gl::ObjectKind::buffer);
  statistics.gl.programs = resources.live(gl::ObjectKind::program);
  statistics.gl.framebuffers = resources.live(gl::ObjectKind::frameBuffer);
  statistics.gl.errors = static_cast<std::int64_t>(context_.debugErrors());
  statistics.gl.bytes = static_cast<std::int64_t>(resources.bytes());
}

}  // namespace skydrop::render
