#include "app/cli/flag_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "skydrop/core/error.h"

namespace skydrop::app {

void addText(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
             std::function<void(const std::string&)> read) {
  verb.add_option_function<std::string>(flag, std::move(read), help)
      ->type_name(form)
      ->allow_extra_args(false);
}

void addPath(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
             std::optional<std::filesystem::path>& target) {
  addText(verb, flag, form, help, [flag, &target](const std::string& t) {
    if (t.empty()) throw core::UsageError(flag + ": the path is empty");
    target = t;
  });
}

CLI::Option* addFiles(CLI::App& verb, const std::string& name, const std::string& who,
                      const std::string& help, std::vector<std::filesystem::path>& target) {
  return verb
      .add_option_function<std::vector<std::string>>(
          name,
          [who, &target](const std::vector<std::string>& all) {
            if (std::ranges::find(all, "") != all.end()) throw core::UsageError(who + ": the path is empty");
            target.assign(all.begin(), all.end());
          },
          help)
      ->type_name("FILE|-");
}

}  // namespace skydrop::app
