// What effects prepare before the first frame, and the table that says so.
#include "app/session/preparations.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "app/settings/settings.h"

namespace skydrop::app {
namespace {

using scene::Effect;
using scene::EffectSet;

struct Answer {
  int value = 0;
};

// Ready when the test says so. As many as are alive are counted.
class FakePreparation final : public Preparation {
 public:
  FakePreparation() { ++alive; }
  ~FakePreparation() override { --alive; }

  std::string_view title() const override { return "Making the answer"; }
  double progress() const override { return share; }
  bool isReady() const override {
    if (fails) throw std::runtime_error("no answer");
    return share >= 1;
  }
  void waitUntilReady() const override { share = 1; }
  void makePart(render::gl::Context&) override {}
  void putResult(PreparedResources& resources) const override {
    resources.put(std::make_shared<const Answer>(Answer{42}));
  }
  std::vector<std::string> takeMessages() override { return {"the answer was not kept"}; }

  static inline int alive = 0;
  static inline double share = 0;
  static inline bool fails = false;
};

std::unique_ptr<Preparation> prepareAnswer(Preparation::Maker, const Settings&) {
  return std::make_unique<FakePreparation>();
}

EffectSet setOf(std::initializer_list<Effect> effects) {
  EffectSet set;
  for (const Effect effect : effects) set.insert(effect);
  return set;
}

constexpr auto kMaker = Preparation::Maker::processor;
const Settings kSettings;

// A table in which clouds and haze prepare something, and the sky does not.
class PreparationsTest : public testing::Test {
 protected:
  PreparationsTest() {
    FakePreparation::share = 0;
    FakePreparation::fails = false;
  }

  const std::vector<EffectDescriptor> table_ = {{.effect = Effect::sky},
                                                {.effect = Effect::haze, .prepare = prepareAnswer},
                                                {.effect = Effect::clouds, .prepare = prepareAnswer}};
  Preparations preparations_{table_};
};

TEST_F(PreparationsTest, onlyWhatTheEffectsCallForIsStartedAndOnlyOnce) {
  preparations_.begin(setOf({Effect::sky, Effect::terrain}), kMaker, kSettings);
  EXPECT_EQ(FakePreparation::alive, 0);
  EXPECT_EQ(preparations_.pending(), nullptr);
  EXPECT_EQ(preparations_.progress(), 1);
  preparations_.begin(setOf({Effect::sky, Effect::clouds}), kMaker, kSettings);
  preparations_.begin(setOf({Effect::sky, Effect::clouds}), kMaker, kSettings);
  EXPECT_EQ(FakePreparation::alive, 1);
}

TEST_F(PreparationsTest, resultsAreThereWhenTheyAreReady) {
  // Before, they are pending and nothing can be found; after, only effects that need a result are given it.
  const EffectSet clouds = setOf({Effect::clouds});
  preparations_.begin(clouds, kMaker, kSettings);
  FakePreparation::share = 0.5;
  ASSERT_NE(preparations_.pending(), nullptr);
  EXPECT_EQ(preparations_.pending()->title(), "Making the answer");
  EXPECT_EQ(preparations_.progress(), 0.5);
  EXPECT_EQ(preparations_.results(clouds).find<Answer>(), nullptr);
  preparations_.waitUntilReady();
  EXPECT_EQ(preparations_.pending(), nullptr);
  ASSERT_NE(preparations_.results(clouds).find<Answer>(), nullptr);
  EXPECT_EQ(preparations_.results(clouds).find<Answer>()->value, 42);
  EXPECT_EQ(preparations_.results(clouds).find<int>(), nullptr);
  EXPECT_EQ(preparations_.results(setOf({Effect::sky})).find<Answer>(), nullptr);
  EXPECT_THAT(preparations_.takeMessages(), testing::ElementsAre("the answer was not kept"));
}

TEST_F(PreparationsTest, whatTheNextSceneDoesNotNeedEnds) {
  // And what it does need goes on as it is.
  preparations_.begin(setOf({Effect::clouds, Effect::haze}), kMaker, kSettings);
  EXPECT_EQ(FakePreparation::alive, 2);
  const Preparation* first = preparations_.pending();
  preparations_.keepOnly(setOf({Effect::clouds, Effect::sky}));
  EXPECT_EQ(FakePreparation::alive, 1);
  EXPECT_EQ(preparations_.pending(), first);
  preparations_.keepOnly({});
  EXPECT_EQ(FakePreparation::alive, 0);
}

TEST_F(PreparationsTest, aFailureReachesWhoAsks) {
  preparations_.begin(setOf({Effect::clouds}), kMaker, kSettings);
  FakePreparation::fails = true;
  EXPECT_THROW(preparations_.pending(), std::runtime_error);
}

TEST(EffectTable, everyEffectHasOneRow) {
  // And a row that applies settings has passes to apply them to.
  std::set<Effect> seen;
  for (const EffectDescriptor& row : effectTable()) {
    EXPECT_TRUE(seen.insert(row.effect).second) << scene::kEffectNames[static_cast<std::size_t>(row.effect)];
    EXPECT_TRUE(row.addPasses || !row.apply);
  }
  EXPECT_EQ(seen.size(), scene::kEffectNames.size());
}

}  // namespace
}  // namespace skydrop::app
