// kiri states: the folded states of a crease pattern, counted, listed, written.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/output_format.h"
#include "apps/cli/state_number.h"
#include "apps/cli/states_output.h"
#include "apps/cli/states_report.h"

namespace kiri::cli {

namespace {

struct StatesOptions {
  std::string file;
  bool isCount = false;
  std::string state;
  bool isAll = false;
  std::size_t limit = 0;
  bool isJson = false;
  bool setsCode = false;
  std::string out;
  std::string format;
  double dpi = 200;
  double memory = 2048;
  double time = 0;
};

Status checkUsage(const StatesOptions& options) {
  const int modes =
      (options.isCount ? 1 : 0) + (options.state.empty() ? 0 : 1) + (options.isAll ? 1 : 0);
  const auto wrong = [](const std::string& sentence) {
    return Error{ErrorCode::BadValue, sentence};
  };
  if (modes > 1) return wrong("--count, --state and --all ask for different things; choose one");
  if (options.isCount && !options.out.empty())
    return wrong("--count writes no states; leave -o out, or choose some with --state or --all");
  if (!options.state.empty() && !isStateNumber(options.state))
    return wrong("--state " + options.state + " is no number; states count from 0");
  if (options.limit > 0 && !options.isAll) return wrong("--limit goes with --all");
  constexpr double kMostMemory = 1 << 20;
  if (!(options.memory >= 1 && options.memory <= kMostMemory))
    return wrong("--memory must lie between 1 and 1048576 (MB)");
  if (!(options.time >= 0)) return wrong("--time must not be negative; 0 means no limit");
  constexpr double kHighest = 10000;
  if (!(options.dpi >= 1 && options.dpi <= kHighest))
    return wrong("--dpi must lie between 1 and 10000");
  if (options.out == "-" && options.isJson)
    return wrong("-o - and --json would mix on standard output; name a file for one of them");
  return std::monostate{};
}

Result<StatesFile> fileOf(const StatesOptions& options) {
  const Result<std::string> format = chooseFormat(options.out, options.format, stateFormats());
  if (!format.isOk()) return format.error();
  StatesFile file{options.out, *format, options.dpi};
  const Status status = checkStatesFile(file, options.isAll);
  if (!status.isOk()) return status.error();
  return file;
}

/// How many states --all writes or lists: all, up to --limit. Errors: BadValue - too many.
Result<std::size_t> howMany(const StatesOptions& options, const StateCount& total) {
  constexpr std::size_t kMost = 10000;
  const std::size_t most = options.limit > 0 ? options.limit : kMost;
  if (total <= most) return static_cast<std::size_t>(total);
  if (options.limit > 0) return options.limit;
  return Error{ErrorCode::BadValue,
               "there are " + total.str() + " states, and --all takes up to " +
                   std::to_string(kMost) +
                   "; take the first N with --limit N, or one of them with --state"};
}

Result<std::vector<ChosenState>> chooseStates(const StatesOptions& options,
                                              const StatesAnswer& answer, SearchWatch& watch) {
  const LayerStates& states = *answer.states;
  std::vector<ChosenState> out;
  if (!options.isAll) {
    if (options.state.empty()) return std::vector<ChosenState>{{"0", states.first()}};
    const StateCount number = stateNumber(options.state);
    Result<LayerValues> values =
        watch.part("searching state " + number.str(),
                   [&](const Progress& p) { return states.state(number, p); });
    if (!values.isOk()) return values.error();
    return std::vector<ChosenState>{{number.str(), std::move(*values)}};
  }
  const Result<std::size_t> count = howMany(options, *answer.total);
  if (!count.isOk()) return count.error();
  const Status status = watch.part("searching all", [&](const Progress& progress) -> Status {
    for (std::size_t i = 0; i < *count; ++i) {
      if (!goesOn(progress, static_cast<double>(i) / static_cast<double>(*count)))
        return Error{ErrorCode::Cancelled, "", {}};
      Result<LayerValues> values = states.state(StateCount(i), {});
      if (!values.isOk()) return values.error();
      out.push_back({std::to_string(i), std::move(*values)});
    }
    return std::monostate{};
  });
  if (!status.isOk()) return status.error();
  return out;
}

/// --all without a file: a line for each state, with the choice of each component.
Result<std::string> listOf(const StatesOptions& options, const StatesAnswer& answer) {
  const Result<std::size_t> count = howMany(options, *answer.total);
  if (!count.isOk()) return count.error();
  std::string out;
  for (std::size_t i = 0; i < *count; ++i) {
    out += "state " + std::to_string(i) + ":";
    for (const StateCount& choice : choicesOf(*answer.states, StateCount(i)))
      out += " " + choice.str();
    out += "\n";
  }
  return out;
}

int failed(Console& console, const Error& error, const SearchWatch& watch) {
  if (error.code == ErrorCode::Cancelled && watch.ranOut()) {
    return fail(console, kLimitMet,
                "the time was over while " + watch.lastPart() +
                    "; nothing was written; give it more with --time SECONDS");
  }
  const bool isWish = error.code == ErrorCode::NotFound || error.code == ErrorCode::BadValue;
  return fail(console, error, isWish ? kBadUsage : kBadModel);
}

/// Writes what was asked for; kDone where nothing was.
int writeChosen(Console& console, const PatternInput& input, const StatesOptions& options,
                const StatesAnswer& answer, SearchWatch& watch) {
  const bool isImpossible = answer.total && *answer.total == 0;
  if (isImpossible && !options.out.empty()) {
    const Result<StatesFile> file = fileOf(options);
    if (!file.isOk()) return fail(console, file.error(), kBadUsage);
    return isPicture(file->format) ? writeConflictPicture(console, input, answer, *file) : kDone;
  }
  if (!answer.exist() || (options.isAll && !answer.total)) return kDone;
  if (options.out.empty() && options.state.empty()) return kDone;
  const Result<std::vector<ChosenState>> states = chooseStates(options, answer, watch);
  if (!states.isOk()) return failed(console, states.error(), watch);
  if (options.out.empty()) return kDone;
  const Result<StatesFile> file = fileOf(options);
  if (!file.isOk()) return fail(console, file.error(), kBadUsage);
  return writeStatesFile(console, input, answer, *states, *file, watch);
}

int say(Console& console, const PatternInput& input, const StatesOptions& options,
        const StatesAnswer& answer, const SearchWatch& watch) {
  if (options.out == "-" && answer.exist()) return kDone;
  std::string text =
      options.isJson ? statesJson(input, answer, watch.seconds()) : statesText(input, answer);
  if (!options.isJson && options.isCount && answer.total) text = answer.total->str() + "\n";
  if (options.isAll && options.out.empty() && !options.isJson && answer.exist() && answer.total) {
    const Result<std::string> list = listOf(options, answer);
    if (!list.isOk()) return fail(console, list.error(), kBadUsage);
    text += *list;
  }
  return writeResult(console, "-", text);
}

int run(Console& console, const StatesOptions& options) {
  const Status usage = checkUsage(options);
  if (!usage.isOk()) return fail(console, usage.error(), kBadUsage);
  if (!options.out.empty()) {
    const Result<StatesFile> file = fileOf(options);
    if (!file.isOk()) return fail(console, file.error(), kBadUsage);
  }
  SearchWatch watch(console, options.time);
  const Result<PatternInput> input = loadPattern(console, options.file);
  if (!input.isOk()) return fail(console, input.error());
  noteRepairs(console, *input);
  SearchRequest request;
  constexpr double kMegabyte = 1 << 20;
  request.limits.memory = static_cast<std::size_t>(options.memory * kMegabyte);
  request.counts = options.state.empty();
  const Result<StatesAnswer> answer = searchStates(*input, request, watch);
  if (!answer.isOk()) return fail(console, answer.error());
  const int written = writeChosen(console, *input, options, *answer, watch);
  if (written != kDone) return written;
  const int said = say(console, *input, options, *answer, watch);
  if (said != kDone) return said;
  if (!answer->stopped.empty()) return fail(console, kLimitMet, answer->stopped);
  if (!options.out.empty() && !answer->exist()) {
    const Result<StatesFile> file = fileOf(options);
    const bool isDrawn = file.isOk() && isPicture(file->format);
    return fail(console, kBadModel,
                input->name + ": no state exists; " + options.out +
                    (isDrawn ? " shows why" : " was not written"));
  }
  return options.setsCode && !answer->exist() ? kVerdictNo : kDone;
}

void addStatesOptions(CLI::App& command, StatesOptions& options) {
  command
      .add_option("FILE", options.file,
                  "a crease pattern (.fold, .cp, .opx, .svg, .dxf) or a .kiri file, - for standard "
                  "input")
      ->required();
  command.add_flag("--count", options.isCount, "print the number of states and nothing else");
  command
      .add_option("--state", options.state, "one state by its number, from 0; nothing is counted")
      ->type_name("N");
  command.add_flag("--all", options.isAll, "list or write all states, up to 10000");
  command.add_option("--limit", options.limit, "with --all: the first N states at most")
      ->type_name("N");
  command.add_flag("--json", options.isJson, "one JSON object, for programs");
  command
      .add_option("-o,--output", options.out,
                  "file for the states: FOLD, a model, a picture, or pictures with a number: "
                  "state_%04d.png")
      ->type_name("OUT");
  command
      .add_option("--format", options.format,
                  "fold, kiri, svg, png or pdf (default: by the ending of OUT)")
      ->type_name("FORMAT");
  command.add_option("--dpi", options.dpi, "pixels per inch of a PNG (default 200)")
      ->type_name("N");
  command.add_option("--memory", options.memory, "MB that the search may take (default 2048)")
      ->type_name("MB");
  command.add_option("--time", options.time, "seconds that all of it may take (default: no limit)")
      ->type_name("SECONDS");
  command.add_flag("--exit-code", options.setsCode, "exit with 5 when no state exists");
}

}  // namespace

void addStatesCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("states", "Find, count and write the folded states of a crease pattern");
  const auto options = std::make_shared<StatesOptions>();
  addStatesOptions(*command, *options);
  command->footer(
      "Examples:\n"
      "  kiri states crane.cp\n"
      "  kiri states crane.fold --count\n"
      "  kiri states crane.fold --json -o crane_folded.fold\n"
      "  kiri states crane.fold --state 3 -o crane_3.png\n"
      "  kiri states crane.fold --all -o crane_all.fold\n"
      "  kiri states ryujin.fold --state 0 --time 60 --memory 4000 -o ryujin_folded.fold");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
