// A JSON file of settings: {"schema": 1, "settings": {"aircraft": {"mass": 900}}}. The player's settings,
// presets and qualities all have this form, with other members beside `settings` where a kind of file needs
// them. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace skydrop::core {

inline constexpr int kSettingsSchema = 1;
inline constexpr std::size_t kMostSettingsBytes = std::size_t{1} << 20;

// What becomes of a member that the program does not know: refused in a file that is shipped or named; kept
// in the player's own, which a newer version may have written.
enum class UnknownMembers { refuse, keep };

// The whole object; `settings` is in it and an object, the schema is ours, and of other members there are
// none but `members`. At most 1 MiB. Throws DataError that names the file, the place and the reason; what the
// settings and members say is judged by applyJson() and the caller.
nlohmann::json readSettingsFile(const std::filesystem::path& file,
                                std::initializer_list<std::string_view> members,
                                UnknownMembers unknown = UnknownMembers::refuse);
nlohmann::json parseSettings(std::string_view text, std::string_view file,
                             std::initializer_list<std::string_view> members,
                             UnknownMembers unknown = UnknownMembers::refuse);

// Writes `members` with the schema, so that not even a loss of power loses the file, and makes the folder.
// Throws DataError.
void writeSettingsFile(const std::filesystem::path& file, const nlohmann::json& members);

}  // namespace skydrop::core
