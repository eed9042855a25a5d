// "Fold your first leaf": five movements of the hand, each waited for.
// SPDX-License-Identifier: MIT
#include "editor/session/tour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

namespace kiri {

namespace {

constexpr double kSide = 150;  // mm, of the sheet
constexpr double kNear = 6;    // mm, what a hand may be off

double distanceToLine(Vec2 p, Vec2 a, Vec2 b) { return std::abs(cross(normalized(b - a), p - a)); }

/// All hinges that are folded lie on one of the lines through the origin in these directions, and
/// on each of them lies one.
bool isFoldedAlong(const FoldedState& state, const std::vector<double>& degrees) {
  std::vector<bool> isMet(degrees.size(), false);
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    constexpr double kFolded = 170;
    if (std::abs(edge.angle) < kFolded) return false;
    const auto liesOn = [&](double angle) {
      const double radians = angle * std::numbers::pi / 180;
      const Vec2 along{std::cos(radians), std::sin(radians)};
      return distanceToLine(state.pattern[edge.from], {0, 0}, along) < kNear &&
             distanceToLine(state.pattern[edge.to], {0, 0}, along) < kNear;
    };
    const auto found = std::find_if(degrees.begin(), degrees.end(), liesOn);
    if (found == degrees.end()) return false;
    isMet[static_cast<std::size_t>(found - degrees.begin())] = true;
  }
  return std::find(isMet.begin(), isMet.end(), false) == isMet.end();
}

bool isOpen(const FoldedState& state) {
  constexpr double kFlat = 1;
  return std::all_of(state.pattern.edges.begin(), state.pattern.edges.end(), [](const Edge& edge) {
    return edge.kind != EdgeKind::Hinge || std::abs(edge.angle) < kFlat;
  });
}

bool isCut(const Step& step, const FoldedState& after) {
  const bool cuts = std::holds_alternative<CurveCutStep>(step.action) ||
                    std::holds_alternative<StraightCutStep>(step.action);
  constexpr double kWhole = 0.97;
  return cuts && areaOf(after.pattern) < kWhole * kSide * kSide;
}

/// How many movements the steps of the document have done, and whether what they did after the last
/// of them leads elsewhere.
struct Reached {
  std::size_t step = 0;
  bool isAstray = false;
};

bool isReached(std::size_t movement, const Step& step, const FoldedState& after) {
  constexpr double kVein = 45;
  constexpr double kSideVein = 22.5;
  switch (movement) {
    case 0:
      return isFoldedAlong(after, {kVein});
    case 1:
      return isFoldedAlong(after, {kVein, kVein - kSideVein, kVein + kSideVein});
    case 2:
      return isCut(step, after);
    default:
      return isOpen(after);
  }
}

/// What may happen on the way to an open leaf: one fold after the other.
bool isOpening(const Step& step) {
  return std::holds_alternative<UnfoldStep>(step.action) ||
         std::holds_alternative<AngleStep>(step.action);
}

Reached reachedIn(const Document& document) {
  constexpr std::size_t kOpening = 3;
  constexpr std::size_t kLooking = 4;
  Reached reached;
  for (std::size_t i = 0; i < document.cursor(); ++i) {
    const Step& step = document.model().steps[i];
    const auto after = document.stateAfter(i + 1);
    if (!after || reached.step == kLooking) break;
    if (!reached.isAstray && isReached(reached.step, step, *after)) {
      ++reached.step;
    } else if (reached.step != kOpening || !isOpening(step)) {
      reached.isAstray = true;
    }
  }
  return reached;
}

bool hasTurned(const ViewFrame& from, const ViewFrame& to) {
  constexpr double kSeen = 0.93;  // cosine of some 20 degrees
  return dot(from.toEye, to.toEye) < kSeen;
}

/// The way of a hand through points of the model, as far as it has gone, with its end.
Marks handAlong(const std::vector<Vec2>& way, double part, bool isDragged) {
  Marks marks;
  PathMark path{MarkRole::Ghost, {}, false, isDragged};
  for (const Vec2 p : way) path.places.push_back(Vec3{p.x, p.y, 0});
  marks.push_back(path);
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(way.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), way.size() - 2);
  const Vec2 at = lerp(way[i], way[i + 1], place - static_cast<double>(i));
  marks.push_back(PointMark{MarkRole::ActiveHandle, Vec3{at.x, at.y, 0}});
  if (!isDragged) {
    for (const Vec2 p : way) marks.push_back(PointMark{MarkRole::Ghost, Vec3{p.x, p.y, 0}});
  }
  return marks;
}

/// A bow from a to b, as a hand goes.
std::vector<Vec2> bow(Vec2 a, Vec2 b) {
  constexpr int kParts = 16;
  constexpr double kBend = 0.18;
  const Vec2 middle = (a + b) / 2 + perpendicular(b - a) * kBend;
  std::vector<Vec2> way;
  for (int i = 0; i <= kParts; ++i) {
    const double t = static_cast<double>(i) / kParts;
    way.push_back(lerp(lerp(a, middle, t), lerp(middle, b, t), t));
  }
  return way;
}

}  // namespace

Model Tour::startModel() {
  Model model;
  model.title = "My first leaf";
  model.sheet.width = kSide;
  model.sheet.height = kSide;
  return model;
}

bool Tour::look(const Document& document, const ViewFrame& eye) {
  const std::size_t before = step_;
  const bool wasAstray = isAstray_;
  Reached reached = reachedIn(document);
  if (reached.step < kSteps - 1) {
    start_.reset();
    hasLooked_ = false;
  } else {
    if (!start_) start_ = eye;
    hasLooked_ = hasLooked_ || hasTurned(*start_, eye);
    if (hasLooked_) reached.step = kSteps;
  }
  step_ = reached.step;
  isAstray_ = reached.isAstray;
  return step_ != before || isAstray_ != wasAstray;
}

Phrase Tour::title() const {
  switch (step_) {
    case 0:
      return {KIRI_TEXT("editor/session", "Fold the sheet in half"), {}};
    case 1:
      return {KIRI_TEXT("editor/session", "Fold all layers once more"), {}};
    case 2:
      return {KIRI_TEXT("editor/session", "Cut the margin"), {}};
    case 3:
      return {KIRI_TEXT("editor/session", "Open the leaf"), {}};
    case 4:
      return {KIRI_TEXT("editor/session", "Look at it from all sides"), {}};
    default:
      return {KIRI_TEXT("editor/session", "Your first leaf"), {}};
  }
}

Phrase Tour::text() const {
  if (isAstray_) {
    return {KIRI_TEXT("editor/session",
                      "That was another movement than this leaf needs. Press Ctrl+Z to take it "
                      "back and try again, or go on by yourself and close this card."),
            {}};
  }
  switch (step_) {
    case 0:
      return {KIRI_TEXT("editor/session",
                        "Take the lower right corner of the sheet and drag it onto the upper left "
                        "one. The crease that appears becomes the mid-vein. Press Enter."),
              {}};
    case 1:
      return {KIRI_TEXT("editor/session",
                        "Hold Shift, which takes all layers, and drag the upper left corner onto "
                        "the folded edge, so that the new crease starts in the lower left corner. "
                        "Press Enter."),
              {}};
    case 2:
      return {KIRI_TEXT("editor/session",
                        "Click points across the paper, from outside to outside: far out on the "
                        "mid-vein, near on the other side. Enter ends the curve, Enter again cuts "
                        "through all layers."),
              {}};
    case 3:
      return {KIRI_TEXT("editor/session",
                        "Press Ctrl+U to unfold everything, or drag the sliders of the folds."),
              {}};
    case 4:
      return {KIRI_TEXT("editor/session",
                        "Drag with the right mouse button, or on the empty ground, to turn the "
                        "leaf about."),
              {}};
    default:
      return {KIRI_TEXT("editor/session",
                        "One cut through the layers of a bud makes a whole margin: this is how "
                        "leaves grow lobes. Save it, or press Space to see how it came to be."),
              {}};
  }
}

std::optional<ToolId> Tour::tool() const {
  if (step_ < 2) return ToolId::Fold;
  if (step_ == 2) return ToolId::CurveCut;
  return std::nullopt;
}

Marks Tour::ghost(double part) const {
  if (isAstray_) return {};
  const double onVein = kSide / std::numbers::sqrt2;
  switch (step_) {
    case 0:
      return handAlong(bow({kSide, 0}, {0, kSide}), part, true);
    case 1:
      return handAlong(bow({0, kSide}, {onVein, onVein}), part, true);
    case 2:
      return handAlong({{112, 90}, {96, 104}, {66, 104}, {52, 92}, {38, 82}, {20, 74}}, part,
                       false);
    default:
      return {};
  }
}

}  // namespace kiri
