// Every setting of the program: the modules' structs, composed. Precedence, later wins: defaults, the tier of
// the clouds, the quality's preset, scene, the player's file (fly only, or where --user-dir is given), the
// log of a replay (what decides the simulation), --preset, --set, menu.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/input/gamepad.h"
#include "app/settings/effect_switches.h"
#include "app/settings/mood.h"
#include "app/settings/split_settings.h"
#include "app/types/photo_request.h"
#include "skydrop/audio/audio_settings.h"
#include "skydrop/clouds/cloud_dome_settings.h"
#include "skydrop/clouds/cloud_planes_settings.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/clouds/ice_clouds.h"
#include "skydrop/core/settings.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/wind.h"
#include "skydrop/elevation/elevation_settings.h"
#include "skydrop/flight/airplane_settings.h"
#include "skydrop/flight/gear_settings.h"
#include "skydrop/flight/package_settings.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/delivery.h"
#include "skydrop/game/flight_assist.h"
#include "skydrop/game/game_settings.h"
#include "skydrop/game/input_log.h"
#include "skydrop/render/fog/ground_fog_settings.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/ground_cover/ground_cover_settings.h"
#include "skydrop/render/models/aircraft_lights_settings.h"
#include "skydrop/render/places/places_settings.h"
#include "skydrop/render/precipitation/precipitation_settings.h"
#include "skydrop/render/shadows/land_shadow_settings.h"
#include "skydrop/render/shafts/light_shaft_settings.h"
#include "skydrop/render/sky/halo_settings.h"
#include "skydrop/render/sky/rainbow_settings.h"
#include "skydrop/render/sky/stars_settings.h"
#include "skydrop/render/spray/dust_and_spray_settings.h"
#include "skydrop/render/vegetation/vegetation_settings.h"
#include "skydrop/render/water/water_detail_settings.h"
#include "skydrop/scene/scene.h"
#include "skydrop/terrain/ground_picture.h"
#include "skydrop/terrain/ground_relief.h"
#include "skydrop/terrain/places_settings.h"
#include "skydrop/terrain/strips.h"
#include "skydrop/terrain/terrain_settings.h"
#include "skydrop/terrain/terrain_streaming_settings.h"
#include "skydrop/terrain/woods.h"
#include "skydrop/weather/forecast.h"
#include "skydrop/weather/handover.h"
#include "skydrop/weather/lightning_settings.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::app {

// How a package in the air is shown: not, small at the upper right, or by a camera that goes down with it.
enum class DropView { none, picture, ride };
inline constexpr std::array<std::string_view, 3> kDropViewNames = {"none", "picture", "ride"};

// When the dials of the cockpit are shown.
enum class InstrumentsShown { never, cockpit, always };
inline constexpr std::array<std::string_view, 3> kInstrumentsShownNames = {"never", "cockpit", "always"};

// How the player looks at the game.
struct ViewSettings {
  render::CameraMode camera = render::CameraMode::chase;
  bool hud = true;
  DropView dropView = DropView::picture;  // in a window
  InstrumentsShown instruments = InstrumentsShown::cockpit;
  bool marks = true;         // on places of the world: landings, the way to the target
  bool briefing = true;      // before a player's first flight in a window
  bool lesson = false;       // three steps with words, in a window
  bool freezeTime = false;   // of this run alone: not kept
  double frameCapHz = 0;     // 0: none
  double frameBudgetMs = 0;  // that frames may take; 0: none
  bool vsync = true;
  double interfaceScale = 1;
  bool eyeAdaptation = true;             // in frames that follow each other
  bool weatherBar = false;               // where there is weather data
  PhotoView photo = PhotoView::overlay;  // how it is shown, in flights with a photograph
  double photoShare = 0.5;               // its opacity, or how much of the width it has, [0, 1]
  SplitSettings split;
};

// Whether the dials are shown, by the camera that is chosen.
inline bool showsInstruments(const ViewSettings& view) {
  return view.instruments == InstrumentsShown::always ||
         (view.instruments == InstrumentsShown::cockpit && view.camera == render::CameraMode::cockpit);
}

// How good the picture is and what it may cost: a file of settings (quality_preset.h). Automatic: by the
// machine.
enum class Quality { automatic, low, medium, high, ultra };
inline constexpr std::array<std::string_view, 5> kQualityNames = {"automatic", "low", "medium", "high",
                                                                  "ultra"};

struct Settings {
  EffectSwitches effects;
  flight::AirplaneSettings aircraft;
  flight::PackageSettings package;
  game::GameSettings game;
  game::DeliverySettings delivery;
  game::AssistSettings assist;
  game::AutopilotSettings autopilot;
  terrain::TerrainSettings terrain;
  terrain::StripSettings strips;
  terrain::WoodsSettings woods;
  render::VegetationSettings vegetation;
  terrain::PlacesSettings villages;
  render::PlacesViewSettings places;
  terrain::GroundDetailSettings groundDetail;
  render::WaterDetailSettings waterDetail;
  render::DustAndSpraySettings dustAndSpray;
  render::GroundCoverSettings groundCover;
  flight::GearSettings gear;
  elevation::ElevationSettings elevation;      // of elevation files, where there are some
  terrain::GroundPictureSettings aerialImage;  // of aerial images, where there are some
  terrain::TerrainStreamingSettings streaming;
  render::RenderSettings render;
  clouds::CloudSettings clouds;
  clouds::CloudPlanesSettings cloudPlanes;
  clouds::CloudDomeSettings cloudDome;
  render::GroundFogSettings groundFog;
  render::StarsSettings stars;
  render::LandShadowSettings landShadows;
  render::HaloSettings halo;
  render::RainbowSettings rainbow;
  render::LightShaftSettings lightShafts;
  render::AircraftLightsSettings aircraftLights;
  render::LandingLightSettings landingLight;
  clouds::IceCloudSettings iceClouds;
  render::PrecipitationSettings precipitation;
  MoodSettings sky;
  core::WindSettings wind;
  weather::WeatherSettings weather;
  weather::ForecastClock weatherFile;  // how time runs through the forecast of a file
  weather::LiveSettings live;          // whether it is followed, and how a newer one comes
  weather::LightningSettings lightning;
  audio::AudioSettings audio;
  ViewSettings view;
  InputSettings input;
  Quality quality = Quality::automatic;
};

void describe(core::SettingsVisitor& visitor, ViewSettings& settings);
void describe(core::SettingsVisitor& visitor, Settings& settings);

// Applies the scene's effects and its overrides. Throws core::DataError.
void applyScene(const core::SettingsTable& table, const scene::Scene& scene);

// Applies --set in order. Throws core::UsageError.
void applyOverrides(const core::SettingsTable& table, const std::vector<std::string>& assignments);

// The settings that an input log keeps, all of them, as it does (isRecorded()); and back (a value that is
// refused is a core::DataError that names `file`).
std::vector<game::SettingOverride> simulationSettings(const core::SettingsTable& table);
void applyLogged(const core::SettingsTable& table, const std::vector<game::SettingOverride>& settings,
                 std::string_view file);

// Whether the player's file keeps the field at this path.
bool isKept(std::string_view path);

// Whether the field at this path switches an effect that the simulation is made of.
bool switchesSimulation(std::string_view path);

// Whether a change of the field at this path changes the simulation.
bool decidesSimulation(std::string_view path);

// Whether an input log keeps the field at this path and its changes: what decides the simulation, and what
// the pilot does that is a picture only (the landing light).
bool isRecorded(std::string_view path);

}  // namespace skydrop::app
