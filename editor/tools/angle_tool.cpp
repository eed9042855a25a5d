// SPDX-License-Identifier: MIT
#include "editor/tools/angle_tool.h"

#include <algorithm>
#include <cmath>

#include "core/fold/fold_line.h"
#include "editor/tools/drawn_line.h"
#include "editor/tools/tool_fields.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// Pulling the paper by so many pixels across the crease turns it from half open to flat.
constexpr double kReach = 90;
/// Whole degrees, and the steps of a dial where the hand is near one.
constexpr double kStep = 15;
constexpr double kNearStep = 3;

bool isFoldLine(const Edge& edge) { return edge.kind == EdgeKind::Hinge && edge.line.isValid(); }

std::optional<FoldLineId> lineNamed(const FoldedState& state, const std::string& name) {
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    if (state.lines[i].name == name) return FoldLineId(i);
  }
  return std::nullopt;
}

/// The hinge of a fold line that runs through a place of the paper.
std::optional<EdgeId> hingeAt(const FoldedState& state, FoldLineId line, Vec2 place) {
  std::optional<EdgeId> best;
  double nearest = 0;
  for (const EdgeId e : hingesOf(state, line)) {
    const double away = nearestOn(arcOf(state.pattern, e), place).distance;
    if (best && away >= nearest) continue;
    best = e;
    nearest = away;
  }
  return best;
}

/// How the dial stands at a hinge: what rests, the direction of the flat sheet beyond the crease,
/// and the axis about which the fold's own direction turns.
struct Dial {
  FacetId resting;
  Vec3 flat;
  Vec3 axis;
};

Dial dialOf(const FoldedState& state, const Edge& edge) {
  const FacetId resting = edge.leftMoves ? edge.right : edge.left;
  const Vec2 along = normalized(state.pattern[edge.to] - state.pattern[edge.from]);
  const Vec2 outward = edge.leftMoves ? perpendicular(along) : -perpendicular(along);
  const Rigid& pose = state.poseOf(resting);
  const Vec3 flat = pose.direction(outward);
  return {resting, flat, cross(flat, pose.normal()) * static_cast<double>(edge.sign)};
}

double atStep(double degrees, bool snaps) {
  const double step = std::round(degrees / kStep) * kStep;
  if (snaps && std::abs(step - degrees) <= kNearStep) return step;
  return std::round(degrees);
}

}  // namespace

void AngleTool::reset() {
  chosen_.reset();
  hovered_.clear();
}

std::optional<EdgeId> AngleTool::creaseUnder(const PointerEvent& event, const Scope& scope) const {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  const double reach = handleReach(event);
  const auto pick = pickEdge(state, map, event.at, reach);
  if (pick && isFoldLine(state.pattern[pick->edge])) return pick->edge;
  // A crease may lie under other paper of its own fold.
  std::optional<EdgeId> best;
  double nearest = reach;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (!isFoldLine(edge)) continue;
    const Arc seen = Arc::line(map.toPixels(state, {edge.left, state.pattern[edge.from]}),
                               map.toPixels(state, {edge.left, state.pattern[edge.to]}));
    const double away = nearestOn(seen, event.at).distance;
    if (!(away < nearest)) continue;
    nearest = away;
    best = EdgeId(e);
  }
  return best;
}

bool AngleTool::choose(const Scope& scope, const std::string& name, Vec2 place) {
  const FoldedState& state = *scope.state;
  const auto line = lineNamed(state, name);
  const auto hinge = line ? hingeAt(state, *line, place) : std::nullopt;
  if (!hinge) return false;
  const Edge& edge = state.pattern[*hinge];
  const double amount = amountOf(state, *line).value_or(edge.sign * edge.angle);
  const Arc arc = arcOf(state.pattern, *hinge);
  const Vec2 on = pointAt(arc, nearestOn(arc, place).t);
  chosen_ = Chosen{name, on, amount, amount};
  return true;
}

Reaction AngleTool::pointer(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const bool isLeft = event.button == PointerButton::Left;
  if (event.action == PointerAction::Press && isLeft) {
    const auto crease = creaseUnder(event, scope);
    if (!crease) return Reaction::ignored();
    const Edge& edge = state.pattern[*crease];
    const std::string& name = state.lines[edge.line.index].name;
    const PaneMap& map = scope.map(event.pane);
    const Vec2 from = map.toPixels(state, {edge.left, state.pattern[edge.from]});
    const Vec2 to = map.toPixels(state, {edge.left, state.pattern[edge.to]});
    const double t = nearestOn(Arc::line(from, to), event.at).t;
    const bool isSame = chosen_ && chosen_->line == name;
    const double amount = isSame ? chosen_->amount : 0;
    if (!choose(scope, name, lerp(state.pattern[edge.from], state.pattern[edge.to], t)))
      return Reaction::ignored();
    if (isSame) chosen_->amount = amount;
    chosen_->pane = event.pane;
    chosen_->pressedAt = event.at;
    chosen_->pressedAmount = chosen_->amount;
    return Reaction::handled();
  }
  if (event.action == PointerAction::Move && chosen_ && chosen_->isHeld) {
    turn(event, scope);
    return Reaction::handled();
  }
  if (event.action == PointerAction::Release && isLeft && chosen_ && chosen_->isHeld) {
    turn(event, scope);
    if (chosen_) chosen_->isHeld = false;
    return Reaction::handled();
  }
  if (event.action == PointerAction::DoubleClick && chosen_ && proposal(scope))
    return {.isHandled = true, .wantsCommit = true};
  if (event.action == PointerAction::Leave) hovered_.clear();
  if (event.action == PointerAction::Move) {
    const auto crease = creaseUnder(event, scope);
    hovered_ = crease ? state.lines[state.pattern[*crease].line.index].name : std::string();
  }
  return Reaction::ignored();
}

/// The hand pulls the moving paper: towards the place where it lay flat it opens, across the crease
/// it closes.
void AngleTool::turn(const PointerEvent& event, const Scope& scope) {
  const FoldedState& state = *scope.state;
  const auto line = lineNamed(state, chosen_->line);
  const auto hinge = line ? hingeAt(state, *line, chosen_->place) : std::nullopt;
  if (!hinge || event.pane != chosen_->pane) return;
  const Dial dial = dialOf(state, state.pattern[*hinge]);
  const PaneMap& map = scope.map(event.pane);
  const Vec3 at = map.placeOf(state, {dial.resting, chosen_->place});
  const Rigid shown = map.poseOf(state, dial.resting);
  const Vec3 flat = shown.direction(Vec3{dot(dial.flat, state.poseOf(dial.resting).x),
                                         dot(dial.flat, state.poseOf(dial.resting).y), 0});
  const Vec2 seen = map.toPixels(at + flat) - map.toPixels(at);
  const Vec2 way = event.at - chosen_->pressedAt;
  const bool isEdgeOn = length(seen) * 8 < map.pixelsPerMm;
  const double pulled = isEdgeOn ? way.y : dot(way, normalized(seen));
  const double sign = chosen_->pressedAmount < 0 ? -1 : 1;
  const CosSin before = cosSinDegrees(chosen_->pressedAmount);
  if (std::abs(pulled) < 1) return;
  const double cosine = std::clamp(before.cos + pulled / kReach, -1.0, 1.0);
  const double degrees = angleDegrees(cosine, std::sqrt(1 - cosine * cosine));
  chosen_->amount = sign * atStep(degrees, scope.snaps.isOn);
}

Reaction AngleTool::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress || !chosen_) return Reaction::ignored();
  if (event.key == Key::Escape) {
    reset();
    return Reaction::handled();
  }
  if (event.key == Key::Enter && proposal(scope) && !chosen_->isHeld)
    return {.isHandled = true, .wantsCommit = true};
  const double step = event.modifiers.shift ? 1 : kStep;
  const bool isUp = event.key == Key::Up || event.key == Key::Right;
  const bool isDown = event.key == Key::Down || event.key == Key::Left;
  if (!isUp && !isDown) return Reaction::ignored();
  chosen_->amount = std::clamp(chosen_->amount + (isUp ? step : -step), -180.0, 180.0);
  return Reaction::handled();
}

std::optional<Proposal> AngleTool::proposal(const Scope& scope) const {
  if (!chosen_ || !lineNamed(*scope.state, chosen_->line)) return std::nullopt;
  if (std::abs(chosen_->amount - chosen_->before) <= kSameAngle) return std::nullopt;
  return Proposal{{AngleStep{chosen_->line, chosen_->amount}, {}, {}, {}}, !chosen_->isHeld};
}

void AngleTool::addDial(const Scope& scope, Marks& marks) const {
  const FoldedState& state = *scope.state;
  const auto line = lineNamed(state, chosen_->line);
  const auto hinge = line ? hingeAt(state, *line, chosen_->place) : std::nullopt;
  if (!hinge) return;
  const Dial dial = dialOf(state, state.pattern[*hinge]);
  const Spot at{dial.resting, chosen_->place};
  marks.push_back(DialMark{at, dial.axis, dial.flat, chosen_->amount, 40});
  marks.push_back(PointMark{chosen_->isHeld ? MarkRole::ActiveHandle : MarkRole::Handle, at});
  marks.push_back(TextMark{MarkRole::Measure, at, {"%1", {chosen_->line}}});
}

Marks AngleTool::marks(const Scope& scope) const {
  Marks marks;
  const FoldedState& state = *scope.state;
  const auto addLine = [&](const std::string& name, MarkRole role) {
    const auto line = lineNamed(state, name);
    if (!line) return;
    for (const EdgeId e : hingesOf(state, *line)) {
      const Edge& edge = state.pattern[e];
      marks.push_back(PathMark{
          role,
          {Spot{edge.left, state.pattern[edge.from]}, Spot{edge.left, state.pattern[edge.to]}},
          false,
          false});
    }
  };
  if (!hovered_.empty()) addLine(hovered_, MarkRole::Hovered);
  if (!chosen_) return marks;
  addLine(chosen_->line, MarkRole::Selected);
  addDial(scope, marks);
  return marks;
}

std::vector<Field> AngleTool::fields(const Scope&) const {
  if (!chosen_) return {};
  return {numberField(
      "angle", {KIRI_TEXT("editor/tools", "Angle"), {}}, chosen_->amount, {-180, 180, kStep, "°"},
      {KIRI_TEXT("editor/tools", "0 is unfolded, 180 flat; below 0 the fold turns the other way"),
       {}})};
}

Reaction AngleTool::setField(const std::string& id, const FieldValue& value, const Scope&) {
  if (id != "angle" || !chosen_ || !std::isfinite(value.number)) return Reaction::ignored();
  chosen_->amount = std::clamp(value.number, -180.0, 180.0);
  return Reaction::handled();
}

Phrase AngleTool::hint(const Scope& scope) const {
  if (chosen_ && chosen_->isHeld)
    return {KIRI_TEXT("editor/tools", "Pull the paper over the crease, or back, then release"), {}};
  if (chosen_) {
    return {KIRI_TEXT("editor/tools",
                      "Enter sets the angle, Esc leaves it; arrow keys turn by 15°, or type it"),
            {}};
  }
  if (scope.state->lines.empty())
    return {KIRI_TEXT("editor/tools", "There is no fold yet; make one with the fold tool"), {}};
  return {KIRI_TEXT("editor/tools", "Press on a crease and pull to open or close its fold"), {}};
}

CursorShape AngleTool::cursor(const Scope&) const {
  if (chosen_ && chosen_->isHeld) return CursorShape::ClosedHand;
  return hovered_.empty() ? CursorShape::Arrow : CursorShape::Hand;
}

}  // namespace kiri
