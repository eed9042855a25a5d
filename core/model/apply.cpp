// SPDX-License-Identifier: MIT
#include "core/model/apply.h"

#include "core/base/text.h"
#include "core/cut/add_edge.h"
#include "core/fold/fold_line.h"
#include "core/fold/group_motion.h"
#include "core/model/numbers.h"
#include "core/model/pattern_step.h"
#include "core/model/requests.h"
#include "core/paper/boxes.h"

namespace kiri {
namespace {

/// All folds have no order that a person gave.
GroupMotion motionOf(Sequence sequence, const std::vector<FoldLineName>& lines) {
  if (sequence == Sequence::Together) return GroupMotion::Together;
  return lines.empty() ? GroupMotion::InFreeOrder : GroupMotion::InOrder;
}

/// One function for each kind of step.
class Applying {
 public:
  Applying(const FoldedState& state, int number, Movements* record)
      : state_(state), number_(number), record_(record) {}

  Result<FoldedState> operator()(const FoldStep& step) const {
    const Result<FoldRequest> request = foldRequest(state_, step, number_);
    if (!request) return request.error();
    return fold(state_, *request, record_);
  }

  Result<FoldedState> operator()(const AngleStep& step) const {
    if (!(step.angle >= -180 && step.angle <= 180)) {
      return Error{
          ErrorCode::BadValue,
          "the angle " + text(step.angle) + " is out of range; give degrees from -180 to 180",
          {}};
    }
    const Result<FoldLineId> line = locateFoldLine(state_, step.line);
    if (!line) return line.error();
    return setAmount(state_, *line, step.angle, record_);
  }

  Result<FoldedState> operator()(const UnfoldStep& step) const {
    const Result<std::vector<FoldLineId>> lines = lineGroup(state_, step.lines);
    if (!lines) return lines.error();
    return unfoldLines(state_, *lines, motionOf(step.sequence, step.lines), record_);
  }

  Result<FoldedState> operator()(const RefoldStep& step) const {
    const Result<std::vector<FoldLineId>> lines = lineGroup(state_, step.lines);
    if (!lines) return lines.error();
    return refoldLines(state_, *lines, motionOf(step.sequence, step.lines), record_);
  }

  Result<FoldedState> operator()(const TearStep& step) const {
    if (step.path.points.empty())
      return Error{ErrorCode::BadValue, "the tear has no path; give two or more points", {}};
    const Result<EdgeRequest> request = edgeRequest(state_, step.path, step.layers);
    if (!request) return request.error();
    return tear(state_, request->path, request->choice);
  }

  Result<FoldedState> operator()(const MendStep& step) const {
    const Result<EdgeRequest> request = edgeRequest(state_, step.path, step.layers);
    if (!request) return request.error();
    return mend(state_, request->path, request->choice);
  }

  Result<FoldedState> operator()(const AddEdgeStep& step) const {
    const Result<FacetLine> line = locateLine(state_, step.line);
    if (!line) return line.error();
    const Result<std::vector<FacetId>> layers = locateLayers(state_, step.layers, *line);
    if (!layers) return layers.error();
    return addEdge(state_, *line, *layers);
  }

  Result<FoldedState> operator()(const StraightCutStep& step) const { return cutWith(step); }
  Result<FoldedState> operator()(const CurveCutStep& step) const { return cutWith(step); }

  Result<FoldedState> operator()(const TurnOverStep& step) const {
    const Vec3 axis = step.axis == TurnAxis::Vertical ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    return carried({{modelBoxOf(state_).middle(), axis, 180}, {}});
  }

  Result<FoldedState> operator()(const RotateStep& step) const {
    const Vec3 about =
        step.about ? Vec3{step.about->x, step.about->y, 0} : modelBoxOf(state_).middle();
    return carried({{about, {0, 0, 1}, step.degrees}, {}});
  }

  Result<FoldedState> operator()(const MoveStep& step) const {
    return carried({{{}, {0, 0, 1}, 0}, {step.by.x, step.by.y, 0}});
  }

  Result<FoldedState> operator()(const PatternStep& step) const {
    return applyPattern(state_, step, record_);
  }

 private:
  FoldedState carried(const Carrying& how) const {
    Movement movement{std::make_shared<const FoldedState>(state_), how};
    FoldedState end = stateDuring(movement, 1);
    if (record_ != nullptr) record_->push_back(std::move(movement));
    return end;
  }

  template <class CutStep>
  Result<FoldedState> cutWith(const CutStep& step) const {
    const Result<CutRequest> request = cutRequest(state_, step);
    if (!request) return request.error();
    return cut(state_, *request);
  }

  const FoldedState& state_;
  int number_;
  Movements* record_;
};

}  // namespace

Result<FoldedState> apply(const FoldedState& state, const Step& step, int number,
                          Movements* record) {
  if (const Status checked = checkNumbers(step); !checked) return checked.error();
  Result<FoldedState> next = std::visit(Applying(state, number, record), step.action);
  if (!next) return next;
  for (std::size_t i = state.collisions.size(); i < next->collisions.size(); ++i) {
    next->collisions[i].step = static_cast<std::uint32_t>(number);
  }
  return next;
}

}  // namespace kiri
