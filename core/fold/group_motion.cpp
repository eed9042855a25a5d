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

Error cancelled() { return {ErrorCode::Cancelled, "the folds were stopped on their way", {}}; }

/// An end of lines that moved, and the way there.
struct Moved {
  Result<FoldedState> end;
  Movements way;

  bool isFree(const FoldedState& start) const {
    return end && end->collisions.size() == start.collisions.size();
  }
  /// The better one collides less.
  void improve(Moved other) {
    if (other.end && (!end || other.end->collisions.size() < end->collisions.size()))
      *this = std::move(other);
  }
};

/// How one line moves.
using MovesLine = Result<FoldedState> (*)(const FoldedState&, FoldLineId, double, Movements*);

Moved movedBy(MovesLine moves, const FoldedState& state, const Wanted& wanted, bool isRecorded) {
  Movements way;
  Result<FoldedState> end = moves(state, wanted.first, wanted.second, isRecorded ? &way : nullptr);
  return {std::move(end), std::move(way)};
}

/// A line of the group that can move next, and what comes of it.
struct Next {
  Moved moved;
  std::size_t place;
};

/// The first line that can move so without a collision; else the first that can move at all.
Result<Next> nextToMove(const FoldedState& state, const std::vector<Wanted>& wanted,
                        bool isRecorded, MovesLine moves) {
  std::optional<Next> best;
  std::optional<Error> error;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Moved next = movedBy(moves, state, wanted[i], isRecorded);
    if (!next.end) {
      if (!error) error = next.end.error();
      continue;
    }
    const bool isFree = next.isFree(state);
    if (isFree || !best) best = Next{std::move(next), i};
    if (isFree) break;
  }
  if (!best) return *error;
  return std::move(*best);
}

/// Tries the lines in turn and again until all have moved.
Result<FoldedState> moveInAnyOrder(const FoldedState& start, std::vector<Wanted> wanted,
                                   Movements* record, const Progress& progress,
                                   MovesLine moves = setAmountAlone) {
  FoldedState state = start;
  const auto all = static_cast<double>(wanted.size());
  while (!wanted.empty()) {
    if (!goesOn(progress, 1 - static_cast<double>(wanted.size()) / all)) return cancelled();
    Result<Next> next = nextToMove(state, wanted, record != nullptr, moves);
    if (!next) return next.error();
    state = std::move(*next->moved.end);
    const Movements& way = next->moved.way;
    if (record != nullptr) record->insert(record->end(), way.begin(), way.end());
    wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(next->place));
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

/// How far lines came that moved one after the other.
struct InOrder {
  FoldedState state;
  std::vector<Wanted> left;  ///< those that did not move
  std::optional<Error> why;  ///< none where all moved, or a crease would have turned through itself
};

/// True when a crease has turned through itself since there were so many collisions: one that holds
/// the line which turned, as those of a tuck do that was mended.
bool isHeld(const FoldedState& state, std::size_t before) {
  return std::any_of(
      state.collisions.begin() + static_cast<std::ptrdiff_t>(before), state.collisions.end(),
      [](const Collision& collision) { return collision.moment == CollisionMoment::Hinge; });
}

/// One of several lines. What other folds turned over moves only where that is free: the lines that
/// would turn it back may come later.
Moved moveOneOf(const FoldedState& state, const Wanted& wanted, bool isOnly, bool isRecorded) {
  if (isOnly) return movedBy(setAmount, state, wanted, isRecorded);
  Moved next = movedBy(setAmountFollowed, state, wanted, isRecorded);
  if (next.end || next.end.error().code != ErrorCode::Locked) return next;
  Moved turned = movedBy(setAmountTurnedOver, state, wanted, isRecorded);
  return turned.isFree(state) ? std::move(turned) : std::move(next);
}

/// In which order lines move one after the other.
struct OrderRule {
  bool mayWait = false;         ///< one that is not free waits for one that turns freely
  bool stopsWhereHeld = false;  ///< before a crease turns through itself
};

InOrder moveInOrder(const FoldedState& start, const std::vector<Wanted>& wanted,
                    const OrderRule& rule, Movements* record, const Progress& progress) {
  InOrder way{start, wanted, {}};
  const auto all = static_cast<double>(wanted.size());
  const bool isRecorded = record != nullptr;
  while (!way.left.empty()) {
    if (!goesOn(progress, 1 - static_cast<double>(way.left.size()) / all)) {
      way.why = cancelled();
      return way;
    }
    std::size_t place = 0;
    Moved taken = moveOneOf(way.state, way.left.front(), wanted.size() == 1, isRecorded);
    for (std::size_t i = 1; rule.mayWait && i < way.left.size() && !taken.isFree(way.state); ++i) {
      Moved other = movedBy(setAmountAlone, way.state, way.left[i], isRecorded);
      if (!other.isFree(way.state)) continue;
      taken = std::move(other);
      place = i;
    }
    if (!taken.end) {
      way.why = taken.end.error();
      return way;
    }
    if (rule.stopsWhereHeld && isHeld(*taken.end, way.state.collisions.size())) return way;
    way.state = std::move(*taken.end);
    if (isRecorded) record->insert(record->end(), taken.way.begin(), taken.way.end());
    way.left.erase(way.left.begin() + static_cast<std::ptrdiff_t>(place));
  }
  return way;
}

Moved movedInAnyOrder(const FoldedState& start, const std::vector<Wanted>& wanted,
                      const Progress& progress, bool isRecorded, MovesLine moves) {
  Movements way;
  Result<FoldedState> end =
      moveInAnyOrder(start, wanted, isRecorded ? &way : nullptr, progress, moves);
  return {std::move(end), std::move(way)};
}

Moved movedInOrder(const FoldedState& start, const std::vector<Wanted>& wanted,
                   const Progress& progress, bool isRecorded) {
  Movements way;
  InOrder in = moveInOrder(start, wanted, {}, isRecorded ? &way : nullptr, progress);
  if (in.why) return {*in.why, {}};
  return {std::move(in.state), std::move(way)};
}

/// Line by line says how the paper comes to lie, where it meets nothing on the way. It moves all at
/// once where that is free, or the only way that is, or the only way there is. What collides so may
/// be free in order, with creases of loops following each other. Creases that were turned over come
/// last of all: a loop of creases may turn them back.
Result<FoldedState> moveTogether(const FoldedState& start, const std::vector<Wanted>& wanted,
                                 Movements* record, const Progress& progress) {
  const bool isRecorded = record != nullptr;
  Moved best = movedInAnyOrder(start, wanted, progress, isRecorded, setAmountAlone);
  const auto isStopped = [&] { return !best.end && best.end.error().code == ErrorCode::Cancelled; };
  if (isStopped() || (best.isFree(start) && !isRecorded)) return best.end;
  const bool isFree = best.isFree(start);
  const Progress still = [&progress](double) { return goesOn(progress, 1); };
  const std::shared_ptr<const RigidPath> path = pathFor(start, wanted);
  if (!isFree && path != nullptr) best.improve({endOf(start, path, wanted), {}});
  if (!best.isFree(start)) {
    Moved inOrder = movedInOrder(start, wanted, still, isRecorded);
    if (best.end || inOrder.isFree(start)) best.improve(std::move(inOrder));
  }
  if (!best.end) {
    Moved over = movedInAnyOrder(start, wanted, still, isRecorded, setAmountTurnedOver);
    if (over.isFree(start)) best = std::move(over);
  }
  if (!goesOn(progress, 1)) return cancelled();
  if (!best.end || !isRecorded) return best.end;
  if (path != nullptr && (isFree || best.way.empty())) {
    Movement atOnce = movementAlong(start, path, *best.end);
    if (best.way.empty() || collisionsOnTheWay(atOnce, wanted.front().first).empty())
      best.way = {std::move(atOnce)};
  }
  record->insert(record->end(), best.way.begin(), best.way.end());
  return best.end;
}

/// True when nothing but hinges of these lines is folded.
bool areAllFolded(const FoldedState& state, const std::vector<FoldLineId>& lines) {
  return std::none_of(
      state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
        const bool isMeant = std::find(lines.begin(), lines.end(), edge.line) != lines.end();
        return edge.kind == EdgeKind::Hinge && edge.angle != 0 && !isMeant;
      });
}

/// Why lines cannot move in order, and that they can together where that is so.
Error refused(const FoldedState& start, const std::vector<Wanted>& wanted, Error why,
              const Progress& progress) {
  if (why.code == ErrorCode::Locked && wanted.size() > 1 &&
      moveTogether(start, wanted, nullptr, progress))
    why.message += "; these folds can move together, though not in order";
  return why;
}

/// All at once. Where that is all that is folded it always can be: flat paper is flat.
Result<FoldedState> openTogether(const FoldedState& start, const std::vector<Wanted>& wanted,
                                 bool isAll, Movements* record, const Progress& progress) {
  Result<FoldedState> next = moveTogether(start, wanted, record, progress);
  if (!next && next.error().code != ErrorCode::Cancelled && isAll) return flattened(start);
  return next;
}

/// From the last to the first. Creases that were folded at once, or have been mended together
/// since, hold each other: where nothing else is folded any more, they open at once, the paper
/// bending rather than passing through itself.
Result<FoldedState> openInOrder(const FoldedState& start, const std::vector<Wanted>& wanted,
                                const OrderRule& rule, Movements* record,
                                const Progress& progress) {
  const bool isAll = rule.stopsWhereHeld;
  InOrder way = moveInOrder(start, wanted, rule, record, progress);
  if (way.left.empty()) return std::move(way.state);
  if (way.why && way.why->code == ErrorCode::Cancelled) return *way.why;
  if (!isAll) return refused(start, wanted, *way.why, progress);
  Movements made;
  Result<FoldedState> open =
      moveTogether(way.state, way.left, record != nullptr ? &made : nullptr, progress);
  if (!open && open.error().code == ErrorCode::Cancelled) return open;
  if (!open || open->collisions.size() > way.state.collisions.size()) return flattened(way.state);
  if (record != nullptr) record->insert(record->end(), made.begin(), made.end());
  return open;
}

}  // namespace

Result<FoldedState> unfoldLines(const FoldedState& state, std::vector<FoldLineId> lines,
                                GroupMotion motion, Movements* record, const Progress& progress) {
  std::reverse(lines.begin(), lines.end());
  const std::vector<Wanted> wanted = wantedOf(state, lines, true);
  const bool isAll = areAllFolded(state, lines);
  if (motion == GroupMotion::Together) return openTogether(state, wanted, isAll, record, progress);
  const OrderRule rule{motion == GroupMotion::InFreeOrder, isAll};
  return openInOrder(state, wanted, rule, record, progress);
}

Result<FoldedState> unfoldOneByOne(const FoldedState& state, std::vector<FoldLineId> lines,
                                   Movements* record, const Progress& progress) {
  std::reverse(lines.begin(), lines.end());
  return moveInAnyOrder(state, wantedOf(state, lines, true), record, progress);
}

Result<FoldedState> refoldLines(const FoldedState& state, const std::vector<FoldLineId>& lines,
                                GroupMotion motion, Movements* record, const Progress& progress) {
  const std::vector<Wanted> wanted = wantedOf(state, lines, false);
  if (motion == GroupMotion::Together) return moveTogether(state, wanted, record, progress);
  InOrder way = moveInOrder(state, wanted, {}, record, progress);
  if (way.why) return refused(state, wanted, *way.why, progress);
  return std::move(way.state);
}

}  // namespace kiri
