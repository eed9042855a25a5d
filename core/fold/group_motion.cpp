// SPDX-License-Identifier: MIT
#include "core/fold/group_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/fold/fold_line.h"
#include "core/fold/path_collisions.h"

namespace kiri {
namespace {

using Wanted = std::pair<FoldLineId, double>;

/// A line of the group that can move next, and what comes of it.
struct Next {
  FoldedState state;
  std::size_t place;
  Movements movements;
};

Error cancelled() { return {ErrorCode::Cancelled, "the folds were stopped on their way", {}}; }

/// The first line that can move about its own axis without a collision; else the first that can
/// move at all.
Result<Next> nextToMove(const FoldedState& state, const std::vector<Wanted>& wanted,
                        bool isRecorded) {
  std::optional<Next> best;
  std::optional<Error> error;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Movements made;
    Result<FoldedState> next =
        setAmountAlone(state, wanted[i].first, wanted[i].second, isRecorded ? &made : nullptr);
    if (!next) {
      if (!error) error = next.error();
      continue;
    }
    const bool isFree = next->collisions.size() == state.collisions.size();
    if (isFree || !best) best = Next{std::move(*next), i, std::move(made)};
    if (isFree) break;
  }
  if (!best) return *error;
  return std::move(*best);
}

/// Tries the lines in turn and again until all have moved.
Result<FoldedState> moveInAnyOrder(const FoldedState& start, std::vector<Wanted> wanted,
                                   Movements* record, const Progress& progress) {
  FoldedState state = start;
  const auto all = static_cast<double>(wanted.size());
  while (!wanted.empty()) {
    if (!goesOn(progress, 1 - static_cast<double>(wanted.size()) / all)) return cancelled();
    Result<Next> next = nextToMove(state, wanted, record != nullptr);
    if (!next) return next.error();
    state = std::move(next->state);
    if (record != nullptr)
      record->insert(record->end(), next->movements.begin(), next->movements.end());
    wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(next->place));
  }
  return state;
}

Result<FoldedState> moveInOrder(const FoldedState& start, const std::vector<Wanted>& wanted,
                                Movements* record, const Progress& progress) {
  FoldedState state = start;
  double done = 0;
  for (const auto& [line, amount] : wanted) {
    if (!goesOn(progress, done++ / static_cast<double>(wanted.size()))) return cancelled();
    Result<FoldedState> next = setAmount(state, line, amount, record);
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

/// All hinges of the lines at once; one leads, the one that turns most, the others follow it.
PathRequest requestFor(const FoldedState& state, const std::vector<Wanted>& wanted) {
  PathRequest request{anglesOf(state.pattern), {}, {}};
  std::optional<std::size_t> leader;
  double most = 0;
  for (const auto& [line, amount] : wanted) {
    for (const EdgeId id : hingesOf(state, line)) {
      const Edge& edge = state.pattern[id];
      request.wanted[id.index] = edge.sign * amount;
      const double turn = std::abs(request.wanted[id.index] - edge.angle);
      if (turn <= most && leader) {
        request.free.push_back(id);
        continue;
      }
      if (leader) request.free.push_back(EdgeId(*leader));
      leader = id.index;
      most = turn;
    }
  }
  if (leader) request.driven.push_back(EdgeId(*leader));
  return request;
}

/// The way of all of them at once; none when the paper would have to bend on it.
std::shared_ptr<const RigidPath> pathFor(const FoldedState& state,
                                         const std::vector<Wanted>& wanted) {
  if (wanted.empty()) return nullptr;
  RigidPath path = rigidPath(state, requestFor(state, wanted));
  if (!path.arrives()) return nullptr;
  return std::make_shared<const RigidPath>(std::move(path));
}

/// The end of a path that no order of single lines leads to.
FoldedState endOf(const FoldedState& start, const std::shared_ptr<const RigidPath>& path,
                  const std::vector<Wanted>& wanted) {
  FoldedState end = stateDuring(movementAlong(start, path, start), 1);
  for (const auto& [line, amount] : wanted) {
    if (amount != 0) end.lines[line.index].foldedAmount = amount;
  }
  notePathCollisions(movementAlong(start, path, end), wanted.front().first, end);
  return end;
}

/// Line by line says how the paper comes to lie, where it meets nothing on the way. It moves all at
/// once where that is free, or the only way that is, or the only way there is.
Result<FoldedState> moveTogether(const FoldedState& start, const std::vector<Wanted>& wanted,
                                 Movements* record, const Progress& progress) {
  Movements oneByOne;
  Result<FoldedState> end =
      moveInAnyOrder(start, wanted, record != nullptr ? &oneByOne : nullptr, progress);
  if (!end && end.error().code == ErrorCode::Cancelled) return end;
  const bool isFree = end && end->collisions.size() == start.collisions.size();
  if (isFree && record == nullptr) return end;
  const std::shared_ptr<const RigidPath> path = pathFor(start, wanted);
  if (path == nullptr) {
    if (end && record != nullptr) record->insert(record->end(), oneByOne.begin(), oneByOne.end());
    return end;
  }
  if (!isFree) {
    FoldedState atOnce = endOf(start, path, wanted);
    if (!end || atOnce.collisions.size() < end->collisions.size()) {
      end = std::move(atOnce);
      oneByOne.clear();
    }
  }
  if (record == nullptr) return end;
  Movement motion = movementAlong(start, path, *end);
  if (oneByOne.empty() || collisionsOnTheWay(motion, wanted.front().first).empty()) {
    record->push_back(std::move(motion));
  } else {
    record->insert(record->end(), oneByOne.begin(), oneByOne.end());
  }
  return end;
}

/// True when nothing but hinges of these lines is folded.
bool areAllFolded(const FoldedState& state, const std::vector<FoldLineId>& lines) {
  return std::none_of(
      state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
        const bool isMeant = std::find(lines.begin(), lines.end(), edge.line) != lines.end();
        return edge.kind == EdgeKind::Hinge && edge.angle != 0 && !isMeant;
      });
}

}  // namespace

Result<FoldedState> unfoldLines(const FoldedState& state, std::vector<FoldLineId> lines,
                                GroupMotion motion, Movements* record, const Progress& progress) {
  std::reverse(lines.begin(), lines.end());
  const std::vector<Wanted> wanted = wantedOf(state, lines, true);
  if (motion == GroupMotion::InOrder) return moveInOrder(state, wanted, record, progress);
  Result<FoldedState> next = moveTogether(state, wanted, record, progress);
  if (!next && next.error().code != ErrorCode::Cancelled && areAllFolded(state, lines))
    return flattened(state);
  return next;
}

Result<FoldedState> unfoldOneByOne(const FoldedState& state, std::vector<FoldLineId> lines,
                                   Movements* record, const Progress& progress) {
  std::reverse(lines.begin(), lines.end());
  return moveInAnyOrder(state, wantedOf(state, lines, true), record, progress);
}

Result<FoldedState> refoldLines(const FoldedState& state, const std::vector<FoldLineId>& lines,
                                GroupMotion motion, Movements* record, const Progress& progress) {
  const std::vector<Wanted> wanted = wantedOf(state, lines, false);
  return motion == GroupMotion::InOrder ? moveInOrder(state, wanted, record, progress)
                                        : moveTogether(state, wanted, record, progress);
}

}  // namespace kiri
