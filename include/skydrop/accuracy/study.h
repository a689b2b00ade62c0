// A study as data: which settings are turned, against which reference, how the error is measured and what is
// timed. docs/accuracy-studies.md describes the file. A value; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/study_flight.h"

namespace skydrop::accuracy {

inline constexpr int kStudySchema = 1;
inline constexpr std::size_t kMostStudyBytes = std::size_t{1} << 18, kMostPoints = 256, kMostCases = 64;

// "path=value" in order; a later one of the same path replaces an earlier one.
using Assignments = std::vector<std::string>;

// One place, or one run, at which all points are measured: a view of a scene, a motion.
struct StudyCase {
  std::string name;   // "from below"; unique in the study
  std::string scene;  // of subjects that have one
  // Free camera: x, y, z (m), yaw, pitch, roll (degrees); yaw 0 looks along +x. None: the scene's camera.
  std::optional<std::array<double, 6>> pose;
  // The camera flies on from the pose, and what is judged and timed is the last of the frames, each of which
  // may use what the one before it left. Only with a pose, of the subject picture.
  std::optional<StudyFlight> flight;
  double seconds = 0;  // simulated before, [0, 3600]
  Assignments set;     // on top of the study's
};

struct StudyPoint {
  std::string label;   // unique in the study
  Assignments set;     // what is turned
  std::string series;  // the values of all axes but that of the order
  // The value of that axis; its inverse where the reference's value is larger than all (a rate, a number of
  // steps): errors fall with it.
  std::optional<double> step;
};

// A combination that the program ships ("medium"): marked in tables and plots where a point sets the same.
struct ShippedPoint {
  std::string name;
  Assignments set;
};

struct ChosenMetric {
  std::string name;  // of metrics()
  // Errors up to it count as rounding: they neither need nor get a reference that is better.
  double floor = 0;
};

struct Study {
  std::string name;                   // the file's, without folder and ending
  std::string file;                   // named in errors
  std::string text;                   // the file's content
  std::string title, method;          // what is measured, against what; plain text
  std::string subject;                // what is measured: subject.h
  Assignments set;                    // under all points and the reference
  std::vector<StudyCase> cases;       // at least one
  std::vector<StudyPoint> points;     // at least one
  Assignments reference;              // what the reference sets instead of a point
  Assignments check;                  // what the doubled reference sets on top; never empty
  std::vector<ChosenMetric> metrics;  // at least one; fronts are those of the first unless told
  std::string timed;                  // "frame", "pass NAME" (NAME+NAME: their sum) or "cpu"
  std::string timeUnit;               // "ms a frame"
  std::string order;                  // the path whose values are steps; may be empty
  std::vector<ShippedPoint> shipped;
};

// Throws core::DataError with file, place and reason. Paths and values are judged by the subject.
Study parseStudy(std::string_view text, std::string_view file);

// A built-in study by its name (assets/studies/NAME.json), or any file: a word with a slash or that ends in
// .json. Throws core::UsageError for a name that there is not, core::DataError.
Study loadStudy(const std::string& nameOrFile);
std::vector<std::string> listStudies();  // the built-in ones, by name

// The last value of each path, in the order of the last appearances.
Assignments merged(const Assignments& below, const Assignments& above);

}  // namespace skydrop::accuracy
