// What kiri states says: for people and for programs.
// SPDX-License-Identifier: MIT
#include "apps/cli/states_report.h"

#include <algorithm>

#include "core/base/text.h"

namespace kiri::cli {

namespace {

std::size_t largestComponent(const LayerStates& states) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < states.componentCount(); ++i)
    most = std::max(most, states.component(i).pairs.size());
  return most;
}

std::string counted(const StateCount& count, const char* one, const char* many) {
  return count.str() + " " + (count == 1 ? one : many);
}

/// "2 components with 3 x 3 choices".
std::string componentsText(const LayerStates& states) {
  const std::size_t count = states.componentCount();
  if (count == 0) return "nothing is left to choose\n";
  std::string out = counted(count, "independent component", "independent components");
  constexpr std::size_t kMost = 12;
  if (count > kMost) return out + "\n";
  std::string choices;
  for (std::size_t i = 0; i < count; ++i) {
    const StateComponent& component = states.component(i);
    if (!component.count) return out + "\n";
    choices += (choices.empty() ? "" : " x ") + component.count->str();
  }
  return out + " with " + choices + " choices\n";
}

std::string conflictText(const PatternInput& input, const StatesAnswer& answer) {
  if (!answer.report.map)
    return "no folded state: the pattern " + closingOf(answer.report, input.unit) + "\n";
  const OrderConflict& conflict = answer.states->conflict();
  std::string out = "no folded state: " + conflict.message + "\n";
  constexpr std::size_t kMost = 20;
  for (std::size_t i = 0; i < std::min(kMost, conflict.facets.size()); ++i)
    out += "  facet at " + text(interiorPointOf(input.creases.pattern, conflict.facets[i])) + "\n";
  if (conflict.facets.size() > kMost)
    out += "  and " + std::to_string(conflict.facets.size() - kMost) + " more\n";
  return out;
}

JsonValue numberJson(const std::optional<StateCount>& count) {
  return count ? JsonValue::ofText(count->str()) : JsonValue{};
}

JsonValue conflictJson(const PatternInput& input, const StatesAnswer& answer) {
  JsonValue out = JsonValue::object();
  JsonValue& facets = out.add("facets", JsonValue::array());
  if (answer.report.map) {
    for (const FacetId facet : answer.states->conflict().facets) {
      JsonValue& item = facets.items.emplace_back(JsonValue::object());
      item.add("face", countJson(facet.index));
      item.add("place", pointJson(interiorPointOf(input.creases.pattern, facet)));
    }
  }
  out.add("message", JsonValue::ofText(answer.report.map ? answer.states->conflict().message
                                                         : answer.report.whyOpen));
  return out;
}

JsonValue componentsJson(const LayerStates& states) {
  JsonValue out = JsonValue::array();
  for (std::size_t i = 0; i < states.componentCount(); ++i) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("pairs", countJson(states.component(i).pairs.size()));
    item.add("states", numberJson(states.component(i).count));
  }
  return out;
}

}  // namespace

std::string statesText(const PatternInput& input, const StatesAnswer& answer) {
  std::string out = input.name + ": " + input.formatName + ", " + describedAs(input.creases) + "\n";
  out += verdictOf(answer.report) + "\n";
  if (!answer.report.isLocallyFlat()) out += "(kiri check says where and why)\n";
  if (answer.total && *answer.total == 0) return out + conflictText(input, answer);
  if (!answer.states) return out;
  out += answer.total ? counted(*answer.total, "folded state", "folded states") + "\n"
                      : "folded states exist; they were not counted\n";
  return out + componentsText(*answer.states);
}

std::string statesJson(const PatternInput& input, const StatesAnswer& answer, double seconds) {
  JsonValue out = JsonValue::object();
  out.add("file", JsonValue::ofText(input.name));
  out.add("faces", countJson(input.creases.pattern.facets.size()));
  out.add("locally_flat_foldable", JsonValue::ofBool(answer.report.isLocallyFlat()));
  out.add("faulty_vertices", countJson(answer.report.faultyVertices()));
  out.add("closes", JsonValue::ofBool(answer.report.map.has_value()));
  out.add("states", numberJson(answer.total));
  out.add("exist", answer.total    ? JsonValue::ofBool(*answer.total != 0)
                   : answer.states ? JsonValue::ofBool(answer.states->exist())
                                   : JsonValue{});
  const bool isKnown = answer.states.has_value();
  out.add("components", isKnown        ? countJson(answer.states->componentCount())
                        : answer.total ? countJson(0)
                                       : JsonValue{});
  out.add("pairs", isKnown ? countJson(answer.states->problem().pairs.size()) : JsonValue{});
  out.add("cells", answer.ground ? countJson(answer.ground->cells.size()) : JsonValue{});
  out.add("largest_component", isKnown ? countJson(largestComponent(*answer.states)) : JsonValue{});
  if (isKnown) out.add("component_list", componentsJson(*answer.states));
  if (answer.total && *answer.total == 0) out.add("conflict", conflictJson(input, answer));
  if (!answer.stopped.empty()) out.add("stopped", JsonValue::ofText(answer.stopped));
  out.add("angles_taken_as_180", countJson(input.bentCreases));
  out.add("notes", textsJson(input.notes));
  out.add("repairs", repairsJson(input.repairs));
  out.add("seconds", JsonValue::ofNumber(seconds));
  constexpr std::size_t kDocument = 1;
  return layOut(out, kDocument);
}

std::vector<StateCount> choicesOf(const LayerStates& states, StateCount number) {
  std::vector<StateCount> out(states.componentCount());
  for (std::size_t i = out.size(); i-- > 0;) {
    const StateCount& choices = *states.component(i).count;
    out[i] = number % choices;
    number /= choices;
  }
  return out;
}

}  // namespace kiri::cli
