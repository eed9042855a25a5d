// SPDX-License-Identifier: MIT
#include "editor/tools/fold_tool.h"

#include <algorithm>

#include "editor/snap/snap_dragged.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// Pixels beside the paper that still count as its corner.
constexpr double kBeside = 5;

/// The paper under the pointer, at the snapped place if that is on the same piece of paper.
std::optional<Snapped> paperToTake(const Scope& scope, const PointerEvent& event) {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  const auto pick = pickPaper(state, map, event.at);
  if (!pick) {
    // Nobody meets a corner to the pixel: just beside it is meant as the corner.
    const auto corner = scope.snaps.isOn ? pickVertex(state, map, event.at, kBeside) : std::nullopt;
    if (!corner) return std::nullopt;
    return Snapped{corner->spot, SnapKind::Vertex, {}, {}};
  }
  Snapped taken{pick->spot, SnapKind::None, {}, {}};
  auto snapped = snapPoint(state, map, event.at, scope.snaps);
  if (!snapped) return taken;
  const auto here = carried(state, map, snapped->spot, pick->spot.facet);
  const Region paper = regionOf(state.pattern, pick->spot.facet);
  if (!here || locate(paper, *here, state.tolerance().match()) == Where::Outside) return taken;
  snapped->spot = {pick->spot.facet, *here};
  return snapped;
}

/// The straight edge of the facet that a place lies on, not at its ends.
std::optional<Line2> edgeAt(const FoldedState& state, const Spot& spot) {
  const double tol = state.tolerance().match();
  for (const EdgeUse use : state.pattern[spot.facet].border) {
    if (state.pattern[use.edge].isCurved()) continue;
    const Vec2 a = state.pattern[startOf(state.pattern, use)];
    const Vec2 b = state.pattern[endOf(state.pattern, use)];
    const Vec2 along = normalized(b - a);
    const double t = dot(spot.paper - a, along);
    const bool isOn =
        std::abs(cross(along, spot.paper - a)) <= tol && t > tol && t < distance(a, b) - tol;
    if (isOn) return Line2{a, b};
  }
  return std::nullopt;
}

}  // namespace

void FoldTool::reset() { *this = FoldTool(); }

bool FoldTool::isBusy() const { return phase_ != Phase::Idle || pressed_.has_value(); }

Reaction FoldTool::pointer(const PointerEvent& event, const Scope& scope) {
  switch (event.action) {
    case PointerAction::Press:
      return event.button == PointerButton::Left ? press(event, scope) : Reaction::ignored();
    case PointerAction::Move:
      return move(event, scope);
    case PointerAction::Release:
      return event.button == PointerButton::Left ? release(event, scope) : Reaction::ignored();
    case PointerAction::DoubleClick:
      pressed_.reset();
      if (phase_ != Phase::Resting || !hasOffer()) return Reaction::ignored();
      return {.isHandled = true, .wantsCommit = true};
    case PointerAction::Leave:
      caught_.clear();
      return Reaction::ignored();
  }
  return Reaction::ignored();
}

Reaction FoldTool::press(const PointerEvent& event, const Scope& scope) {
  caught_.clear();
  if (phase_ == Phase::Resting && !event.modifiers.control && event.pane == pane_) {
    const auto held = heldAt(scope.map(pane_), *scope.state);
    if (held && distance(*held, event.at) <= handleReach(event)) {
      phase_ = Phase::Grabbing;
      return Reaction::handled();
    }
    if (line_.takeHandle(event, scope)) return Reaction::handled();
  }
  if (phase_ == Phase::Resting && offer_.pressLayers(event, scope)) return Reaction::handled();
  pressed_ = event;
  return Reaction::handled();
}

Reaction FoldTool::move(const PointerEvent& event, const Scope& scope) {
  if (pressed_) {
    if (distance(event.at, pressed_->at) < kDragBegins) return Reaction::handled();
    startAnew(scope);
  }
  if (phase_ == Phase::Grabbing) {
    if (event.pane == pane_) dragPaper(event, scope);
    return Reaction::handled();
  }
  if (line_.isMoving()) {
    if (line_.follow(event, scope)) lookAtLine(scope, phase_ == Phase::Drawing);
    return Reaction::handled();
  }
  hover(event, scope);
  return Reaction::ignored();
}

Reaction FoldTool::release(const PointerEvent& event, const Scope& scope) {
  if (pressed_) {
    pressed_.reset();
    return Reaction::handled();
  }
  if (phase_ == Phase::Grabbing) {
    if (event.pane == pane_) dragPaper(event, scope);
    rest(scope);
    return Reaction::handled();
  }
  if (!line_.isMoving()) return Reaction::ignored();
  PointerEvent last = event;
  last.pane = pane_;
  line_.follow(last, scope);
  lookAtLine(scope, phase_ == Phase::Drawing);
  rest(scope);
  return Reaction::handled();
}

void FoldTool::startAnew(const Scope& scope) {
  const PointerEvent press = *pressed_;
  reset();
  pane_ = press.pane;
  if (takesPaper(press, scope)) {
    phase_ = Phase::Grabbing;
  } else {
    phase_ = Phase::Drawing;
    line_.begin(press, scope);
  }
}

bool FoldTool::takesPaper(const PointerEvent& event, const Scope& scope) {
  const auto taken = paperToTake(scope, event);
  if (!taken) return false;
  grab_ = Grab{FacetName(*scope.state, taken->spot.facet), taken->spot.paper, std::nullopt,
               taken->spot.paper};
  if (taken->kind == SnapKind::Edge) grab_->edge = edgeAt(*scope.state, taken->spot);
  return true;
}

/// Shift takes all layers, Alt the uppermost; without them it is as before.
void FoldTool::modifyLayers(const Modifiers& modifiers) {
  LayerPicker& layers = offer_.layers();
  const bool isHeld = modifiers.shift || modifiers.alt;
  if (isHeld && !isModeHeld_) modeBefore_ = layers.mode();
  if (isHeld && modifiers.shift) layers.setMode(LayerMode::All);
  if (isHeld && !modifiers.shift) layers.setCount(1);
  if (!isHeld && isModeHeld_) layers.setMode(modeBefore_);
  isModeHeld_ = isHeld;
}

void FoldTool::dragPaper(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const auto facet = grab_->facet.in(state);
  if (!facet) return reset();
  modifyLayers(event.modifiers);
  opening_.reset();
  if (pane_ == Pane::Model) opening_ = openingUnder(scope, {*facet, grab_->from}, event.at);
  if (opening_) {
    caught_.clear();
    grab_->to = opening_->place;
    offer_.drop();
    return line_.reset();
  }
  const auto onto =
      snapDragged(state, scope.map(pane_), event.at, scope.snaps, *facet, grab_->from);
  if (!onto) return;
  caught_ = onto->marks;
  grab_->to = onto->spot.paper;
  if (grab_->edge && onto->kind == SnapKind::Edge) {
    if (const auto to = edgeOntoEdge(scope, event.at, onto->spot)) grab_->to = *to;
  }
  const Vec2 way = grab_->to - grab_->from;
  if (length(way) <= state.tolerance().pick()) {
    offer_.drop();
    line_.reset();
    return;
  }
  const Vec2 middle = lerp(grab_->from, grab_->to, 0.5);
  const Vec2 along = normalized(perpendicular(way)) * state.tolerance().sheetSize();
  offer_.look(
      scope,
      {{*facet, middle - along, middle + along}, pane_, Spot{*facet, grab_->from}, true, true});
  if (const auto segment = offer_.segment(state)) line_.set(state, *segment, pane_);
}

/// An edge dragged to another edge is laid along it, when that leaves the held place near the
/// pointer.
std::optional<Vec2> FoldTool::edgeOntoEdge(const Scope& scope, Vec2 pixels,
                                           const Spot& onto) const {
  const FoldedState& state = *scope.state;
  const double tol = state.tolerance().match();
  std::optional<Vec2> best;
  double nearest = 2 * scope.snaps.radius;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(onto.facet)].upward) {
    const auto there = carried(state, scope.map(pane_), onto, f);
    const auto edge = there ? edgeAt(state, {f, *there}) : std::nullopt;
    if (!edge) continue;
    const auto from = carried(state, scope.map(pane_), {f, edge->from}, onto.facet);
    const auto to = carried(state, scope.map(pane_), {f, edge->to}, onto.facet);
    if (!from || !to) continue;
    for (const Line2& line : lineOntoLine(*grab_->edge, {*from, *to}, tol)) {
      const Vec2 image = mirrored(grab_->from, line);
      const double away = distance(scope.map(pane_).toPixels(state, {onto.facet, image}), pixels);
      if (away >= nearest || distance(image, grab_->from) <= tol) continue;
      nearest = away;
      best = image;
    }
  }
  return best;
}

void FoldTool::lookAtLine(const Scope& scope, bool isNew) {
  const auto line = line_.on(*scope.state);
  if (!line) return offer_.drop();
  std::optional<Spot> grabbed;
  if (grab_) {
    if (const auto facet = grab_->facet.in(*scope.state)) grabbed = Spot{*facet, grab_->from};
    // The paper in the hand is elsewhere than the pointer from now on.
    grab_->to = grab_->from;
  }
  offer_.look(scope, {*line, pane_, grabbed, grab_.has_value(), isNew});
}

void FoldTool::rest(const Scope& scope) {
  caught_.clear();
  if (!opening_) offer_.lookAgain(scope);
  if (!hasOffer()) return reset();
  phase_ = Phase::Resting;
  const auto segment = offer_.segment(*scope.state);
  if (grab_ && segment) line_.set(*scope.state, *segment, pane_);
}

std::optional<Vec2> FoldTool::heldAt(const PaneMap& map, const FoldedState& state) const {
  if (!grab_ || grab_->to == grab_->from) return std::nullopt;
  const auto facet = grab_->facet.in(state);
  if (!facet) return std::nullopt;
  return map.toPixels(state, {*facet, grab_->to});
}

void FoldTool::hover(const PointerEvent& event, const Scope& scope) {
  caught_.clear();
  offer_.hoverLayers(event, scope);
  const PaneMap& map = scope.map(event.pane);
  cursor_ = CursorShape::Cross;
  if (!pickPaper(*scope.state, map, event.at)) return;
  cursor_ = CursorShape::Hand;
  if (phase_ != Phase::Idle) return;
  if (const auto taken = paperToTake(scope, event)) caught_ = taken->marks;
}

Reaction FoldTool::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress || !isBusy()) return Reaction::ignored();
  if (event.key == Key::Escape) {
    reset();
    return Reaction::handled();
  }
  if (event.key == Key::Enter) {
    if (phase_ != Phase::Resting || line_.isMoving() || !hasOffer()) return Reaction::ignored();
    return {.isHandled = true, .wantsCommit = true};
  }
  return offer_.key(event, scope) ? Reaction::handled() : Reaction::ignored();
}

Reaction FoldTool::wheel(const WheelEvent& event, const Scope& scope) {
  return offer_.wheel(event, scope) ? Reaction::handled() : Reaction::ignored();
}

std::optional<Proposal> FoldTool::proposal(const Scope&) const {
  const bool isComplete = phase_ == Phase::Resting && !line_.isMoving();
  if (opening_) return Proposal{{AngleStep{opening_->line, 0}, {}, {}, {}}, isComplete};
  const auto step = offer_.step();
  if (!step) return std::nullopt;
  return Proposal{{*step, {}, {}, {}}, isComplete};
}

Marks FoldTool::marks(const Scope& scope) const {
  Marks marks;
  if (phase_ != Phase::Idle) {
    line_.addMarks(scope, MarkRole::Line, marks);
    offer_.addMarks(scope, marks);
  }
  addOpening(scope, marks);
  if (const auto held = heldAt(scope.map(pane_), *scope.state)) {
    const MarkRole role = phase_ == Phase::Grabbing ? MarkRole::ActiveHandle : MarkRole::Handle;
    marks.push_back(PointMark{role, PixelPlace{pane_, *held}});
  }
  marks.insert(marks.end(), caught_.begin(), caught_.end());
  return marks;
}

void FoldTool::addOpening(const Scope& scope, Marks& marks) const {
  const auto facet = opening_ && grab_ ? grab_->facet.in(*scope.state) : std::nullopt;
  if (!facet) return;
  marks.push_back(PathMark{MarkRole::Selected,
                           {Spot{*facet, opening_->from}, Spot{*facet, opening_->to}},
                           false,
                           false});
  const Vec3 at = scope.state->poseOf(*facet).apply(opening_->place);
  marks.push_back(PointMark{MarkRole::Snap, at});
  marks.push_back(
      TextMark{MarkRole::Snap, at, {KIRI_TEXT("editor/tools", "opens \"%1\""), {opening_->line}}});
}

std::vector<TintedFacet> FoldTool::tints(const Scope& scope) const { return offer_.tints(scope); }

std::vector<Field> FoldTool::fields(const Scope& scope) const {
  std::vector<Field> fields;
  offer_.addFields(scope, fields);
  if (offer_.isThere() && !grab_) line_.addFields(fields);
  return fields;
}

Reaction FoldTool::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  if (!offer_.isThere()) return Reaction::ignored();
  if (offer_.setField(id, value, scope)) return Reaction::handled();
  if (grab_ || !line_.setField(id, value)) return Reaction::ignored();
  lookAtLine(scope, false);
  return Reaction::handled();
}

Phrase FoldTool::hint(const Scope& scope) const {
  if (phase_ == Phase::Grabbing) {
    return {KIRI_TEXT("editor/tools",
                      "Release where the paper is to lie; Shift takes all layers, Alt the top one, "
                      "Ctrl and the wheel more or fewer"),
            {}};
  }
  if (phase_ == Phase::Drawing)
    return {KIRI_TEXT("editor/tools", "Draw the line right across the paper, then release"), {}};
  if (phase_ == Phase::Resting && opening_)
    return {KIRI_TEXT("editor/tools", "Enter opens the fold again, Esc leaves it"), {}};
  if (phase_ == Phase::Resting) {
    if (const std::optional<Phrase> trouble = offer_.trouble(scope)) return *trouble;
    return {KIRI_TEXT("editor/tools",
                      "Enter folds, Esc drops it; V valley, M mountain, Tab the other side, drag "
                      "the handles"),
            {}};
  }
  return {KIRI_TEXT("editor/tools",
                    "Drag a corner, an edge or any paper to fold it over; press beside the paper "
                    "to draw a fold line across"),
          {}};
}

CursorShape FoldTool::cursor(const Scope&) const {
  if (phase_ == Phase::Grabbing) return CursorShape::ClosedHand;
  if (phase_ == Phase::Drawing) return CursorShape::Cross;
  return cursor_;
}

}  // namespace kiri
