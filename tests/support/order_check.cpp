// Brute-force check of a layer order.
// SPDX-License-Identifier: MIT
#include "tests/support/order_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

constexpr double kFat = 1e-6;      // of the sheet: thinner overlaps are left out
constexpr double kAside = 2e-6;    // of the sheet: how far beside a hinge the layers are looked at
constexpr double kStretch = 5e-5;  // of the sheet: shorter stretches of a hinge are left out
constexpr double kNear = 1e-7;     // of the sheet: points nearer than this coincide

std::string nameOf(FacetId f) { return "facet " + std::to_string(f.index); }
std::string nameOf(const FoldedState& state, FacetId f) {
  const Vec2 p = interiorPointOf(state.pattern, f);
  return nameOf(f) + " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

/// One plane of the model with the facets that lie in it.
struct Plane {
  Vec3 normal;
  PlaneFrame frame;
  std::vector<FacetId> facets;
  std::vector<Loops> loops;  // of facets, in the frame
};

/// A facet that ends at a place of a hinge line on one side, and how its paper goes on there.
struct Passage {
  enum class Kind { Through, Taco, Up, Down };
  Kind kind = Kind::Through;
  FacetId first;  ///< on the side that is looked at
  FacetId
      second;  ///< Through: on the other side; Taco: the other facet of the fold, on the same side
  double turn = 0;  ///< Up, Down: degrees away from going straight on
};

struct Segment {
  Vec2 a;
  Vec2 b;
};

class OrderCheck {
 public:
  explicit OrderCheck(const FoldedState& state)
      : state_(state), size_(state.tolerance().sheetSize()) {}

  std::vector<std::string> run() {
    if (!checkSets()) return found_;
    gatherPlanes();
    checkAcrossSets();
    for (const Plane& plane : planes_) {
      checkRelation(plane);
      for (std::size_t e = 0; e < state_.pattern.edges.size(); ++e) checkHinge(plane, EdgeId(e));
    }
    return found_;
  }

 private:
  void report(const std::string& what) {
    if (found_.size() < 20 && std::find(found_.begin(), found_.end(), what) == found_.end())
      found_.push_back(what);
  }

  bool checkSets() {
    std::vector<int> seen(state_.pattern.facets.size(), 0);
    for (const LayerSet& set : state_.layers.sets()) {
      if (set.upward.empty()) report("a layer-set is empty");
      for (const FacetId f : set.upward) {
        if (f.index >= seen.size()) {
          report("a layer-set lists a facet that does not exist");
          return false;
        }
        ++seen[f.index];
      }
      for (const auto& [upper, lower] : set.exceptions) {
        if (set.exceptions.count({lower, upper}) != 0) report("exceptions contradict each other");
      }
    }
    for (std::size_t f = 0; f < seen.size(); ++f) {
      if (seen[f] == 1) continue;
      report(nameOf(FacetId(f)) + " stands in " + std::to_string(seen[f]) + " layer-sets");
      return false;
    }
    return true;
  }

  void gatherPlanes() {
    for (const LayerSet& set : state_.layers.sets()) {
      if (set.upward.empty()) continue;
      const FacetId first = set.upward.front();
      Plane plane;
      plane.normal = set.normal;
      plane.frame =
          frameOf(set.normal, state_.poseOf(first).apply(interiorPointOf(state_.pattern, first)));
      plane.facets = set.upward;
      for (const FacetId f : set.upward) {
        checkInPlane(plane, f);
        plane.loops.push_back(
            placed(flatLoopsOf(state_.pattern, f), state_.poseOf(f), plane.frame));
      }
      planes_.push_back(std::move(plane));
    }
  }

  void checkInPlane(const Plane& plane, FacetId f) {
    const Rigid& pose = state_.poseOf(f);
    if (length(cross(pose.normal(), plane.normal)) > kNear)
      report(nameOf(state_, f) + " is tilted in its set");
    for (const EdgeUse use : state_.pattern[f].border) {
      const Vec3 p = pose.apply(state_.pattern[state_.pattern[use.edge].from]);
      if (std::abs(dot(p - plane.frame.origin, plane.normal)) <= kNear * size_) continue;
      report(nameOf(state_, f) + " is off the plane of its set");
      return;
    }
  }

  /// Facets of two sets that lie in one plane and overlap.
  void checkAcrossSets() {
    for (std::size_t a = 0; a < planes_.size(); ++a) {
      for (std::size_t b = a + 1; b < planes_.size(); ++b) {
        if (length(cross(planes_[a].normal, planes_[b].normal)) > kNear) continue;
        const double gap =
            dot(planes_[b].frame.origin - planes_[a].frame.origin, planes_[a].normal);
        if (std::abs(gap) <= kNear * size_ / 10) compareSets(planes_[a], planes_[b]);
      }
    }
  }

  void compareSets(const Plane& a, const Plane& b) {
    for (std::size_t i = 0; i < a.facets.size(); ++i) {
      for (const FacetId g : b.facets) {
        const Loops other = placed(flatLoopsOf(state_.pattern, g), state_.poseOf(g), a.frame);
        if (commonOf({&a.loops[i], &other}).fatness() <= kFat * size_) continue;
        report(nameOf(state_, a.facets[i]) + " and " + nameOf(state_, g) +
               " overlap in one plane but are in different layer-sets");
      }
    }
  }

  bool isAbove(FacetId a, FacetId b) const { return state_.layers.isAbove(a, b); }

  void checkRelation(const Plane& plane) {
    const std::size_t n = plane.facets.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        const bool ij = isAbove(plane.facets[i], plane.facets[j]);
        if (ij == isAbove(plane.facets[j], plane.facets[i])) {
          report(nameOf(state_, plane.facets[i]) + " and " + nameOf(state_, plane.facets[j]) +
                 " are each above the other");
        }
        for (std::size_t k = j + 1; k < n; ++k) {
          if (isAbove(plane.facets[j], plane.facets[k]) != ij ||
              isAbove(plane.facets[k], plane.facets[i]) != ij)
            continue;
          checkCircle(plane, i, j, k);
        }
      }
    }
  }

  void checkCircle(const Plane& plane, std::size_t i, std::size_t j, std::size_t k) {
    const Common common = commonOf({&plane.loops[i], &plane.loops[j], &plane.loops[k]});
    if (common.fatness() <= kFat * size_) return;
    report(nameOf(state_, plane.facets[i]) + ", " + nameOf(state_, plane.facets[j]) + " and " +
           nameOf(state_, plane.facets[k]) +
           " lie above each other in a circle over common ground");
  }

  bool isIn(const Plane& plane, FacetId f) const {
    return f.isValid() &&
           std::find(plane.facets.begin(), plane.facets.end(), f) != plane.facets.end();
  }

  Segment segmentOf(const Plane& plane, const Edge& edge) const {
    const Rigid& pose = state_.poseOf(isIn(plane, edge.left) ? edge.left : edge.right);
    return {plane.frame.flatten(pose.apply(state_.pattern[edge.from])),
            plane.frame.flatten(pose.apply(state_.pattern[edge.to]))};
  }

  void checkHinge(const Plane& plane, EdgeId e) {
    const Edge& edge = state_.pattern[e];
    if (edge.kind != EdgeKind::Hinge) return;
    if (!isIn(plane, edge.left) && !isIn(plane, edge.right)) return;
    if (std::abs(edge.angle) == 180) checkSign(plane, edge);
    const Segment hinge = segmentOf(plane, edge);
    const double span = distance(hinge.a, hinge.b);
    std::vector<double> stops = {0, 1};
    for (const Loops& loops : plane.loops) addStops(loops, hinge, stops);
    std::sort(stops.begin(), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if ((stops[i + 1] - stops[i]) * span < kStretch * size_) continue;
      const double middle = (stops[i] + stops[i + 1]) / 2;
      const Vec2 aside = perpendicular(hinge.b - hinge.a) * (kAside * size_ / span);
      checkPlace(plane, e, lerp(hinge.a, hinge.b, middle), aside);
    }
  }

  /// Where borders meet the hinge: crossings, and corners that lie on it.
  void addStops(const Loops& loops, const Segment& hinge, std::vector<double>& stops) const {
    const Vec2 d = hinge.b - hinge.a;
    const double span = length(d);
    for (const std::vector<Vec2>& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 p = loop[i];
        const Vec2 q = loop[(i + 1) % loop.size()];
        const double hp = cross(d, p - hinge.a) / span;
        const double hq = cross(d, q - hinge.a) / span;
        double at = -1;
        if (std::abs(hp) <= 3 * kAside * size_) {
          at = dot(p - hinge.a, d) / (span * span);
        } else if ((hp < 0) != (hq < 0)) {
          at = dot(lerp(p, q, hp / (hp - hq)) - hinge.a, d) / (span * span);
        }
        if (at > 0 && at < 1) stops.push_back(at);
      }
    }
  }

  void checkSign(const Plane& plane, const Edge& edge) {
    if (!isIn(plane, edge.left) || !isIn(plane, edge.right)) {
      report("a hinge folded flat joins facets of two layer-sets");
      return;
    }
    const bool frontIsUp = dot(state_.poseOf(edge.left).normal(), plane.normal) > 0;
    if (isAbove(edge.right, edge.left) != ((edge.angle > 0) == frontIsUp)) {
      report(std::string(edge.angle > 0 ? "valley" : "mountain") + " between " +
             nameOf(state_, edge.left) + " and " + nameOf(state_, edge.right) +
             " has its facets the wrong way round");
    }
  }

  /// How the paper of the plane runs at `place`, seen from the side of `aside`.
  std::vector<Passage> passagesAt(const Plane& plane, Vec2 place, Vec2 aside) const {
    std::vector<FacetId> here;
    std::vector<FacetId> there;
    for (std::size_t i = 0; i < plane.facets.size(); ++i) {
      if (contains(plane.loops[i], place + aside)) here.push_back(plane.facets[i]);
      if (contains(plane.loops[i], place - aside)) there.push_back(plane.facets[i]);
    }
    const auto isHere = [&here](FacetId f) {
      return std::find(here.begin(), here.end(), f) != here.end();
    };
    const auto isThere = [&there](FacetId f) {
      return std::find(there.begin(), there.end(), f) != there.end();
    };
    std::vector<Passage> passages;
    std::vector<FacetId> ended;
    for (const Edge& edge : state_.pattern.edges) {
      if (!runsAlong(plane, edge, place, aside)) continue;
      for (const FacetId f : {edge.left, edge.right}) {
        if (f.isValid()) ended.push_back(f);
      }
      if (edge.kind == EdgeKind::Hinge) addPassages(plane, edge, isHere, isThere, passages);
    }
    for (const FacetId f : here) {
      const bool ends = std::find(ended.begin(), ended.end(), f) != ended.end();
      if (!ends && isThere(f)) passages.push_back({Passage::Kind::Through, f, f});
    }
    return passages;
  }

  template <class Here, class There>
  void addPassages(const Plane& plane, const Edge& edge, Here isHere, There isThere,
                   std::vector<Passage>& passages) const {
    for (const FacetId f : {edge.left, edge.right}) {
      const FacetId g = f == edge.left ? edge.right : edge.left;
      if (!isIn(plane, f) || !isHere(f)) continue;
      if (edge.angle == 0) {
        if (isThere(g)) passages.push_back({Passage::Kind::Through, f, g});
      } else if (std::abs(edge.angle) == 180) {
        if (f == edge.left && isHere(g)) passages.push_back({Passage::Kind::Taco, f, g});
      } else {
        const bool isUp = (edge.angle > 0) == (dot(state_.poseOf(f).normal(), plane.normal) > 0);
        passages.push_back(
            {isUp ? Passage::Kind::Up : Passage::Kind::Down, f, g, std::abs(edge.angle)});
      }
    }
  }

  bool runsAlong(const Plane& plane, const Edge& edge, Vec2 place, Vec2 aside) const {
    if (edge.isCurved() || (!isIn(plane, edge.left) && !isIn(plane, edge.right))) return false;
    const Segment s = segmentOf(plane, edge);
    const double span = distance(s.a, s.b);
    const Vec2 d = (s.b - s.a) / span;
    if (std::abs(dot(d, aside)) > 0.1 * length(aside)) return false;
    const double along = dot(place - s.a, d);
    return std::abs(cross(d, place - s.a)) <= kNear * size_ && along > 0 && along < span;
  }

  void checkPlace(const Plane& plane, EdgeId e, Vec2 place, Vec2 aside) {
    for (const Vec2 side : {aside, -aside}) {
      const std::vector<Passage> passages = passagesAt(plane, place, side);
      for (std::size_t i = 0; i < passages.size(); ++i) {
        for (std::size_t j = 0; j < passages.size(); ++j) {
          if (i != j && !agree(passages[i], passages[j]))
            reportPassage(e, passages[i], passages[j]);
        }
      }
    }
  }

  void reportPassage(EdgeId e, const Passage& a, const Passage& b) {
    static const char* const kNames[] = {"through", "taco", "up", "down"};
    const auto text = [this](const Passage& p) {
      return std::string(kNames[static_cast<int>(p.kind)]) + " " + nameOf(p.first) + "|" +
             nameOf(p.second);
    };
    const Edge& edge = state_.pattern[e];
    const Vec2 middle = lerp(state_.pattern[edge.from], state_.pattern[edge.to], 0.5);
    report("paper passes through paper at the hinge by (" + std::to_string(middle.x) + ", " +
           std::to_string(middle.y) + "): " + text(a) + " against " + text(b));
  }

  bool isBetween(FacetId f, const Passage& taco) const {
    return isAbove(f, taco.first) != isAbove(f, taco.second);
  }

  /// Whether `f` lies on the side of the front of `g`.
  bool isInFront(FacetId f, FacetId g) const {
    const Vec3 normal = state_.layers.sets()[state_.layers.setOf(g)].normal;
    return isAbove(f, g) == (dot(state_.poseOf(g).normal(), normal) > 0);
  }

  /// Two sheets that bend by the same angle along the same line: the one that is in front stays so.
  bool isTied(const Passage& a, const Passage& b) const {
    if (!state_.layers.areCoplanar(a.second, b.second)) return true;
    return isInFront(a.first, b.first) == isInFront(a.second, b.second);
  }

  /// Whether two runs of paper get past each other. Looks at the pair in this order only.
  bool agree(const Passage& a, const Passage& b) const {
    using Kind = Passage::Kind;
    if (a.first == b.first || a.second == b.second) return true;
    if (b.kind == Kind::Taco && (a.first == b.second || a.second == b.first)) return true;
    switch (a.kind) {
      case Kind::Through:
        if (b.kind == Kind::Through)
          return isAbove(a.first, b.first) == isAbove(a.second, b.second);
        if (b.kind == Kind::Taco) return !isBetween(a.first, b);
        return true;
      case Kind::Taco:
        if (b.kind == Kind::Taco) return isBetween(a.first, b) == isBetween(a.second, b);
        return true;
      case Kind::Up:
        if (b.kind == Kind::Through || b.kind == Kind::Down) return isAbove(a.first, b.first);
        if (b.kind == Kind::Taco) return !isBetween(a.first, b);
        if (std::abs(a.turn - b.turn) <= kSame) return isTied(a, b);
        return a.turn < b.turn || isAbove(a.first, b.first);
      case Kind::Down:
        if (b.kind == Kind::Through || b.kind == Kind::Up) return isAbove(b.first, a.first);
        if (b.kind == Kind::Taco) return !isBetween(a.first, b);
        if (std::abs(a.turn - b.turn) <= kSame) return isTied(a, b);
        return a.turn < b.turn || isAbove(b.first, a.first);
    }
    return true;
  }

  static constexpr double kSame = 1e-6;  // degrees

  const FoldedState& state_;
  double size_;
  std::vector<Plane> planes_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> orderViolations(const FoldedState& state) {
  return OrderCheck(state).run();
}

}  // namespace kiri::test
