// Flags of a verb whose values arrive as text, so that every refusal has the same form: CLI11 only splits
// words and writes the help.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skydrop::app {

// `form` names the value in the help; `read` throws core::UsageError.
void addText(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
             std::function<void(const std::string&)> read);

// A path that is not empty.
void addPath(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
             std::optional<std::filesystem::path>& target);

// Files or standard input; a flag may stand several times. `who` begins the refusal of an empty path.
CLI::Option* addFiles(CLI::App& verb, const std::string& name, const std::string& who,
                      const std::string& help, std::vector<std::filesystem::path>& target);

}  // namespace skydrop::app
