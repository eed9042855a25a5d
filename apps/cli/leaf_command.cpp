// kiri leaf: a leaf model from a recipe of angles and lengths.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_format.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/leaf_measures.h"
#include "core/leaf/leaf_model.h"
#include "core/leaf/straight_margin.h"
#include "io/kiri_writer.h"
#include "io/leaf_recipe_reader.h"

namespace kiri::cli {

namespace {

struct LeafOptions {
  std::string recipe;
  std::string out;
};

/// Makes the leaf and measures its unfolded margin.
Result<LeafMeasures> measuredLeaf(Console& console, const std::string& name,
                                  const LeafModel& leaf) {
  const ModelInput input{name, "", leaf.model};
  const auto state = loadState(console, input, {leaf.model.steps.size()});
  if (!state) return state.error();
  MeasureOptions options;
  options.petiole = leaf.petiole;
  options.axis = 0;
  options.prominence = kParallel;  // however faint
  return measuresOf((*state)->pattern, options);
}

/// The tip or sinus of the right half that lies nearest to a crease; the basal edge ends in none.
const MarginPoint* measuredAt(const LeafMeasures& measures, const LeafCrease& crease) {
  const MarginPoint* nearest = nullptr;
  const double wanted = angleDegrees(crease.end.y, crease.end.x);
  for (const MarginPoint& point : measures.margin) {
    const bool isAlike = point.isLobe == (crease.kind == RayKind::Vein);
    if (!isAlike || crease.kind == RayKind::BasalEdge) continue;
    const double away = std::abs(point.angle - wanted);
    if (nearest == nullptr || away < std::abs(nearest->angle - wanted)) nearest = &point;
  }
  return nearest;
}

std::string cell(const std::optional<double>& value, int decimals) {
  std::ostringstream out;
  out << std::setw(9);
  if (value) {
    out << std::fixed << std::setprecision(decimals) << *value;
  } else {
    out << '-';
  }
  return out.str();
}

/// The creases as the recipe has them, as the model's margin has them, and the lengths that one
/// straight cut would give: how far this leaf is from the kirigami law of straight margins.
std::string lawTable(const LeafModel& leaf, const LeafMeasures& measures, double midVein) {
  const std::vector<LeafCrease>& creases = leaf.half.creases();
  const std::vector<double> straight = straightLengths(leaf.half);
  std::size_t wide = 0;
  for (const LeafCrease& crease : creases) wide = std::max(wide, crease.name.size());
  const auto name = [&](const std::string& text) {
    return text + std::string(wide - text.size(), ' ');
  };
  std::string out = name("") + "   folded       recipe          measured      straight\n" +
                    name("") + "    angle    angle   length    angle   length   length\n";
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const Vec2 end = creases[i].end;
    const Vec2 folded = leaf.half.foldedEnd(i);
    const MarginPoint* point = measuredAt(measures, creases[i]);
    std::optional<double> angle;
    std::optional<double> length;
    if (point != nullptr) {
      angle = point->angle;
      length = point->length / midVein;
    }
    std::optional<double> cut;
    if (straight[i] > 0) cut = straight[i];
    out += name(creases[i].name) + cell(angleDegrees(folded.y, folded.x), 2) +
           cell(angleDegrees(end.y, end.x), 2) + cell(kiri::length(end), 3) + cell(angle, 2) +
           cell(length, 3) + cell(cut, 3) + '\n';
  }
  std::ostringstream halves;
  halves << "\nAngles in degrees from the mid-vein, lengths from the petiole as parts of the "
            "mid-vein's ("
         << midVein << " mm).\nLobes: " << measures.lobeCount
         << ", sinuses: " << measures.sinusCount << ". The halves are mirror images to "
         << std::setprecision(1) << std::scientific << measures.asymmetry << " mm.\n";
  return out + halves.str();
}

int showLaw(Console& console, const std::string& name, const LeafModel& leaf, double midVein) {
  const Result<LeafMeasures> measures = measuredLeaf(console, name, leaf);
  if (!measures) return fail(console, measures.error());
  console.out << lawTable(leaf, *measures, midVein);
  return kDone;
}

/// A leaf is written as a model; what else is made of it, other commands make.
Status checkEnding(const std::string& out) {
  const std::string ending = endingOf(out);
  if (out.empty() || out == "-" || ending.empty() || ending == "kiri") return std::monostate{};
  return Error{ErrorCode::BadValue, out + " ends in ." + ending +
                                        ", but this command writes a model, a .kiri file; kiri " +
                                        "render makes pictures of it, kiri export other files"};
}

int run(Console& console, const LeafOptions& options) {
  if (const Status status = checkEnding(options.out); !status) {
    return fail(console, status.error(), kBadUsage);
  }
  const Result<InputText> input = readInput(console, options.recipe);
  if (!input) return fail(console, input.error());
  const Result<LoadedRecipe> loaded = readLeafRecipe(input->text, input->name);
  if (!loaded) return fail(console, loaded.error());
  for (const std::string& warning : loaded->warnings) warn(console, warning);
  const Result<LeafModel> leaf = leafModelOf(loaded->recipe);
  if (!leaf) {
    return fail(console, ExitCode::kBadModel, input->name + ": " + leaf.error().message);
  }
  if (options.out.empty()) return showLaw(console, input->name, *leaf, loaded->recipe.midVein);
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
      "along\nthem, cuts one margin through all layers and unfolds. Without -o the leaf is made "
      "and\nmeasured, and its creases are listed: as the recipe has them, as the unfolded margin "
      "has\nthem, and with the lengths that one straight cut would give (the kirigami law).\n\n"
      "Examples:\n"
      "  kiri leaf examples/leaves/acer_pseudoplatanus.json -o sycamore.kiri\n"
      "  kiri leaf examples/leaves/acer_pseudoplatanus.json");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
