// No field of a settings struct is left out of its description. A field that describe() does not name has no
// row in the menu, is not kept, not logged and not compared, and nothing else would say so.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "app/settings/settings.h"
#include "app/window/noise_tool_settings.h"
#include "app/window/window_memory.h"
#include "skydrop/lab/knobs.h"
#include "skydrop/noise/noise_settings.h"
#include "support/paths.h"
#include "support/struct_fields.h"

namespace skydrop::app {
namespace {

// Every value of the struct, changed by itself, changes what exactly one described field reads.
template <class Settings>
std::vector<std::string> undescribedValues() {
  Settings settings{};
  const core::SettingsTable table(settings);
  const auto read = [&] {
    std::vector<double> values;
    for (const core::Field& field : table.fields()) values.push_back(field.get());
    return values;
  };
  const std::vector<double> before = read();
  std::vector<std::string> wrong;
  int number = 0;
  test::forEachValue(settings, [&](auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    const Value kept = value;
    if constexpr (std::is_same_v<Value, bool>)
      value = !value;
    else if constexpr (std::is_enum_v<Value>)
      value = static_cast<Value>(static_cast<int>(value) + 1);
    else
      value += 1;
    const std::vector<double> now = read();
    std::string changed;
    int count = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] == before[i]) continue;
      ++count;
      changed += " " + table.fields()[i].path;
    }
    value = kept;
    ++number;
    if (count != 1) {
      wrong.push_back("value " + std::to_string(number) +
                      (count == 0 ? " is not described" : " is described by" + changed));
    }
  });
  if (static_cast<std::size_t>(number) != before.size()) {
    wrong.push_back(std::to_string(before.size()) + " fields are described, " + std::to_string(number) +
                    " are there");
  }
  return wrong;
}

template <class Settings>
void expectDescribed(const char* name) {
  EXPECT_EQ(undescribedValues<Settings>(), std::vector<std::string>()) << name;
}

// Structs that are described, as the headers declare them: "void describe(core::SettingsVisitor& visitor,
// RenderSettings& settings);", a line each.
std::set<std::string> describedStructs() {
  std::set<std::string> names;
  for (const char* folder : {"include", "src"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(test::sourceDir()) / folder)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("void describe(")) continue;
        const std::size_t begin = line.find(", ") + 2, end = line.find('&', begin);
        if (end != std::string::npos) names.insert(line.substr(begin, end - begin));
      }
    }
  }
  return names;
}

#define SKYDROP_STRUCT(type) \
  { #type, &expectDescribed < type> }

TEST(DescribedFields, everyFieldOfEveryStructIsDescribedOnce) {
  using audio::AudioSettings;
  using clouds::CloudDomeSettings;
  using clouds::CloudPlaneSettings;
  using clouds::CloudPlanesSettings;
  using clouds::CloudSettings;
  using clouds::IceCloudSettings;
  using clouds::MarchSettings;
  using core::WindSettings;
  using elevation::ElevationSettings;
  using flight::AirplaneSettings;
  using flight::GearSettings;
  using flight::PackageSettings;
  using game::AssistSettings;
  using game::AutopilotSettings;
  using game::DeliverySettings;
  using game::GameSettings;
  using lab::BlendKnobs;
  using lab::CloudKnobs;
  using lab::FractalKnobs;
  using lab::MarchKnobs;
  using lab::OcclusionKnobs;
  using lab::OrbitKnobs;
  using lab::PerlinKnobs;
  using lab::RandomKnobs;
  using lab::ShadowKnobs;
  using lab::ShapeKnobs;
  using lab::VoronoiKnobs;
  using noise::NoiseSettings;
  using noise::PostProcess;
  using render::AircraftLightsSettings;
  using render::AtmosphereSettings;
  using render::CameraSettings;
  using render::DustAndSpraySettings;
  using render::GroundCoverSettings;
  using render::GroundFogSettings;
  using render::HaloSettings;
  using render::LandingLightSettings;
  using render::LandShadowSettings;
  using render::LightShaftSettings;
  using render::PlacesViewSettings;
  using render::PrecipitationSettings;
  using render::RainbowSettings;
  using render::RenderSettings;
  using render::SkySettings;
  using render::StarsSettings;
  using render::SunSettings;
  using render::VegetationSettings;
  using render::WaterDetailSettings;
  using terrain::GroundDetailSettings;
  using terrain::GroundPictureSettings;
  using terrain::PlacesSettings;
  using terrain::StripSettings;
  using terrain::TerrainSettings;
  using terrain::TerrainStreamingSettings;
  using terrain::WoodsSettings;
  using weather::ForecastClock;
  using weather::LightningSettings;
  using weather::LiveSettings;
  using weather::SiteSettings;
  using weather::WeatherLayerSettings;
  using weather::WeatherSettings;
  using weather::WindLevelSettings;
  const std::map<std::string, void (*)(const char*)> structs = {
      SKYDROP_STRUCT(AirplaneSettings),
      SKYDROP_STRUCT(PackageSettings),
      SKYDROP_STRUCT(GearSettings),
      SKYDROP_STRUCT(StripSettings),
      SKYDROP_STRUCT(WoodsSettings),
      SKYDROP_STRUCT(PlacesSettings),
      SKYDROP_STRUCT(GroundDetailSettings),
      SKYDROP_STRUCT(GameSettings),
      SKYDROP_STRUCT(AutopilotSettings),
      SKYDROP_STRUCT(TerrainSettings),
      SKYDROP_STRUCT(TerrainStreamingSettings),
      SKYDROP_STRUCT(CameraSettings),
      SKYDROP_STRUCT(SunSettings),
      SKYDROP_STRUCT(AtmosphereSettings),
      SKYDROP_STRUCT(RenderSettings),
      SKYDROP_STRUCT(SplitSettings),
      SKYDROP_STRUCT(MarchSettings),
      SKYDROP_STRUCT(CloudSettings),
      SKYDROP_STRUCT(AudioSettings),
      SKYDROP_STRUCT(ViewSettings),
      SKYDROP_STRUCT(GamepadSettings),
      SKYDROP_STRUCT(InputSettings),
      SKYDROP_STRUCT(Settings),
      SKYDROP_STRUCT(WindowMemory),
      SKYDROP_STRUCT(WindSettings),
      SKYDROP_STRUCT(EffectSwitches),
      SKYDROP_STRUCT(NoiseSettings),
      SKYDROP_STRUCT(CloudKnobs),
      SKYDROP_STRUCT(FractalKnobs),
      SKYDROP_STRUCT(PerlinKnobs),
      SKYDROP_STRUCT(RandomKnobs),
      SKYDROP_STRUCT(VoronoiKnobs),
      SKYDROP_STRUCT(BlendKnobs),
      SKYDROP_STRUCT(MarchKnobs),
      SKYDROP_STRUCT(OcclusionKnobs),
      SKYDROP_STRUCT(OrbitKnobs),
      SKYDROP_STRUCT(ShadowKnobs),
      SKYDROP_STRUCT(ShapeKnobs),
      SKYDROP_STRUCT(PostProcess),
      SKYDROP_STRUCT(NoiseToolSettings),
      SKYDROP_STRUCT(CloudPlaneSettings),
      SKYDROP_STRUCT(CloudPlanesSettings),
      SKYDROP_STRUCT(CloudDomeSettings),
      SKYDROP_STRUCT(GroundFogSettings),
      SKYDROP_STRUCT(StarsSettings),
      SKYDROP_STRUCT(LandShadowSettings),
      SKYDROP_STRUCT(SkySettings),
      SKYDROP_STRUCT(HaloSettings),
      SKYDROP_STRUCT(RainbowSettings),
      SKYDROP_STRUCT(WindLevelSettings),
      SKYDROP_STRUCT(WeatherLayerSettings),
      SKYDROP_STRUCT(SiteSettings),
      SKYDROP_STRUCT(WeatherSettings),
      SKYDROP_STRUCT(LightShaftSettings),
      SKYDROP_STRUCT(LandingLightSettings),
      SKYDROP_STRUCT(AircraftLightsSettings),
      SKYDROP_STRUCT(MoodSettings),
      SKYDROP_STRUCT(ForecastClock),
      SKYDROP_STRUCT(IceCloudSettings),
      SKYDROP_STRUCT(PrecipitationSettings),
      SKYDROP_STRUCT(VegetationSettings),
      SKYDROP_STRUCT(PlacesViewSettings),
      SKYDROP_STRUCT(WaterDetailSettings),
      SKYDROP_STRUCT(DustAndSpraySettings),
      SKYDROP_STRUCT(GroundCoverSettings),
      SKYDROP_STRUCT(LightningSettings),
      SKYDROP_STRUCT(ElevationSettings),
      SKYDROP_STRUCT(GroundPictureSettings),
      SKYDROP_STRUCT(LiveSettings),
      SKYDROP_STRUCT(DeliverySettings),
      SKYDROP_STRUCT(AssistSettings),
  };
  std::set<std::string> tested;
  for (const auto& [name, expect] : structs) {
    tested.insert(name);
    expect(name.c_str());
  }
  EXPECT_EQ(describedStructs(), tested) << "a struct with a describe() that this test does not know";
}

// What the test above would miss if it could not fail.
struct Inner {
  double a = 1;
  bool b = false;
};
struct Forgetful {
  double named = 1;
  double forgotten = 2;
  std::array<Inner, 2> inner;
  Quality quality = Quality::low;
};
void describe(core::SettingsVisitor& visitor, Inner& inner) {
  visitor.number("a", inner.a, {"1", 0, 9, "A number."});
  visitor.flag("b", inner.b, {"A flag."});
}
void describe(core::SettingsVisitor& visitor, Forgetful& f) {
  visitor.number("named", f.named, {"1", 0, 9, "A number."});
  visitor.group("inner", f.inner, "Two of them.");
  visitor.choice("quality", f.quality, kQualityNames, {"A choice."});
  visitor.choice("again", f.quality, kQualityNames, {"The same choice."});
}

TEST(DescribedFields, aForgottenFieldAndOneThatIsNamedTwiceAreFound) {
  static_assert(test::fieldCount<Inner>() == 2);
  static_assert(test::fieldCount<Forgetful>() == 4);
  EXPECT_EQ(undescribedValues<Forgetful>(),
            (std::vector<std::string>{"value 2 is not described", "value 7 is described by quality again"}));
}

}  // namespace
}  // namespace skydrop::app
