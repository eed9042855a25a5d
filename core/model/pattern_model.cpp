// SPDX-License-Identifier: MIT
#include "core/model/pattern_model.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/creases/repair.h"
#include "core/flatfold/polish.h"
#include "core/layers/merge_orders.h"
#include "core/layers/plane_view.h"
#include "core/model/facet_finder.h"
#include "core/model/pattern_layers.h"
#include "core/model/pattern_order.h"
#include "core/model/pattern_sheet.h"
#include "core/model/pattern_step.h"
#include "core/paper/boxes.h"

namespace kiri {
namespace {

/// One pattern on its way to be a model.
class ModelMaking {
 public:
  ModelMaking(const AssignedPattern& creases, const PatternModelOptions& options,
              const Progress& progress)
      : creases_(creases), options_(options), progress_(progress) {}

  Result<PatternModel> run() {
    if (const Status drawn = straighten(); !drawn) return drawn.error();
    takeLargestPiece();
    scale();
    if (options_.isFolded) {
      if (const Status exact = polish(); !exact) return exact.error();
    }
    Model& model = made_.model;
    model.title = options_.title;
    model.opening = Sequence::Together;
    model.sheet = sheetOfOutline(creases_.pattern);
    const Result<Sheet> sheet = makeSheet(model.sheet);
    if (!sheet) return sheet.error();
    sheet_ = flatState(*sheet);
    PatternStep step = stepOfCreases(creases_);
    if (step.creases.empty()) {
      made_.notes.push_back("the pattern has no creases; the model is the untouched sheet");
      return std::move(made_);
    }
    step.isFolded = options_.isFolded && !isTooRough_;
    return withStep(std::move(step));
  }

 private:
  /// Curves become polylines.
  Status straighten() {
    const std::size_t curves = creases_.pattern.curves.size();
    if (curves == 0) return std::monostate{};
    Result<RepairedPattern> straight = patternOf(drawingOf(creases_), {}, progress_);
    if (!straight) return straight.error();
    creases_ = std::move(straight->creases);
    made_.notes.push_back("curved edges became polylines: " + std::to_string(curves));
    return std::monostate{};
  }

  void takeLargestPiece() {
    LargestPiece piece = largestPieceOf(creases_);
    if (piece.dropped == 0) return;
    creases_ = std::move(piece.creases);
    isWhole_ = false;
    made_.notes.push_back(
        "the paper is in " + std::to_string(piece.dropped + 1) +
        " pieces that do not touch; the model is the largest, the others were left out");
  }

  void scale() {
    if (options_.longestSide <= 0) return;
    const Box box = paperBoxOf(creases_.pattern);
    const double longest = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    scale_ = options_.longestSide / longest;
    for (Vec2& v : creases_.pattern.vertices) v = v * scale_;
    creases_.pattern.tolerance = Tolerance(creases_.pattern.tolerance.sheetSize() * scale_);
  }

  /// Drawings are precise to some digits; the kernel needs more.
  Status polish() {
    if (!isMeantFlat(creases_)) return std::monostate{};
    Result<Polished> fine = polished(creases_, progress_);
    if (!fine && fine.error().code == ErrorCode::Cancelled) return fine.error();
    if (!fine) {
      isTooRough_ = true;
      made_.notes.push_back("the model is flat, with its creases: " + fine.error().message);
      return std::monostate{};
    }
    if (fine->farthest > 0) {
      made_.notes.push_back(
          "the drawing folds flat only roughly; its vertices were moved by up to " +
          text(fine->farthest) + " mm to make it exact");
    }
    creases_ = std::move(fine->creases);
    return std::monostate{};
  }

  Result<PatternModel> withStep(PatternStep step) {
    if (step.isFolded && options_.chosen && isWhole_) takeChosen(step);
    PatternRequest request{true, options_.orders, progress_};
    for (DrawnOrder& order : request.orders) {
      order.upper = order.upper * scale_;
      order.lower = order.lower * scale_;
    }
    Result<PatternOutcome> outcome = foldPattern(*sheet_, step, request);
    if (!outcome && outcome.error().code == ErrorCode::Cancelled) return outcome.error();
    if (!outcome && step.isFolded) {
      made_.notes.push_back("the model is flat, with its creases: " + outcome.error().message);
      step.isFolded = false;
      step.layers.clear();
      step.exceptions.clear();
      outcome = foldPattern(*sheet_, step, {});
    }
    if (!outcome) return outcome.error();
    nameLayers(outcome->state, step);
    Step whole{std::move(step), "", "", ""};
    made_.way = outcome->way;
    if (outcome->refused)
      made_.notes.push_back("the layer order of the file was not taken: " + *outcome->refused);
    if (made_.way) whole.notes = sentenceOf(*made_.way);
    if (!whole.notes.empty()) made_.notes.push_back(whole.notes);
    for (const Collision& collision : outcome->state.collisions)
      made_.notes.push_back(collision.message);
    made_.model.steps.push_back(std::move(whole));
    return std::move(made_);
  }

  /// The order of the state that was chosen. Its places are those before scaling.
  void takeChosen(PatternStep& step) const {
    writeLayers(*options_.chosen, step);
    for (Vec2& p : step.layers) p = p * scale_;
    for (auto& [upper, lower] : step.exceptions) {
      upper = upper * scale_;
      lower = lower * scale_;
    }
    const FoldedState& chosen = *options_.chosen;
    step.resting = namingPointOf(chosen.pattern, chosen.rests.front().facet) * scale_;
  }

  AssignedPattern creases_;
  const PatternModelOptions& options_;
  Progress progress_;
  PatternModel made_;
  std::optional<FoldedState> sheet_;
  double scale_ = 1;
  bool isWhole_ = true;
  bool isTooRough_ = false;
};

}  // namespace

Result<PatternModel> modelOf(const AssignedPattern& creases, const PatternModelOptions& options,
                             const Progress& progress) {
  return ModelMaking(creases, options, progress).run();
}

FoldedState asFolded(const FoldedState& state) {
  FoldedState out = state;
  std::vector<Edge>& edges = out.pattern.edges;
  const bool isFolded = std::any_of(edges.begin(), edges.end(), [](const Edge& edge) {
    return edge.kind == EdgeKind::Hinge && std::abs(edge.angle) == 180;
  });
  if (isFolded) return out;
  for (Edge& edge : edges) {
    if (edge.kind == EdgeKind::Hinge && edge.line.isValid() && edge.angle == 0)
      edge.angle = edge.sign * out.lines[edge.line.index].foldedAmount;
  }
  return out;
}

AssignedPattern assignedPatternOf(const FoldedState& state, bool isAsFolded) {
  AssignedPattern creases(isAsFolded ? asFolded(state).pattern : state.pattern);
  for (const Edge& edge : creases.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) {
      creases.assignments.push_back(edge.kind == EdgeKind::Border ? Assignment::Border
                                                                  : Assignment::Cut);
      continue;
    }
    creases.assignments.push_back(edge.angle > 0   ? Assignment::Valley
                                  : edge.angle < 0 ? Assignment::Mountain
                                                   : Assignment::Flat);
  }
  return creases;
}

std::vector<DrawnOrder> drawnOrdersOf(const FoldedState& state) {
  std::vector<Vec2> names;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f)
    names.push_back(namingPointOf(state.pattern, FacetId(f)));
  std::vector<DrawnOrder> orders;
  for (const LayerSet& set : state.layers.sets()) {
    PlaneView view(state.pattern, state.poses, state.poseOf(set.upward.front()));
    for (const AbovePair& pair : relationsWithin(set, view)) {
      const bool isFront = dot(set.normal, state.poseOf(pair.lower).normal()) > 0;
      orders.push_back({names[pair.upper.index], names[pair.lower.index], isFront});
    }
  }
  return orders;
}

}  // namespace kiri
