// What weather, loudspeakers and the interface make of their rows; and the list of all.
#include "app/settings_probes.h"

#include <imgui.h>

#include <array>
#include <memory>
#include <string>

#include "app/input/player_input.h"
#include "app/session/flown_weather.h"
#include "app/session/forecast_in_force.h"
#include "app/session/photo_seen.h"
#include "app/session/run_config.h"
#include "app/settings_probe_parts.h"
#include "app/window/overlay.h"
#include "skydrop/audio/audio_manager.h"
#include "skydrop/audio/sound_scene.h"
#include "skydrop/core/image.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/weather/lightning.h"

namespace skydrop::app {
namespace {

using core::StateHasher;
using game::Controls;

// What flashes there are in some minutes of a storm, and how bright they are.
std::uint64_t flashesOfAStorm(const Settings& settings) {
  auto storm = std::make_shared<weather::WeatherSettings>();
  storm->sites[0].lightning = 30;
  storm->sites[0].layers[0].cover = 1;
  core::StateHasher hash;
  for (const weather::Flash& flash :
       weather::flashesBetween({storm, 1, 0}, settings.lightning, 0, 1800, {})) {
    hash.add(flash.toGround ? 1.0 : 0.0);
    hash.add(weather::brightnessAt(flash, settings.lightning, flash.seconds + 0.1));
  }
  return hash.value();
}

// The weather at some places and times.
std::uint64_t weatherStates(const Settings& settings) {
  StateHasher h;
  for (const double seconds : {0.0, 500.0, 1700.0, 4000.0}) {
    for (const double east : {-40000.0, 0.0, 3000.0, 15000.0, 60000.0}) {
      const weather::State s = weather::stateAt(settings.weather, 1, seconds, {east, -0.4 * east});
      for (const weather::Layer& l : s.layers) {
        h.add(static_cast<std::uint64_t>(l.genus));
        h.add(l.baseM), h.add(l.topM), h.add(l.cover), h.add(l.density);
      }
      for (const weather::WindLevel& l : s.wind.levels)
        h.add(l.heightM), h.add(l.speedMps), h.add(l.directionDeg);
      for (const double value :
           {s.wind.speedMps, s.wind.directionDeg, s.wind.gustMps, s.wind.roughnessM, s.wind.gradientHeightM,
            s.fog.extinction, s.fog.topM, s.precipitation.rain, s.precipitation.snow, s.precipitation.sleet,
            s.precipitation.hail, s.visibilityM, s.temperatureC, s.pressurePa, s.lightningPerMinute,
            s.turbulenceSeverity})
        h.add(value);
    }
  }
  return h.value();
}

// A week of hours, each warmer than the one before, as the clock of the settings runs through it.
std::uint64_t forecastStates(const Settings& settings) {
  std::vector<weather::TimedState> hours(169);
  for (std::size_t i = 0; i < hours.size(); ++i) {
    hours[i].utcMs = 1782000000000 + static_cast<std::int64_t>(i) * 3600000;
    hours[i].state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
    hours[i].state.temperatureC = -50 + 0.5 * static_cast<double>(i);
  }
  const weather::Forecast forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1};
  core::StateHasher h;
  for (const double seconds : {0.0, 10.0, 90.0}) {
    h.add(weather::stateAt(settings.weather, forecast, forecastClock(settings, forecast), 1, seconds, {0, 0})
              .temperatureC);
  }
  return h.value();
}

// A forecast of 20 degrees that takes over from the sites, or is not followed.
std::uint64_t handedOver(const Settings& settings) {
  std::vector<weather::TimedState> hours(1);
  hours[0].utcMs = 1782000000000;
  hours[0].state.temperatureC = 20;
  hours[0].state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
  const auto forecast = std::make_shared<const weather::Forecast>(
      weather::Forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1});
  ForecastInForce inForce(nullptr, {});
  inForce.set(settings.live.follow ? forecast : nullptr, {}, 0, settings.live.blendSeconds);
  core::StateHasher h;
  for (int i = 1; i < 64; ++i) {
    h.add(weather::stateAt(settings.weather, inForce.forecast().get(), {}, inForce.handover().get(), 1,
                           5.0 * i, {0, 0})
              .temperatureC);
  }
  return h.value();
}

// Two sites that differ, all layers with cover.
std::vector<std::string> twoSites() {
  std::vector<std::string> given = {"weather.secondSite=true", "weather.approachSeconds=3000",
                                    "weather.sites.1.windSpeed=12", "weather.sites.1.windDirection=300"};
  for (const char* site : {"0", "1"}) {
    for (const char* layer : {"0", "1", "2", "3"})
      given.push_back(std::string("weather.sites.") + site + ".layers." + layer + ".cover=0.4");
  }
  return given;
}
// A photograph over a picture.
std::uint64_t photographs(const Settings& settings) {
  core::Image dark(100, 2), light(100, 2);
  for (std::size_t i = 0; i < dark.rgba.size(); ++i) {
    dark.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 10);
    light.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 240);
  }
  core::StateHasher h;
  for (const std::uint8_t byte : together(dark, light, settings.view.photo, settings.view.photoShare).rgba)
    h.add(static_cast<std::uint64_t>(byte));
  return h.value();
}
std::uint64_t sound(const Settings& settings) {
  audio::AudioManager audio(settings.audio, audio::AudioManager::Output::loopback);
  audio::SoundScene scene(audio, settings.audio);
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.throttle = 0.7;
  now.aircraft.airspeedMps = 70;
  auto storm = std::make_shared<weather::WeatherSettings>();
  storm->sites[0].rain = 10;
  storm->sites[0].layers[0].cover = 1;
  now.weather = {.settings = storm};
  game::GameEvent drop;
  drop.kind = game::GameEventKind::drop;
  scene.update(now, std::array{drop}, {}, {.birds = 1, .water = 1});
  std::vector<float> samples(4410);
  audio.render(samples);
  StateHasher h;
  for (const float sample : samples) h.add(static_cast<double>(sample));
  return h.value();
}

std::uint64_t interface(const Settings& settings) {
  constexpr Size kSize{1920, 1080};
  scene::EffectSet effects;
  effects.insert(scene::Effect::hud);
  Overlay overlay(effects, kSize, {}, {settings.view.interfaceScale});
  overlay.hudShown = settings.view.hud;
  Settings copy = settings;
  const core::SettingsTable table(copy);
  game::Snapshot now;
  now.aircraft.present = true;
  OverlayFrame frame{now, kSize, 0, table};
  frame.scale = {settings.view.interfaceScale};
  overlay.build(frame);
  StateHasher h;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int list = 0; list < data.CmdListsCount; ++list) {
    for (const ImDrawVert& vertex : data.CmdLists[list]->VtxBuffer)
      h.add(static_cast<double>(vertex.pos.x)), h.add(static_cast<double>(vertex.pos.y));
  }
  return h.value();
}

// Dials and marks, from behind the aircraft and from its seat, with a target behind.
std::uint64_t dialsAndMarks(const Settings& settings) {
  constexpr Size kSize{1280, 720};
  scene::EffectSet effects;
  effects.insert(scene::Effect::hud);
  StateHasher h;
  for (const render::CameraMode camera : {render::CameraMode::chase, render::CameraMode::cockpit}) {
    Settings copy = settings;
    copy.view.camera = camera;
    const core::SettingsTable table(copy);
    Overlay overlay(effects, kSize, {});
    game::Snapshot now;
    now.aircraft.present = now.target.present = true;
    now.target.position = {100, 0, 5000};
    OverlayFrame frame{now, kSize, 0, table};
    frame.instruments = showsInstruments(copy.view);
    if (copy.view.marks) frame.eye = ui::Eye{{0, 100, 0}, glm::dmat3(1), 1, 1280, 720};
    overlay.build(frame);
    const ImDrawData& data = *ImGui::GetDrawData();
    h.add(static_cast<double>(data.TotalVtxCount));
  }
  return h.value();
}

// The levers after sticks and triggers were pushed a little further each time.
std::uint64_t sticks(const Settings& settings) {
  StateHasher h;
  PlayerInput input;
  for (int i = 0; i <= 40; ++i) {
    GamepadState state;
    const float push = -1 + 0.05f * static_cast<float>(i);
    state.axes = {push, -0.7f * push, 0.6f * push, 0.3f, push, 0.5f * push};
    input.handle(readingOf(state, settings.input.gamepad), settings.input.gamepad);
    const Controls c = input.step();
    for (const double lever : {c.thrust, c.brake, c.pitch, c.roll, c.yaw}) h.add(lever);
  }
  return h.value();
}

// From where a turning, stalled aircraft is seen close above land, by each camera; which one, by the row's
// own camera.
render::View seenBy(render::CameraMode mode, const Settings& settings) {
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.position = {0, 6, 0};
  now.aircraft.orientation = glm::dquat(glm::dvec3(0.2, 0.4, 0.6));
  now.aircraft.trailingOrientation = glm::dquat(glm::dvec3(0.1, 0.1, 0.2));
  now.aircraft.buffet = 0.7;
  now.simulatedSeconds = 1.23;
  render::Camera camera;
  camera.setMode(mode);
  static const auto flat = terrain::makeFlatSource(2);
  return camera.view(now, settings.render.camera, 640, 360, flat.get());
}

std::uint64_t cameras(const Settings& settings) {
  StateHasher h;
  for (const auto mode : {settings.view.camera, render::CameraMode::chase, render::CameraMode::cockpit}) {
    const render::View view = seenBy(mode, settings);
    add(h, view.position), add(h, view.forward()), add(h, view.up());
    h.add(view.fovYRad), h.add(view.nearM);
  }
  return h.value();
}

// All rows but these two, as `render` would have them.
std::uint64_t preparedRows(const Settings& settings) {
  CommandLine line;
  line.verb = Verb::render;
  line.set = {
      "quality=" + std::string(kQualityNames[static_cast<std::size_t>(settings.quality)]),
      "clouds.tier=" + std::string(clouds::kCloudTierNames[static_cast<std::size_t>(settings.clouds.tier)])};
  if (settings.quality != Quality::automatic) line.set.pop_back();
  StateHasher h;
  const auto run = prepareRun(line);
  for (const core::Field& field : run->table.fields())
    if (field.path != "quality" && field.path != "clouds.tier") h.add(field.get());
  return h.value();
}
}  // namespace

const std::vector<Probe>& settingsProbes() {
  static const std::vector<Probe> kProbes = [] {
    std::vector<Probe> all = {
        {"weather.", weatherStates, twoSites()},
        {"weatherFile.followsSky", forecastStates, {"sky.sun=clock"}},
        {"weatherFile.", forecastStates, {"weatherFile.followsSky=false"}},
        {"live.follow", handedOver},
        {"live.blendSeconds", handedOver},
        {"lightning.", flashesOfAStorm},
        {"view.photo", photographs},
        {"audio.", sound},
        {"view.hud", interface},
        {"view.instruments", dialsAndMarks},
        {"view.marks", dialsAndMarks},
        {"view.interfaceScale", interface},
        {"input.", sticks},
        {"render.camera.", cameras},
        {"view.camera", cameras},
        {"quality", preparedRows},
        {"clouds.tier", preparedRows},
    };
    for (const std::vector<Probe>& part : {flightProbes(), landProbes()})
      all.insert(all.begin(), part.begin(), part.end());
    return all;
  }();
  return kProbes;
}

}  // namespace skydrop::app
