// Only the effects that a scene calls for: each effect of the table is proven by the same tests, so a new one
// is proven the day it is added.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/effect_table.h"
#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "support/gl_test.h"
#include "support/instrumented.h"
#include "support/process_memory.h"
#include "support/shared_noise.h"
#include "support/soak.h"

namespace skydrop::app {
namespace {

using render::gl::ObjectKind;
using scene::Effect;
using scene::EffectSet;

constexpr Size kSize{64, 36};
// Memory that may stay resident: what allocator and driver take at first, and of each round what Mesa 22.3
// keeps of programs (17 KiB a round of land, nothing of clouds, over 97 rounds). A texture or a noise is
// larger.
constexpr double kFirstBytes = 8 << 20, kBytesARound = 64 << 10;

std::vector<Effect> allEffects() {
  std::vector<Effect> effects;
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) effects.push_back(static_cast<Effect>(i));
  return effects;
}

EffectSet everything() {
  EffectSet set;
  for (const Effect effect : allEffects()) set.insert(effect);
  return set;
}

// Without the effect and all that rest on it.
EffectSet without(EffectSet set, Effect effect) {
  set.erase(effect);
  for (std::size_t round = 0; round < scene::kEffectNeeds.size(); ++round) {
    for (const scene::EffectNeed& need : scene::kEffectNeeds) {
      if (!set.contains(need.needs)) set.erase(need.effect);
    }
  }
  return scene::effective(set);
}

// The table of a program that does not know the effect.
std::vector<EffectDescriptor> tableWithout(Effect effect) {
  std::vector<EffectDescriptor> table = effectTable();
  std::erase_if(table, [&](const EffectDescriptor& row) { return row.effect == effect; });
  for (EffectDescriptor& row : table) {
    std::erase_if(row.joints, [&](const EffectDescriptor::Joint& joint) { return joint.with == effect; });
  }
  return table;
}

// Everything that could be left behind.
struct Ledger {
  std::array<std::int64_t, render::gl::kObjectKindCount> objects{};
  std::uint64_t bytes = 0;
  std::map<std::string, render::gl::PassCounts> passes;
  std::size_t threads = 0, openFiles = 0;
  bool operator==(const Ledger&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Ledger& ledger) {
  out << "objects";
  for (const std::int64_t count : ledger.objects) out << ' ' << count;
  out << ", " << ledger.bytes << " bytes, " << ledger.threads << " threads, " << ledger.openFiles
      << " files;";
  for (const auto& [pass, counts] : ledger.passes)
    out << ' ' << pass << ' ' << counts.draws << '+' << counts.dispatches;
  return out;
}

std::size_t entriesIn(const char* folder) {
  std::error_code error;
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder, error),
                                                std::filesystem::directory_iterator()));
}

// Without those of Mesa's cache on disk ("gl_test:disk$0"), which come as it has programs to write.
std::size_t threads() {
  std::error_code error;
  std::size_t count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", error)) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    count += name.find(":disk$") == std::string::npos;
  }
  return count;
}

// A scene with these effects as it flies in a window, without the window.
class Flight {
 public:
  static constexpr double kSwitchBudgetMs = 1000;

  Flight(render::gl::Context& context, const EffectSet& effects,
         const std::vector<EffectDescriptor>& table = effectTable(), const std::vector<std::string>& set = {})
      : context_(context), table_(table), run_(prepareRun(lineOf(effects, set))), preparations_(table_) {
    preparations_.begin(effects, Preparation::Maker::processor, run_->settings);
    preparations_.waitUntilReady();
    simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
    sceneRenderer_ =
        std::make_unique<SceneRenderer>(context,
                                        SceneRenderer::Setup{effects, simulation_->ground(), 1, false,
                                                             preparations_.results(effects), &table_},
                                        run_->settings);
    sceneRenderer_->warmUp(snapshot(), kSize);
    settle();
  }

  // As with --set while flying.
  void set(const std::vector<std::string>& assignments) {
    Settings before = run_->settings;
    for (const std::string& one : assignments) core::setField(run_->table, one);
    sceneRenderer_->apply(SettingsChange::between(core::SettingsTable(before), run_->table));
  }

  // What is drawn: where the world is, or a place that pictures of several flights have in common.
  game::Snapshot snapshot() const { return shown_ ? *shown_ : simulation_->world().now(); }
  void show(const game::Snapshot& snapshot) { shown_ = snapshot; }
  Simulation& simulation() { return *simulation_; }
  SceneRenderer& sceneRenderer() { return *sceneRenderer_; }

  void settle() { sceneRenderer_->draw(snapshot(), kSize, Streaming::settled); }

  core::Image picture() {
    settle();
    return sceneRenderer_->renderer().readBack();
  }

  // Linear light of the last frame.
  std::vector<glm::vec4> light() {
    const render::gl::Texture& color = sceneRenderer_->renderer().sceneColor();
    std::vector<glm::vec4> texels(static_cast<std::size_t>(kSize.width * kSize.height));
    color.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
    return texels;
  }

  void fly(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 120); ++i) {
      simulation_->step({});
      if (i % 40 == 0) sceneRenderer_->draw(snapshot(), kSize, Streaming::asItComes);
    }
  }

  // As WindowGame does it, with more time for each frame: SceneRendererGLTest has slices as short as there.
  // Returns the frames that it took.
  int switchTo(const EffectSet& effects) {
    run_->settings.effects = switchesOf(effects);
    simulation_->apply({"effects"});
    EXPECT_EQ(simulation_->effects(), effects);
    preparations_.begin(effects, Preparation::Maker::processor, run_->settings);
    sceneRenderer_->beginSwitch(effects, simulation_->ground());
    preparations_.keepOnly(effects);
    preparations_.waitUntilReady();
    int frames = 0;
    for (; sceneRenderer_->isSwitching(); ++frames) {
      sceneRenderer_->continueSwitch(preparations_.results(effects), snapshot(), kSwitchBudgetMs);
      sceneRenderer_->draw(snapshot(), kSize, Streaming::asItComes);
      EXPECT_LT(frames, 100000) << "a switch that never ends";
    }
    return frames;
  }

  Ledger ledger() {
    settle();
    Ledger ledger;
    const render::gl::GpuResourceTracker& resources = context_.resources();
    for (int i = 0; i < render::gl::kObjectKindCount; ++i)
      ledger.objects[static_cast<std::size_t>(i)] = resources.live(static_cast<ObjectKind>(i));
    ledger.bytes = resources.bytes();
    ledger.passes = resources.passes();
    ledger.threads = threads();
    ledger.openFiles = entriesIn("/proc/self/fd");
    return ledger;
  }

 private:
  static CommandLine lineOf(const EffectSet& effects, const std::vector<std::string>& set) {
    CommandLine line;
    line.verb = Verb::render;
    // Land that is soon made: what is proven hangs on no land in particular.
    line.set = {"quality=low", "streaming.farDistanceM=5000", "streaming.viewDistanceM=1000",
                "landShadows.detail=coarse"};
    for (const Effect effect : allEffects()) {
      line.set.push_back("effects." + std::string(scene::nameOf(effect)) + "=" +
                         (effects.contains(effect) ? "true" : "false"));
    }
    line.set.insert(line.set.end(), set.begin(), set.end());
    return line;
  }

  render::gl::Context& context_;
  std::optional<game::Snapshot> shown_;
  std::vector<EffectDescriptor> table_;
  std::unique_ptr<RunConfig> run_;
  Preparations preparations_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneRenderer> sceneRenderer_;
};

class EffectGLTestBase : public test::GLTest {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
    test::sharedNoise();
    test::GLTest::SetUp();
  }
};

class EffectGLTest : public EffectGLTestBase, public testing::WithParamInterface<Effect> {
 protected:
  // After a first round, which takes what is taken once.
  void expectNothingLeftBehind(Flight& flight, const EffectSet& all, const EffectSet& less) {
    const int rounds = test::soaking() ? 98 : 2;
    const auto round = [&] { flight.switchTo(less), flight.switchTo(all); };
    const Ledger before = flight.ledger();
    const auto grownOverRounds = [&] {
      const std::size_t memoryBefore = test::residentBytes();
      for (int i = 0; i < rounds; ++i) round();
      return static_cast<double>(test::residentBytes()) - static_cast<double>(memoryBefore);
    };
    const double most = kFirstBytes + kBytesARound * rounds;
    double grown = grownOverRounds();
    // What a thread still holds, or a pool that has grown, shows once; what is left behind, in each round
    // again.
    if (grown > most) grown = grownOverRounds();
    EXPECT_EQ(flight.ledger(), before);
    RecordProperty("kibibytesARound", std::to_string(grown / rounds / 1024));
    EXPECT_LE(grown, most);
  }
};

INSTANTIATE_TEST_SUITE_P(, EffectGLTest, testing::ValuesIn(allEffects()),
                         [](const auto& effect) { return std::string(scene::nameOf(effect.param)); });

TEST_P(EffectGLTest, aSceneWithoutItIsThatOfAProgramWithoutItHoweverItBegan) {
  // Objects, bytes, draws, dispatches, threads, files and every pixel of a scene without the effect are those
  // of a program whose table has no row for it, and those after it was switched off in flight. Switched on
  // again all is as it was; then off and on twice more (98 times when soaking): the GPU, threads and files
  // are as before, and memory too but for what the driver keeps of each program that it has compiled.
  const EffectSet all = everything(), less = without(all, GetParam());
  Ledger switchedOff;
  core::Image pictureOff;
  game::Snapshot shown;
  {
    Flight flight(context(), all);
    shown = flight.snapshot();
    flight.show(shown);  // targets that come again are elsewhere
    const Ledger begun = flight.ledger();
    const core::Image picture = flight.picture();
    flight.switchTo(less);
    switchedOff = flight.ledger();
    pictureOff = flight.picture();
    flight.switchTo(all);
    EXPECT_EQ(flight.ledger(), begun);
    EXPECT_EQ(flight.picture().rgba, picture.rgba);
    expectNothingLeftBehind(flight, all, less);
  }
  Ledger off;
  {
    Flight flight(context(), less);
    off = flight.ledger();
    const core::Image begunOff = flight.picture();
    flight.show(shown);
    EXPECT_EQ(switchedOff, flight.ledger());
    EXPECT_EQ(pictureOff.rgba, flight.picture().rgba);
    pictureOff = begunOff;
  }
  Flight flight(context(), less, tableWithout(GetParam()));
  EXPECT_EQ(off, flight.ledger());
  EXPECT_EQ(pictureOff.rgba, flight.picture().rgba);
}

class EffectSetGLTest : public EffectGLTestBase {};

TEST_F(EffectSetGLTest, turningUpWhatHadNothingToDrawCompilesNothing) {
  // Fog of no density and sheets whose cutoff leaves no cloud are idle, and their programs are there.
  const std::vector<std::string> idle = {"groundFog.density=0", "cloudDome.cutoff=1",
                                         "cloudPlanes.layers.0.cutoff=1", "cloudPlanes.layers.1.cutoff=1",
                                         "cloudPlanes.layers.2.cutoff=1"};
  Flight flight(context(), everything(), effectTable(), idle);
  flight.fly(0.5);
  const auto idlePasses = [&] {
    core::FrameStatistics statistics;
    flight.sceneRenderer().writeTo(statistics, 1);
    int count = 0;
    for (const auto& [pass, of] : statistics.passes) {
      const bool isOne = pass == "groundFog" || pass == "cloudDome" || pass == "cloudPlanes";
      count += isOne && !of.skipped.empty();
    }
    return count;
  };
  EXPECT_EQ(idlePasses(), 3);
  const std::uint64_t made = flight.sceneRenderer().renderer().shaders().madeSoFar();
  flight.set({"groundFog.density=0.001", "cloudDome.cutoff=0.6", "cloudPlanes.layers.0.cutoff=0.5"});
  flight.fly(0.5);
  EXPECT_EQ(idlePasses(), 0);
  EXPECT_EQ(flight.sceneRenderer().renderer().shaders().madeSoFar(), made);
}

TEST_F(EffectSetGLTest, anySetOfEffectsStartsFliesAndEnds) {
  // All pairs, and 20 sets at random (200 when soaking), each with what it needs and each from the one before
  // it as while flying: flies two seconds and draws a picture. Every sixth of them unless all are asked for,
  // under a sanitizer every ninth.
  std::vector<EffectSet> sets;
  const auto add = [&](const EffectSet& wanted) {
    const EffectSet set = scene::effective(scene::withNeeds(wanted));
    if (std::ranges::find(sets, set) == sets.end()) sets.push_back(set);
  };
  const std::vector<Effect> effects = allEffects();
  for (std::size_t a = 0; a < effects.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EffectSet pair;
      pair.insert(effects[a]), pair.insert(effects[b]);
      add(pair);
    }
  }
  core::RandomStream random{7, 0};
  for (int i = 0; i < (test::soaking() ? 200 : 20); ++i) {
    EffectSet set;
    for (const Effect effect : effects) {
      if (random.next() % 2 == 0) set.insert(effect);
    }
    add(set);
  }
  Flight flight(context(), sets.front());
  const std::size_t stride = test::kInstrumented && !test::soaking() ? 9 : test::triesAll() ? 1 : 6;
  for (std::size_t i = 0; i < sets.size(); i += stride) {
    const EffectSet& set = sets[i];
    flight.switchTo(set);
    flight.fly(2);
    const std::vector<glm::vec4> light = flight.light();
    const bool isFinite = std::ranges::all_of(
        light, [](const glm::vec4& texel) { return std::isfinite(texel.x + texel.y + texel.z); });
    EXPECT_TRUE(isFinite);
    EXPECT_EQ(flight.simulation().world().now().aircraft.present, set.contains(Effect::aircraft));
  }
}

}  // namespace
}  // namespace skydrop::app
