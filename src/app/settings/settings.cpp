#include "app/settings/settings.h"

#include <algorithm>
#include <array>

#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::app {
namespace {

constexpr std::array<std::string_view, 15> kSimulationGroups =
    {"aircraft.",  "package.", "delivery.", "game.",        "terrain.",
     "elevation.", "wind.",    "weather.",  "weatherFile.", "live.",
     "gear.",      "strips.",  "woods.",    "villages.",    "clouds.layers."};  // of a weather's low
                                                                                // layer

// Effects that are more than pictures and sounds.
constexpr std::array<std::string_view, 7> kSimulatedEffects = {
    "effects.aircraft",       "effects.targets",    "effects.terrain", "effects.weather",
    "effects.groundHandling", "effects.vegetation", "effects.places"};

constexpr std::array<std::string_view, 3> kCameraNames = {"chase", "cockpit", "free"};

}  // namespace

void describe(core::SettingsVisitor& visitor, ViewSettings& settings) {
  visitor.choice(
      "camera", settings.camera, kCameraNames,
      {.help = "From where the game is seen: behind the aircraft, from its seat, or from anywhere.",
       .aliases = "third person, first person, follow"});
  visitor.flag("hud", settings.hud,
               {.help = "Shows instruments, navigation bar and messages over the picture.",
                .aliases = "overlay, interface, UI"});
  visitor.choice("dropView", settings.dropView, kDropViewNames,
                 {.help = "How a package in the air is shown: not, in a small picture, or by a camera that "
                          "rides along until it has landed. Windows alone.",
                  .aliases = "picture in picture, PIP, package camera, follow"});
  visitor.choice("instruments", settings.instruments, kInstrumentsShownNames,
                 {.help = "When the dials are shown: airspeed, attitude, height, compass, climb, engine.",
                  .aliases = "gauges, dials, cockpit, horizon, altimeter, variometer"});
  visitor.flag("marks", settings.marks,
               {.help = "Marks where packages land, and points to a target out of view.",
                .aliases = "aim, arrow, landing point, CCIP"});
  visitor.flag("briefing", settings.briefing,
               {.help = "Tells before a player's first flight what there is to do. Windows alone.",
                .aliases = "tutorial, introduction, first start"});
  visitor.flag("lesson", settings.lesson,
               {.help = "Three steps with words: turn, climb or sink, deliver. Windows alone; the scene "
                        "'lesson' has it on.",
                .aliases = "tutorial, training, school"});
  visitor.flag("freezeTime", settings.freezeTime,
               {.help = "Holds simulated time; the camera is free to look around. Off at every start.",
                .aliases = "pause, photo mode, stop"});
  visitor.number("frameCapHz", settings.frameCapHz,
                 {.unit = "Hz",
                  .min = 0,
                  .max = 1000,
                  .help = "Most frames a second, evenly spaced; 0 for as many as there can be.",
                  .aliases = "FPS, frame rate limit"});
  visitor.number(
      "frameBudgetMs", settings.frameBudgetMs,
      {.unit = "ms",
       .min = 0,
       .max = 1000,
       .help = "Chooses how exactly clouds are drawn, and in how many pixels, so that a frame takes "
               "no longer; 0 leaves that to their own rows.",
       .takesEffect = core::TakesEffect::rebuild,  // of the ladder, once the slider is released
       .slider = core::Range{0, 100},
       .aliases = "FPS, frame rate, budget, dynamic resolution, automatic"});
  visitor.flag("vsync", settings.vsync,
               {.help = "Waits for the screen with each frame: no tearing, a little more delay.",
                .aliases = "vertical sync, tearing, FPS"});
  visitor.number("interfaceScale", settings.interfaceScale,
                 {.unit = "1",
                  .min = 0.5,
                  .max = 3,
                  .help = "Size of texts and menus; never so large that they would not fit.",
                  .slider = core::Range{0.5, 2.2},
                  .aliases = "UI scale, font size, text size"});
  visitor.flag("eyeAdaptation", settings.eyeAdaptation,
               {.help = "Eyes need a moment to get used to light, and some to darkness. Pictures without a "
                        "window show what they are used to in the end.",
                .aliases = "HDR, pupil, iris, adaptation, brightness"});
  visitor.flag("weatherBar", settings.weatherBar,
               {.help = "The bar of the forecast at the bottom, in flights with weather data.",
                .aliases = "forecast, time slider, live, play"});
  visitor.choice(
      "photo", settings.photo, kPhotoViewNames,
      {.help = "How a photograph (--photo) is laid over the picture: not, with an opacity, up to a "
               "share of the width, or its middle in the left half beside that of the picture.",
       .aliases = "photograph, overlay, wipe, side by side, compare"});
  visitor.number("photoShare", settings.photoShare,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "The opacity of a photograph that is laid over, or the share of the width that a "
                          "wiped one has from the left.",
                  .aliases = "opacity, wipe"});
  visitor.group("split", settings.split, "The picture beside a reference.");
}

void describe(core::SettingsVisitor& visitor, Settings& settings) {
  visitor.group("aircraft", settings.aircraft, "How the aircraft answers the controls.");
  visitor.group("package", settings.package, "The package and its parachute.");
  visitor.group("game", settings.game, "Targets, drops and score.");
  visitor.group("delivery", settings.delivery, "What a delivery earns, and where a flight begins.");
  visitor.group("assist", settings.assist, "What helps the pilot.");
  visitor.group("autopilot", settings.autopilot, "How the autopilot flies.");
  visitor.group("terrain", settings.terrain, "The shape of the land.");
  visitor.group("strips", settings.strips, "Grass strips in the land: places to land.");
  visitor.group("woods", settings.woods, "The trees of the land.");
  visitor.group("vegetation", settings.vegetation, "How trees are drawn.");
  visitor.group("villages", settings.villages, "Villages, fields and roads of the land.");
  visitor.group("places", settings.places, "How villages are drawn.");
  visitor.group("groundDetail", settings.groundDetail, "What the ground looks like close by.");
  visitor.group("waterDetail", settings.waterDetail, "How water close by is drawn.");
  visitor.group("dustAndSpray", settings.dustAndSpray,
                "What flies up where something touches land or water.");
  visitor.group("groundCover", settings.groundCover, "Grass, flowers, reeds and stones near by.");
  visitor.group("gear", settings.gear, "The landing gear: what it bears, and what it stands.");
  visitor.group("elevation", settings.elevation, "Where elevation data lie, and how they end.");
  visitor.group("aerialImage", settings.aerialImage, "How the land wears aerial images.");
  visitor.group("streaming", settings.streaming,
                "How fine and how far the land is drawn, and what it may cost.");
  visitor.group("render", settings.render, "Sun, air, cameras and exposure.");
  visitor.group("clouds", settings.clouds, "The cloud layers, and how exactly they are drawn.");
  visitor.group("cloudPlanes", settings.cloudPlanes, "Clouds as flat layers that follow the eye.");
  visitor.group("cloudDome", settings.cloudDome, "Clouds on a dome behind everything.");
  visitor.group("groundFog", settings.groundFog, "Fog that lies on the ground.");
  visitor.group("stars", settings.stars, "The stars of the night.");
  visitor.group("landShadows", settings.landShadows, "Shadows that mountains cast.");
  visitor.group("halo", settings.halo, "The ice of halos and sun dogs.");
  visitor.group("rainbow", settings.rainbow, "The rain of rainbows.");
  visitor.group("lightShafts", settings.lightShafts, "Shade in the air.");
  visitor.group("aircraftLights", settings.aircraftLights, "Lamps on the aircraft.");
  visitor.group("landingLight", settings.landingLight, "The lamp that lights the land ahead.");
  visitor.group("iceClouds", settings.iceClouds, "High clouds of ice, made by hand where no weather is.");
  visitor.group("precipitation", settings.precipitation, "How rain and snow are drawn.");
  visitor.group("sky", settings.sky, "The sky as a whole.");
  visitor.group("wind", settings.wind, "The wind of clouds and flight.");
  visitor.group("weather", settings.weather, "The air that one flies in.");
  visitor.group("weatherFile", settings.weatherFile, "How time runs through the forecast of a file.");
  visitor.group("live", settings.live, "Whether the weather follows a forecast, and how a newer one comes.");
  visitor.group("lightning", settings.lightning, "The flashes of the weather.");
  visitor.group("audio", settings.audio, "What is heard.");
  visitor.group("effects", settings.effects, "What is simulated, drawn and heard in this flight.");
  visitor.group("view", settings.view, "How the game is looked at.");
  visitor.group("input", settings.input, "How the game is steered.");
  visitor.choice(
      "quality", settings.quality, kQualityNames,
      {.help = "Sets the rows that cost most. Automatic: low where the processor has to draw, else "
               "high.",
       .aliases = "graphics preset, performance"});
  visitor.renamed("clouds.windSpeed", "wind.speed");
  visitor.renamed("clouds.windDirection", "wind.direction");
  // The short names of the sky's model and of the clock that moves the sun.
  visitor.renamed("sky.model", "render.sky.model");
  visitor.renamed("sky.sun", "render.sun.source");
  visitor.renamed("sky.utc", "render.sun.utc");
  visitor.renamed("sky.shiftDays", "render.sun.shiftDays");
  visitor.renamed("sky.shiftHours", "render.sun.shiftHours");
  visitor.renamed("sky.timeScale", "render.sun.timeScale");
  visitor.renamed("sky.offsetSeconds", "render.sun.offsetSeconds");
  visitor.renamed("sky.latitude", "render.sun.latitudeDegrees");
  visitor.renamed("sky.longitude", "render.sun.longitudeDegrees");
}

void applyScene(const core::SettingsTable& table, const scene::Scene& scene) {
  const std::string file = scene.file.string();
  const scene::EffectSet effects = scene::requiredEffects(scene);
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) {
    table.at("effects." + std::string(scene::kEffectNames[i]))
        .set(effects.contains(static_cast<scene::Effect>(i)) ? 1 : 0);
  }
  core::applyJson(table, core::parseJson(scene.settingsJson, file), file);
}

void applyOverrides(const core::SettingsTable& table, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    try {
      core::setField(table, assignment);
    } catch (const core::RangeError& error) {
      throw core::UsageError(std::string("--set: ") + error.what());
    }
  }
}

bool isKept(std::string_view path) {
  return path != "view.freezeTime" && path != "live.follow" && path != "weatherFile.hour" &&
         path != "landingLight.on" && path != "render.sun.offsetSeconds" &&
         path != "delivery.startFacesTarget" && !path.starts_with("effects.");
}

bool switchesSimulation(std::string_view path) {
  return std::ranges::find(kSimulatedEffects, path) != kSimulatedEffects.end();
}

bool decidesSimulation(std::string_view path) {
  return switchesSimulation(path) ||
         std::any_of(kSimulationGroups.begin(), kSimulationGroups.end(),
                     [&](std::string_view group) { return path.starts_with(group); });
}

bool isRecorded(std::string_view path) { return decidesSimulation(path) || path == "landingLight.on"; }

std::vector<game::SettingOverride> simulationSettings(const core::SettingsTable& table) {
  std::vector<game::SettingOverride> settings;
  for (const core::Field& field : table.fields()) {
    if (isRecorded(field.path)) settings.push_back({field.path, core::fieldText(field)});
  }
  return settings;
}

void applyLogged(const core::SettingsTable& table, const std::vector<game::SettingOverride>& settings,
                 std::string_view file) {
  for (const game::SettingOverride& setting : settings) {
    try {
      const core::Field& field = table.at(setting.path);
      if (!isRecorded(field.path)) throw core::RangeError(setting.path + ": is no setting of the simulation");
      core::setField(field, setting.value);
    } catch (const core::RangeError& error) {
      throw core::DataError(file, "settings", error.what());
    }
  }
  EffectSwitches switches;
  for (std::size_t i = 0; i < switches.on.size(); ++i)
    switches.on[i] = table.at("effects." + std::string(scene::kEffectNames[i])).get() != 0;
  if (const std::string missing = scene::unmetNeed(switches.set()); !missing.empty())
    throw core::DataError(file, "settings", "effects: " + missing);
}

}  // namespace skydrop::app
