// From a crease pattern to its folded states, part by part, as far as the limits allow.
// SPDX-License-Identifier: MIT
#include "apps/cli/states_search.h"

#include <utility>

namespace kiri::cli {

namespace {

/// True when the work was ended by a limit; the answer says so then.
bool stoppedBy(const Error& error, const SearchWatch& watch, StatesAnswer& answer) {
  if (error.code == ErrorCode::Cancelled) {
    if (!watch.ranOut()) return false;
    answer.stopped = "the time was over while " + watch.lastPart() +
                     "; give it more with --time SECONDS (0: no limit)";
    return true;
  }
  if (error.code != ErrorCode::BadValue) return false;
  answer.stopped = error.message;
  return true;
}

Status countStates(StatesAnswer& answer, SearchWatch& watch) {
  if (!answer.states->exist()) {
    answer.total = StateCount(0);
    return std::monostate{};
  }
  const std::size_t components = answer.states->componentCount();
  const std::string name =
      "counting " + std::to_string(components) + (components == 1 ? " component" : " components");
  Status counted =
      watch.part(name, [&](const Progress& progress) { return answer.states->count(progress); });
  if (counted.isOk()) {
    answer.total = answer.states->total();
    return counted;
  }
  if (!stoppedBy(counted.error(), watch, answer)) return counted;
  return std::monostate{};
}

}  // namespace

Result<StatesAnswer> searchStates(const PatternInput& input, const SearchRequest& request,
                                  SearchWatch& watch) {
  StatesAnswer answer;
  answer.report = watch.part("folding", [&](const Progress&) { return reportOf(input.creases); });
  if (!answer.report.map) {
    answer.total = StateCount(0);
    return answer;
  }
  Result<GroundAndOrders> ground =
      watch.part("looking for overlaps", [&](const Progress& progress) {
        return overlapsOf(input.creases, *answer.report.map, progress);
      });
  if (!ground.isOk()) {
    if (ground.error().code != ErrorCode::Cancelled || !watch.ranOut()) return ground.error();
    stoppedBy(ground.error(), watch, answer);
    return answer;
  }
  answer.ground = std::move(ground->ground);
  Result<LayerStates> states = watch.part("searching", [&](const Progress& progress) {
    return LayerStates::find(std::move(ground->problem), request.limits, progress);
  });
  if (!states.isOk()) {
    if (!stoppedBy(states.error(), watch, answer)) return states.error();
    return answer;
  }
  answer.states = std::move(*states);
  if (request.counts || !answer.states->exist()) {
    const Status counted = countStates(answer, watch);
    if (!counted.isOk()) return counted.error();
  }
  return answer;
}

}  // namespace kiri::cli
