// Lines, paths, places and choices of layers as they stand in a .kiri file.
// SPDX-License-Identifier: MIT
#include "io/places_json.h"

#include <optional>
#include <string>
#include <utility>

namespace kiri {

namespace {

const std::vector<std::string>& frameNames() {
  static const std::vector<std::string> names = {"paper", "model"};
  return names;
}

Frame frameOf(const Field& field) { return field.name() == "model" ? Frame::Model : Frame::Paper; }

const char* nameOf(Frame frame) { return frame == Frame::Model ? "model" : "paper"; }

}  // namespace

DrawnLine readLine(const Field& field) {
  DrawnLine line;
  if (field.isArray()) {
    field.mistake(
        "must say where it is drawn: {\"paper\": [[x, y], [x, y]]} or {\"model\": [[x, y], [x, "
        "y]]}");
    return line;
  }
  Fields fields(field);
  const std::optional<Field> ends = fields.requireOneOf(
      frameNames(), "the two ends of the line in mm, on the sheet or on the folded model");
  if (ends) {
    line.frame = frameOf(*ends);
    const std::vector<Vec2> points = ends->points(2);
    if (points.size() > 2)
      ends->mistake("has " + std::to_string(points.size()) + " points, a line has 2");
    if (points.size() == 2) {
      line.from = points[0];
      line.to = points[1];
      if (line.from == line.to)
        ends->mistake("has its two ends at the same point; move one of them");
    }
  }
  if (const std::optional<Field> facet = fields.find("facet")) {
    line.facet = facet->point();
    if (line.frame == Frame::Model) {
      facet->mistake(
          "goes with a line on the paper only; take it out or write the line as \"paper\"");
    }
  }
  fields.finish();
  return line;
}

DrawnPath readPath(const Field& field) {
  DrawnPath path;
  if (field.isArray()) {
    field.mistake(
        "must say where it is drawn: {\"paper\": [[x, y], ...]} or {\"model\": [[x, y], ...]}");
    return path;
  }
  Fields fields(field);
  if (const std::optional<Field> points = fields.requireOneOf(
          frameNames(), "the points of the path in mm, on the sheet or on the folded model")) {
    path.frame = frameOf(*points);
    path.points = points->points(2);
  }
  fields.finish();
  return path;
}

Place readPlace(const Field& field, Frame frame) {
  if (!field.isObject()) return {frame, field.point()};
  Place place{frame, {}};
  Fields fields(field);
  if (const std::optional<Field> point = fields.requireOneOf(
          frameNames(), "a point [x, y] in mm, on the sheet or on the folded model")) {
    place = {frameOf(*point), point->point()};
  }
  fields.finish();
  return place;
}

std::vector<Place> readPlaces(const Field& field, Frame frame) {
  std::vector<Place> out;
  if (!field.isArray() || field.size() == 0) {
    field.isNot("a list of places [[x, y], ...] with at least one");
    return out;
  }
  if (field.looksLikePoint()) {
    field.mistake("must be a list of places [[x, y], ...]; put the point in brackets once more");
    return out;
  }
  for (std::size_t i = 0; i < field.size(); ++i) out.push_back(readPlace(field.item(i), frame));
  return out;
}

LayerChoice readLayers(const Field& field, Frame frame) {
  if (!field.isObject()) {
    if (field.isText() && field.json().text == kThrough) return ThroughAll{};
    if (!field.isText() || field.json().text != kAll) {
      field.isNot("\"all\", \"through\", {\"top\": count} or {\"facets\": [[x, y], ...]}");
    }
    return AllLayers{};
  }
  Fields fields(field);
  LayerChoice choice = AllLayers{};
  if (const std::optional<Field> chosen = fields.requireOneOf(
          {"top", "facets"}, "how many layers from the top, or a point on each facet")) {
    if (chosen->name() == "top") {
      choice = TopLayers{chosen->count()};
    } else {
      choice = ChosenLayers{readPlaces(*chosen, frame)};
    }
  }
  fields.finish();
  return choice;
}

MovingSide readMoving(const Field& field, Frame frame) {
  if (!field.isObject()) {
    if (field.isText()) return field.oneOf({"left", "right"}) == 0 ? Hand::Left : Hand::Right;
    field.isNot("\"left\", \"right\", {\"point\": [x, y]} or {\"facets\": [[x, y], ...]}");
    return Hand::Left;
  }
  Fields fields(field);
  MovingSide side = Hand::Left;
  if (const std::optional<Field> chosen = fields.requireOneOf(
          {"point", "facets"}, "a point on the side that moves, or one on each facet")) {
    if (chosen->name() == "point") {
      side = MovingPoint{readPlace(*chosen, frame)};
    } else {
      side = MovingFacets{readPlaces(*chosen, frame)};
    }
  }
  fields.finish();
  return side;
}

Keep readKeep(const Field& field, Frame frame) {
  if (field.isText()) {
    field.oneOf({kAll});
    return {};
  }
  if (!field.isArray()) {
    field.isNot("\"all\" or a list of places [[x, y], ...] on the paper that stays");
    return {};
  }
  return {readPlaces(field, frame)};
}

FoldLineName readFoldLineName(const Field& field) {
  if (!field.isText()) {
    if (!field.isArray() && !field.isObject()) {
      field.isNot("the name of a fold or a place [x, y] on its crease");
      return std::string();
    }
    return readPlace(field, Frame::Paper);
  }
  if (field.json().text.empty()) field.mistake("is an empty name");
  return field.json().text;
}

JsonValue writePoint(Vec2 point) {
  JsonValue out = JsonValue::array();
  out.items.push_back(JsonValue::ofNumber(point.x));
  out.items.push_back(JsonValue::ofNumber(point.y));
  return out;
}

JsonValue writePoints(const std::vector<Vec2>& points) {
  JsonValue out = JsonValue::array();
  for (const Vec2 point : points) out.items.push_back(writePoint(point));
  return out;
}

JsonValue writeLine(const DrawnLine& line) {
  JsonValue out = JsonValue::object();
  out.add(nameOf(line.frame), writePoints({line.from, line.to}));
  if (line.facet && line.frame == Frame::Paper) out.add("facet", writePoint(*line.facet));
  return out;
}

JsonValue writePath(const DrawnPath& path) {
  JsonValue out = JsonValue::object();
  out.add(nameOf(path.frame), writePoints(path.points));
  return out;
}

JsonValue writePlace(const Place& place, Frame frame) {
  if (place.frame == frame) return writePoint(place.point);
  JsonValue out = JsonValue::object();
  out.add(nameOf(place.frame), writePoint(place.point));
  return out;
}

JsonValue writePlaces(const std::vector<Place>& places, Frame frame) {
  JsonValue out = JsonValue::array();
  for (const Place& place : places) out.items.push_back(writePlace(place, frame));
  return out;
}

JsonValue writeLayers(const LayerChoice& layers, Frame frame) {
  JsonValue out = JsonValue::object();
  if (const auto* top = std::get_if<TopLayers>(&layers)) {
    out.add("top", JsonValue::ofNumber(top->count));
  } else if (const auto* chosen = std::get_if<ChosenLayers>(&layers)) {
    out.add("facets", writePlaces(chosen->facets, frame));
  } else {
    out = JsonValue::ofText(std::holds_alternative<ThroughAll>(layers) ? kThrough : kAll);
  }
  return out;
}

JsonValue writeMoving(const MovingSide& moving, Frame frame) {
  if (const auto* hand = std::get_if<Hand>(&moving)) {
    return JsonValue::ofText(*hand == Hand::Left ? "left" : "right");
  }
  JsonValue out = JsonValue::object();
  if (const auto* point = std::get_if<MovingPoint>(&moving)) {
    out.add("point", writePlace(point->place, frame));
  } else {
    out.add("facets", writePlaces(std::get<MovingFacets>(moving).facets, frame));
  }
  return out;
}

JsonValue writeKeep(const Keep& keep, Frame frame) {
  return keep.places.empty() ? JsonValue::ofText(kAll) : writePlaces(keep.places, frame);
}

JsonValue writeFoldLineName(const FoldLineName& name) {
  if (const auto* text = std::get_if<std::string>(&name)) return JsonValue::ofText(*text);
  return writePlace(std::get<Place>(name), Frame::Paper);
}

}  // namespace kiri
