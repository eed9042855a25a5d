// How high in its plane each facet lies, counted in layers of paper.
// SPDX-License-Identifier: MIT
#include "core/layers/layer_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/layers/plane_view.h"

namespace kiri {

namespace {

/// The facets of one plane by the squares of a grid that their boxes touch.
class FacetGrid {
 public:
  explicit FacetGrid(double square) : square_(square) {}

  void add(const Box& box, std::size_t place) {
    forSquares(box, [&](Key key) { squares_[key].push_back(place); });
  }

  /// see(place) for what may touch the box, the last added first; some more than once.
  template <class See>
  void visit(const Box& box, const See& see) const {
    forSquares(box, [&](Key key) {
      const auto at = squares_.find(key);
      if (at == squares_.end()) return;
      std::for_each(at->second.rbegin(), at->second.rend(), see);
    });
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;

  template <class Visit>
  void forSquares(const Box& box, const Visit& visit) const {
    const auto square = [this](double v) {
      return static_cast<std::int64_t>(std::floor(v / square_));
    };
    for (std::int64_t x = square(box.low.x); x <= square(box.high.x); ++x) {
      for (std::int64_t y = square(box.low.y); y <= square(box.high.y); ++y) visit(Key{x, y});
    }
  }

  double square_;
  std::map<Key, std::vector<std::size_t>> squares_;
};

class SetLevels {
 public:
  SetLevels(const FoldedState& state, const LayerSet& set)
      : state_(state),
        set_(set),
        view_(state.pattern, state.poses, state.poseOf(set.upward.front())),
        grid_(squareFor()) {}

  /// Levels by place in the list of the set.
  std::vector<std::uint32_t> find() {
    levels_.assign(set_.upward.size(), 0);
    if (set_.exceptions.empty()) {
      stack();
    } else {
      climb();
    }
    return levels_;
  }

 private:
  /// About the size of a facet, so that each touches few squares.
  double squareFor() {
    double sum = 0;
    for (const FacetId facet : set_.upward) {
      const Box& box = view_.footprint(facet).box;
      sum += std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    }
    return std::max(sum / static_cast<double>(set_.upward.size()), state_.tolerance().thin());
  }

  /// In a list the lower layers are known when a facet's turn comes.
  void stack() {
    for (std::size_t place = 0; place < set_.upward.size(); ++place) {
      const Box box = view_.footprint(set_.upward[place]).box;
      grid_.visit(box, [&](std::size_t below) {
        if (levels_[below] < levels_[place]) return;
        if (view_.doOverlap(set_.upward[place], set_.upward[below])) {
          levels_[place] = levels_[below] + 1;
        }
      });
      grid_.add(box, place);
    }
  }

  /// With exceptions: the longest way down, leaving out what would close a ring.
  void climb() {
    const std::size_t count = set_.upward.size();
    below_.assign(count, {});
    for (std::size_t place = 0; place < count; ++place) {
      const Box box = view_.footprint(set_.upward[place]).box;
      std::vector<std::size_t> near;
      grid_.visit(box, [&](std::size_t other) { near.push_back(other); });
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      for (const std::size_t other : near) addPair(place, other);
      grid_.add(box, place);
    }
    visits_.assign(count, Visit::None);
    for (std::size_t place = 0; place < count; ++place) climbFrom(place);
  }

  void addPair(std::size_t a, std::size_t b) {
    if (!view_.doOverlap(set_.upward[a], set_.upward[b])) return;
    if (state_.layers.isAbove(set_.upward[a], set_.upward[b])) {
      below_[a].push_back(b);
    } else {
      below_[b].push_back(a);
    }
  }

  /// Depth first, on a stack of our own: piles may be thousands deep.
  void climbFrom(std::size_t start) {
    struct Frame {
      std::size_t place;
      std::size_t next;
    };
    if (visits_[start] != Visit::None) return;
    visits_[start] = Visit::Open;
    std::vector<Frame> frames = {{start, 0}};
    while (!frames.empty()) {
      const std::size_t place = frames.back().place;
      if (frames.back().next == below_[place].size()) {
        visits_[place] = Visit::Done;
        frames.pop_back();
        if (!frames.empty()) lift(frames.back().place, place);
        continue;
      }
      const std::size_t other = below_[place][frames.back().next++];
      if (visits_[other] == Visit::Done) lift(place, other);
      if (visits_[other] != Visit::None) continue;
      visits_[other] = Visit::Open;
      frames.push_back({other, 0});
    }
  }

  void lift(std::size_t place, std::size_t above) {
    levels_[place] = std::max(levels_[place], levels_[above] + 1);
  }

  enum class Visit : std::uint8_t { None, Open, Done };

  const FoldedState& state_;
  const LayerSet& set_;
  PlaneView view_;
  FacetGrid grid_;
  std::vector<std::uint32_t> levels_;
  std::vector<std::vector<std::size_t>> below_;
  std::vector<Visit> visits_;
};

}  // namespace

std::vector<std::uint32_t> layerLevels(const FoldedState& state) {
  std::vector<std::uint32_t> out(state.pattern.facets.size(), 0);
  for (const LayerSet& set : state.layers.sets()) {
    if (set.upward.size() < 2) continue;
    const std::vector<std::uint32_t> levels = SetLevels(state, set).find();
    for (std::size_t place = 0; place < levels.size(); ++place) {
      out[set.upward[place].index] = levels[place];
    }
  }
  return out;
}

std::vector<Rigid> spreadPoses(const FoldedState& state, double gap) {
  return gap == 0 ? state.poses : spreadPoses(state, gap, layerLevels(state));
}

std::vector<Rigid> spreadPoses(const FoldedState& state, double gap,
                               const std::vector<std::uint32_t>& levels) {
  std::vector<Rigid> out = state.poses;
  for (std::size_t f = 0; f < out.size(); ++f) {
    const Vec3 up = state.layers.sets()[state.layers.setOf(FacetId(f))].normal;
    out[f].origin = out[f].origin + up * (gap * levels[f]);
  }
  return out;
}

}  // namespace kiri
