// kiri resolve: the same model with every choice written down as places on the paper.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "core/model/apply.h"
#include "io/kiri_writer.h"

namespace kiri::cli {

namespace {

struct ResolveOptions {
  std::string model;
  std::string out;
};

int run(Console& console, const ResolveOptions& options) {
  Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const std::size_t count = input->model.steps.size();
  const Result<Replay> replay = replayFirst(console, *input, count);
  if (!replay.isOk()) return fail(console, replay.error());
  const auto last = stateAfter(console, *input, *replay, count);
  if (!last.isOk()) return fail(console, last.error());
  Model model = input->model;
  for (std::size_t i = 0; i < count; ++i) {
    const FoldedState& before = i == 0 ? *replay->start : *replay->outcomes[i - 1].state;
    Result<Step> step = resolve(before, model.steps[i], static_cast<int>(i + 1));
    if (!step.isOk()) return fail(console, errorOfStep(*input, i, step.error()));
    model.steps[i] = std::move(*step);
  }
  return writeResult(console, options.out, writeKiri(model));
}

}  // namespace

void addResolveCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("resolve", "Write the model with every choice as places on the paper");
  const auto options = std::make_shared<ResolveOptions>();
  command->add_option("MODEL", options->model, "a .kiri file, - for standard input")->required();
  command->add_option("-o,--output", options->out, "file to write, - for standard output")
      ->type_name("OUT")
      ->required();
  command->footer(
      "Lines drawn on the folded model become lines on the paper, \"all\" and \"top\" layers "
      "become points on\n"
      "facets. The result folds the same way even when earlier steps are changed later.\n\n"
      "Examples:\n"
      "  kiri resolve leaf.kiri -o leaf-resolved.kiri\n"
      "  kiri resolve - -o - < leaf.kiri");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
