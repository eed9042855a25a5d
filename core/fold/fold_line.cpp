// SPDX-License-Identifier: MIT
#include "core/fold/fold_line.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/fold/follow.h"
#include "core/fold/moving_facets.h"
#include "core/fold/rotate.h"

namespace kiri {
namespace {

std::string quoted(const FoldedState& state, FoldLineId line) {
  return "\"" + state.lines[line.index].name + "\"";
}

/// Names of the folded lines whose hinges end on a hinge of this one: what to unfold first.
std::string holders(const FoldedState& state, FoldLineId line) {
  std::vector<bool> isEnd(state.pattern.vertices.size(), false);
  for (const EdgeId id : hingesOf(state, line)) {
    isEnd[state.pattern[id].from.index] = true;
    isEnd[state.pattern[id].to.index] = true;
  }
  std::vector<bool> holds(state.lines.size(), false);
  for (const Edge& edge : state.pattern.edges) {
    const bool isOther = edge.kind == EdgeKind::Hinge && edge.line.isValid() && edge.line != line;
    if (isOther && edge.angle != 0 && (isEnd[edge.from.index] || isEnd[edge.to.index])) {
      holds[edge.line.index] = true;
    }
  }
  std::string names;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    if (!holds[i]) continue;
    names += (names.empty() ? "" : ", ") + quoted(state, FoldLineId(i));
  }
  return names;
}

Error locked(const FoldedState& state, FoldLineId line, const std::string& why,
             const std::vector<EdgeId>& where) {
  const std::string names = holders(state, line);
  Error error{
      ErrorCode::Locked, "the fold line " + quoted(state, line) + " cannot move: " + why, {}};
  error.message += names.empty() ? "; tear the paper there first"
                                 : "; unfold " + names + " first, or everything together";
  for (const EdgeId id : where) {
    const Edge& edge = state.pattern[id];
    error.witness.segments.push_back({state.pattern[edge.from], state.pattern[edge.to]});
  }
  return error;
}

EdgeId longestOf(const FoldedState& state, const std::vector<EdgeId>& hinges) {
  EdgeId longest;
  double most = -1;
  for (const EdgeId id : hinges) {
    const Edge& edge = state.pattern[id];
    const double span = distance(state.pattern[edge.from], state.pattern[edge.to]);
    if (span > most) {
      most = span;
      longest = id;
    }
  }
  return longest;
}

/// The longest hinge gives the axis, for it is the most exact.
Motion axisOf(const FoldedState& state, const std::vector<EdgeId>& hinges) {
  const Edge& longest = state.pattern[longestOf(state, hinges)];
  const Rigid& pose = state.poseOf(longest.left);
  const Vec2 a = state.pattern[longest.from];
  return {pose.apply(a), normalized(pose.direction(state.pattern[longest.to] - a)), 0};
}

/// Degrees about the axis that bring every hinge to the amount; none when they ask for different
/// turns.
std::optional<double> turnFor(const FoldedState& state, const std::vector<EdgeId>& hinges,
                              const Motion& axis, double amount) {
  std::optional<double> degrees;
  for (const EdgeId id : hinges) {
    const Edge& edge = state.pattern[id];
    const double here =
        (edge.sign * amount - edge.angle) * turnSign(state, edge, axis, edge.leftMoves);
    if (degrees && std::abs(*degrees - here) > kSameAngle) return std::nullopt;
    degrees = here;
  }
  return degrees;
}

/// The turn about one axis that brings the line to the amount. Errors: NothingToDo, Locked.
Result<Turning> turnTo(const FoldedState& state, FoldLineId line, double amount) {
  const std::vector<EdgeId> hinges = hingesOf(state, line);
  if (hinges.empty()) {
    return Error{
        ErrorCode::NothingToDo,
        "the fold line " + quoted(state, line) + " has no creases left that hold paper together",
        {}};
  }
  Motion motion = axisOf(state, hinges);
  for (const EdgeId id : hinges) {
    if (!liesOnAxis(state, state.pattern[id], motion)) {
      return locked(state, line, "other folds have brought its creases out of line", {id});
    }
  }
  const std::optional<double> degrees = turnFor(state, hinges, motion, amount);
  if (!degrees) {
    return locked(state, line,
                  amountOf(state, line) ? "a part of it lies on paper that other folds turned over"
                                        : "its creases are folded by different angles",
                  hinges);
  }
  motion.degrees = *degrees;
  std::vector<FacetId> seeds;
  std::vector<FacetId> resting;
  for (const EdgeId id : hinges) {
    const Edge& edge = state.pattern[id];
    seeds.push_back(edge.leftMoves ? edge.left : edge.right);
    resting.push_back(edge.leftMoves ? edge.right : edge.left);
  }
  const MovingSet moving = movingFacets(state, motion, seeds, resting);
  if (!moving.broken.empty()) {
    return locked(state, line,
                  "the paper on its two sides is joined elsewhere too and would stretch",
                  moving.broken);
  }
  return Turning{moving.moves, motion};
}

/// The state in which flat creases of the line that lie on paper turned over since then fold the
/// other way round, and so with the longest of them. None when there are no such creases.
std::optional<FoldedState> withCreasesTurnedOver(const FoldedState& state, FoldLineId line) {
  const std::vector<EdgeId> hinges = hingesOf(state, line);
  const bool isFlatLine = std::all_of(hinges.begin(), hinges.end(),
                                      [&](EdgeId id) { return state.pattern[id].angle == 0; });
  if (!isFlatLine || hinges.empty()) return std::nullopt;
  const Motion axis = axisOf(state, hinges);
  const auto wayOf = [&](EdgeId id) {
    const Edge& edge = state.pattern[id];
    return edge.sign * turnSign(state, edge, axis, edge.leftMoves);
  };
  const int way = wayOf(longestOf(state, hinges));
  FoldedState turned = state;
  bool isTurned = false;
  for (const EdgeId id : hinges) {
    if (wayOf(id) == way) continue;
    turned.pattern[id].sign = static_cast<std::int8_t>(-turned.pattern[id].sign);
    isTurned = true;
  }
  if (!isTurned) return std::nullopt;
  return turned;
}

/// True when creases of other lines lie on the axis by chance and would turn too: the sides of a
/// tuck that is folded flat. In their loop they turn another way.
bool doesTurnOthers(const FoldedState& state, FoldLineId line, const Turning& turn) {
  return std::any_of(state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
    return edge.kind == EdgeKind::Hinge && edge.line != line &&
           turn.moves[edge.left.index] != turn.moves[edge.right.index];
  });
}

/// The line can move, and others with it, but not so far.
Error stopped(const FoldedState& state, FoldLineId line, const Followed& followed,
              const Error& alone) {
  Error error = alone;
  error.message = "the fold line " + quoted(state, line) +
                  " cannot move so far: with the creases " +
                  "that form closed loops with it, it stops at " + text(followed.amount) +
                  " degrees; ask for less";
  const std::string names = holders(state, line);
  error.message += names.empty() ? ", or tear the paper" : ", or unfold " + names + " first";
  return error;
}

}  // namespace

std::vector<EdgeId> hingesOf(const FoldedState& state, FoldLineId line) {
  std::vector<EdgeId> hinges;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge && edge.line == line) hinges.push_back(EdgeId(e));
  }
  return hinges;
}

Result<FoldedState> setAmountAlone(const FoldedState& state, FoldLineId line, double amount,
                                   Movements* record) {
  const Result<Turning> turn = turnTo(state, line, amount);
  if (!turn) return turn.error();
  FoldedState next = rotate(state, turn->moves, turn->motion, record);
  if (amount != 0) next.lines[line.index].foldedAmount = amount;
  return next;
}

Result<FoldedState> setAmountTurnedOver(const FoldedState& state, FoldLineId line, double amount,
                                        Movements* record) {
  const std::optional<FoldedState> turned = withCreasesTurnedOver(state, line);
  return setAmountAlone(turned ? *turned : state, line, amount, record);
}

Result<FoldedState> setAmountFollowed(const FoldedState& state, FoldLineId line, double amount,
                                      Movements* record) {
  const Result<Turning> turn = turnTo(state, line, amount);
  if (!turn && turn.error().code != ErrorCode::Locked) return turn.error();
  if (!turn || doesTurnOthers(state, line, *turn)) {
    std::optional<Followed> followed = follow(state, line, amount);
    if (followed && followed->path->isComplete()) {
      FoldedState next = stateFollowing(state, line, *followed);
      if (record != nullptr) record->push_back(movementAlong(state, followed->path, next));
      return next;
    }
    if (!turn) return followed ? stopped(state, line, *followed, turn.error()) : turn.error();
  }
  return setAmountAlone(state, line, amount, record);
}

Result<FoldedState> setAmount(const FoldedState& state, FoldLineId line, double amount,
                              Movements* record) {
  Result<FoldedState> next = setAmountFollowed(state, line, amount, record);
  if (next || next.error().code != ErrorCode::Locked) return next;
  Result<FoldedState> over = setAmountTurnedOver(state, line, amount, record);
  return over ? std::move(over) : std::move(next);
}

Slide slideAmount(const FoldedState& state, FoldLineId line, double amount) {
  Result<FoldedState> there = setAmount(state, line, amount);
  if (there) return {std::move(*there), amount, std::nullopt};
  if (there.error().code == ErrorCode::Locked) {
    if (std::optional<Followed> followed = follow(state, line, amount))
      return {stateFollowing(state, line, *followed), followed->amount, there.error()};
  }
  return {state, amountOf(state, line).value_or(0), there.error()};
}

}  // namespace kiri
