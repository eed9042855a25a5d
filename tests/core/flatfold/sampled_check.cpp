// SPDX-License-Identifier: MIT
#include "tests/core/flatfold/sampled_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <unordered_map>

#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

struct Line {
  Vec2 a;
  Vec2 b;
};

/// Things with boxes, found by place.
class Squares {
 public:
  Squares(Vec2 low, Vec2 high) : low_(low), high_(high), lists_(kSide * kSide) {}

  void add(std::uint32_t item, const std::vector<Vec2>& points, double around) {
    int from[2] = {kSide, kSide};
    int to[2] = {0, 0};
    for (const Vec2 p : points) {
      from[0] = std::min(from[0], step(p.x - around, low_.x, high_.x));
      from[1] = std::min(from[1], step(p.y - around, low_.y, high_.y));
      to[0] = std::max(to[0], step(p.x + around, low_.x, high_.x));
      to[1] = std::max(to[1], step(p.y + around, low_.y, high_.y));
    }
    for (int y = from[1]; y <= to[1]; ++y) {
      for (int x = from[0]; x <= to[0]; ++x) lists_[index(x, y)].push_back(item);
    }
  }
  const std::vector<std::uint32_t>& at(Vec2 p) const {
    return lists_[index(step(p.x, low_.x, high_.x), step(p.y, low_.y, high_.y))];
  }

 private:
  static constexpr int kSide = 128;
  static int step(double at, double low, double high) {
    return std::clamp(static_cast<int>((at - low) / (high - low) * kSide), 0, kSide - 1);
  }
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }
  Vec2 low_;
  Vec2 high_;
  std::vector<std::vector<std::uint32_t>> lists_;
};

class Sampler {
 public:
  Sampler(const FoldedState& state, double blur)
      : state_(state), blur_(blur * state.tolerance().sheetSize()) {
    readShape();
    for (const LayerSet& set : state.layers.sets()) {
      for (const auto& [upper, lower] : set.exceptions) {
        exceptions_[upper.index].push_back(lower.index);
      }
    }
  }

  SampledCheck run(std::size_t perHinge) {
    Random random(7);
    for (std::size_t e = 0; e < lines_.size(); ++e) {
      if (state_.pattern.edges[e].kind != EdgeKind::Hinge) continue;
      for (std::size_t n = 0; n < perHinge; ++n) {
        look(lerp(lines_[e].a, lines_[e].b, random.between(0.02, 0.98)), lines_[e]);
      }
    }
    return std::move(result_);
  }

 private:
  void readShape() {
    Vec2 low{1e300, 1e300};
    Vec2 high{-1e300, -1e300};
    for (std::uint32_t f = 0; f < state_.pattern.facets.size(); ++f) {
      corners_.emplace_back();
      for (const EdgeUse use : state_.pattern.facets[f].border) {
        const Vec3 p = state_.poses[f].apply(state_.pattern[startOf(state_.pattern, use)]);
        corners_.back().push_back({p.x, p.y});
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    facets_ = std::make_unique<Squares>(low, high);
    edges_ = std::make_unique<Squares>(low, high);
    for (std::uint32_t f = 0; f < corners_.size(); ++f) facets_->add(f, corners_[f], 0);
    for (std::uint32_t e = 0; e < state_.pattern.edges.size(); ++e) {
      const Edge& edge = state_.pattern.edges[e];
      const Rigid& pose = state_.poseOf(edge.left.isValid() ? edge.left : edge.right);
      const Vec3 a = pose.apply(state_.pattern[edge.from]);
      const Vec3 b = pose.apply(state_.pattern[edge.to]);
      lines_.push_back({{a.x, a.y}, {b.x, b.y}});
      edges_->add(e, {lines_[e].a, lines_[e].b}, 4 * blur_);
    }
  }

  bool covers(std::uint32_t f, Vec2 p) const {
    bool isIn = false;
    const std::vector<Vec2>& c = corners_[f];
    // Loops of holes follow the outer one; sides between loops are left out by walking uses.
    const Facet& facet = state_.pattern.facets[f];
    std::size_t start = 0;
    for (std::size_t loop = 0; loop <= facet.holeStarts.size(); ++loop) {
      const std::size_t end = loop < facet.holeStarts.size() ? facet.holeStarts[loop] : c.size();
      for (std::size_t i = start, j = end - 1; i < end; j = i++) {
        if ((c[i].y > p.y) != (c[j].y > p.y) &&
            p.x < (c[j].x - c[i].x) * (p.y - c[i].y) / (c[j].y - c[i].y) + c[i].x) {
          isIn = !isIn;
        }
      }
      start = end;
    }
    return isIn;
  }

  /// Distance from a segment, and whether the segment runs along `line`.
  double distanceTo(const Line& s, Vec2 p) const {
    const Vec2 d = s.b - s.a;
    const double t = std::clamp(dot(p - s.a, d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
    return distance(p, lerp(s.a, s.b, t));
  }

  /// The edges that run through the place along the line; none when others are so near that sides
  /// cannot be told.
  bool edgesThrough(Vec2 place, const Line& line, std::vector<std::uint32_t>& through) const {
    const Vec2 along = normalized(line.b - line.a);
    for (const std::uint32_t e : edges_->at(place)) {
      const Line& s = lines_[e];
      if (distanceTo(s, place) > 3 * blur_) continue;
      const double t = dot(s.b - place, along);
      const double u = dot(s.a - place, along);
      const bool isAlong = std::abs(cross(s.a - place, along)) < blur_ / 3 &&
                           std::abs(cross(s.b - place, along)) < blur_ / 3;
      const bool isOver = std::min(t, u) < -3 * blur_ && std::max(t, u) > 3 * blur_;
      if (!isAlong || !isOver) return false;
      through.push_back(e);
    }
    return true;
  }

  void report(const std::string& what, Vec2 place) {
    if (result_.violations.size() >= 10) return;
    result_.violations.push_back(what + " at (" + std::to_string(place.x) + ", " +
                                 std::to_string(place.y) + ")");
  }

  /// The facets over a place from bottom to top; none when they go round.
  bool layersAt(Vec2 p, std::vector<std::uint32_t>& stack) {
    for (const std::uint32_t f : facets_->at(p)) {
      if (covers(f, p)) stack.push_back(f);
    }
    const auto rankOf = [&](std::uint32_t f) { return state_.layers.rankOf(FacetId(f)); };
    std::sort(stack.begin(), stack.end(),
              [&](std::uint32_t f, std::uint32_t g) { return rankOf(f) < rankOf(g); });
    std::vector<std::size_t> below(stack.size());
    for (std::size_t i = 0; i < stack.size(); ++i) below[i] = i;
    for (std::size_t i = 0; i < stack.size() && !exceptions_.empty(); ++i) {
      const auto turned = exceptions_.find(stack[i]);
      if (turned == exceptions_.end()) continue;
      for (const std::uint32_t lower : turned->second) {
        const auto at = std::find(stack.begin(), stack.end(), lower);
        if (at == stack.end()) continue;
        ++below[i];
        --below[static_cast<std::size_t>(at - stack.begin())];
      }
    }
    std::vector<std::uint32_t> sorted(stack.size(), ~0U);
    for (std::size_t i = 0; i < stack.size(); ++i) {
      if (below[i] >= stack.size() || sorted[below[i]] != ~0U) return false;
      sorted[below[i]] = stack[i];
    }
    stack = sorted;
    return true;
  }

  void look(Vec2 place, const Line& line) {
    const Vec2 aside = perpendicular(normalized(line.b - line.a)) * blur_;
    std::vector<std::uint32_t> through;
    if (!edgesThrough(place, line, through)) {
      ++result_.skipped;
      return;
    }
    ++result_.places;
    std::vector<std::uint32_t> left;
    std::vector<std::uint32_t> right;
    if (!layersAt(place + aside, left) || !layersAt(place - aside, right)) {
      return report("layers go round", place);
    }
    checkPassage(through, left, right, place);
    checkBrackets(through, left, place);
    checkBrackets(through, right, place);
  }

  /// Paper that goes on across the line keeps its order.
  void checkPassage(const std::vector<std::uint32_t>& through,
                    const std::vector<std::uint32_t>& left, const std::vector<std::uint32_t>& right,
                    Vec2 place) {
    std::unordered_map<std::uint32_t, std::size_t> rightPlace;
    for (std::size_t i = 0; i < right.size(); ++i) rightPlace[right[i]] = i;
    std::map<std::uint32_t, std::uint32_t> goesOnAs;
    for (const std::uint32_t e : through) {
      const Edge& edge = state_.pattern.edges[e];
      for (const FacetId f : {edge.left, edge.right}) {
        if (!f.isValid()) continue;
        const bool isFlat = edge.kind == EdgeKind::Hinge && edge.angle == 0;
        goesOnAs[f.index] = isFlat ? across(edge, f).index : ~0U;
      }
    }
    std::size_t last = 0;
    for (const std::uint32_t f : left) {
      const auto other = goesOnAs.find(f);
      const auto at = rightPlace.find(other == goesOnAs.end() ? f : other->second);
      if (at == rightPlace.end()) continue;
      if (at->second + 1 < last) report("paper passes through paper", place);
      last = std::max(last, at->second + 1);
    }
  }

  /// Folds on one side close like brackets; what goes on to the other side is in no bracket.
  void checkBrackets(const std::vector<std::uint32_t>& through,
                     const std::vector<std::uint32_t>& stack, Vec2 place) {
    std::unordered_map<std::uint32_t, std::uint32_t> foldOf;
    std::unordered_map<std::uint32_t, bool> isRim;
    for (const std::uint32_t e : through) {
      const Edge& edge = state_.pattern.edges[e];
      for (const FacetId f : {edge.left, edge.right}) {
        if (!f.isValid()) continue;
        if (edge.kind != EdgeKind::Hinge) isRim[f.index] = true;
        if (edge.kind == EdgeKind::Hinge && edge.angle != 0) foldOf[f.index] = e;
      }
    }
    std::vector<std::uint32_t> open;
    for (const std::uint32_t f : stack) {
      const auto fold = foldOf.find(f);
      if (fold == foldOf.end()) {
        if (isRim.count(f) == 0 && !open.empty()) report("paper passes through a fold", place);
      } else if (!open.empty() && open.back() == fold->second) {
        open.pop_back();
      } else if (std::find(open.begin(), open.end(), fold->second) != open.end()) {
        return report("folds pass through each other", place);
      } else {
        open.push_back(fold->second);
      }
    }
    if (!open.empty()) report("a fold has one side only", place);
  }

  const FoldedState& state_;
  double blur_;
  std::vector<std::vector<Vec2>> corners_;
  std::vector<Line> lines_;
  std::unique_ptr<Squares> facets_;
  std::unique_ptr<Squares> edges_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> exceptions_;
  SampledCheck result_;
};

}  // namespace

SampledCheck sampledCheck(const FoldedState& state, std::size_t perHinge, double blur) {
  return Sampler(state, blur).run(perHinge);
}

}  // namespace kiri::test
