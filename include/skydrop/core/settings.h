// Settings are described once. A module writes, for each of its settings structs, one function
//
//     void describe(core::SettingsVisitor& visitor, AirplaneSettings& settings);
//
// that names every field with unit, range and a sentence. From that one description come JSON reading and
// writing, range checks, --set, menu sliders, search and the axes of accuracy studies (settings_table.h). The
// default of a field is its value in a default-constructed struct: it is written nowhere else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace skydrop::core {

// How a change takes effect. While a slider is held, at the next step or frame: at no cost, or (liveRebuild)
// with a part rebuilt for each change on the main thread, which a tuner rather waits for (tens of ms) than
// works blind. When a slider is released: by compiling a shader variant, by rebuilding a part, or by starting
// the flight again with land and sky reloaded.
enum class TakesEffect { live, liveRebuild, variant, rebuild, restart };

constexpr bool isWhileHeld(TakesEffect effect) {
  return effect == TakesEffect::live || effect == TakesEffect::liveRebuild;
}

struct Range {
  double min, max;
};

// What the value that a field has now comes to, where that is not plain, or why it does nothing now: a
// sentence, or nothing. Called whenever it is shown; may refer to the struct that is described.
using FieldNote = std::function<std::string()>;

inline FieldNote noteWhile(std::function<bool()> holds, std::string sentence) {
  return [holds = std::move(holds), sentence = std::move(sentence)] { return holds() ? sentence : ""; };
}

// A number that people write in another way: an instant as "2026-06-21T12:00:00Z". JSON has it in quotes.
struct WrittenForm {
  std::string (*write)(double value);  // of any value within the field's range
  // Sets the value and returns nothing, or returns why the text cannot be read ("has month 13").
  std::string (*read)(std::string_view text, double& value);
};

struct NumberInfo {
  std::string_view unit;  // SI, "1" for a pure number
  // What typing, --set and files may set.
  double min = -std::numeric_limits<double>::max();
  double max = std::numeric_limits<double>::max();
  std::string_view help;  // one sentence: what it does, and what more of it means
  TakesEffect takesEffect = TakesEffect::live;
  bool logarithmic = false;  // the slider moves by ratios; needs a slider that begins above 0
  bool powersOfTwo = false;  // nothing between them makes a difference: the slider stops at them alone
  // What the slider covers: where the result looks and flies right, and every value makes a difference. All
  // of min to max where it is not given.
  std::optional<Range> slider = std::nullopt;
  std::string_view aliases = {};  // "HG, g": what else people call it; for search and suggestions alone
  FieldNote note = {};
  const WrittenForm* written = nullptr;  // digits; else outlives every table
};

struct ChoiceInfo {
  std::string_view help;
  TakesEffect takesEffect = TakesEffect::live;
  std::string_view aliases = {};  // as of numbers
  FieldNote note = {};
};

// Walks a settings struct. Names are lowerCamel, unique within their group, without dots.
class SettingsVisitor {
 public:
  virtual ~SettingsVisitor() = default;

  virtual void number(std::string_view name, double& value, const NumberInfo& info) = 0;
  virtual void integer(std::string_view name, std::int64_t& value, const NumberInfo& info) = 0;
  virtual void flag(std::string_view name, bool& value, const ChoiceInfo& info) = 0;
  virtual void choiceByIndex(std::string_view name, std::function<int()> get, std::function<void(int)> set,
                             std::span<const std::string_view> names, const ChoiceInfo& info) = 0;
  virtual void enterGroup(std::string_view name, std::string_view help) = 0;
  virtual void leaveGroup() = 0;

  // A field of this group, or below it ("layers.0.base"), that earlier versions called `formerly`: files,
  // logs and --set that have the old name still mean it. Where a file has both, the new name counts. A field
  // that moved to another group is renamed by the group that holds both ("clouds.windSpeed", "wind.speed").
  // A shorter name that a field has besides its path is given to it in the same way.
  virtual void renamed(std::string_view formerly, std::string_view now) {
    static_cast<void>(formerly), static_cast<void>(now);
  }
  // A field of this group that earlier versions had and this one does without: files that set it are read as
  // if they did not, --set is told that it is gone.
  virtual void removed(std::string_view name) { static_cast<void>(name); }

  // An enumeration, written by name: names[i] belongs to static_cast<Enum>(i).
  template <class Enum>
  void choice(std::string_view name, Enum& value, std::span<const std::string_view> names,
              const ChoiceInfo& info) {
    choiceByIndex(
        name, [&value] { return static_cast<int>(value); }, [&value](int i) { value = static_cast<Enum>(i); },
        names, info);
  }

  // A nested struct that has its own describe(), found by argument-dependent lookup.
  template <class Settings>
  void group(std::string_view name, Settings& settings, std::string_view help) {
    enterGroup(name, help);
    describe(*this, settings);
    leaveGroup();
  }

  // An array of structs: layers.0, layers.1, ...
  template <class Settings, std::size_t N>
  void group(std::string_view name, std::array<Settings, N>& settings, std::string_view help) {
    enterGroup(name, help);
    for (std::size_t i = 0; i < N; ++i) group(std::to_string(i), settings[i], help);
    leaveGroup();
  }
};

}  // namespace skydrop::core
