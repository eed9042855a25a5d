// kiri leaf: a leaf model from a recipe of angles and lengths.
// SPDX-License-Identifier: MIT
#include <iomanip>
#include <memory>
#include <sstream>
#include <string>

#include "apps/cli/commands.h"
#include "core/base/text.h"
#include "core/leaf/leaf_model.h"
#include "io/file.h"
#include "io/kiri_writer.h"
#include "io/leaf_recipe_reader.h"

namespace kiri::cli {

namespace {

struct LeafOptions {
  std::string recipe;
  std::string out;
};

/// The rays with the lengths that one straight cut would give: how far this leaf is from the
/// kirigami law of straight margins.
std::string lawTable(const std::vector<FanRay>& fan) {
  const std::vector<double> straight = straightLengths(fan);
  std::ostringstream out;
  out << std::left << std::setw(20) << "ray" << std::right << std::setw(9) << "angle"
      << std::setw(9) << "folded" << std::setw(9) << "length" << std::setw(15) << "straight cut"
      << '\n';
  for (std::size_t i = 0; i < fan.size(); ++i) {
    out << std::left << std::setw(20) << fan[i].name << std::right << std::fixed
        << std::setprecision(1) << std::setw(9) << fan[i].angle << std::setw(9) << fan[i].folded
        << std::setprecision(3) << std::setw(9) << fan[i].length << std::setw(15) << straight[i]
        << '\n';
  }
  return out.str();
}

Result<std::string> recipeText(Console& console, const std::string& path) {
  return path == "-" ? readStream(console.in, "standard input") : readFile(path);
}

int run(Console& console, const LeafOptions& options) {
  const Result<std::string> text = recipeText(console, options.recipe);
  if (!text) return fail(console, text.error());
  const std::string name = options.recipe == "-" ? "standard input" : options.recipe;
  const Result<LoadedRecipe> loaded = readLeafRecipe(*text, name);
  if (!loaded) return fail(console, loaded.error());
  for (const std::string& warning : loaded->warnings) warn(console, warning);
  const Result<LeafModel> leaf = leafModelOf(loaded->recipe);
  if (!leaf) return fail(console, ExitCode::kBadModel, name + ": " + leaf.error().message);
  if (options.out.empty()) {
    console.out << lawTable(leaf->fan);
    return kDone;
  }
  return writeResult(console, options.out, writeKiri(leaf->model));
}

}  // namespace

void addLeafCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand("leaf", "Make the model of a leaf from a recipe");
  const auto options = std::make_shared<LeafOptions>();
  command->add_option("RECIPE", options->recipe, "a recipe, - for standard input")->required();
  command->add_option("-o,--output", options->out, "model to write, - for standard output")
      ->type_name("OUT");
  command->footer(
      "A recipe holds the angles and lengths of veins and anti-veins. The model folds a sheet "
      "along\n"
      "them, cuts one margin through all layers and unfolds. Without -o the rays are listed "
      "beside\n"
      "the lengths that one straight cut would give (the kirigami law).\n\n"
      "Examples:\n"
      "  kiri leaf examples/leaves/sweet_gum.json -o sweet_gum.kiri\n"
      "  kiri leaf examples/leaves/sweet_gum.json");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
