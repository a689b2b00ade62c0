// What a run of the device check found, as JSON and as Markdown. Written again after each part: a run that is
// cut off leaves what it had.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace skydrop::device {

// A suite of tests that ran as a program of its own.
struct Suite {
  std::string name;
  int tests = 0, failed = 0, skipped = 0;
  std::vector<std::string> failures = {};  // names
  std::string error = {};                  // why it came to no result; empty: it did
  double seconds = 0;
};

// Passes of a scene at a size. Times in ms, by `clock`.
struct Passes {
  std::string scene, variant;  // the variant is what was set beside the scene
  int width = 0, height = 0, frames = 0;
  std::string clock = {};
  double frameMs = 0, frameP99Ms = 0;     // of whole frames, by the wall clock
  std::map<std::string, double> ms = {};  // medians
  double gpuMiB = 0;
  std::string error = {};  // why it was not measured
};

// A figure that was promised for such a machine.
struct Promise {
  std::string text;
  double limit = 0, measured = 0;
  bool isKept() const { return measured <= limit; }
};

struct Report {
  std::string version, vendor, renderer, openGl, processor;
  bool isSoftware = false;
  std::vector<Suite> suites;
  std::vector<Passes> passes;
  std::vector<Promise> promises;
  std::string accuracy;              // path of the report of the studies, beside this one; empty: none
  std::vector<std::string> leftOut;  // parts for which no time was left
  double seconds = 0;

  // Whether nothing failed; promises do not count.
  bool isGood() const;
};

std::string jsonOf(const Report& report);
std::string markdownOf(const Report& report);

// device.json and device.md in the folder. Throws core::DataError.
void write(const Report& report, const std::filesystem::path& folder);

}  // namespace skydrop::device
