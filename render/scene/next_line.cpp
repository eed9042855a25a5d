// The line that a step is about to be done along, as it lies on the model.
// SPDX-License-Identifier: MIT
#include "render/scene/next_line.h"

#include <optional>
#include <variant>

#include "core/model/locate.h"
#include "core/model/requests.h"
#include "render/scene/sheet_scene.h"
#include "render/visibility/projection.h"

namespace kiri {
namespace {

/// Adds the arcs that show an arc of the paper frame of a facet, or of another frame in which
/// something is drawn.
void appendArcs(const Arc& drawn, const Rigid& pose, const ViewFrame& view,
                const Tolerance& tolerance, std::vector<Arc>& out) {
  std::vector<SeenArc> seen;
  appendSeen(drawn, pose, view, tolerance.match(), seen);
  for (const SeenArc& piece : seen) out.push_back(piece.arc);
}

class LineFinder {
 public:
  LineFinder(const FoldedState& state, const ViewFrame& view) : state_(state), view_(view) {}

  NextLine operator()(const FoldStep& step) const {
    const bool isFromBehind = view_.toEye.z < 0;
    const bool isValley = (step.type == FoldType::Valley) != isFromBehind;
    return straight(isValley ? LineKind::Valley : LineKind::Mountain, step.line);
  }
  NextLine operator()(const AddEdgeStep& step) const { return straight(LineKind::Flat, step.line); }
  NextLine operator()(const StraightCutStep& step) const {
    return straight(LineKind::Cut, step.line);
  }
  NextLine operator()(const TearStep& step) const { return along(LineKind::Tear, step.path); }
  NextLine operator()(const MendStep& step) const { return along(LineKind::Flat, step.path); }

  NextLine operator()(const CurveCutStep& step) const {
    NextLine line{LineKind::Cut, {}};
    const Result<CutRequest> request = cutRequest(state_, step);
    if (!request) return line;
    line.chains.emplace_back();
    for (const Arc& arc : request->chain) {
      appendArcs(arc, request->frame, view_, state_.tolerance(), line.chains.back());
    }
    return line;
  }

  /// All its creases, as they lie on the sheet.
  NextLine operator()(const PatternStep& step) const {
    NextLine line{LineKind::Flat, {}};
    const Rigid& pose = state_.poseOf(FacetId(0));
    const std::size_t count = step.vertices.size();
    for (const PatternCrease& crease : step.creases) {
      if (crease.from >= count || crease.to >= count) continue;
      line.chains.push_back({Arc::line(view_.project(pose.apply(step.vertices[crease.from])),
                                       view_.project(pose.apply(step.vertices[crease.to])))});
    }
    return line;
  }

  template <class Other>
  NextLine operator()(const Other&) const {
    return {};
  }

 private:
  NextLine straight(LineKind kind, const DrawnLine& drawn) const {
    NextLine line{kind, {}};
    if (const std::optional<ModelSegment> segment = onModel(state_, drawn)) {
      line.chains.push_back({Arc::line(view_.project(segment->from), view_.project(segment->to))});
    }
    return line;
  }

  /// A path along edges may cross folds: each stretch lies on the model as the facet at its middle
  /// does.
  NextLine along(LineKind kind, const DrawnPath& path) const {
    NextLine line{kind, {}};
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Vec2 from = path.points[i - 1];
      const Vec2 to = path.points[i];
      Arc arc = Arc::line(view_.project({from.x, from.y, 0}), view_.project({to.x, to.y, 0}));
      if (path.frame == Frame::Paper) {
        const std::optional<FacetId> facet = facetAt(state_.pattern, lerp(from, to, 0.5));
        if (!facet) continue;
        std::vector<Arc> arcs;
        appendArcs(Arc::line(from, to), state_.poseOf(*facet), view_, state_.tolerance(), arcs);
        arc = arcs.front();
      }
      const bool goesOn = !line.chains.empty() && line.chains.back().back().end == arc.start;
      if (!goesOn) line.chains.emplace_back();
      line.chains.back().push_back(arc);
    }
    return line;
  }

  const FoldedState& state_;
  const ViewFrame& view_;
};

struct Words {
  std::string operator()(const FoldStep& step) const {
    return step.type == FoldType::Valley ? "valley fold" : "mountain fold";
  }
  std::string operator()(const AngleStep&) const { return "set the angle"; }
  std::string operator()(const UnfoldStep& step) const {
    return step.lines.empty() ? "unfold all" : "unfold";
  }
  std::string operator()(const RefoldStep& step) const {
    return step.lines.empty() ? "refold all" : "refold";
  }
  std::string operator()(const TearStep&) const { return "tear"; }
  std::string operator()(const MendStep&) const { return "mend"; }
  std::string operator()(const AddEdgeStep&) const { return "add an edge"; }
  std::string operator()(const StraightCutStep&) const { return "cut straight"; }
  std::string operator()(const CurveCutStep&) const { return "cut along the curve"; }
  std::string operator()(const TurnOverStep&) const { return "turn over"; }
  std::string operator()(const RotateStep&) const { return "rotate"; }
  std::string operator()(const MoveStep&) const { return "move"; }
  std::string operator()(const PatternStep& step) const {
    return step.isFolded ? "fold the crease pattern" : "crease";
  }
};

}  // namespace

std::optional<ModelSegment> onModel(const FoldedState& state, const DrawnLine& line) {
  const Result<FacetLine> located = locateLine(state, line);
  if (!located) return std::nullopt;
  const Rigid& pose = state.poseOf(located->facet);
  return ModelSegment{pose.apply(located->from), pose.apply(located->to)};
}

NextLine nextLine(const FoldedState& state, const Step& step, const ViewFrame& view) {
  return std::visit(LineFinder(state, view), step.action);
}

std::string wordsFor(const Step& step) { return std::visit(Words{}, step.action); }

}  // namespace kiri
