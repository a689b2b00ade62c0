#include "app/session/start_camera.h"

#include <algorithm>
#include <cstdio>
#include <glm/trigonometric.hpp>

#include "skydrop/game/contact.h"

namespace skydrop::app {

void placeCamera(render::Camera& camera, const Pose& pose, const terrain::HeightSource& ground) {
  glm::dvec3 position = pose.position;
  if (pose.aboveGround) position.y += game::surfaceAt(ground, {position.x, position.z}).height;
  position.y = std::min(position.y, render::kHighestCameraM);
  camera.setMode(render::CameraMode::free);
  camera.setPose(position, glm::radians(pose.yawDegrees), glm::radians(pose.pitchDegrees),
                 glm::radians(pose.rollDegrees));
}

std::optional<std::string> underSurface(const render::Camera& camera, const terrain::HeightSource& ground) {
  const glm::dvec3& place = camera.position();
  const game::Surface surface = game::surfaceAt(ground, {place.x, place.z});
  if (place.y >= surface.height) return std::nullopt;
  char line[160];
  std::snprintf(line, sizeof line, "the camera is %.1f m under the %s, whose surface is at %.1f m there",
                surface.height - place.y, surface.water ? "sea" : "land", surface.height);
  return line;
}

}  // namespace skydrop::app
