// The parameters of the clouds where a weather makes the layers: ratios and differences on its low layer.
#include "skydrop/weather/layer_look.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/world.h"
#include "skydrop/weather/moment.h"
#include "skydrop/weather/usual_layer.h"

namespace skydrop::weather {
namespace {

clouds::CloudLayerSettings tuned() {
  clouds::CloudLayerSettings s;
  s.densityThreshold = 0.6, s.scale = 0.9, s.anisotropy = 0.4, s.extinction = 0.03;
  s.higherScale = 30, s.weatherScale = 0.05, s.cloudHeight = 900;
  s.thickness = 1000, s.coverage = 0.8, s.typeShift = -0.3, s.erosion = 0.1, s.forwardShare = 0.5;
  return s;
}

TEST(LayerLook, ofDefaultsLeavesEachBitOfEveryGenus) {
  // Golden frames and replays of a weather whose clouds nobody tuned are what they were.
  const LayerLook none = game::lookOf({});
  EXPECT_EQ(none, LayerLook{});
  for (std::size_t i = 0; i < kGenusNames.size(); ++i) {
    Layer layer = usualLayer(static_cast<Genus>(i));
    layer.baseM += 1.0 / 3, layer.topM += 0.7;
    EXPECT_EQ(withLook(layer, none), layer) << kGenusNames[i];
  }
}

TEST(LayerLook, ofACumulusIsTheLayerOfTheSettings) {
  // The default cumulus is the default layer, so each parameter gives it what it gives that.
  const clouds::CloudLayerSettings s = tuned();
  const Layer cumulus{Genus::cumulus, 1555, 3355, 0.5, 1};
  const clouds::CloudLayerSettings m = game::cloudLayerOf(withLook(cumulus, game::lookOf(s))).layer;
  EXPECT_NEAR(m.densityThreshold, s.densityThreshold, 1e-12);
  EXPECT_NEAR(m.scale, s.scale, 1e-12);
  EXPECT_NEAR(m.anisotropy, s.anisotropy, 1e-12);
  EXPECT_NEAR(m.extinction, s.extinction, 1e-12);
  EXPECT_NEAR(m.higherScale, s.higherScale, 1e-12);
  EXPECT_NEAR(m.weatherScale, s.weatherScale, 1e-12);
  EXPECT_NEAR(m.cloudHeight, s.cloudHeight, 1e-9);
  EXPECT_NEAR(m.thickness, s.thickness, 1e-9);
  EXPECT_NEAR(m.coverage, s.coverage, 1e-12);
  EXPECT_NEAR(m.typeShift, s.typeShift, 1e-12);
  EXPECT_NEAR(m.erosion, s.erosion, 1e-12);
  EXPECT_NEAR(m.forwardShare, s.forwardShare, 1e-12);
}

TEST(LayerLook, keepsEveryGenusUsableAtTheEndsOfTheRows) {
  // Heights, cover and medium stay within their ranges whatever genus and settings meet.
  State state;
  for (std::size_t k = 0; k < kWindLevels; ++k) state.wind.levels[k] = {1500.0 + 1000 * double(k), 10, 0};
  for (const bool most : {false, true}) {
    clouds::CloudLayerSettings s;
    s.densityThreshold = most ? 0.95 : 0, s.scale = most ? 4 : 0.1, s.anisotropy = most ? 0.95 : -0.9;
    s.extinction = most ? 1 : 0, s.higherScale = most ? 80 : 2, s.weatherScale = most ? 0.1 : 0.005;
    s.cloudHeight = most ? 8000 : 100, s.thickness = most ? 6000 : 50, s.coverage = most ? 1 : 0;
    s.typeShift = most ? 1 : -1, s.erosion = most ? 0.9 : 0, s.forwardShare = most ? 1 : 0;
    for (std::size_t i = 0; i < kGenusNames.size(); ++i) {
      state.layers[0] = usualLayer(static_cast<Genus>(i));
      lookLow(state, game::lookOf(s));
      EXPECT_NO_THROW(requireUsable(state)) << kGenusNames[i] << ' ' << most;
      const clouds::CloudLayerSettings m = game::cloudLayerOf(state.layers[0]).layer;
      EXPECT_GT(m.thickness, 0) << kGenusNames[i];
      EXPECT_LE(m.extinction, 1) << kGenusNames[i];
      EXPECT_GE(m.densityThreshold, -0.95) << kGenusNames[i];
    }
  }
}

TEST(LayerLook, isOfTheLowLayerAlone) {
  // The middle and the high layer stay; ice in the low place stays too.
  WeatherSettings settings;
  settings.variability = 0;
  settings.sites[0].layers[0] = {Genus::stratocumulus, 1200, 2000, 0.7, 1};
  settings.sites[0].layers[1] = {Genus::altocumulus, 4200, 4700, 0.5, 1};
  Moment moment{std::make_shared<const WeatherSettings>(settings), 1, 100};
  const State plain = moment.at({0, 0});
  moment.lowLook = game::lookOf(tuned());
  const State looked = moment.at({0, 0});
  EXPECT_NE(looked.layers[0], plain.layers[0]);
  EXPECT_DOUBLE_EQ(looked.layers[0].baseM, 1200 * 900.0 / 1555);
  EXPECT_EQ(looked.layers[1], plain.layers[1]);
  Layer cirrus = usualLayer(Genus::cirrus);
  EXPECT_EQ(withLook(cirrus, moment.lowLook), cirrus);
  // What flies asks the same.
  game::WeatherSetup setup{settings, {}, nullptr};
  setup.lowLook = moment.lowLook;
  EXPECT_EQ(setup.at(1, 100, {0, 0}).layers[0], looked.layers[0]);
}

}  // namespace
}  // namespace skydrop::weather
