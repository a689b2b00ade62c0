#include "skydrop/accuracy/result_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include "accuracy/result_lines.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"

namespace skydrop::accuracy {
namespace {

constexpr core::JsonLimits kLineLimits{.bytes = std::size_t{4} << 20, .depth = 8, .values = 200'000};

// A picture's name in a results file is one of ours, or it could name any file of the reader's.
bool isPictureName(const std::string& name) {
  constexpr std::string_view kFolder = "pictures/";
  return name.starts_with(kFolder) && name.find('/', kFolder.size()) == std::string::npos &&
         name.ends_with(".png");
}

void requirePictures(const Results& results, std::string_view file) {
  const auto require = [&](const std::string& name) {
    if (!name.empty() && !isPictureName(name))
      throw core::DataError(file, "picture", "'" + name + "' is not in the folder pictures");
  };
  for (const CaseResult& of : results.cases) {
    for (const ReferenceResult& reference : of.references) require(reference.picture);
    for (const PointResult& point : of.points) require(point.picture), require(point.heat);
  }
}

void copyPicture(const std::string& name, const std::filesystem::path& from,
                 const std::filesystem::path& into) {
  if (name.empty() || into.empty()) return;
  core::makeFolder(into / "pictures");
  core::writeFileAtomically(into / name, core::readFile(from / name));
}

}  // namespace

Results parseResults(std::string_view text, std::string_view file, bool* cutOff) {
  Results results;
  if (cutOff) *cutOff = false;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string place = "line " + std::to_string(++number);
    if (end == std::string_view::npos) {
      if (cutOff) *cutOff = true;
      break;
    }
    nlohmann::json line;
    try {
      line = core::parseJson(text.substr(begin, end - begin), file, kLineLimits);
    } catch (const core::DataError&) {
      throw core::DataError(file, place, "is damaged: no whole line of JSON");
    }
    addLine(line, file, place, results);
    begin = end + 1;
  }
  if (results.digest.empty()) throw core::DataError(file, "line 1", "the head is missing");
  requirePictures(results, file);
  return results;
}

Results readResults(const std::filesystem::path& folder, bool* cutOff) {
  const std::filesystem::path file = folder / kResultFile;
  return parseResults(core::readTextFile(file), file.string(), cutOff);
}

Results mergeResults(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& into) {
  Results all;
  std::map<std::string, std::filesystem::path> from;
  for (const std::filesystem::path& folder : folders) {
    const std::string file = (folder / kResultFile).string();
    Results part = readResults(folder);
    if (all.digest.empty()) {
      all = part;
      all.cases.clear();
    }
    if (part.digest != all.digest)
      throw core::DataError(file, "",
                            "is of other studies, or of another effort, than " + folders[0].string());
    for (CaseResult& of : part.cases) {
      const auto [entry, isNew] = from.emplace(of.id(), folder);
      if (!isNew)
        throw core::DataError(file, "",
                              "the case '" + of.id() + "' is in " + entry->second.string() + " too");
      all.cases.push_back(std::move(of));
    }
  }
  std::ranges::sort(all.cases, {}, &CaseResult::index);
  for (const CaseResult& of : all.cases) {
    for (const ReferenceResult& reference : of.references)
      copyPicture(reference.picture, from[of.id()], into);
    for (const PointResult& point : of.points) {
      copyPicture(point.picture, from[of.id()], into);
      copyPicture(point.heat, from[of.id()], into);
    }
  }
  return all;
}

std::string resultText(const Results& results) {
  std::string text = headLine(results);
  for (const CaseResult& of : results.cases) {
    text += caseLine(of);
    for (std::size_t i = 0; i < of.references.size(); ++i) {
      if (!of.references[i].changes.empty()) text += referenceLine(of, i);
    }
    if (!of.clock.empty()) text += clockLine(of);
    for (std::size_t i = 0; i < of.points.size(); ++i) {
      if (!of.points[i].errors.empty()) text += errorLine(of, i);
      for (const double ms : of.points[i].ms) text += timeLine(of, i, ms);
    }
    if (!of.failure.empty()) text += failureLine(of);
  }
  return text;
}

ResultWriter::ResultWriter(std::filesystem::path folder, Results before)
    : folder_(std::move(folder)), results_(std::move(before)), file_(folder_ / kResultFile) {}

void ResultWriter::append(const std::string& line) {
  file_.append(std::exchange(begun_, true) ? line : resultText(results_));
}

CaseResult& ResultWriter::begin(const CaseResult& description) {
  CaseResult& of = describeCase(description, results_);
  append(caseLine(of));
  return of;
}

void ResultWriter::reference(CaseResult& of, std::size_t index, std::vector<double> changes,
                             std::string picture) {
  of.references[index].changes = std::move(changes);
  of.references[index].picture = std::move(picture);
  append(referenceLine(of, index));
}

void ResultWriter::error(CaseResult& of, std::size_t point, std::vector<double> errors, std::string picture,
                         std::string heat) {
  of.points[point].errors = std::move(errors);
  of.points[point].picture = std::move(picture);
  of.points[point].heat = std::move(heat);
  append(errorLine(of, point));
}

void ResultWriter::time(CaseResult& of, std::size_t point, double ms) {
  of.points[point].ms.push_back(ms);
  append(timeLine(of, point, ms));
}

void ResultWriter::clock(CaseResult& of, std::string clock, std::string machine) {
  of.clock = std::move(clock);
  of.machine = std::move(machine);
  append(clockLine(of));
}

void ResultWriter::failure(CaseResult& of, std::string reason) {
  of.failure = std::move(reason);
  append(failureLine(of));
}

}  // namespace skydrop::accuracy
