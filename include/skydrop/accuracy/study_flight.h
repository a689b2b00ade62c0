// A short straight or circling flight of a camera, for studies of what depends on the frames before. Values.
#pragma once

#include <array>

namespace skydrop::accuracy {

struct StudyFlight {
  double speedMps = 70;    // [0, 1000]
  double bankDegrees = 0;  // of a level turn to the right, [-80, 80]; 0: straight on
  int frames = 24;         // drawn one after the other, 60 a second, before the one that is judged; [1, 600]
};

inline constexpr double kFlightFramesPerSecond = 60;

// Where the camera of a study (StudyCase::pose) is after so many frames: it keeps its height and its pitch,
// turns at the rate of its bank, and its roll is the bank's. Frame 0 is the pose, rolled.
std::array<double, 6> flownPose(const std::array<double, 6>& pose, const StudyFlight& flight, int frame);

}  // namespace skydrop::accuracy
