// The crease pattern that a command works on: read, repaired, and said what was repaired.
// SPDX-License-Identifier: MIT
#include "apps/cli/pattern_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/cli/model_input.h"
#include "core/model/moments.h"
#include "core/model/pattern_model.h"

namespace kiri::cli {

namespace {

constexpr double kFold = 180;

bool isFull(double degrees) { return std::abs(degrees) == kFold; }

/// The creases of a state. Curved borders become polylines on the way.
Result<RepairedPattern> creasesOf(const FoldedState& state, const Progress& progress) {
  AssignedPattern creases = assignedPatternOf(state, true);
  const bool isStraight = std::none_of(state.pattern.edges.begin(), state.pattern.edges.end(),
                                       [](const Edge& edge) { return edge.isCurved(); });
  if (isStraight) return RepairedPattern{std::move(creases), {}, 0};
  return patternOf(drawingOf(creases), {}, progress);
}

/// The model where it is folded; at its end when it never is.
Result<std::shared_ptr<const FoldedState>> foldedStateOf(Console& console,
                                                         const ModelInput& model) {
  const std::size_t count = model.model.steps.size();
  const Result<Replay> replay = replayFirst(console, model, count);
  if (!replay.isOk()) return replay.error();
  auto last = stateAfter(console, model, *replay, count);
  if (!last.isOk()) return last;
  const StateAfter stateAt = [&](std::size_t i) -> const FoldedState& {
    return i == 0 ? *replay->start : *replay->outcomes[i - 1].state;
  };
  return replay->after(stepsUntilFolded(model.model, stateAt).value_or(count));
}

Result<PatternInput> modelCreases(Console& console, const InputText& text) {
  const Result<ModelInput> model = modelFrom(console, text);
  if (!model.isOk()) return model.error();
  const auto state = foldedStateOf(console, *model);
  if (!state.isOk()) return state.error();
  ProgressLine line(console, "reading");
  Result<RepairedPattern> creases = creasesOf(**state, line.progress());
  if (!creases.isOk()) return creases.error();
  PatternInput input{model->name,
                     titleOf(*model),
                     "model",
                     std::nullopt,
                     std::move(creases->creases),
                     std::move(creases->repairs),
                     {},
                     0,
                     "mm",
                     {}};
  input.standing = standingVertices(input.creases);
  input.bentCreases = flattenAngles(input.creases);
  return input;
}

}  // namespace

std::vector<VertexId> standingVertices(const AssignedPattern& creases) {
  std::vector<bool> isEnd(creases.pattern.vertices.size(), false);
  for (const Edge& edge : creases.pattern.edges) {
    const bool isBent = edge.kind == EdgeKind::Hinge && edge.angle != 0 && !isFull(edge.angle);
    if (isBent) isEnd[edge.from.index] = isEnd[edge.to.index] = true;
  }
  std::vector<VertexId> standing;
  for (std::size_t v = 0; v < isEnd.size(); ++v)
    if (isEnd[v]) standing.push_back(VertexId(v));
  return standing;
}

std::size_t flattenAngles(AssignedPattern& creases) {
  std::size_t bent = 0;
  for (Edge& edge : creases.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || edge.angle == 0) continue;
    if (!isFull(edge.angle)) ++bent;
    edge.angle = edge.angle > 0 ? kFold : -kFold;
  }
  return bent;
}

Result<PatternInput> loadPattern(Console& console, const std::string& path) {
  const Result<InputText> text = readInput(console, path);
  if (!text.isOk()) return text.error();
  if (!isPattern(*text)) return modelCreases(console, *text);
  Result<PatternInput> input = patternFrom(console, *text);
  if (!input.isOk()) return input;
  input->standing = standingVertices(input->creases);
  input->bentCreases = flattenAngles(input->creases);
  return input;
}

Result<PatternInput> patternFrom(Console& console, const InputText& text) {
  Result<PatternFile> file = readPattern(text.text, text.name);
  if (!file.isOk()) return file.error();
  ProgressLine line(console, "reading");
  line.update(0);
  RepairOptions options;
  options.scale = file->mmPerUnit.value_or(1);
  Result<RepairedPattern> repaired = patternOf(file->drawing, options, line.progress());
  if (!repaired.isOk()) {
    Error error = repaired.error();
    if (error.code != ErrorCode::Cancelled) error.message = text.name + ": " + error.message;
    return error;
  }
  PatternInput input{text.name,
                     file->title.empty() ? bareName(text) : file->title,
                     nameOf(file->format),
                     std::nullopt,
                     std::move(repaired->creases),
                     std::move(repaired->repairs),
                     file->notes,
                     0,
                     file->mmPerUnit ? "mm" : "units",
                     {}};
  input.file = std::move(*file);
  return input;
}

void noteRepairs(Console& console, const PatternInput& input) {
  for (const std::string& note : input.notes) console.err << "note: " << note << '\n';
  for (const Repair& repair : input.repairs) console.err << "note: " << repair.message << '\n';
  if (input.bentCreases > 0) {
    console.err << "note: " << input.bentCreases
                << (input.bentCreases == 1 ? " crease has an angle" : " creases have angles")
                << " other than 180 degrees; folding flat means 180\n";
  }
}

const char* nameOf(RepairKind kind) {
  switch (kind) {
    case RepairKind::MergedVertices:
      return "merged_vertices";
    case RepairKind::MovedToEdge:
      return "moved_to_edge";
    case RepairKind::SplitCrossings:
      return "split_crossings";
    case RepairKind::DroppedDuplicates:
      return "dropped_duplicates";
    case RepairKind::Conflicts:
      return "conflicts";
    case RepairKind::DroppedPoints:
      return "dropped_points";
    case RepairKind::DroppedDangling:
      return "dropped_dangling";
    case RepairKind::DroppedOutside:
      return "dropped_outside";
    case RepairKind::AddedBorder:
      return "added_border";
    case RepairKind::SlitBorders:
      return "slit_borders";
    case RepairKind::JoinedPieces:
      return "joined_pieces";
    case RepairKind::IgnoredFaces:
      return "ignored_faces";
  }
  return "";
}

const char* nameOf(PatternFormat format) {
  switch (format) {
    case PatternFormat::Fold:
      return "FOLD";
    case PatternFormat::Cp:
      return "CP";
    case PatternFormat::Opx:
      return "OPX";
    case PatternFormat::Svg:
      return "SVG";
    case PatternFormat::Dxf:
      return "DXF";
  }
  return "";
}

JsonValue repairsJson(const std::vector<Repair>& repairs) {
  JsonValue out = JsonValue::array();
  for (const Repair& repair : repairs) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("kind", JsonValue::ofText(nameOf(repair.kind)));
    item.add("count", countJson(repair.count));
    item.add("farthest", JsonValue::ofNumber(repair.farthest));
    JsonValue& places = item.add("places", JsonValue::array());
    for (const Vec2 place : repair.places) places.items.push_back(pointJson(place));
    item.add("message", JsonValue::ofText(repair.message));
  }
  return out;
}

std::size_t countOf(const AssignedPattern& creases, Assignment assignment) {
  return static_cast<std::size_t>(
      std::count(creases.assignments.begin(), creases.assignments.end(), assignment));
}

std::string describedAs(const AssignedPattern& creases) {
  std::size_t hinges = 0;
  for (const Edge& edge : creases.pattern.edges) hinges += edge.kind == EdgeKind::Hinge ? 1 : 0;
  std::string kinds;
  const auto add = [&](Assignment assignment, const char* name) {
    const std::size_t count = countOf(creases, assignment);
    if (count == 0) return;
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  };
  add(Assignment::Mountain, "mountain");
  add(Assignment::Valley, "valley");
  add(Assignment::Unassigned, "unassigned");
  add(Assignment::Flat, "flat");
  add(Assignment::Join, "join");
  add(Assignment::Cut, "cut");
  return std::to_string(creases.pattern.facets.size()) + " facets, " + std::to_string(hinges) +
         " creases" + (kinds.empty() ? "" : " (" + kinds + ")");
}

}  // namespace kiri::cli
