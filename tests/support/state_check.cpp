// What must hold of every state.
// SPDX-License-Identifier: MIT
#include "tests/support/state_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "tests/support/crossing_check.h"
#include "tests/support/order_check.h"
#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

constexpr double kHold = 1e-9;  // of the sheet: what the two sides of a hinge may differ by

std::string textOf(Vec2 p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

class PatternCheck {
 public:
  explicit PatternCheck(const CreasePattern& pattern)
      : pattern_(pattern), size_(pattern.tolerance.sheetSize()) {}

  std::vector<std::string> run() {
    if (!idsAreValid()) return found_;
    checkVertices();
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) checkEdge(EdgeId(e));
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) checkFacet(FacetId(f));
    checkUses();
    checkDisjoint();
    return found_;
  }

 private:
  void report(const std::string& what) { found_.push_back(what); }

  bool idsAreValid() {
    for (const Edge& edge : pattern_.edges) {
      for (const FacetId f : {edge.left, edge.right}) {
        if (f.isValid() && f.index >= pattern_.facets.size())
          report("an edge names a facet that does not exist");
      }
      if (edge.from.index >= pattern_.vertices.size() ||
          edge.to.index >= pattern_.vertices.size()) {
        report("an edge names a vertex that does not exist");
      }
      if (edge.isCurved() && edge.curve >= pattern_.curves.size())
        report("an edge names a curve that does not exist");
    }
    for (const Facet& facet : pattern_.facets) {
      for (const EdgeUse use : facet.border) {
        if (use.edge.index >= pattern_.edges.size())
          report("a facet names an edge that does not exist");
      }
    }
    return found_.empty();
  }

  void checkVertices() {
    for (std::size_t i = 0; i < pattern_.vertices.size(); ++i) {
      for (std::size_t j = i + 1; j < pattern_.vertices.size(); ++j) {
        if (distance(pattern_.vertices[i], pattern_.vertices[j]) < pattern_.tolerance.length()) {
          report("two vertices at " + textOf(pattern_.vertices[i]));
        }
      }
    }
  }

  void checkEdge(EdgeId e) {
    const Edge& edge = pattern_[e];
    const std::string at =
        " at " + textOf(pattern_[edge.from]) + " to " + textOf(pattern_[edge.to]);
    const int sides = (edge.left.isValid() ? 1 : 0) + (edge.right.isValid() ? 1 : 0);
    if (sides == 0) report("an edge without paper" + at);
    if (edge.from == edge.to && !edge.isCurved()) report("a straight edge without length" + at);
    if (edge.kind == EdgeKind::Border && sides == 2)
      report("a border with paper on both sides" + at);
    if (edge.kind != EdgeKind::Border && sides != 2)
      report("a hinge, tear or cut with paper on one side" + at);
    if (edge.kind == EdgeKind::Hinge && edge.isCurved()) report("a curved hinge" + at);
    if (edge.kind == EdgeKind::Hinge && edge.left == edge.right && edge.angle != 0)
      report("a folded hinge within one facet" + at);
    if (std::abs(edge.angle) > 180 || std::isnan(edge.angle))
      report("a fold angle beyond 180 degrees" + at);
    if (edge.sign != 1 && edge.sign != -1) report("a sign that is no sign" + at);
  }

  void checkFacet(FacetId f) {
    const Facet& facet = pattern_[f];
    const std::string name = "facet " + std::to_string(f.index);
    if (facet.border.empty()) {
      report(name + " has no border");
      return;
    }
    std::vector<std::size_t> starts = {0};
    for (const std::uint32_t s : facet.holeStarts) starts.push_back(s);
    starts.push_back(facet.border.size());
    for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
      if (starts[loop] >= starts[loop + 1]) {
        report(name + " has an empty loop");
        continue;
      }
      double twice = 0;
      for (std::size_t i = starts[loop]; i < starts[loop + 1]; ++i) {
        const std::size_t next = i + 1 == starts[loop + 1] ? starts[loop] : i + 1;
        if (endOf(pattern_, facet.border[i]) != startOf(pattern_, facet.border[next])) {
          report(name + " has a loop that does not close");
        }
        twice += doubleArea(arcOf(pattern_, facet.border[i]));
      }
      if (loop == 0 && twice <= 0) report(name + " runs the wrong way round or has no area");
      if (loop > 0 && twice > 0) report(name + " has a hole that runs the wrong way round");
    }
    if (kiri::areaOf(regionOf(pattern_, f)) <= 0) report(name + " has no area");
  }

  /// Each facet lists an edge exactly as often and in the direction that the edge says.
  void checkUses() {
    std::vector<int> lefts(pattern_.edges.size(), 0);
    std::vector<int> rights(pattern_.edges.size(), 0);
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) {
      for (const EdgeUse use : pattern_.facets[f].border) {
        const Edge& edge = pattern_[use.edge];
        if ((use.isReversed ? edge.right : edge.left) != FacetId(f)) {
          report("facet " + std::to_string(f) + " lists an edge that does not name it there");
        }
        ++(use.isReversed ? rights : lefts)[use.edge.index];
      }
    }
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      if (lefts[e] != (edge.left.isValid() ? 1 : 0) ||
          rights[e] != (edge.right.isValid() ? 1 : 0)) {
        report("the edge from " + textOf(pattern_[edge.from]) + " to " + textOf(pattern_[edge.to]) +
               " is not listed once by each of its facets");
      }
    }
  }

  void checkDisjoint() {
    std::vector<Loops> all;
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f)
      all.push_back(flatLoopsOf(pattern_, FacetId(f)));
    const PlaneFrame frame{
        {0, 0, 0}, {0.8, -0.6, 0}, {0.6, 0.8, 0}};  // no border stands upright here
    for (Loops& loops : all) loops = placed(loops, Rigid{}, frame);
    for (std::size_t f = 0; f < all.size(); ++f) {
      for (std::size_t g = f + 1; g < all.size(); ++g) {
        if (commonOf({&all[f], &all[g]}).fatness() > 1e-7 * size_) {
          report("facets " + std::to_string(f) + " and " + std::to_string(g) +
                 " are made of the same paper");
        }
      }
    }
  }

  const CreasePattern& pattern_;
  double size_;
  std::vector<std::string> found_;
};

/// A point turned about a line by the formula of Rodrigues.
Vec3 turned(Vec3 p, Vec3 point, Vec3 axis, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  const Vec3 r = p - point;
  return point + r * std::cos(radians) + cross(axis, r) * std::sin(radians) +
         axis * (dot(axis, r) * (1 - std::cos(radians)));
}

bool isRigid(const Rigid& pose) {
  const double worst =
      std::max({std::abs(dot(pose.x, pose.x) - 1), std::abs(dot(pose.y, pose.y) - 1),
                std::abs(dot(pose.x, pose.y)), length(cross(pose.x, pose.y) - pose.z)});
  return worst < kHold;
}

void checkDihedral(const FoldedState& state, const Edge& edge, std::vector<std::string>& found) {
  const Rigid& f = state.poseOf(edge.left);
  const Rigid& g = state.poseOf(edge.right);
  const Vec2 along = normalized(state.pattern[edge.to] - state.pattern[edge.from]);
  const Vec3 axis = f.direction(along);
  const double turn =
      std::atan2(dot(cross(f.normal(), g.normal()), axis), dot(f.normal(), g.normal()));
  double off = std::abs(-turn * 180 / std::numbers::pi - edge.angle);
  off = std::min(off, std::abs(360 - off));
  if (off > 1e-6) {
    found.push_back("the hinge from " + textOf(state.pattern[edge.from]) +
                    " stands at another angle than " + std::to_string(edge.angle));
  }
}

/// Poses as three points of each facet, found by turning them about hinges in the model frame,
/// depth first.
class Walk {
 public:
  explicit Walk(const FoldedState& state) : state_(state), images_(state.pattern.facets.size()) {}

  std::vector<std::string> run() {
    std::vector<int> rests(state_.pattern.facets.size(), 0);
    for (const Rest& rest : state_.rests) {
      if (rest.facet.index >= images_.size()) return {"a rest names a facet that does not exist"};
      if (!images_[rest.facet.index].empty()) return {"two rests hold one piece"};
      place(rest.facet, rest.pose);
    }
    std::vector<std::string> found;
    for (std::size_t f = 0; f < images_.size(); ++f) {
      if (images_[f].empty()) {
        found.push_back("facet " + std::to_string(f) + " hangs on no rest");
        continue;
      }
      const double size = state_.tolerance().sheetSize();
      for (std::size_t i = 0; i < 3; ++i) {
        const double off = distance(images_[f][i], state_.poses[f].apply(kPoints[i] * size));
        if (off > 1e-8 * size) {
          found.push_back("facet " + std::to_string(f) + " lies " + std::to_string(off) +
                          " mm from where its hinges put it");
        }
      }
    }
    return found;
  }

 private:
  static constexpr Vec2 kPoints[3] = {{0, 0}, {1, 0}, {0, 1}};  // times the size of the sheet
  using Turn = std::pair<std::size_t, EdgeId>;

  /// Walks with a stack of its own: a halved sheet is thousands of facets deep.
  void place(FacetId first, const Rigid& pose) {
    std::vector<std::pair<FacetId, Rigid>> stack;
    set(first, pose);
    stack.emplace_back(first, pose);
    while (!stack.empty()) {
      const auto [f, at] = stack.back();
      stack.pop_back();
      for (const EdgeUse use : state_.pattern[f].border) {
        const Edge& edge = state_.pattern[use.edge];
        if (edge.kind != EdgeKind::Hinge) continue;
        const FacetId g = across(edge, f);
        if (!images_[g.index].empty()) continue;
        const Rigid next = beyond(edge, at, use.isReversed);
        set(g, next);
        stack.emplace_back(g, next);
      }
    }
  }

  void set(FacetId f, const Rigid& pose) {
    const double size = state_.tolerance().sheetSize();
    for (const Vec2 p : kPoints) images_[f.index].push_back(pose.apply(p * size));
  }

  /// The pose of the facet on the other side: the paper straight on, turned towards this front by
  /// the angle.
  Rigid beyond(const Edge& edge, const Rigid& at, bool isReversed) const {
    const Vec2 a = state_.pattern[isReversed ? edge.to : edge.from];
    const Vec2 b = state_.pattern[isReversed ? edge.from : edge.to];
    const Vec3 point = at.apply(a);
    const Vec3 axis = normalized(at.apply(b) - point);
    const Vec3 origin = turned(at.apply(Vec2{0, 0}), point, axis, -edge.angle);
    const Vec3 x = turned(at.apply(Vec2{1, 0}), point, axis, -edge.angle) - origin;
    const Vec3 y = turned(at.apply(Vec2{0, 1}), point, axis, -edge.angle) - origin;
    return {x, y, cross(x, y), origin};
  }

  const FoldedState& state_;
  std::vector<std::vector<Vec3>> images_;
};

void checkLines(const FoldedState& state, std::vector<std::string>& found) {
  std::set<std::string> names;
  for (const FoldLine& line : state.lines) {
    if (!names.insert(line.name).second)
      found.push_back("two fold lines are called '" + line.name + "'");
  }
  for (const Edge& edge : state.pattern.edges) {
    if (edge.line.isValid() && edge.line.index >= state.lines.size()) {
      found.push_back("an edge names a fold line that does not exist");
    }
  }
}

}  // namespace

std::vector<std::string> patternViolations(const CreasePattern& pattern) {
  return PatternCheck(pattern).run();
}

std::vector<std::string> poseViolations(const FoldedState& state) {
  std::vector<std::string> found;
  if (state.poses.size() != state.pattern.facets.size())
    return {"there is not one pose for each facet"};
  for (std::size_t f = 0; f < state.poses.size(); ++f) {
    if (!isRigid(state.poses[f]))
      found.push_back("the pose of facet " + std::to_string(f) + " is no rigid motion");
  }
  const double gap = hingeGap(state);
  if (gap > kHold * state.tolerance().sheetSize()) {
    found.push_back("the two sides of a hinge are " + std::to_string(gap) + " mm apart");
  }
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) checkDihedral(state, edge, found);
  }
  for (std::string& sentence : Walk(state).run()) found.push_back(std::move(sentence));
  return found;
}

std::vector<std::string> violationsOf(const FoldedState& state) {
  std::vector<std::string> found = patternViolations(state.pattern);
  if (!found.empty()) return found;  // the rest reads the pattern and would trip over it
  checkLines(state, found);
  for (std::string& sentence : poseViolations(state)) found.push_back(std::move(sentence));
  for (std::string& sentence : orderViolations(state)) found.push_back(std::move(sentence));
  for (std::string& sentence : crossingViolations(state)) found.push_back(std::move(sentence));
  return found;
}

double hingeGap(const FoldedState& state) {
  double worst = 0;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec2 p = state.pattern[v];
      worst = std::max(
          worst, distance(state.poseOf(edge.left).apply(p), state.poseOf(edge.right).apply(p)));
    }
  }
  return worst;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += "\n  " + sentence;
  return text;
}

}  // namespace kiri::test
