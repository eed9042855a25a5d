// What is seen of a state, sample by sample.
// SPDX-License-Identifier: MIT
#include "tests/support/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kiri::test {
namespace {

constexpr int kChords = 256;

Vec2 onCurve(const Arc& arc, double t) {
  if (!arc.isCurved) return arc.start * (1 - t) + arc.end * t;
  const double s = 1 - t;
  return arc.start * (s * s * s) + arc.control1 * (3 * s * s * t) + arc.control2 * (3 * s * t * t) +
         arc.end * (t * t * t);
}

using Polygon = std::vector<Vec2>;

template <class Place>
Polygon flattened(const std::vector<Arc>& loop, const Place& place) {
  Polygon out;
  for (const Arc& arc : loop) {
    const int chords = arc.isCurved ? kChords : 1;
    for (int i = 0; i < chords; ++i) out.push_back(place(onCurve(arc, 1.0 * i / chords)));
  }
  return out;
}

/// Columns whose middles lie inside the polygons (even-odd) in the row at height y.
template <class Visit>
void visitRow(const std::vector<Polygon>& polygons, double y, const Box& box, int width,
              const Visit& visit) {
  std::vector<double> xs;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i];
      const Vec2 b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= y) != (b.y <= y)) xs.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  }
  std::sort(xs.begin(), xs.end());
  const double cell = (box.high.x - box.low.x) / width;
  for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
    const int first = std::max(0, static_cast<int>(std::ceil((xs[i] - box.low.x) / cell - 0.5)));
    const int last =
        std::min(width - 1, static_cast<int>(std::floor((xs[i + 1] - box.low.x) / cell - 0.5)));
    for (int x = first; x <= last; ++x) visit(x);
  }
}

double rowHeight(const Box& box, int y, int height) {
  return box.high.y - (box.high.y - box.low.y) * (y + 0.5) / height;
}

/// A facet and where it hides what.
struct Plate {
  FacetId facet;
  std::vector<Polygon> outline;
  Vec3 point;
  Vec3 normal;
  bool upIsNear = true;  ///< the normal of its layer-set points to the eye
};

struct Hit {
  const Plate* sheet;
  double nearness;
};

class Viewer {
 public:
  Viewer(const FoldedState& state, const Eye& eye) : state_(state), eye_(eye) {
    at_ = eye.centre + eye.toEye * eye.distance;
    for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) add(FacetId(f));
  }

  const std::vector<Plate>& sheets() const { return sheets_; }

  /// Larger is nearer.
  double nearnessOf(const Plate& sheet, Vec2 p) const {
    if (eye_.distance == 0) {
      const Vec3 start = eye_.right * p.x + eye_.up * p.y;
      return dot(sheet.point - start, sheet.normal) / dot(eye_.toEye, sheet.normal);
    }
    const Vec3 place = eye_.centre + eye_.right * (p.x - dot(eye_.centre, eye_.right)) +
                       eye_.up * (p.y - dot(eye_.centre, eye_.up));
    const Vec3 ray = place - at_;
    return -length(ray) * dot(sheet.point - at_, sheet.normal) / dot(ray, sheet.normal);
  }

  std::int32_t seen(const std::vector<Hit>& hits) const {
    if (hits.empty()) return DepthPicture::kNothing;
    const Hit* best = &hits.front();
    for (const Hit& hit : hits) {
      if (order(hit, *best) > 0) best = &hit;
    }
    for (const Hit& hit : hits) {
      if (&hit != best && order(*best, hit) <= 0) return DepthPicture::kUnclear;
    }
    return static_cast<std::int32_t>(best->sheet->facet.index);
  }

 private:
  void add(FacetId f) {
    const Rigid& pose = state_.poseOf(f);
    const Vec3 sight = eye_.distance == 0 ? eye_.toEye : (at_ - pose.origin) / eye_.distance;
    if (std::abs(dot(pose.normal(), sight)) < 1e-4) return;
    Plate sheet{f, {}, pose.origin, pose.normal(), true};
    const LayerSet& set = state_.layers.sets()[state_.layers.setOf(f)];
    sheet.upIsNear = dot(set.normal, sight) > 0;
    for (const auto& loop : regionOf(state_.pattern, f).loops) {
      sheet.outline.push_back(
          flattened(loop, [&](Vec2 paper) { return onPicture(pose.apply(paper)); }));
    }
    sheets_.push_back(std::move(sheet));
  }

  Vec2 onPicture(Vec3 p) const {
    const Vec2 centre{dot(eye_.centre, eye_.right), dot(eye_.centre, eye_.up)};
    const Vec2 flat{dot(p, eye_.right), dot(p, eye_.up)};
    if (eye_.distance == 0) return flat;
    return centre + (flat - centre) * (eye_.distance / dot(at_ - p, eye_.toEye));
  }

  /// Positive when a hides b, 0 when nobody can say.
  int order(const Hit& a, const Hit& b) const {
    const FacetId f = a.sheet->facet;
    const FacetId g = b.sheet->facet;
    if (f == g) return 0;
    if (state_.layers.areCoplanar(f, g)) {
      return state_.layers.isAbove(f, g) == a.sheet->upIsNear ? 1 : -1;
    }
    const double slack = 1e-6 * state_.tolerance().sheetSize();
    const double ahead = a.nearness - b.nearness;
    return ahead > slack ? 1 : ahead < -slack ? -1 : 0;
  }

  const FoldedState& state_;
  const Eye& eye_;
  Vec3 at_;
  std::vector<Plate> sheets_;
};

DepthPicture blank(int width, int height) {
  DepthPicture picture{width, height, {}};
  picture.samples.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                         DepthPicture::kNothing);
  return picture;
}

}  // namespace

DepthPicture depthPicture(const FoldedState& state, const Eye& eye, const Box& box, int width,
                          int height) {
  const Viewer viewer(state, eye);
  DepthPicture picture = blank(width, height);
  std::vector<std::vector<Hit>> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    const double level = rowHeight(box, y, height);
    for (std::vector<Hit>& hits : row) hits.clear();
    for (const Plate& sheet : viewer.sheets()) {
      visitRow(sheet.outline, level, box, width, [&](int x) {
        const Vec2 p{box.low.x + (box.high.x - box.low.x) * (x + 0.5) / width, level};
        row[static_cast<std::size_t>(x)].push_back({&sheet, viewer.nearnessOf(sheet, p)});
      });
    }
    for (int x = 0; x < width; ++x) {
      const auto column = static_cast<std::size_t>(x);
      picture.samples[static_cast<std::size_t>(y) * row.size() + column] = viewer.seen(row[column]);
    }
  }
  return picture;
}

DepthPicture pictureOf(const std::vector<SeenLoops>& seen, const Box& box, int width, int height) {
  DepthPicture picture = blank(width, height);
  for (const SeenLoops& part : seen) {
    std::vector<Polygon> outline;
    for (const auto& loop : part.loops) {
      outline.push_back(flattened(loop, [](Vec2 p) { return p; }));
    }
    for (int y = 0; y < height; ++y) {
      visitRow(outline, rowHeight(box, y, height), box, width, [&](int x) {
        picture.samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)] = part.facet;
      });
    }
  }
  return picture;
}

int wrongSamples(const DepthPicture& drawn, const DepthPicture& truth) {
  int wrong = 0;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const std::int32_t shown = drawn.at(x, y);
      bool isNear = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const std::int32_t there = truth.at(x + dx, y + dy);
          isNear = isNear || there == shown || there == DepthPicture::kUnclear;
        }
      }
      if (!isNear) ++wrong;
    }
  }
  return wrong;
}

}  // namespace kiri::test
