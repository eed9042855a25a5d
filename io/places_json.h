// Lines, paths, places and choices of layers as they stand in a .kiri file.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/step.h"
#include "io/json_fields.h"
#include "io/json_tree.h"

namespace kiri {

/// Names for messages, and the text that stands for "all".
inline constexpr const char* kAll = "all";
inline constexpr const char* kThrough = "through";

DrawnLine readLine(const Field& field);
DrawnPath readPath(const Field& field);
/// A place written as [x, y] is in `frame`.
Place readPlace(const Field& field, Frame frame);
std::vector<Place> readPlaces(const Field& field, Frame frame);
LayerChoice readLayers(const Field& field, Frame frame);
MovingSide readMoving(const Field& field, Frame frame);
Keep readKeep(const Field& field, Frame frame);
FoldLineName readFoldLineName(const Field& field);

JsonValue writePoint(Vec2 point);
JsonValue writePoints(const std::vector<Vec2>& points);
JsonValue writeLine(const DrawnLine& line);
JsonValue writePath(const DrawnPath& path);
JsonValue writePlace(const Place& place, Frame frame);
JsonValue writePlaces(const std::vector<Place>& places, Frame frame);
JsonValue writeLayers(const LayerChoice& layers, Frame frame);
JsonValue writeMoving(const MovingSide& moving, Frame frame);
JsonValue writeKeep(const Keep& keep, Frame frame);
JsonValue writeFoldLineName(const FoldLineName& name);

}  // namespace kiri
