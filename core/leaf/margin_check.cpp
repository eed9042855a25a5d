// Whether one curve gives every facet its part of the margin, from a tip down to a sinus.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/margin.h"
#include "core/leaf/segments.h"

namespace kiri {
namespace {

constexpr int kSamplesPerPiece = 8;
/// Lobes and sinuses must open by more than this on either side of their crease: the sine of about
/// one degree.
constexpr double kSlender = 0.0175;
constexpr const char* kRemedy = "; change a length, or the angles before them";

Error badMargin(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

/// The knot that draws the curve away: the one on it nearest to piece `at`, between those of a
/// facet's own creases. None: the nearest of all is one of these.
const MarginKnot* culpritNear(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                              const MarginCurve& curve, std::size_t facet, std::size_t at) {
  const std::size_t first = curve.crossings[half.tipOf(facet)];
  const std::size_t last = curve.crossings[half.sinusOf(facet)];
  const MarginKnot* culprit = nullptr;
  std::size_t best = 0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const std::size_t piece = curve.crossings[i];
    const std::size_t away = piece > at ? piece - at : at - piece;
    if (piece <= first || piece >= last || (culprit != nullptr && away >= best)) continue;
    culprit = &knots[i];
    best = away;
  }
  return culprit;
}

/// The main vein that a secondary crease leaves, or that the crease is; the number of creases when
/// it is neither.
std::size_t mainVeinOf(const FoldedHalf& half, std::size_t crease) {
  const std::vector<LeafCrease>& creases = half.creases();
  for (std::size_t i = 0; i < creases.size(); ++i) {
    if (creases[i].kind != RayKind::Vein || creases[i].isSecondary) continue;
    const std::vector<Vec2>& junctions = creases[i].junctions;
    const bool leaves =
        std::find(junctions.begin(), junctions.end(), creases[crease].from) != junctions.end();
    if (i == crease || (creases[crease].isSecondary && leaves)) return i;
  }
  return creases.size();
}

/// Where one of two lobes has a pair and the other none: what brings their tips together. Empty
/// when that is not so.
std::string pairRemedy(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                       std::size_t crease, std::size_t other) {
  const std::vector<LeafCrease>& creases = half.creases();
  if (other >= creases.size()) return "";
  std::size_t turned = mainVeinOf(half, crease);
  std::size_t still = mainVeinOf(half, other);
  if (turned >= creases.size() || still >= creases.size()) return "";
  if (creases[turned].junctions.empty()) std::swap(turned, still);
  if (creases[turned].junctions.empty() || !creases[still].junctions.empty()) return "";
  return "; secondary lobes turn the end of the " + creases[turned].name + " to " +
         text(std::round(knots[turned].folded * 10) / 10) + " degrees: fold the " +
         creases[still].name + " to about as much, or give its lobe a pair that turns it alike";
}

Error between(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
              const MarginCurve& curve, std::size_t facet, std::size_t sample,
              const std::string& what) {
  const std::string tip = "the " + half.creases()[half.tipOf(facet)].name;
  const std::string sinus = "the " + half.creases()[half.sinusOf(facet)].name;
  const std::size_t at = curve.crossings[half.tipOf(facet)] + sample / kSamplesPerPiece;
  const MarginKnot* culprit = culpritNear(half, knots, curve, facet, at);
  const std::string near = culprit == nullptr ? "" : " at " + told(*culprit);
  const std::string remedy = culprit == nullptr
                                 ? ""
                                 : pairRemedy(half, knots, half.tipOf(facet),
                                              static_cast<std::size_t>(culprit - knots.data()));
  return badMargin("no single margin cuts " + tip + " and " + sinus +
                   " so that they end in a tip " + "and a sinus: between them it " + what + near +
                   (remedy.empty() ? kRemedy : remedy));
}

Vec3 lifted(Vec2 p) { return {p.x, p.y, 0}; }

/// Sine of the angle, seen from the end of a crease, by which a place lies clockwise of it.
double roomBeside(const LeafCrease& crease, Vec2 place) {
  const Vec2 seen = place - crease.end;
  return cross(seen, normalized(crease.end - crease.from)) / length(seen);
}

/// Whether the margin of a facet comes nearer to the petiole at the very end of a crease.
bool isFallingAt(const FoldedHalf& half, const MarginCurve& curve, std::size_t facet,
                 std::size_t crease) {
  const Rigid& pose = half.pose(facet);
  const Vec2 way = startDirection(curve.arcs[curve.crossings[crease]]);
  const Vec2 place = pose.pullBack(lifted(curve.arcs[curve.crossings[crease]].start));
  const Vec2 flat = {dot(lifted(way), pose.x), dot(lifted(way), pose.y)};
  return dot(flat, place) < 0;
}

Status checkFacet(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                  const MarginCurve& curve, std::size_t facet) {
  const LeafCrease& before = half.creases()[facet];
  const LeafCrease& behind = half.creases()[facet + 1];
  if (curve.crossings[half.tipOf(facet)] >= curve.crossings[half.sinusOf(facet)]) {
    return badMargin("no single margin cuts both " + told(knots[half.tipOf(facet)]) + " and " +
                     told(knots[half.sinusOf(facet)]) +
                     ": it must come nearer to the petiole from one to the next" + kRemedy);
  }
  const std::vector<Vec2> places = marginOfFacet(half, curve, facet, kSamplesPerPiece);
  const auto roomAt = [&](std::size_t k) {
    return std::min(roomBeside(before, places[k]), -roomBeside(behind, places[k]));
  };
  for (std::size_t k = 1; k < places.size(); ++k) {
    const bool isRising = length(places[k]) >= length(places[k - 1]);
    if (isRising || (k == 1 && !isFallingAt(half, curve, facet, half.tipOf(facet))) ||
        (k + 1 == places.size() && !isFallingAt(half, curve, facet, half.sinusOf(facet)))) {
      return between(half, knots, curve, facet, k, "would go away from the petiole");
    }
    if (k + 1 < places.size() && !(roomAt(k) > 0)) {
      return between(half, knots, curve, facet, k, "would leave the paper between their creases");
    }
  }
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    if (roomAt(k) >= kSlender) continue;
    return between(half, knots, curve, facet, k, "would leave only a sliver beside a crease");
  }
  return std::monostate{};
}

/// The curve must cross a crease, not run along it.
Status checkAcross(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                   const MarginCurve& curve, std::size_t i) {
  const LeafCrease& crease = half.creases()[i];
  const Rigid& pose = half.pose(std::min(i, half.creases().size() - 2));
  const Vec2 along = normalized(flatten(pose.direction(crease.end - crease.from)));
  const Vec2 way = startDirection(curve.arcs[curve.crossings[i]]);
  if (std::abs(cross(along, way)) >= kSlender) return std::monostate{};
  const auto apart = [&](std::size_t k) {
    const std::size_t a = curve.crossings[k];
    const std::size_t b = curve.crossings[i];
    return a > b ? a - b : b - a;
  };
  std::size_t nearest = i;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (apart(k) > 0 && (nearest == i || apart(k) < apart(nearest))) nearest = k;
  }
  return badMargin("the margin would run along the end of " + told(knots[i]) + " to " +
                   told(knots[nearest]) + ", so that only a sliver of paper is cut off" + kRemedy);
}

struct Stretch {
  Vec2 from;
  Vec2 to;
  std::size_t crease = 0;
};

/// The creases of the kept paper in the folded leaf.
std::vector<Stretch> keptCreases(const FoldedHalf& half) {
  std::vector<Stretch> out;
  const std::vector<LeafCrease>& creases = half.creases();
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const auto folded = [&](std::size_t facet, Vec2 p) {
      return flatten(half.pose(std::min(facet, creases.size() - 2)).apply(p));
    };
    out.push_back({folded(i, creases[i].from), folded(i, creases[i].end), i});
    const std::vector<Vec2>& junctions = creases[i].junctions;
    for (std::size_t j = 0; j < junctions.size(); ++j) {
      // Behind a vein every pair has two creases: this stretch bounds the facet inside those.
      const std::size_t facet = i + 2 * (junctions.size() - j);
      const Vec2 from = j == 0 ? Vec2{0, 0} : junctions[j - 1];
      out.push_back({folded(facet, from), folded(facet, junctions[j]), i});
    }
  }
  return out;
}

/// No piece but those that start or end at its end may cut a crease.
Status checkOnce(const FoldedHalf& half, const MarginCurve& curve, const Stretch& stretch) {
  const std::size_t own = curve.crossings[stretch.crease];
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    if (i == own || i + 1 == own) continue;
    for (int k = 0; k < kSamplesPerPiece; ++k) {
      const Vec2 a = pointAt(curve.arcs[i], static_cast<double>(k) / kSamplesPerPiece);
      const Vec2 b = pointAt(curve.arcs[i], static_cast<double>(k + 1) / kSamplesPerPiece);
      if (!doSegmentsCross(a, b, stretch.from, stretch.to)) continue;
      return badMargin("no single margin cuts all layers: it would cut the " +
                       half.creases()[stretch.crease].name +
                       " a second time, nearer to the petiole than its end; make it shorter, or "
                       "change the angles before it");
    }
  }
  return std::monostate{};
}

}  // namespace

std::vector<Vec2> marginOfFacet(const FoldedHalf& half, const MarginCurve& curve, std::size_t facet,
                                int perPiece) {
  std::vector<Vec2> places;
  const auto add = [&](Vec2 p) { places.push_back(half.pose(facet).pullBack(lifted(p))); };
  const std::size_t last = curve.crossings[half.sinusOf(facet)];
  for (std::size_t i = curve.crossings[half.tipOf(facet)]; i < last; ++i) {
    for (int k = 0; k < perPiece; ++k) {
      add(pointAt(curve.arcs[i], static_cast<double>(k) / perPiece));
    }
  }
  add(curve.arcs[last].start);
  return places;
}

Status checkMargin(const FoldedHalf& half, const std::vector<MarginKnot>& knots,
                   const MarginCurve& curve) {
  for (std::size_t i = 0; i + 1 < half.creases().size(); ++i) {
    if (Status status = checkFacet(half, knots, curve, i); !status) return status;
  }
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    if (Status status = checkAcross(half, knots, curve, i); !status) return status;
  }
  for (const Stretch& stretch : keptCreases(half)) {
    if (Status status = checkOnce(half, curve, stretch); !status) return status;
  }
  return std::monostate{};
}

}  // namespace kiri
