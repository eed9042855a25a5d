// From loose lines to a planar map, with every repair counted.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"

namespace kiri {

enum class RepairKind {
  MergedVertices,     ///< ends so near to each other that one vertex is meant
  MovedToEdge,        ///< ends so near beside a line that they are meant to lie on it
  SplitCrossings,     ///< lines that crossed without a vertex
  DroppedDuplicates,  ///< lines, or parts, that lay on others
  Conflicts,          ///< lines on each other with different assignments: which one was kept
  DroppedPoints,      ///< lines without length, coordinates that are no numbers
  DroppedDangling,    ///< creases that end inside a facet: they cannot fold
  DroppedOutside,     ///< lines where there is no paper
  AddedBorder,        ///< lines of the outline that were not marked as border, or were missing
  SlitBorders,        ///< border lines with paper on both sides, read as cuts
  JoinedPieces,       ///< vertices that only lines left out had made on a straight line
  IgnoredFaces,       ///< faces of the file that disagree with its border lines
};

/// What was repaired of one kind, for a list to show and a picture to mark.
struct Repair {
  RepairKind kind = RepairKind::MergedVertices;
  std::size_t count = 0;
  double farthest = 0;       ///< the longest way a point was moved, units of the drawing
  std::vector<Vec2> places;  ///< the first few, paper frame
  std::string message;       ///< a sentence with the count
};

struct RepairOptions {
  /// Ends nearer than this are one vertex; 0: found from the drawing (a small part of its shortest
  /// true lines, never more than 1/300 of the sheet).
  double merge = 0;
  /// Millimetres a unit of the drawing; the pattern comes out in mm.
  double scale = 1;
};

struct RepairedPattern {
  AssignedPattern creases;
  std::vector<Repair>
      repairs;              ///< in the order of RepairKind; kinds that did not occur are left out
  double mergedWithin = 0;  ///< the distance that was used, units of the drawing
};

/// The planar map that a drawing means. Paper is where the drawing's faces are; where it has none,
/// or some that its lines contradict, what border lines enclose (a region inside a border inside
/// paper is a hole); where they enclose nothing, what cuts enclose, else all that lines enclose if
/// every line has a part in it, else the convex hull of all lines. A clean drawing comes out with
/// its coordinates bit by bit (but for scale 1 times themselves). Vertices stand in the order in
/// which the edges come to them, edges in that of the lines. Cost: n log n for n lines that cross
/// little. Errors: BadFile - no lines, nothing encloses paper (with what was found), too
/// many crossings to be a pattern; Cancelled.
Result<RepairedPattern> patternOf(const CreaseDrawing& drawing, const RepairOptions& options = {},
                                  const Progress& progress = {});

/// The lines of a pattern, one for each edge; curves as polylines.
CreaseDrawing drawingOf(const AssignedPattern& creases);

}  // namespace kiri
