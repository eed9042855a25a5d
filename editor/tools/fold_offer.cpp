// SPDX-License-Identifier: MIT
#include "editor/tools/fold_offer.h"

#include <algorithm>
#include <cmath>

#include "core/fold/fold.h"
#include "editor/tools/seen_side.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

std::vector<Place> placesOf(const std::vector<Vec2>& points) {
  std::vector<Place> places;
  for (const Vec2 p : points) places.push_back({Frame::Paper, p});
  return places;
}

}  // namespace

std::optional<Spot> FoldOffer::Named::in(const FoldedState& state) const {
  const auto found = facet.in(state);
  if (!found) return std::nullopt;
  return Spot{*found, paper};
}

bool FoldOffer::isFor(const FoldedState& state) const {
  return plan_ && plan_->facetCount == state.pattern.facets.size();
}

void FoldOffer::look(const Scope& scope, const FoldPlace& place) {
  const FoldedState& state = *scope.state;
  selected_.clear();
  for (const FacetId f : facetsOf(state, scope.selection))
    selected_.push_back({f, interiorPointOf(state.pattern, f)});
  std::optional<Named> grabbed;
  if (place.grabbed) grabbed = Named{FacetName(state, place.grabbed->facet), place.grabbed->paper};
  source_ = Source{FacetName(state, place.line.facet),
                   place.line.from,
                   place.line.to,
                   place.pane,
                   grabbed,
                   place.isEndless};
  if (place.isNew) {
    const Spot middle{place.line.facet, lerp(place.line.from, place.line.to, 0.5)};
    stepType_ = turnedIf(seenType_, !seesAsSteps(state, scope.map(place.pane), middle));
    side_.reset();
    takeSelected(scope, place.line);
  }
  plan_ = planFor(scope, place);
  if (!plan_) return;
  // Ends that a step will take to be a vertex are that vertex from now on.
  const FacetLine& segment = plan_->segment;
  FoldPlace snapped = place;
  snapped.line.from = snapToVertex(state, segment.facet, segment.from);
  snapped.line.to = snapToVertex(state, segment.facet, segment.to);
  const double moved =
      std::max(distance(snapped.line.from, segment.from), distance(snapped.line.to, segment.to));
  if (moved <= state.tolerance().length()) return;
  if (distance(snapped.line.from, snapped.line.to) <= state.tolerance().pick()) return;
  if (auto plan = planFor(scope, snapped)) plan_ = std::move(plan);
}

void FoldOffer::lookAgain(const Scope& scope) {
  if (!source_) return;
  const auto facet = source_->facet.in(*scope.state);
  if (!facet) return drop();
  std::optional<Spot> grabbed;
  if (source_->grabbed) grabbed = source_->grabbed->in(*scope.state);
  look(scope,
       {{*facet, source_->from, source_->to}, source_->pane, grabbed, source_->isEndless, false});
}

/// Selected facets that the line crosses are the layers.
void FoldOffer::takeSelected(const Scope& scope, const FacetLine& line) {
  const bool isOpen =
      layers_.mode() == LayerMode::Hand || (layers_.mode() == LayerMode::Chosen && isBySelection_);
  if (selected_.empty() || !isOpen) return;
  std::vector<FacetId> crossed;
  for (const Crossed& c : crossedBy(*scope.state, line, {0, 1})) {
    const auto isIt = [&c](const Spot& spot) { return spot.facet == c.facet; };
    if (std::any_of(selected_.begin(), selected_.end(), isIt)) crossed.push_back(c.facet);
  }
  isBySelection_ = !crossed.empty();
  layers_.setMode(LayerMode::Hand);
  if (isBySelection_) layers_.choose(*scope.state, crossed);
}

std::optional<bool> FoldOffer::sideBySelection(const Scope& scope, const PartedPaper& paper) const {
  const std::vector<Vec2> points = scope.selection.placesOf(SelectedKind::Point);
  if (!points.empty()) {
    const auto facet = facetAt(scope.state->pattern, points.back());
    const int side = facet ? paper.sideOf({*facet, points.back()}) : 0;
    if (side != 0) return side > 0;
  }
  const std::vector<FacetId>& taken = layers_.taken();
  for (const Spot& spot : selected_) {
    if (std::find(taken.begin(), taken.end(), spot.facet) != taken.end()) continue;
    const int side = paper.sideOf(spot);
    if (side != 0) return side > 0;
  }
  return std::nullopt;
}

bool FoldOffer::smallerIsLeft(const Scope& scope, const FoldPlace& place,
                              const PartedPaper& paper) {
  Reach reaches[2];
  for (const bool left : {false, true}) {
    LayerPicker layers = layers_;
    layers.look(scope, place.line, std::nullopt, place.pane, {paper, left, place.isEndless});
    reaches[left] = paper.reachOf(paper.piecesAlong(layers.taken(), left, layers.stretch()), left);
  }
  if (reaches[0].isFree != reaches[1].isFree) return reaches[1].isFree;
  return reaches[1].area <= reaches[0].area + scope.state->tolerance().match();
}

bool FoldOffer::chooseSide(const Scope& scope, const FoldPlace& place, const PartedPaper& paper) {
  if (side_) {
    const auto spot = side_->in(*scope.state);
    const int side = spot ? paper.sideOf(*spot) : 0;
    if (side != 0) return side > 0;
  }
  if (place.grabbed) {
    const int side = paper.sideOf(*place.grabbed);
    if (side != 0) return (side > 0) != isTurnedByHand_;
  }
  if (const auto side = sideBySelection(scope, paper)) return *side != isTurnedByHand_;
  return smallerIsLeft(scope, place, paper) != isTurnedByHand_;
}

std::vector<Vec2> FoldOffer::selectedMovers(const Plan& plan, const PartedPaper& paper) const {
  std::vector<Vec2> movers;
  for (const Spot& spot : selected_) {
    const bool isTaken =
        std::find(plan.taken.begin(), plan.taken.end(), spot.facet) != plan.taken.end();
    if (!isTaken && paper.sideOf(spot) == (plan.leftMoves ? 1 : -1)) movers.push_back(spot.paper);
  }
  return movers;
}

std::optional<FoldOffer::Plan> FoldOffer::planFor(const Scope& scope, const FoldPlace& place) {
  const FoldedState& state = *scope.state;
  if (distance(place.line.from, place.line.to) <= state.tolerance().pick()) return std::nullopt;
  const PartedPaper paper(state, place.line);
  Plan plan;
  plan.facetCount = state.pattern.facets.size();
  plan.leftMoves = chooseSide(scope, place, paper);
  const bool isGrabbedSide =
      place.grabbed && paper.sideOf(*place.grabbed) == (plan.leftMoves ? 1 : -1);
  layers_.look(scope, place.line, isGrabbedSide ? place.grabbed : std::nullopt, place.pane,
               {paper, plan.leftMoves, place.isEndless});
  plan.taken = layers_.taken();
  std::sort(plan.taken.begin(), plan.taken.end());
  // Paper that is dragged so far that its crease would lie beside it.
  if (plan.taken.empty() && place.isEndless && layers_.mode() == LayerMode::Hand)
    return std::nullopt;
  Stretch stretch = layers_.stretch();
  const Reach reach =
      paper.reachOf(paper.piecesAlong(plan.taken, plan.leftMoves, stretch), plan.leftMoves);
  std::set_difference(reach.layers.begin(), reach.layers.end(), plan.taken.begin(),
                      plan.taken.end(), std::back_inserter(plan.missing));
  if (plan.missing.empty() && !reach.layers.empty() && layers_.mode() == LayerMode::Chosen) {
    stretch = {std::min(stretch.from, reach.stretch.from), std::max(stretch.to, reach.stretch.to)};
  }
  if (!reach.isFree) plan.missing.clear();
  plan.segment = partOf(place.line, stretch);
  plan.line = {Frame::Paper, plan.segment.from, plan.segment.to,
               interiorPointOf(state.pattern, place.line.facet)};
  plan.layers = layers_.choice(state);
  plan.rims = reach.rims;
  if (reach.layers.empty()) {
    plan.moving = plan.leftMoves ? Hand::Left : Hand::Right;
  } else {
    plan.mover = isGrabbedSide ? *place.grabbed : reach.inside;
    plan.moving = MovingPoint{{Frame::Paper, reach.inside.paper}};
    if (!place.isNew && !side_)
      side_ = Named{FacetName(state, reach.inside.facet), reach.inside.paper};
  }
  const std::vector<Vec2> movers = selectedMovers(plan, paper);
  if (!movers.empty()) plan.moving = MovingFacets{placesOf(movers)};
  for (const Crossed& c : crossedBy(state, place.line, stretch)) {
    if (std::find(plan.taken.begin(), plan.taken.end(), c.facet) == plan.taken.end()) continue;
    const FacetLine chord = lineOn(state, partOf(place.line, c.stretch), c.facet);
    plan.creases.push_back({{c.facet, chord.from}, {c.facet, chord.to}});
  }
  return plan;
}

void FoldOffer::setType(FoldType asSeen, const Scope& scope) {
  seenType_ = asSeen;
  stepType_ = turnedIf(asSeen, isTurned(scope));
}

bool FoldOffer::isTurned(const Scope& scope) const {
  if (!source_) return false;
  const auto facet = source_->facet.in(*scope.state);
  const Vec2 middle = lerp(source_->from, source_->to, 0.5);
  return facet && !seesAsSteps(*scope.state, scope.map(source_->pane), {*facet, middle});
}

void FoldOffer::turnSide(const Scope& scope) {
  if (!source_ || !plan_) return;
  const auto facet = source_->facet.in(*scope.state);
  if (!facet) return;
  isTurnedByHand_ = !isTurnedByHand_;
  const FacetLine line{*facet, source_->from, source_->to};
  const PartedPaper paper(*scope.state, line);
  const bool left = !plan_->leftMoves;
  LayerPicker layers = layers_;
  layers.look(scope, line, std::nullopt, source_->pane, {paper, left, source_->isEndless});
  const Reach reach =
      paper.reachOf(paper.piecesAlong(layers.taken(), left, layers.stretch()), left);
  side_.reset();
  if (!reach.layers.empty())
    side_ = Named{FacetName(*scope.state, reach.inside.facet), reach.inside.paper};
  lookAgain(scope);
}

bool FoldOffer::pressLayers(const PointerEvent& event, const Scope& scope) {
  if (!isFor(*scope.state)) return false;
  auto facet = fan_.cardUnder(event, scope, plan_->segment, source_->pane);
  if (!facet && !event.modifiers.control) return false;
  if (!facet) {
    const auto pick = pickPaper(*scope.state, scope.map(event.pane), event.at);
    if (!pick) return true;
    facet = pick->spot.facet;
  }
  isBySelection_ = false;
  layers_.toggle(*scope.state, *facet);
  lookAgain(scope);
  return true;
}

void FoldOffer::hoverLayers(const PointerEvent& event, const Scope& scope) {
  if (isFor(*scope.state)) fan_.hover(event, scope, plan_->segment, source_->pane);
}

std::optional<FacetLine> FoldOffer::segment(const FoldedState& state) const {
  if (!isFor(state)) return std::nullopt;
  return plan_->segment;
}

std::optional<FoldStep> FoldOffer::step() const {
  if (!plan_) return std::nullopt;
  return FoldStep{name_, plan_->line, stepType_, angle_, plan_->layers, plan_->moving};
}

MarkRole FoldOffer::role(const Scope& scope) const {
  return turnedIf(stepType_, isTurned(scope)) == FoldType::Valley ? MarkRole::Valley
                                                                  : MarkRole::Mountain;
}

}  // namespace kiri
