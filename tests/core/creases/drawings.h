// Drawings for the tests of repairs: real files with known answers, and edits that repairs undo.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/creases/assigned_pattern.h"
#include "core/creases/crease_drawing.h"

namespace kiri::test {

/// A drawing in a few words: statements of a letter (B M V F U C J), an angle perhaps, and places
/// "x,y" joined by lines, parted by ';'. "face" and places: a face.
CreaseDrawing drawn(const std::string& text);

/// A line of conformance.csv: what other programs found in a file.
struct KnownPattern {
  std::string file;  ///< below the folder of patterns
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  int badVertices = -1;  ///< locally; -1: not known
  bool isUsable = false;
};

/// Empty where the folder of shared patterns is not there.
std::vector<KnownPattern> knownPatterns();

/// What a file of the shared patterns holds; nothing where its reader refuses it.
std::optional<CreaseDrawing> knownDrawing(const std::string& file);

/// A pattern as sorted lines "x,y x,y letter angle" with the places rounded to `step`, each line
/// from its lower end: equal for equal maps, whatever the order and direction of lines.
std::vector<std::string> linesOf(const AssignedPattern& creases, double step);

/// What is wrong with a pattern as a planar map, found in linear time: borders that do not close,
/// uses that do not agree with their edges, hinges with one facet, facets without area, vertices
/// that nothing uses.
std::vector<std::string> mapViolations(const AssignedPattern& creases);

}  // namespace kiri::test
