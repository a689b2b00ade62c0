// Eyes that get used to the light in view: slowly to darkness, fast to brightness, in simulated time.
#pragma once

#include <optional>

#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {

// The light in a view, as SkyLight::level (klx): that level for a view along the horizon without the sun in
// it. Views of the sky or of the land alone have the light of these; a sun within 40 degrees of the view's
// axis adds to it, as its glare does. Within a factor of 4 of the level; finite and above 0 for any light.
// Knows neither clouds nor mountains before the sun.
double levelInView(const SkyLight& light, const View& view);

// What the eye is adapted to. The logarithm of the level follows that of the light in view exponentially,
// with one time constant to darkness and another to brightness: exact for any step while the light is the
// same, so frame rates differ by no more than the light changes within a frame. It never overshoots.
//
// The time constants are those of a game, not of retinas, whose rods take half an hour: pupils close within
// half a second and open within some (Ellis 1981), and of the rest exposure leaves a share anyway
// (SkyLight::adaptation).
class EyeAdaptation {
 public:
  static constexpr double kToBrightnessS = 0.4, kToDarknessS = 3;  // simulated seconds
  // Without a frame for so long, or back in time, the eye is another one.
  static constexpr double kLongestStepS = 1;

  // What the next frame is exposed for; nullopt: for its own light, as after a cut.
  std::optional<double> level() const { return level_; }
  // The next frame shows something else: another camera, another time.
  void cut() { level_.reset(); }
  // After a frame: the light in its view (any number: what is not above 0 is no light to follow) and its
  // simulated time. speed: how fast the clock of the sky runs; eyes in a time lapse keep up with it.
  void follow(double lightInView, double simulatedSeconds, double speed = 1);

 private:
  std::optional<double> level_;
  double seconds_ = 0;  // of the last frame
};

}  // namespace skydrop::render
