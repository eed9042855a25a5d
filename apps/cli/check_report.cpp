// What is known about a crease pattern before any search: faults, and whether its facets close.
// SPDX-License-Identifier: MIT
#include "apps/cli/check_report.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"

namespace kiri::cli {

std::size_t PatternReport::faultyVertices() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < faults.size(); ++i)
    if (i == 0 || faults[i].vertex != faults[i - 1].vertex) ++count;
  return count;
}

PatternReport reportOf(const AssignedPattern& creases, const std::vector<VertexId>& standing) {
  PatternReport report;
  report.faults = vertexFaults(creases);
  const std::size_t broken = report.faultyVertices();
  std::erase_if(report.faults, [&](const VertexFault& fault) {
    return std::find(standing.begin(), standing.end(), fault.vertex) != standing.end();
  });
  report.standing = broken - report.faultyVertices();
  Result<FlatMap> map = flatMapOf(creases);
  if (map.isOk()) {
    report.map = std::move(*map);
  } else {
    report.whyOpen = map.error().message;
    report.openAt = map.error().witness;
  }
  return report;
}

std::string verdictOf(const PatternReport& report) {
  const std::size_t count = report.faultyVertices();
  const std::string standing = std::to_string(report.standing);
  const std::string why = report.standing == 1
                              ? "stands in space, with creases at other angles than 180 degrees"
                              : "stand in space, with creases at other angles than 180 degrees";
  if (count == 0)
    return "folds flat around every vertex" +
           (report.standing == 0 ? std::string() : " but " + standing + " that " + why);
  return std::to_string(count) +
         (count == 1 ? " vertex does not fold flat" : " vertices do not fold flat") +
         (report.standing == 0 ? std::string() : "; " + standing + " more " + why);
}

std::string closingOf(const PatternReport& report, const std::string& unit) {
  if (!report.map) return "does not close as a whole: " + report.whyOpen;
  if (report.map->error == 0) return "closes as a whole";
  return "closes as a whole to " + text(report.map->error) + " " + unit;
}

const char* nameOf(VertexRule rule) {
  switch (rule) {
    case VertexRule::EvenDegree:
      return "even_degree";
    case VertexRule::Kawasaki:
      return "kawasaki";
    case VertexRule::Maekawa:
      return "maekawa";
    case VertexRule::BigLittleBig:
      return "big_little_big";
    case VertexRule::SelfCrossing:
      return "self_crossing";
  }
  return "";
}

JsonValue faultsJson(const PatternReport& report, const CreasePattern& pattern) {
  JsonValue out = JsonValue::array();
  for (const VertexFault& fault : report.faults) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("rule", JsonValue::ofText(nameOf(fault.rule)));
    item.add("place", pointJson(pattern[fault.vertex]));
    item.add("amount", JsonValue::ofNumber(fault.amount));
    item.add("message", JsonValue::ofText(fault.message));
  }
  return out;
}

}  // namespace kiri::cli
