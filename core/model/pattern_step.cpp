// Applying a PatternStep: creases, fold lines, folded angles and layers.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_step.h"

#include <algorithm>
#include <optional>

#include "core/base/text.h"
#include "core/model/facet_finder.h"
#include "core/model/pattern_creases.h"
#include "core/model/pattern_layers.h"
#include "core/model/pattern_lines.h"
#include "core/model/pattern_motion.h"
#include "core/model/pattern_order.h"

namespace kiri {
namespace {

/// The facets of the largest area of every piece, the first of several that are equal but for
/// rounding.
std::vector<FacetId> largestFacets(const CreasePattern& pattern) {
  const std::vector<std::uint32_t> piece = piecesOf(pattern);
  const double rounding = pattern.tolerance.fat() * pattern.tolerance.sheetSize();
  std::vector<FacetId> largest;
  std::vector<double> most;
  for (std::size_t f = 0; f < piece.size(); ++f) {
    if (piece[f] >= largest.size()) {
      largest.resize(piece[f] + 1);
      most.resize(piece[f] + 1, 0);
    }
    const double area = areaOf(regionOf(pattern, FacetId(f)));
    if (largest[piece[f]].isValid() && area - most[piece[f]] <= rounding) continue;
    largest[piece[f]] = FacetId(f);
    most[piece[f]] = area;
  }
  return largest;
}

/// The facets that stay where the sheet lay, one for each connected piece, the first as the step
/// says. Errors: NotFound - the step names a place without paper.
Result<std::vector<FacetId>> restingFacets(const CreasePattern& pattern, const PatternStep& step) {
  std::vector<FacetId> resting = largestFacets(pattern);
  std::optional<FacetId> named;
  if (step.resting) {
    named = facetAt(pattern, *step.resting);
    if (!named) {
      return Error{ErrorCode::NotFound,
                   "there is no paper at " + text(*step.resting) +
                       " mm, where the facet that rests is meant to be; name a point on the sheet",
                   {{*step.resting}, {}, {}}};
    }
  }
  if (named) {
    const std::uint32_t piece = piecesOf(pattern)[named->index];
    resting[piece] = *named;
    std::swap(resting[piece], resting.front());
  } else {
    const auto area = [&](FacetId f) { return areaOf(regionOf(pattern, f)); };
    const double rounding = pattern.tolerance.fat() * pattern.tolerance.sheetSize();
    const auto most = std::max_element(resting.begin(), resting.end(), [&](FacetId a, FacetId b) {
      return area(b) - area(a) > rounding;
    });
    std::swap(*most, resting.front());
  }
  return resting;
}

/// By edge: what each becomes.
struct Targets {
  std::vector<double> angles;
  std::vector<Assignment> assignments;
};

Targets targetsOf(const CreasedSheet& creased, const PatternStep& step) {
  const std::size_t count = creased.pattern.edges.size();
  Targets targets{std::vector<double>(count, 0), std::vector<Assignment>(count)};
  for (std::size_t e = 0; e < count; ++e) {
    const bool isCut = creased.pattern.edges[e].kind == EdgeKind::Cut;
    targets.assignments[e] = isCut ? Assignment::Cut : Assignment::Border;
  }
  for (std::size_t i = 0; i < step.creases.size(); ++i) {
    const PatternCrease& crease = step.creases[i];
    const std::size_t e = creased.firstCrease + i;
    targets.assignments[e] = crease.assignment;
    if (crease.assignment != Assignment::Cut) targets.angles[e] = crease.angle;
  }
  return targets;
}

/// All facets in the plane of the sheet, in the order of their numbers.
LayerOrder flatLayers(const CreasePattern& pattern, const Vec3& normal) {
  LayerSet set{normal, {}, {}};
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) set.upward.push_back(FacetId(f));
  return LayerOrder({std::move(set)});
}

/// From the creased flat sheet to the folded state.
class PatternFolding {
 public:
  PatternFolding(FoldedState flat, const PatternStep& step, Targets targets,
                 const PatternRequest& request)
      : flat_(std::move(flat)),
        end_(flat_),
        step_(step),
        targets_(std::move(targets)),
        request_(request) {}

  Result<PatternOutcome> run() {
    turn(targets_.angles);
    const double apart = closureError(end_.pattern, end_.rests, anglesOf(end_.pattern));
    if (stretchOf(end_) > end_.tolerance().length() || apart > end_.tolerance().match())
      return open();
    if (const Status ordered = order(); !ordered) return ordered.error();
    directUnassigned(end_, targets_.assignments);
    takeLines();
    if (const std::optional<Collision> fault = faultOf(end_)) end_.collisions.push_back(*fault);
    PatternOutcome outcome{end_, std::nullopt, {}, refused_};
    if (request_.wantsMotion) addMotion(outcome);
    if (!goesOn(request_.progress, 1))
      return Error{ErrorCode::Cancelled, "the folding of the pattern was stopped", {}};
    return outcome;
  }

 private:
  void turn(const std::vector<double>& angles) {
    for (std::size_t e = 0; e < angles.size(); ++e) {
      if (end_.pattern.edges[e].kind == EdgeKind::Hinge) end_.pattern.edges[e].angle = angles[e];
    }
    end_.poses = derivePoses(end_.pattern, end_.rests);
  }

  /// The farthest that a corner of the right facet is from where the left one would put it.
  double misfit(const Edge& edge) const {
    const Vec2 a = end_.pattern[edge.from];
    const Vec2 u = normalized(end_.pattern[edge.to] - a);
    const Rigid turned =
        compose(end_.poseOf(edge.left), rotationAbout({a.x, a.y, 0}, {u.x, u.y, 0}, -edge.angle));
    double most = 0;
    for (const EdgeUse use : end_.pattern[edge.right].border) {
      const Vec2 p = end_.pattern[startOf(end_.pattern, use)];
      most = std::max(most, distance(turned.apply(p), end_.poseOf(edge.right).apply(p)));
    }
    return most;
  }

  /// The hinge whose sides disagree most.
  Error open() const {
    const Edge* worst = nullptr;
    double most = -1;
    for (const Edge& edge : end_.pattern.edges) {
      if (edge.kind != EdgeKind::Hinge) continue;
      const double gap = misfit(edge);
      if (gap <= most) continue;
      most = gap;
      worst = &edge;
    }
    const Vec2 a = end_.pattern[worst->from];
    const Vec2 b = end_.pattern[worst->to];
    return {
        ErrorCode::WouldStretch,
        "the creases do not fold to these angles: the paper on the two sides of the crease from " +
            text(a) + " to " + text(b) + " mm would be " + text(most) +
            " mm apart; leave the pattern flat and fold it crease by crease, or mend the "
            "drawing",
        {{a, b}, {{a, b}}, {}}};
  }

  Status order() {
    if (!step_.layers.empty()) {
      Result<LayerOrder> given = layersFrom(end_, step_);
      if (!given) return given.error();
      end_.layers = std::move(*given);
      return std::monostate{};
    }
    end_.layers = unorderedLayers(end_);
    if (!request_.orders.empty()) {
      if (takeOrders()) return std::monostate{};
      if (isFlat(end_)) return search();
    }
    const bool isOpen = std::any_of(targets_.assignments.begin(), targets_.assignments.end(),
                                    [](Assignment a) { return a == Assignment::Unassigned; });
    if (!isOpen || !isFlat(end_)) {
      motion_ = patternMotion(flat_, end_, request_.progress);
      if (motion_->way == PatternWay::Rigid && motion_->end) {
        end_.layers = motion_->end->layers;
        return std::monostate{};
      }
    }
    if (isFlat(end_)) return search();
    orderPartly(end_);
    return std::monostate{};
  }

  /// The orders that were asked for hold in what is found, if that can be.
  Status search() {
    const Result<bool> found =
        searchLayers(end_, targets_.assignments, request_.orders, request_.progress);
    if (!found) return found.error();
    if (*found) refused_.reset();
    return std::monostate{};
  }

  /// True when the orders that were asked for are an order without a fault.
  bool takeOrders() {
    FoldedState ordered = end_;
    orderAs(ordered, request_.orders);
    directUnassigned(ordered, targets_.assignments);
    if (const std::optional<Collision> fault = faultOf(ordered)) {
      refused_ = fault->message;
      return false;
    }
    end_.layers = std::move(ordered.layers);
    return true;
  }

  /// The signs of unassigned creases are known now: lines are made from what the hinges have.
  void takeLines() {
    for (std::size_t e = 0; e < targets_.angles.size(); ++e) {
      Edge& edge = end_.pattern.edges[e];
      targets_.angles[e] = edge.kind == EdgeKind::Hinge ? edge.angle : 0;
      edge.line = FoldLineId();
    }
    end_.lines.clear();
    makeFoldLines(end_, targets_.angles, end_.rests.front().facet, linesName(step_));
    for (std::size_t e = 0; e < targets_.angles.size(); ++e) {
      flat_.pattern.edges[e] = end_.pattern.edges[e];
      flat_.pattern.edges[e].angle = 0;
    }
    flat_.lines = end_.lines;
  }

  void addMotion(PatternOutcome& outcome) {
    if (!motion_) motion_ = patternMotion(flat_, end_, request_.progress);
    outcome.way = motion_->way;
    const bool isRigid = motion_->way == PatternWay::Rigid && motion_->end;
    if (isRigid && haveSameOrder(*motion_->end, end_)) {
      outcome.movements.push_back(movementAlong(flat_, motion_->path, end_));
      return;
    }
    if (isRigid) outcome.way = PatternWay::MeetsItself;
    outcome.movements = foldingOneByOne(flat_, end_, request_.progress);
    if (!outcome.movements.empty()) outcome.way = PatternWay::OneByOne;
  }

  FoldedState flat_;
  FoldedState end_;
  const PatternStep& step_;
  Targets targets_;
  const PatternRequest& request_;
  std::optional<std::string> refused_;
  std::optional<PatternMotion> motion_;
};

}  // namespace

std::string linesName(const PatternStep& step) { return step.name.empty() ? "crease" : step.name; }

Result<PatternOutcome> foldPattern(const FoldedState& sheet, const PatternStep& step,
                                   const PatternRequest& request) {
  Result<CreasedSheet> creased = creasedSheet(sheet.pattern, step);
  if (!creased) return creased.error();
  Targets targets = targetsOf(*creased, step);
  const Result<std::vector<FacetId>> resting = restingFacets(creased->pattern, step);
  if (!resting) return resting.error();
  FoldedState flat(std::move(creased->pattern));
  flat.collisions = sheet.collisions;
  for (const FacetId f : *resting) flat.rests.push_back({f, sheet.poseOf(FacetId(0))});
  flat.poses = derivePoses(flat.pattern, flat.rests);
  flat.layers = flatLayers(flat.pattern, sheet.layers.sets().front().normal);
  makeFoldLines(flat, targets.angles, resting->front(), linesName(step));
  if (!step.isFolded) return PatternOutcome{std::move(flat), {}, {}, {}};
  return PatternFolding(std::move(flat), step, std::move(targets), request).run();
}

Result<FoldedState> applyPattern(const FoldedState& state, const PatternStep& step,
                                 Movements* record) {
  Result<PatternOutcome> outcome = foldPattern(state, step, {record != nullptr, {}, {}});
  if (!outcome) return outcome.error();
  if (record != nullptr)
    record->insert(record->end(), outcome->movements.begin(), outcome->movements.end());
  return std::move(outcome->state);
}

void nameLayers(const FoldedState& after, PatternStep& step) {
  if (!step.resting) step.resting = namingPointOf(after.pattern, after.rests.front().facet);
  if (step.isFolded && step.layers.empty()) writeLayers(after, step);
}

}  // namespace kiri
