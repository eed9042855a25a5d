// SPDX-License-Identifier: MIT
#include "core/sweep/pierced.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/sweep/facet_body.h"
#include "core/sweep/found.h"

namespace kiri {
namespace {

struct Space {
  Vec3 low;
  Vec3 high;
};

Space spaceOf(const Body& body) {
  Space space{body.hull.front(), body.hull.front()};
  for (const Vec3 p : body.hull) {
    space.low = {std::min(space.low.x, p.x), std::min(space.low.y, p.y),
                 std::min(space.low.z, p.z)};
    space.high = {std::max(space.high.x, p.x), std::max(space.high.y, p.y),
                  std::max(space.high.z, p.z)};
  }
  return space;
}

bool doTouch(const Space& a, const Space& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

class Piercing {
 public:
  explicit Piercing(const FoldedState& state)
      : state_(state),
        frame_({{}, {0, 0, 1}, 1}),
        moves_(state.pattern.facets.size(), false),
        touch_(state.tolerance().match()) {
    for (std::size_t f = 0; f < moves_.size(); ++f) {
      bodies_.push_back(bodyOf(state_, moves_, frame_, FacetId(f)));
      spaces_.push_back(spaceOf(bodies_.back()));
    }
  }

  std::optional<Pierced> run() {
    std::vector<std::size_t> upward(bodies_.size());
    for (std::size_t i = 0; i < upward.size(); ++i) upward[i] = i;
    std::stable_sort(upward.begin(), upward.end(), [&](std::size_t a, std::size_t b) {
      return spaces_[a].low.z < spaces_[b].low.z;
    });
    std::optional<Pierced> doubtful;
    for (std::size_t i = 0; i < upward.size(); ++i) {
      for (std::size_t j = i + 1; j < upward.size(); ++j) {
        if (spaces_[upward[j]].low.z > spaces_[upward[i]].high.z) break;
        if (!canMeet(upward[i], upward[j])) continue;
        const std::optional<Pierced> found = meet(upward[i], upward[j]);
        if (found && found->isCertain) return found;
        if (found && !doubtful) doubtful = found;
      }
    }
    return doubtful;
  }

 private:
  bool canMeet(std::size_t i, std::size_t j) const {
    if (!doTouch(spaces_[i], spaces_[j])) return false;
    const Body& a = bodies_[i];
    const Body& b = bodies_[j];
    if (length(cross(a.normal, b.normal)) <= kSamePlane) return false;
    const double eps = state_.tolerance().length();
    const double slack = a.goesOn || b.goesOn ? -eps : eps;
    return !isBeside(a, b, slack) && !isBeside(b, a, slack);
  }

  static bool isBeside(const Body& a, const Body& b, double slack) {
    bool isAbove = true;
    bool isBelow = true;
    for (const Vec3 p : a.hull) {
      const double height = dot(b.normal, p) - b.offset;
      isAbove = isAbove && height >= -slack;
      isBelow = isBelow && height <= slack;
    }
    return isAbove || isBelow;
  }

  std::optional<Pierced> meet(std::size_t i, std::size_t j) {
    const std::optional<Vec3> near = placeOf(i, j, touch_);
    if (!near) return std::nullopt;
    const bool isCertain = placeOf(i, j, kDoubtful * touch_).has_value();
    return Pierced{FacetId(std::min(i, j)), FacetId(std::max(i, j)), frame_.toModel(*near),
                   isCertain};
  }

  std::optional<Vec3> placeOf(std::size_t i, std::size_t j, double margin) {
    for (const Patch& a : patches(i, margin)) {
      for (const Patch& b : patches(j, margin)) {
        if (const auto place = piercing(a, b, touch_ / 8)) return place;
        if (const auto place = piercing(b, a, touch_ / 8)) return place;
      }
    }
    return std::nullopt;
  }

  const std::vector<Patch>& patches(std::size_t f, double margin) {
    auto& cache = margin > touch_ ? deep_ : near_;
    const auto [at, isNew] = cache.try_emplace(f);
    if (isNew) at->second = insideOf(state_, moves_, frame_, FacetId(f), margin);
    return at->second;
  }

  const FoldedState& state_;
  AxisFrame frame_;
  std::vector<bool> moves_;
  double touch_;
  std::vector<Body> bodies_;
  std::vector<Space> spaces_;
  std::map<std::size_t, std::vector<Patch>> near_;
  std::map<std::size_t, std::vector<Patch>> deep_;
};

}  // namespace

std::optional<Pierced> firstPierced(const FoldedState& state) { return Piercing(state).run(); }

}  // namespace kiri
