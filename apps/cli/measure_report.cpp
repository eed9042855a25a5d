// The table of measures, written three ways.
// SPDX-License-Identifier: MIT
#include "apps/cli/measure_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/cli/json_parts.h"
#include "apps/cli/measure_names.h"
#include "core/base/text.h"
#include "core/geometry/tolerance.h"

namespace kiri::cli {

namespace {

const char* kindOf(const MarginPoint& point) {
  return !point.isLobe ? "sinus" : point.isTooth ? "tooth" : "lobe";
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

/// Name, value and what is to be said, in columns.
std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  constexpr std::size_t kNames = 17;
  constexpr std::size_t kValues = 16;
  return padded(name, kNames) + padded(value, kValues) + rest + "\n";
}

/// What is nothing but rounding beside the leaf is shown as nothing.
std::string shown(double value, const LeafMeasures& m) {
  return text(std::abs(value) <= Tolerance(m.feret).length() ? 0.0 : value);
}

constexpr const char* kAngleConvention = "from the axis, clockwise";

}  // namespace

std::string measuresJson(const MeasuredThing& thing, const LeafMeasures& m) {
  JsonValue out = JsonValue::object();
  JsonValue conventions = JsonValue::object();
  out.add("model", JsonValue::ofText(thing.name));
  out.add("petiole", pointJson(m.petiole));
  out.add("petioleFrom", JsonValue::ofText(thing.petioleFrom));
  for (const NamedMeasure& measure : namedMeasures(m, thing.prominence)) {
    out.add(measure.name, measure.value ? JsonValue::ofNumber(*measure.value) : JsonValue{});
    const std::string unit = *measure.unit != 0 ? std::string(measure.unit) + "; " : "";
    conventions.add(measure.name, JsonValue::ofText(unit + measure.convention));
  }
  JsonValue margin = JsonValue::array();
  for (const MarginPoint& point : m.margin) {
    JsonValue& item = margin.items.emplace_back(JsonValue::object());
    item.add("kind", JsonValue::ofText(kindOf(point)));
    item.add("angle", JsonValue::ofNumber(point.angle));
    item.add("length", JsonValue::ofNumber(point.length));
    item.add("place", pointJson(point.place));
    if (point.isLobe) item.add("reach", JsonValue::ofNumber(point.reach));
  }
  out.add("margin", std::move(margin));
  conventions.add("margin", JsonValue::ofText(std::string("tips and sinuses from the left of the "
                                                          "base clockwise; angle: deg ") +
                                              kAngleConvention +
                                              "; length: mm from the petiole; reach: of the "
                                              "sinus down the tip's axis (Royer et al. 2005)"));
  out.add("conventions", std::move(conventions));
  return layOut(out, 1);
}

std::string measuresCsv(const MeasuredThing& thing, const LeafMeasures& m) {
  std::string out = "measure,value,unit,angle,x,y,convention\n";
  for (const NamedMeasure& measure : namedMeasures(m, thing.prominence)) {
    out += measure.name + "," + (measure.value ? numberText(*measure.value) : "") + "," +
           measure.unit + ",,,,\"" + measure.convention + "\"\n";
  }
  for (const MarginPoint& point : m.margin) {
    const std::string reach =
        point.isLobe ? "; its sinus reaches " + text(point.reach) + " down its axis" : "";
    out += std::string(kindOf(point)) + "," + numberText(point.length) + ",mm," +
           numberText(point.angle) + "," + numberText(point.place.x) + "," +
           numberText(point.place.y) + ",\"from the petiole; angle " + kAngleConvention + reach +
           "\"\n";
  }
  return out;
}

std::string measuresText(const MeasuredThing& thing, const LeafMeasures& m) {
  std::string out = row("petiole", text(m.petiole), thing.petioleFrom);
  for (const NamedMeasure& measure : namedMeasures(m, thing.prominence)) {
    const std::string value = measure.value ? shown(*measure.value, m) : "none";
    out += row(measure.name, *measure.unit != 0 ? value + " " + measure.unit : value,
               measure.convention);
  }
  for (const MarginPoint& point : m.margin) {
    out += row(kindOf(point), text(point.length) + " mm", "at " + text(point.angle) + " degrees");
  }
  return out;
}

}  // namespace kiri::cli
