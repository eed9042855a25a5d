// SPDX-License-Identifier: MIT
#include "core/fold/fold_line.h"

#include <algorithm>
#include <cmath>

#include "core/fold/moving_facets.h"
#include "core/fold/rotate.h"

namespace kiri {
namespace {

std::vector<EdgeId> hingesOf(const FoldedState& state, FoldLineId line) {
  std::vector<EdgeId> hinges;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge && edge.line == line) hinges.push_back(EdgeId(e));
  }
  return hinges;
}

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
  error.message += names.empty() ? "; tear the paper there first" : "; unfold " + names + " first";
  for (const EdgeId id : where) {
    const Edge& edge = state.pattern[id];
    error.witness.segments.push_back({state.pattern[edge.from], state.pattern[edge.to]});
  }
  return error;
}

/// The longest hinge gives the axis, for it is the most exact.
Motion axisOf(const FoldedState& state, const std::vector<EdgeId>& hinges) {
  const Edge* longest = nullptr;
  double most = -1;
  for (const EdgeId id : hinges) {
    const Edge& edge = state.pattern[id];
    const double span = distance(state.pattern[edge.from], state.pattern[edge.to]);
    if (span > most) {
      most = span;
      longest = &edge;
    }
  }
  const Rigid& pose = state.poseOf(longest->left);
  const Vec2 a = state.pattern[longest->from];
  return {pose.apply(a), normalized(pose.direction(state.pattern[longest->to] - a)), 0};
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

using Wanted = std::pair<FoldLineId, double>;

/// Tries the lines in turn and again until all have moved; what moves without a collision goes
/// first.
Result<FoldedState> moveInAnyOrder(const FoldedState& start, std::vector<Wanted> wanted) {
  FoldedState state = start;
  while (!wanted.empty()) {
    std::optional<FoldedState> colliding;
    std::size_t collidingAt = 0;
    std::optional<Error> error;
    std::size_t moved = wanted.size();
    for (std::size_t i = 0; i < wanted.size() && moved == wanted.size(); ++i) {
      Result<FoldedState> next = setAmount(state, wanted[i].first, wanted[i].second);
      if (!next) {
        if (!error) error = next.error();
      } else if (next->collisions.size() == state.collisions.size()) {
        state = std::move(*next);
        moved = i;
      } else if (!colliding) {
        colliding = std::move(*next);
        collidingAt = i;
      }
    }
    if (moved == wanted.size()) {
      if (!colliding) return *error;
      state = std::move(*colliding);
      moved = collidingAt;
    }
    wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(moved));
  }
  return state;
}

Result<FoldedState> moveInOrder(const FoldedState& start, const std::vector<Wanted>& wanted) {
  FoldedState state = start;
  for (const auto& [line, amount] : wanted) {
    Result<FoldedState> next = setAmount(state, line, amount);
    if (!next) return next.error();
    state = std::move(*next);
  }
  return state;
}

/// Every hinge at 0 at once: each piece lies flat in the plane of its rest.
FoldedState flattened(const FoldedState& start) {
  FoldedState state = start;
  for (Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = 0;
  }
  state.poses = derivePoses(state.pattern, state.rests);
  const std::vector<std::uint32_t> piece = piecesOf(state.pattern);
  std::vector<LayerSet> sets;
  for (const Rest& rest : state.rests) {
    LayerSet* home = nullptr;
    const Vec3 normal = state.poseOf(rest.facet).normal();
    for (LayerSet& set : sets) {
      const Vec3 between =
          state.poseOf(set.upward.front()).origin - state.poseOf(rest.facet).origin;
      const bool isSame = length(cross(set.normal, normal)) <= kSamePlane &&
                          std::abs(dot(normal, between)) <= state.tolerance().match();
      if (home == nullptr && isSame) home = &set;
    }
    if (home == nullptr) home = &sets.emplace_back(LayerSet{normal, {}, {}});
    for (std::size_t f = 0; f < piece.size(); ++f) {
      if (piece[f] == piece[rest.facet.index]) home->upward.push_back(FacetId(f));
    }
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

/// The lines that are to move at all, with where to.
std::vector<Wanted> wantedOf(const FoldedState& state, const std::vector<FoldLineId>& lines,
                             bool isUnfolding) {
  std::vector<Wanted> wanted;
  for (const FoldLineId line : lines) {
    if (hingesOf(state, line).empty()) continue;
    const double amount = isUnfolding ? 0 : state.lines[line.index].foldedAmount;
    if (amountOf(state, line) != amount) wanted.push_back({line, amount});
  }
  return wanted;
}

}  // namespace

Result<FoldedState> setAmount(const FoldedState& state, FoldLineId line, double amount) {
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
  if (!degrees) return locked(state, line, "its creases are folded by different angles", hinges);
  motion.degrees = *degrees;
  std::vector<FacetId> seeds;
  std::vector<FacetId> resting;
  for (const EdgeId id : hinges) {
    const Edge& edge = state.pattern[id];
    seeds.push_back(edge.leftMoves ? edge.left : edge.right);
    resting.push_back(edge.leftMoves ? edge.right : edge.left);
  }
  const MovingFacets moving = movingFacets(state, motion, seeds, resting);
  if (!moving.broken.empty()) {
    return locked(state, line,
                  "the paper on its two sides is joined elsewhere too and would stretch",
                  moving.broken);
  }
  FoldedState next = rotate(state, moving.moves, motion);
  if (amount != 0) next.lines[line.index].foldedAmount = amount;
  return next;
}

Result<FoldedState> unfoldLines(const FoldedState& state, std::vector<FoldLineId> lines,
                                GroupMotion motion) {
  std::reverse(lines.begin(), lines.end());
  const std::vector<Wanted> wanted = wantedOf(state, lines, true);
  if (motion == GroupMotion::InOrder) return moveInOrder(state, wanted);
  Result<FoldedState> next = moveInAnyOrder(state, wanted);
  if (next) return next;
  const auto folded =
      std::count_if(state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
        const bool isMeant = std::find(lines.begin(), lines.end(), edge.line) != lines.end();
        return edge.kind == EdgeKind::Hinge && edge.angle != 0 && !isMeant;
      });
  return folded == 0 ? Result<FoldedState>(flattened(state)) : next;
}

Result<FoldedState> refoldLines(const FoldedState& state, const std::vector<FoldLineId>& lines,
                                GroupMotion motion) {
  const std::vector<Wanted> wanted = wantedOf(state, lines, false);
  return motion == GroupMotion::InOrder ? moveInOrder(state, wanted)
                                        : moveInAnyOrder(state, wanted);
}

}  // namespace kiri
