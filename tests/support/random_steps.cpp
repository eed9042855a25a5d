// Random steps of all kinds.
// SPDX-License-Identifier: MIT
#include "tests/support/random_steps.h"
#include "core/geometry/bounds.h"

#include <algorithm>
#include <cmath>

namespace kiri::test {
namespace {

/// Writes steps for one state.
class Chooser {
 public:
  Chooser(Random& random, const FoldedState& state, const RandomStepOptions& options)
      : random_(random), state_(state), options_(options) {
    const Box box = boundsOf(state.pattern.vertices);
    low_ = box.low;
    high_ = box.high;
  }

  Action action() {
    const bool isFull = state_.pattern.facets.size() >= options_.facetLimit;
    const double pick = random_.unit();
    if (!isFull) {
      if (pick < 0.42) return fold();
      if (pick < 0.47) return AddEdgeStep{line(), layers()};
      if (pick < 0.52 && options_.hasCuts) return straightCut();
      if (pick < 0.57 && options_.hasCuts) return curveCut();
    }
    if (pick < 0.67 && options_.hasTears) return tear();
    if (pick < 0.71 && options_.hasTears) return MendStep{};
    if (pick < 0.80) return angle();
    if (pick < 0.86) return UnfoldStep{someLines(), sequence()};
    if (pick < 0.90) return RefoldStep{someLines(), sequence()};
    if (pick < 0.94)
      return TurnOverStep{random_.chance(0.5) ? TurnAxis::Vertical : TurnAxis::Horizontal};
    if (pick < 0.97) return rotate();
    return MoveStep{{std::round(random_.between(-20, 20)), std::round(random_.between(-20, 20))}};
  }

 private:
  FacetId facet() { return FacetId(random_.below(state_.pattern.facets.size())); }
  Vec2 placeIn(FacetId f) { return interiorPointOf(state_.pattern, f); }

  /// Often a vertex, the middle of an edge, or a point of an eighth grid; else anywhere on the box
  /// of the sheet.
  Vec2 point() {
    const double pick = random_.unit();
    const CreasePattern& pattern = state_.pattern;
    if (pick < 0.2) return pattern.vertices[random_.below(pattern.vertices.size())];
    if (pick < 0.35) {
      const Edge& e = pattern.edges[random_.below(pattern.edges.size())];
      return lerp(pattern[e.from], pattern[e.to], 0.5);
    }
    const Vec2 size = high_ - low_;
    if (pick < 0.6) {
      return low_ + Vec2{size.x * static_cast<double>(random_.below(9)) / 8,
                         size.y * static_cast<double>(random_.below(9)) / 8};
    }
    return low_ + Vec2{random_.unit() * size.x, random_.unit() * size.y};
  }

  Vec2 inModel(Vec2 paper) {
    const std::optional<FacetId> f = facetAt(state_.pattern, paper);
    return flatten(state_.poseOf(f ? *f : FacetId(std::size_t{0})).apply(paper));
  }

  DrawnLine line() {
    Vec2 a = point();
    Vec2 b = point();
    for (int i = 0; i < 20 && distance(a, b) < 0.05 * state_.tolerance().sheetSize(); ++i)
      b = point();
    DrawnLine drawn;
    if (random_.chance(0.6)) {
      drawn.frame = Frame::Model;
      a = inModel(a);
      b = inModel(b);
    } else if (random_.chance(0.5)) {
      drawn.facet = placeIn(facet());
    }
    const double reach = random_.chance(0.7) ? 2.0 : random_.between(0, 0.3);
    drawn.from = a + (a - b) * reach;
    drawn.to = b + (b - a) * reach;
    return drawn;
  }

  std::vector<Place> someFacets() {
    std::vector<Place> places;
    const std::size_t count = 1 + random_.below(3);
    for (std::size_t i = 0; i < count; ++i) places.push_back({Frame::Paper, placeIn(facet())});
    return places;
  }

  LayerChoice layers() {
    const double pick = random_.unit();
    if (pick < 0.55) return AllLayers{};
    if (pick < 0.8) return TopLayers{1 + static_cast<int>(random_.below(4))};
    return ChosenLayers{someFacets()};
  }

  double amount() {
    if (!options_.hasAngles || random_.chance(0.7)) return 180;
    if (random_.chance(0.5)) return 90;
    return random_.between(1, 179);
  }

  Action fold() {
    FoldStep step;
    step.name =
        "f" + std::to_string(state_.lines.size()) + "x" + std::to_string(random_.below(10000));
    step.line = line();
    step.type = random_.chance(0.5) ? FoldType::Valley : FoldType::Mountain;
    step.angle = amount();
    step.layers = layers();
    const double pick = random_.unit();
    if (pick < 0.6) {
      step.moving = random_.chance(0.5) ? Hand::Left : Hand::Right;
    } else if (pick < 0.85) {
      step.moving = MovingPoint{{Frame::Paper, placeIn(facet())}};
    } else {
      step.moving = MovingFacets{someFacets()};
    }
    return step;
  }

  std::vector<FoldLineName> someLines() {
    std::vector<FoldLineName> lines;
    if (state_.lines.empty() || random_.chance(0.4)) return lines;
    for (const FoldLine& line : state_.lines) {
      if (random_.chance(0.4)) lines.emplace_back(line.name);
    }
    return lines;
  }

  Sequence sequence() { return random_.chance(0.75) ? Sequence::InOrder : Sequence::Together; }

  Action angle() {
    AngleStep step;
    step.line = state_.lines.empty() ? std::string("fold 1")
                                     : state_.lines[random_.below(state_.lines.size())].name;
    const double pick = random_.unit();
    if (pick < 0.35) {
      step.angle = 0;
    } else if (pick < 0.6 || !options_.hasAngles) {
      step.angle = 180;
    } else {
      step.angle = pick < 0.75 ? 90 : random_.between(-180, 180);
    }
    return step;
  }

  Action rotate() {
    RotateStep step;
    step.degrees = random_.chance(0.5) ? 90 : random_.between(-180, 180);
    if (random_.chance(0.3)) step.about = inModel(point());
    return step;
  }

  /// A walk along hinges from a random vertex, sometimes stopping within one.
  Action tear() {
    TearStep step;
    const CreasePattern& pattern = state_.pattern;
    VertexId at(random_.below(pattern.vertices.size()));
    if (random_.chance(0.7)) {
      for (std::size_t tries = 0; tries < 50; ++tries) {
        const Edge& e = pattern.edges[random_.below(pattern.edges.size())];
        if (e.kind == EdgeKind::Border) at = random_.chance(0.5) ? e.from : e.to;
        if (e.kind == EdgeKind::Border && hasHinge(at)) break;
      }
    }
    step.path.points.push_back(pattern[at]);
    const std::size_t length = 1 + random_.below(3);
    VertexId before;
    for (std::size_t i = 0; i < length; ++i) {
      const VertexId to = nextAlongHinge(at, before);
      if (!to.isValid()) break;
      const bool isLast = i + 1 == length && random_.chance(0.4);
      step.path.points.push_back(isLast ? lerp(pattern[at], pattern[to], random_.between(0.2, 0.8))
                                        : pattern[to]);
      before = at;
      at = to;
    }
    if (step.path.points.size() == 1) step.path.points.push_back(point());
    if (random_.chance(0.3)) step.layers = layers();
    return step;
  }

  bool hasHinge(VertexId v) const {
    return std::any_of(
        state_.pattern.edges.begin(), state_.pattern.edges.end(),
        [v](const Edge& e) { return e.kind == EdgeKind::Hinge && (e.from == v || e.to == v); });
  }

  VertexId nextAlongHinge(VertexId at, VertexId before) {
    std::vector<VertexId> ways;
    for (const Edge& e : state_.pattern.edges) {
      if (e.kind != EdgeKind::Hinge) continue;
      if (e.from == at && e.to != before) ways.push_back(e.to);
      if (e.to == at && e.from != before) ways.push_back(e.from);
    }
    return ways.empty() ? VertexId() : ways[random_.below(ways.size())];
  }

  Keep keep() {
    Keep kept;
    if (random_.chance(0.6)) return kept;
    const FacetId f = facet();
    const bool isPaper = random_.chance(0.5);
    kept.places.push_back(isPaper ? Place{Frame::Paper, placeIn(f)}
                                  : Place{Frame::Model, inModel(placeIn(f))});
    return kept;
  }

  Action straightCut() { return StraightCutStep{line(), layers(), keep()}; }

  Action curveCut() {
    CurveCutStep step;
    step.frame = random_.chance(0.7) ? Frame::Model : Frame::Paper;
    step.isClosed = random_.chance(0.5);
    step.ends = random_.chance(0.5) ? SplineEnds::Clamped : SplineEnds::Free;
    step.layers = random_.chance(0.7) ? LayerChoice(AllLayers{}) : layers();
    step.keep = keep();
    Vec2 middle = point();
    if (step.frame == Frame::Model) middle = inModel(middle);
    const Vec2 size = high_ - low_;
    if (step.isClosed) {
      const double radius = random_.between(0.1, 0.7) * std::max(size.x, size.y);
      const std::size_t count = 4 + random_.below(5);
      for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
        const double r = radius * random_.between(0.6, 1.1);
        step.controls.push_back(middle + Vec2{r * std::cos(angle), r * std::sin(angle)});
      }
    } else {
      const Vec2 along = normalized(Vec2{random_.between(-1, 1), random_.between(0.1, 1)});
      const double reach = 1.6 * (size.x + size.y);
      const std::size_t count = 5 + random_.below(6);
      for (std::size_t i = 0; i < count; ++i) {
        const double s = 2.0 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
        step.controls.push_back(middle + along * (s * reach) +
                                perpendicular(along) *
                                    (random_.between(-0.15, 0.15) * (size.x + size.y)));
      }
    }
    return step;
  }

  Random& random_;
  const FoldedState& state_;
  const RandomStepOptions& options_;
  Vec2 low_;
  Vec2 high_;
};

}  // namespace

std::uint64_t Random::next() {
  state_ += 0x9E3779B97F4A7C15ull;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

double Random::unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

Model randomSheet(Random& random) {
  Model model;
  const double pick = random.unit();
  model.sheet.width = 100;
  model.sheet.height = 70;
  if (pick < 0.5) {
    model.sheet.shape = SheetSpec::Shape::Square;
  } else if (pick < 0.65) {
    model.sheet.shape = SheetSpec::Shape::Rectangle;
  } else if (pick < 0.75) {
    model.sheet.shape = SheetSpec::Shape::Disc;
  } else {
    model.sheet.shape = SheetSpec::Shape::Polygon;
    if (pick < 0.85) {
      model.sheet.outline = {{0, 0},   {100, 0}, {100, 100}, {70, 100},
                             {70, 30}, {30, 30}, {30, 100},  {0, 100}};
    } else if (pick < 0.95) {
      model.sheet.outline = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
      model.sheet.holes = {{{40, 40}, {60, 40}, {60, 65}, {40, 60}}};
    } else {
      model.sheet.outline = {{50, 0}, {100, 40}, {80, 100}, {20, 100}, {0, 40}};
    }
  }
  return model;
}

Step randomStep(Random& random, const FoldedState& state, const RandomStepOptions& options) {
  Step step;
  step.action = Chooser(random, state, options).action();
  return step;
}

}  // namespace kiri::test
