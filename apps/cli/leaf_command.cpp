// kiri leaf: a leaf model from a recipe of angles and lengths.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

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

/// Where the ends of the creases lie in the folded leaf, in the order in which one margin would
/// have to meet them: what to look at when none can.
std::string foldedTable(const FoldedHalf& half) {
  struct Row {
    std::string name;
    Vec2 end;
  };
  std::vector<Row> rows;
  std::size_t wide = 0;
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    const std::string& name = half.creases()[i].name;
    // The creases of a pair on a side lobe lie on each other.
    const auto isThis = [&](const Row& row) { return row.name == name; };
    if (std::any_of(rows.begin(), rows.end(), isThis)) continue;
    rows.push_back({name, half.foldedEnd(i)});
    wide = std::max(wide, name.size());
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return length(a.end) > length(b.end); });
  std::string out = "Folded, the creases end here; one margin must meet them in this order:\n" +
                    std::string(wide, ' ') + "    angle   length\n";
  for (const Row& row : rows) {
    out += row.name + std::string(wide - row.name.size(), ' ') +
           cell(angleDegrees(row.end.y, row.end.x), 2) + cell(length(row.end), 3) + '\n';
  }
  return out;
}

/// Says why no leaf can be made; without a file to write, also where its creases lie folded.
int refuse(Console& console, const std::string& name, const LeafRecipe& recipe, const Error& error,
           bool isListing) {
  const int code = fail(console, ExitCode::kBadModel, name + ": " + error.message);
  const Result<FoldedHalf> half = foldedHalfOf(recipe);
  if (isListing && half) console.out << foldedTable(*half);
  return code;
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
    return refuse(console, input->name, loaded->recipe, leaf.error(), options.out.empty());
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
