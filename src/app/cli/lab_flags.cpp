#include "app/cli/lab_flags.h"

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

void addLabFlags(CLI::App& verb, CommandLine& line) {
  verb.add_flag("--list", line.lab.list, "print the pages and their knobs");
  verb.add_flag("--all", line.lab.all, "a picture of every page, and gallery.md, to the folder of --out");
  const auto text = [&](const std::string& flag, const std::string& form, std::optional<std::string>& target,
                        const std::string& help) {
    addText(verb, flag, form, help, [flag, &target](const std::string& t) {
      if (t.empty()) throw UsageError(flag + " is empty");
      target = t;
    });
  };
  text("--page", "NAME", line.lab.page, "the page, see --list");
  text("--out", "FILE.png|DIR", line.lab.out,
       "draw without a window, to this file (-: standard output); of --all the folder");
  addText(verb, "--backend", "egl|osmesa|window", "what draws with --out",
          [&line](const std::string& t) { line.backend = parseBackend(t); });
}

void checkLab(const CommandLine& line) {
  const LabRequest& lab = line.lab;
  if (lab.all && (lab.page || !line.set.empty()))
    throw UsageError("--all draws every page at its defaults: --page and --set cannot be given with it");
  if (lab.all && !lab.out) throw UsageError("--all needs --out DIR");
  if (lab.out && !lab.all && !lab.page) throw UsageError("--out needs --page NAME, or --all");
  if (!line.set.empty() && !lab.page) throw UsageError("--set needs --page NAME, whose knob it is");
  if (lab.out && !lab.all && *lab.out != "-" && !lab.out->ends_with(".png"))
    throw UsageError("--out: '" + *lab.out + "' does not end in .png");
}

}  // namespace skydrop::app
