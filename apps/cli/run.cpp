// The command line program, but for the process around it.
// SPDX-License-Identifier: MIT
#include "apps/cli/run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>

#include "apps/cli/commands.h"
#include "io/json_fields.h"

namespace kiri::cli {

namespace {

constexpr const char* kFooter =
    "MODEL is a .kiri file (docs/formats/kiri.md), or a crease pattern (.fold, .cp, .opx, .svg, "
    ".dxf),\n"
    "which becomes a model as kiri convert makes one; - means standard input or output.\n"
    "Collisions are warnings: work goes on. Lengths are mm, angles degrees.\n\n"
    "Exit codes:\n"
    "  0   done\n"
    "  1   the model cannot be read, or a step that is needed does not apply\n"
    "  2   the command line is wrong\n"
    "  3   the result could not be written\n"
    "  4   stopped by Ctrl-C; nothing was written\n"
    "  5   with --exit-code: the pattern does not fold flat\n"
    "  6   a limit of time or memory ended the search\n"
    "  70  a defect of the program\n\n"
    "Examples:\n"
    "  kiri render leaf.kiri -o leaf.png\n"
    "  kiri sheet leaf.kiri -o leaf.pdf\n"
    "  kiri animate leaf.kiri -o leaf.mp4\n"
    "  kiri info leaf.kiri --json\n"
    "  kiri export leaf.kiri -o leaf.fold\n"
    "  kiri check crane.cp\n"
    "  kiri states crane.fold --count\n"
    "  kiri convert crane.cp crane.kiri\n"
    "kiri COMMAND --help says more about each.";

/// The subcommand that the arguments name; the program itself when they name none.
CLI::App& chosenCommand(CLI::App& app, const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
      if (command->get_name() == argument) return *command;
    }
    if (!argument.empty() && argument[0] != '-') break;
  }
  return app;
}

std::vector<std::string> namesOf(const CLI::App& command) {
  std::vector<std::string> out;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
  }
  return out;
}

std::vector<std::string> commandNames(CLI::App& app) {
  std::vector<std::string> out;
  for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    out.push_back(command->get_name());
  }
  return out;
}

/// What is wrong with the command line, in our words where the library's are hard to read.
std::string sentenceFor(CLI::App& app, const std::vector<std::string>& arguments,
                        const CLI::ParseError& problem) {
  CLI::App& command = chosenCommand(app, arguments);
  const std::string help =
      command.get_parent() == nullptr ? "kiri --help" : "kiri " + command.get_name() + " --help";
  if (arguments.empty()) return "say what to do; see kiri --help";
  if (command.get_parent() == nullptr && arguments[0][0] != '-') {
    const std::string meant = nearestName(arguments[0], commandNames(app));
    return "there is no command \"" + arguments[0] + "\"" +
           (meant.empty() ? "; see kiri --help" : "; did you mean \"" + meant + "\"?");
  }
  const std::vector<std::string> known = namesOf(command);
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    if (name.rfind("--", 0) != 0 || std::find(known.begin(), known.end(), name) != known.end())
      continue;
    const std::string meant = nearestName(name, known);
    return "there is no option " + name +
           (meant.empty() ? "; see " + help : "; did you mean " + meant + "?");
  }
  std::string sentence = problem.what();
  const std::string marker = "Could not convert: ";
  if (sentence.rfind(marker, 0) == 0) {
    sentence = sentence.substr(marker.size()) + " is no number that fits here";
  }
  return sentence + "; see " + help;
}

void describe(CLI::App& app, Console& console) {
  app.name("kiri");
  app.footer(kFooter);
  app.require_subcommand(1);
  app.set_version_flag("--version", "KiriSim " KIRI_VERSION);
  app.add_flag_callback(
      "--progress", [&console] { console.showsProgress = true; },
      "show progress on standard error even when it is no terminal");
  app.fallthrough();
}

int parseAndRun(const std::vector<std::string>& arguments, Console& console) {
  int code = kDone;
  CLI::App app{
      "KiriSim: fold, tear and cut paper as a model file says, and write pictures and data."};
  describe(app, console);
  addRenderCommand(app, console, code);
  addSheetCommand(app, console, code);
  addAnimateCommand(app, console, code);
  addInfoCommand(app, console, code);
  addStepsCommand(app, console, code);
  addExportCommand(app, console, code);
  addResolveCommand(app, console, code);
  addLeafCommand(app, console, code);
  addMeasureCommand(app, console, code);
  addGalleryCommand(app, console, code);
  addCheckCommand(app, console, code);
  addStatesCommand(app, console, code);
  addConvertCommand(app, console, code);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::Success& success) {
    return app.exit(success, console.out, console.err);
  } catch (const CLI::ParseError& problem) {
    return fail(console, kBadUsage, sentenceFor(app, arguments, problem));
  }
  return code;
}

}  // namespace

int run(const std::vector<std::string>& arguments, Console& console) {
  try {
    return parseAndRun(arguments, console);
  } catch (const std::bad_alloc&) {
    return fail(console, kDefect, "there is not enough memory for this model");
  } catch (const std::exception& defect) {
    return fail(console, kDefect,
                std::string("a defect of the program, not of your model: ") + defect.what() +
                    "; please report it with the model file");
  }
}

}  // namespace kiri::cli
