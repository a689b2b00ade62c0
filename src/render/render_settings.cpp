#include "skydrop/render/render_settings.h"

#include <array>
#include <string_view>

namespace skydrop::render {

void describe(core::SettingsVisitor& visitor, CameraSettings& s) {
  visitor.number("fovDegrees", s.fovDegrees,
                 {"deg", 20, 120, "Vertical field of view; more shows more, smaller."});
  visitor.number("nearM", s.nearM, {"m", 0.02, 5, "Near plane; what is nearer to the eye is cut away."});
  visitor.number("chaseDistance", s.chaseDistance,
                 {"m", 4, 60, "How far behind the aircraft the chase camera flies."});
  visitor.number("chaseHeight", s.chaseHeight,
                 {"m", 0, 20, "How far above the aircraft the chase camera flies."});
  visitor.number("chaseSoftness", s.chaseSoftness,
                 {"1", 0, 1, "How far the chase camera hangs back in turns; 0 is bolted to the aircraft."});
  visitor.number("groundClearance", s.groundClearance,
                 {"m", 0.5, 50, "The chase camera stays this far above land and sea."});
  visitor.number("buffetDegrees", s.buffetDegrees,
                 {"deg", 0, 2, "How much a stall shakes the picture; 0 keeps it still."});
  visitor.number("cockpitForward", s.cockpitForward,
                 {"m", -2, 5, "The pilot's eye ahead of the aircraft's centre."});
  visitor.number("cockpitHeight", s.cockpitHeight,
                 {"m", -1, 3, "The pilot's eye above the aircraft's centre."});
}

void describe(core::SettingsVisitor& visitor, SunSettings& s) {
  visitor.number("elevationDegrees", s.elevationDegrees,
                 {"deg", -30, 90, "Height of the sun above the horizon; below 0 it has set."});
  visitor.number("azimuthDegrees", s.azimuthDegrees,
                 {"deg", 0, 360, "Compass direction of the sun: 90 is east, 180 south."});
}

void describe(core::SettingsVisitor& visitor, AtmosphereSettings& s) {
  visitor.number(
      "visibilityM", s.visibilityM,
      {"m", 1000, 250000, "Distance at which a dark hill is just seen against the sky; less is hazier.",
       core::TakesEffect::live, true});
  visitor.number("hazeHeightM", s.hazeHeightM,
                 {"m", 100, 4000, "Height over which the haze thins to 37 %; more reaches higher."});
  visitor.number(
      "hazeAnisotropy", s.hazeAnisotropy,
      {"1", 0, 0.95, "How strongly haze scatters forward; more makes a brighter glow around the sun."});
}

void describe(core::SettingsVisitor& visitor, RenderSettings& s) {
  visitor.group("camera", s.camera, "Where the frame is seen from.");
  visitor.group("sun", s.sun, "Where the sun stands.");
  visitor.group("atmosphere", s.atmosphere, "Air and haze between the eye and the land.");
  visitor.enterGroup("picture", "From light to the screen.");
  visitor.number("exposureStops", s.exposureStops,
                 {"EV", -6, 6, "Brightness on top of the automatic exposure; each step doubles it."});
  visitor.flag("smoothModels", s.smoothModels,
               {"Draws the edges of aircraft and packages with four samples a pixel; off, they are jagged."});
  visitor.leaveGroup();
  visitor.enterGroup("land", "The land's surface, and ways to look at its mesh.");
  static constexpr std::array<std::string_view, 2> kDetails = {"plain", "rich"};
  visitor.choice(
      "detail", s.landDetail, kDetails,
      {"Rich land has single trees, layers of rock and rough ground, and takes half again the time of plain.",
       core::TakesEffect::variant});
  visitor.flag("wireframe", s.wireframe, {"Draws the land as lines."});
  visitor.flag("terrainNormals", s.terrainNormals,
               {"Draws a stroke along the normal of each vertex of the land."});
  visitor.leaveGroup();
}

}  // namespace skydrop::render
