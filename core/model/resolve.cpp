// Writing down as places on the paper what a step left to how the model lies.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/model/apply.h"
#include "core/model/pattern_step.h"
#include "core/model/requests.h"
#include "core/paper/boxes.h"

namespace kiri {
namespace {

std::vector<Place> placesOf(const FoldedState& state, const std::vector<FacetId>& facets) {
  std::vector<Place> places;
  for (const FacetId f : facets)
    places.push_back({Frame::Paper, interiorPointOf(state.pattern, f)});
  return places;
}

/// One function for each kind of step; `after` is the state that the step led to.
class Resolving {
 public:
  Resolving(const FoldedState& state, const FoldedState& after, int number)
      : state_(state), after_(after), number_(number) {}

  void operator()(FoldStep& step) const {
    const FoldRequest request = *foldRequest(state_, step, number_);
    step.name = request.name;
    step.line = onPaper(request.line);
    step.layers = chosen(step.layers, request.layers);
    const FoldLineId line(after_.lines.size() - 1);
    for (const Edge& edge : after_.pattern.edges) {
      if (edge.kind != EdgeKind::Hinge || edge.line != line) continue;
      const FacetId mover = edge.leftMoves ? edge.left : edge.right;
      step.moving = MovingPoint{{Frame::Paper, interiorPointOf(after_.pattern, mover)}};
      break;
    }
  }

  void operator()(AngleStep& step) const { name(step.line); }
  void operator()(UnfoldStep& step) const {
    for (FoldLineName& line : step.lines) name(line);
  }
  void operator()(RefoldStep& step) const {
    for (FoldLineName& line : step.lines) name(line);
  }
  void operator()(TearStep& step) const { step.layers = chosenAlong(step.path, step.layers); }
  void operator()(MendStep& step) const { step.layers = chosenAlong(step.path, step.layers); }

  void operator()(AddEdgeStep& step) const {
    const FacetLine line = *locateLine(state_, step.line);
    step.layers = chosen(step.layers, *locateLayers(state_, step.layers, line));
    step.line = onPaper(line);
  }

  void operator()(StraightCutStep& step) const {
    const CutRequest request = *cutRequest(state_, step);
    keepPieces(step.keep);
    if (!request.facet) return;  // straight down on the model as it lies: that is the choice
    step.line = onPaper({*request.facet, request.chain.front().start, request.chain.back().end});
    step.layers = chosen(step.layers, request.layers);
  }

  void operator()(CurveCutStep& step) const {
    const CutRequest request = *cutRequest(state_, step);
    keepPieces(step.keep);
    if (!request.facet) return;
    if (step.frame == Frame::Model) {
      for (Vec2& control : step.controls) control = onPlaneOf(state_, *request.facet, control);
      step.frame = Frame::Paper;
    }
    step.facet = interiorPointOf(state_.pattern, *request.facet);
    step.layers = chosen(step.layers, request.layers);
  }

  void operator()(TurnOverStep&) const {}
  void operator()(RotateStep& step) const {
    if (!step.about) step.about = flatten(modelBoxOf(state_).middle());
  }
  void operator()(MoveStep&) const {}
  void operator()(PatternStep& step) const { nameLayers(after_, step); }

 private:
  DrawnLine onPaper(const FacetLine& line) const {
    return {Frame::Paper, line.from, line.to, interiorPointOf(state_.pattern, line.facet)};
  }

  /// All layers is a rule, not a choice that hung on the view: it stays. The rest becomes places on
  /// the sheet.
  LayerChoice chosen(const LayerChoice& choice, const std::vector<FacetId>& facets) const {
    if (std::holds_alternative<AllLayers>(choice)) return choice;
    return ChosenLayers{placesOf(state_, facets)};
  }

  LayerChoice chosenAlong(const DrawnPath& path, const LayerChoice& choice) const {
    const Result<EdgeRequest> request = edgeRequest(state_, path, choice);
    if (!request || !request->choice.ofFacets) return choice;
    return ChosenLayers{placesOf(state_, *request->choice.ofFacets)};
  }

  void name(FoldLineName& line) const {
    line = state_.lines[locateFoldLine(state_, line)->index].name;
  }

  /// Every piece that the cut left, named by a place on the sheet.
  void keepPieces(Keep& keep) const {
    if (keep.places.empty()) return;
    keep.places.clear();
    const std::vector<std::uint32_t> piece = piecesOf(after_.pattern);
    for (std::size_t f = 0; f < piece.size(); ++f) {
      if (piece[f] == keep.places.size())
        keep.places.push_back({Frame::Paper, interiorPointOf(after_.pattern, FacetId(f))});
    }
  }

  const FoldedState& state_;
  const FoldedState& after_;
  int number_;
};

}  // namespace

Result<Step> resolve(const FoldedState& state, const Step& step, int number) {
  const Result<FoldedState> after = apply(state, step, number);
  if (!after) return after.error();
  Step resolved = step;
  std::visit(Resolving(state, *after, number), resolved.action);
  return resolved;
}

}  // namespace kiri
