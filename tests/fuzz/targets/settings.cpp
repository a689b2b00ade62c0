// The player's settings and key bindings: what fits is used and can be saved again.
#include "app/settings/settings.h"

#include "app/settings/user_settings.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static app::Settings settings;
  static const core::SettingsTable table(settings);
  const std::filesystem::path file = fuzz::inputFile("settings.json", data, size);
  fuzz::accepts("settings.json", [&] {
    app::UserSettings user(file.parent_path());
    user.reload();
    user.applyTo(table);
    for (const core::Field& field : table.fields()) {
      fuzz::require(field.get() >= field.min && field.get() <= field.max, field.path + " is in its range");
    }
    user.choose("aircraft.mass", 900);
    user.save(table, user.bindings());
    user.reload();
  });
  return 0;
}
