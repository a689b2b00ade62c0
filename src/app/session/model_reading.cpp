#include "app/session/model_reading.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/models/model_bytes.h"

namespace skydrop::app {
namespace {

// Digests of airplane.glb, package.glb and parachute.glb. A test fails for a model that was made again, and
// tells its new one.
constexpr std::array<std::uint64_t, 3> kShipped = {0xd0cb64086e349133u, 0x374b80f6aacf6fe7u,
                                                   0x0322e6033b676ddau};

// The first byte of what a child hands over.
constexpr char kModel = 'm', kRefusal = 'r';

std::filesystem::path program;  // that reads models; set once, before any thread

}  // namespace

std::uint64_t modelDigest(std::span<const std::byte> content) {
  core::StateHasher hasher;
  hasher.add(static_cast<std::uint64_t>(content.size()));
  for (std::size_t at = 0; at < content.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, content.data() + at, std::min(sizeof word, content.size() - at));
    hasher.add(word);
  }
  return hasher.value();
}

bool isShippedModel(std::span<const std::byte> content) {
  return std::ranges::find(kShipped, modelDigest(content)) != kShipped.end();
}

void readForeignModelsApart() {
  if (core::isContainmentPossible()) program = core::runningProgram();
}

render::ModelData readModel(const std::filesystem::path& file) {
  if (program.empty() || isShippedModel(core::readFile(file, render::kMaxModelFileBytes)))
    return render::importModel(file);
  return readModelApart(file, program);
}

render::ModelData readModelApart(const std::filesystem::path& file, const std::filesystem::path& reader,
                                 const core::ContainedLimits& limits) {
  const std::string name = file.string();
  const std::string result =
      core::runContained(reader, {"skydrop", std::string(kReadModelWord), name}, limits, name);
  if (result.starts_with(kRefusal)) {
    const std::size_t end = result.find(": ");  // of the file: the model, or what it names
    if (end == std::string::npos) throw core::DataError(name, "", result.substr(1));
    throw core::DataError(result.substr(1, end - 1), "", result.substr(end + 2));
  }
  if (!result.starts_with(kModel)) throw core::DataError(name, "", "what reads it handed over no model");
  return render::modelOf(std::string_view(result).substr(1), name);
}

int readModelForParent(const std::filesystem::path& file) {
  core::limitThisProcess(kModelLimits);
  std::string result;
  try {
    result = kModel + render::bytesOf(render::importModel(file));
  } catch (const std::bad_alloc&) {
    result = kRefusal + (file.string() + ": takes too much memory");
  } catch (const core::DataError& error) {
    result = std::string(1, kRefusal) + error.what();
  }
  core::writeContainedResult(result);
  return 0;
}

}  // namespace skydrop::app
