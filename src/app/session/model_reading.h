// How the program reads the models that it shows. Those that it comes with are known by their content and
// read here; any other is read by a child process (core/contained_process.h), since assimp may crash on what
// it has never seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "skydrop/core/contained_process.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::app {

// The first word of a child's command line; the file follows. Not for players.
inline constexpr std::string_view kReadModelWord = "--read-model-for-parent";

inline constexpr core::ContainedLimits kModelLimits{
    .wallSeconds = 60, .cpuSeconds = 20, .memoryBytes = std::size_t{3} << 30};

// Whether assets/models holds this content, so that the tests have imported it under the sanitizers.
bool isShippedModel(std::span<const std::byte> content);
std::uint64_t modelDigest(std::span<const std::byte> content);  // by which they are known

// At the start of the program, before any thread: from now on readModel() starts children. Without it, as in
// tests, and where there are none (Windows, no /proc), models are read here.
void readForeignModelsApart();

// As importModel(); a child that ends badly is a core::DataError too.
render::ModelData readModel(const std::filesystem::path& file);
render::ModelData readModelApart(const std::filesystem::path& file, const std::filesystem::path& program,
                                 const core::ContainedLimits& limits = kModelLimits);

// The child: reads the model and hands it, or the line with which it is refused, to its parent. Returns its
// exit code.
int readModelForParent(const std::filesystem::path& file);

}  // namespace skydrop::app
