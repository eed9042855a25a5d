// One vertex after the other, from its fan of folded creases.
// SPDX-License-Identifier: MIT
#include "core/flatfold/local_conditions.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/flatfold/crimping.h"
#include "core/flatfold/vertex_fan.h"

namespace kiri {
namespace {

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string foldsText(const FoldCounts& counts) {
  std::string said =
      counted(counts.mountains, "mountain") + " and " + counted(counts.valleys, "valley");
  if (counts.open > 0) said += " (" + std::to_string(counts.open) + " not assigned)";
  return said;
}

/// By how many creases the differences that the open ones allow miss `wanted`.
double missOf(const FoldCounts& counts, std::size_t wanted) {
  const auto more = static_cast<double>(std::max(counts.mountains, counts.valleys));
  const auto less = static_cast<double>(std::min(counts.mountains, counts.valleys));
  const auto open = static_cast<double>(counts.open);
  const auto target = static_cast<double>(wanted);
  if (more - less - open > target) return more - less - open - target;
  return std::max(0.0, target - (more - less + open));
}

class VertexCheck {
 public:
  VertexCheck(const AssignedPattern& creases, const VertexFan& fan, double within,
              std::vector<VertexFault>& faults)
      : fan_(fan),
        within_(within > 0 ? within : fan.explainedBy(creases.pattern.tolerance.thin())),
        place_(text(creases.pattern[fan.vertex]) + " mm"),
        faults_(faults) {
    for (const EdgeId e : fan.creases) {
      const Assignment a = creases.of(e);
      folds_.push_back(a == Assignment::Unassigned    ? Fold::Either
                       : creases.pattern[e].angle > 0 ? Fold::Valley
                                                      : Fold::Mountain);
    }
  }

  void run() {
    if (fan_.creases.size() % 2 == 1) {
      add(VertexRule::EvenDegree, 1,
          "at " + place_ + " an odd number of folded creases meet (" +
              std::to_string(fan_.creases.size()) +
              "); paper lies flat only around an even number");
      return;
    }
    const std::size_t before = faults_.size();
    checkKawasaki();
    checkMaekawa();
    checkRuns();
    if (faults_.size() == before && !foldsFlat(fan_.sectors, folds_, within_))
      add(VertexRule::SelfCrossing, 1,
          "at " + place_ +
              " paper would pass through paper, however its layers are ordered; some mountains "
              "there must be valleys, or the other way round");
  }

 private:
  void add(VertexRule rule, double amount, std::string message) {
    faults_.push_back({fan_.vertex, rule, amount, std::move(message)});
  }

  void checkKawasaki() {
    const double miss = fan_.kawasakiMiss();
    if (miss <= within_) return;
    if (fan_.creases.size() == 2) {
      add(VertexRule::Kawasaki, miss,
          "at " + place_ + " a crease bends by " + text(miss) +
              " degrees; where only two creases meet they must be one straight line");
      return;
    }
    add(VertexRule::Kawasaki, miss,
        "at " + place_ + " alternate angles add up to 180 degrees but for " + text(miss) +
            "; they must do so for the paper to lie flat");
  }

  void checkMaekawa() {
    FoldCounts counts;
    for (const Fold fold : folds_) counts.add(fold);
    if (counts.allow(2)) return;
    add(VertexRule::Maekawa, missOf(counts, 2),
        "at " + place_ + " " + foldsText(counts) + " meet; they must differ by two");
  }

  void checkRuns() {
    for (const SmallRun& run : smallRuns(fan_.sectors, within_)) {
      if (runFolds(run, folds_)) continue;
      const FoldCounts counts = countsOf(run, folds_);
      const bool isOdd = run.length % 2 == 1;
      const std::string angles =
          run.length == 1
              ? "an angle of " + text(fan_.sectors[run.first]) + " degrees lies between larger ones"
              : std::to_string(run.length) + " equal angles of " + text(fan_.sectors[run.first]) +
                    " degrees lie between larger ones";
      const std::string must = run.length == 1 ? "one must be a mountain, the other a valley"
                               : isOdd         ? "they must be as many mountains as valleys"
                                               : "mountains and valleys must differ by one";
      std::string message = "at " + place_ + " " + angles;
      message += ", but its creases are " + foldsText(counts) + "; " + must;
      add(VertexRule::BigLittleBig, missOf(counts, isOdd ? 0 : 1), std::move(message));
      return;
    }
  }

  const VertexFan& fan_;
  double within_;
  std::string place_;
  std::vector<Fold> folds_;
  std::vector<VertexFault>& faults_;
};

}  // namespace

std::vector<VertexFault> vertexFaults(const AssignedPattern& creases, double within) {
  std::vector<VertexFault> faults;
  for (const VertexFan& fan : fansInside(creases)) VertexCheck(creases, fan, within, faults).run();
  return faults;
}

}  // namespace kiri
