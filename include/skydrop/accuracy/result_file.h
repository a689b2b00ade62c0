// Results on the disk: DIR/results.jsonl, a line of JSON for each thing that was measured, added as it comes,
// so that a run that is cut off loses nothing but what was under way. Pictures lie beside it. One thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/result.h"
#include "skydrop/core/output_file.h"

namespace skydrop::accuracy {

inline constexpr int kResultSchema = 1;
inline constexpr std::string_view kResultFile = "results.jsonl";

// The content of a results file. A last line that was cut off is left out, and `cutOff` set. Throws
// core::DataError with the line's number for anything else that is wrong.
Results parseResults(std::string_view text, std::string_view file, bool* cutOff = nullptr);
Results readResults(const std::filesystem::path& folder, bool* cutOff = nullptr);

// Several shares of one run as one. Pictures are copied from the shares' folders into `into` unless it is
// empty. Throws core::DataError: of different studies or efforts, or a case twice.
Results mergeResults(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& into);

// Writes the whole, as a file that parseResults() reads back to the same bits.
std::string resultText(const Results& results);

// Adds to the file and to the results in memory alike.
class ResultWriter {
 public:
  // Begins a new file in the folder, or goes on with what `before` holds. Refuses a folder that cannot be
  // written to (core::DataError).
  ResultWriter(std::filesystem::path folder, Results before);

  const Results& results() const { return results_; }
  // Adds the case, or describes it again if there is one of this id: what was measured of it stays.
  CaseResult& begin(const CaseResult& description);
  void reference(CaseResult& of, std::size_t index, std::vector<double> changes, std::string picture);
  void error(CaseResult& of, std::size_t point, std::vector<double> errors, std::string picture,
             std::string heat);
  void time(CaseResult& of, std::size_t point, double ms);
  void clock(CaseResult& of, std::string clock, std::string machine);
  void failure(CaseResult& of, std::string reason);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  void append(const std::string& line);

  std::filesystem::path folder_;
  Results results_;
  core::OutputFile file_;
  bool begun_ = false;
};

}  // namespace skydrop::accuracy
