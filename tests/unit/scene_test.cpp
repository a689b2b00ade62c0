#include "skydrop/scene/scene.h"

#include <gtest/gtest.h>

#include "skydrop/core/error.h"
#include "support/refusal.h"

namespace skydrop::scene {
namespace {

std::string refusalOf(const std::string& text) {
  return test::refusalOf<core::DataError>([&] { parseScene(text, "a.json"); });
}

TEST(Scene, shippedScenesLoadAndAreListed) {
  // Every scene in assets/scenes can be loaded by its name.
  const std::vector<std::string> names = listScenes();
  ASSERT_GE(names.size(), 2u);
  for (const std::string& name : names) EXPECT_EQ(loadScene(name).name, name);
}

TEST(Scene, theEmptySceneCallsForNothing) { EXPECT_EQ(requiredEffects(loadScene("empty")), EffectSet()); }

TEST(Scene, theScenesWithWeatherAreTheLandWithClouds) {
  // Same land, same start, same targets: only the clouds come on top, and in fair what a night flight needs
  // and what is seen of the land from low.
  const Scene land = loadScene("terrain");
  EffectSet effects = land.effects;
  EXPECT_FALSE(effects.contains(Effect::clouds)) << "what it does not name costs nothing";
  effects.insert(Effect::clouds);
  for (const char* name : {"clear", "fair", "overcast"}) {
    const Scene scene = loadScene(name);
    EffectSet required = requiredEffects(scene);
    for (const Effect ofFair :
         {Effect::aircraftLights, Effect::landingLight, Effect::vegetation, Effect::groundDetail,
          Effect::waterDetail, Effect::places, Effect::dustAndSpray, Effect::groundCover}) {
      EXPECT_EQ(required.contains(ofFair), scene.name == "fair") << name;
      required.erase(ofFair);
    }
    EXPECT_EQ(required, effects) << name;
    EXPECT_EQ(scene.seed, land.seed);
    EXPECT_EQ(scene.start.position, land.start.position);
    EXPECT_EQ(scene.start.headingDegrees, land.start.headingDegrees);
  }
}

TEST(Scene, targetsCallForWhatTheyRestOn) {
  // Naming targets alone brings the aircraft that drops and the ground to land on, and nothing else.
  const EffectSet effects = requiredEffects(parseScene(R"({"schema": 1, "effects": ["targets"]})", "a.json"));
  EXPECT_TRUE(effects.contains(Effect::aircraft));
  EXPECT_TRUE(effects.contains(Effect::terrain));
  EXPECT_FALSE(effects.contains(Effect::sound));
  EXPECT_FALSE(effects.contains(Effect::sky));
}

TEST(Scene, hazeWithoutAnySurfaceIsNotCalledFor) {
  const Scene scene = parseScene(R"({"schema": 1, "effects": ["sky", "haze"]})", "a.json");
  EXPECT_FALSE(requiredEffects(scene).contains(Effect::haze));
  const Scene clouded = parseScene(R"({"schema": 1, "effects": ["clouds", "haze"]})", "a.json");
  EXPECT_TRUE(requiredEffects(clouded).contains(Effect::haze)) << "it veils clouds too";
}

TEST(Scene, lampsAreCalledForOnAnAircraftAlone) {
  for (const Effect lamps : {Effect::aircraftLights, Effect::landingLight}) {
    EffectSet effects;
    effects.insert(lamps);
    EXPECT_EQ(effective(effects), EffectSet());
    effects.insert(Effect::aircraft);
    EXPECT_TRUE(effective(effects).contains(lamps));
  }
}

TEST(Scene, dustAndSprayAreCalledForWhereSomethingTouchesLand) {
  // Without an aircraft nothing touches, without land nothing is touched: neither is brought along.
  const auto required = [](const char* effects) {
    return requiredEffects(
        parseScene(R"({"schema": 1, "effects": [)" + std::string(effects) + "]}", "a.json"));
  };
  EXPECT_TRUE(required(R"("dustAndSpray", "aircraft", "terrain")").contains(Effect::dustAndSpray));
  EXPECT_FALSE(required(R"("dustAndSpray", "terrain")").contains(Effect::dustAndSpray));
  EXPECT_FALSE(required(R"("dustAndSpray", "aircraft")").contains(Effect::dustAndSpray));
}

TEST(Scene, shaftsAreCalledForWhereSomethingShadesHaze) {
  // Clouds shade air by what shades the land below them.
  const auto isCalledFor = [](const std::string& others) {
    const Scene scene = parseScene(R"({"schema": 1, "effects": ["lightShafts", )" + others + "]}", "a.json");
    return requiredEffects(scene).contains(Effect::lightShafts);
  };
  EXPECT_TRUE(isCalledFor(R"("terrain", "clouds", "haze")"));
  EXPECT_TRUE(isCalledFor(R"("terrain", "landShadows", "haze")"));
  EXPECT_FALSE(isCalledFor(R"("terrain", "haze")"));
  EXPECT_FALSE(isCalledFor(R"("clouds", "landShadows", "haze")"));
  EXPECT_FALSE(isCalledFor(R"("terrain", "clouds", "landShadows")"));
}

TEST(Scene, startAndSeedAreRead) {
  const Scene scene = parseScene(
      R"({"schema": 1, "seed": 9, "start": {"position": [1, 2, -3.5], "heading": 270, "speed": 80}})",
      "b.json");
  EXPECT_EQ(scene.name, "b");
  EXPECT_EQ(scene.seed, 9u);
  EXPECT_EQ(scene.start.position, glm::dvec3(1, 2, -3.5));
  EXPECT_EQ(scene.start.headingDegrees, 270);
  EXPECT_EQ(scene.start.speedMps, 80);
}

TEST(Scene, badScenesAreRefusedWithFilePlaceAndReason) {
  EXPECT_EQ(refusalOf(R"([])"), "a.json: scene: is not an object");
  EXPECT_EQ(refusalOf(R"({})"), "a.json: schema: is missing");
  EXPECT_EQ(refusalOf(R"({"schema": 2})"), "a.json: schema: 2 is not 1");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "wings": 2})"), "a.json: wings: unknown member");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "seed": -1})"),
            "a.json: seed: -1 is out of range 0.0 to 9.007199254740992e+15");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "seed": 1.5})"), "a.json: seed: 1.5 is not a whole number");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "effects": ["fire"]})"),
            "a.json: effects: unknown effect \"fire\"; the nearest are 'iceClouds', 'targets' and 'haze'");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "start": {"position": [1, 2]}})"),
            "a.json: start.position: is not a list of three numbers");
  EXPECT_EQ(refusalOf(R"({"schema": 1, "start": {"speed": "fast"}})"),
            "a.json: start.speed: \"fast\" is not a number");
  EXPECT_NE(refusalOf(R"({"schema": 1, "start": {"position": [0, 200000, 0]}})").find("is out of range"),
            std::string::npos);
  EXPECT_EQ(refusalOf(R"({"schema": 1, "start": {"position": [1e400, 0, 0]}})"),
            "a.json: line 1, column 43: number overflow parsing '1e400'");
  EXPECT_EQ(refusalOf(R"({"schema": 1, )").substr(0, 39), "a.json: line 1, column 14: syntax error");
  EXPECT_EQ(refusalOf("{\"schema\": 1,\n \"seed\": 1, \"seed\": 2}"),
            "a.json: line 2, column 18: 'seed' is defined twice");
}

TEST(Scene, everyTruncationOfASceneIsRefused) {
  const std::string whole = R"({"schema": 1, "effects": ["sky"], "start": {"heading": 10}})";
  ASSERT_EQ(refusalOf(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(refusalOf(whole.substr(0, length)), "") << length;
  }
}

TEST(Scene, unknownNamesListWhatThereIs) {
  try {
    loadScene("nowhere");
    FAIL();
  } catch (const core::DataError& error) {
    EXPECT_EQ(std::string(error.what()),
              "nowhere: scene: there is none of this name; "
              "there are: afterRain, airstrip, bern, breeze, cirrus, clear, coldFront, dome, duskPlanes, "
              "empty, fair, lagoon, lesson, lowlevel, "
              "night-approach, night-range, overcast, plane1, plane3, shafts, snowfall, stress, terrain, "
              "thunderstorm, valleyFog, village, warmFront, woodland");
  }
}

}  // namespace
}  // namespace skydrop::scene
