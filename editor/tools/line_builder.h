// A line that is built from points and lines of the paper: the constructions, picked one by one.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/paper/facet_line.h"
#include "editor/base/events.h"
#include "editor/base/phrase.h"
#include "editor/snap/constructions.h"
#include "editor/tools/facet_name.h"
#include "editor/tools/scope.h"

namespace kiri {

/// How the line tool places a line, in the order of its field. The seven after ByHand are those of
/// Huzita and Justin.
enum class Construction {
  ByHand,
  ThroughPoints,
  PointOntoPoint,
  LineOntoLine,
  SquareThrough,
  PointOntoLine,
  PointsOntoLines,
  PointSquareTo,
  Bisector,
  Mirror,   ///< a line mirrored in a line: in the selected one, where one is selected
  Project,  ///< the drawn line, laid onto the edge nearest to it
};
std::vector<Phrase> constructionNames();

/// Picks what a construction needs, one click each, and gives the lines that do it. All is kept in
/// the plane of the facet of the first pick.
class LineBuilder {
 public:
  void begin(Construction kind);
  Construction kind() const { return kind_; }
  /// Takes the point or the line under the pointer. False: there is none.
  bool pick(const PointerEvent& event, const Scope& scope);
  /// Takes a line that is there already (mirror, project).
  void give(const FoldedState& state, const FacetLine& line);
  void dropLast();
  bool isEmpty() const { return picks_.empty(); }
  bool isComplete() const { return picks_.size() >= wants().size(); }

  /// The lines that do it, in the plane of `frame`; segments for mirror and project, elsewhere the
  /// line goes on without end.
  struct Built {
    FacetId frame;
    std::vector<Line2> lines;
    bool isEndless = true;
  };
  std::optional<Built> build(const Scope& scope) const;

  /// What to click next.
  Phrase hint() const;
  /// What was picked, and what would be picked under the pointer.
  void addMarks(const Scope& scope, Marks& marks) const;
  void hover(const PointerEvent& event, const Scope& scope);

 private:
  enum class Want { Point, Line };
  struct Pick {
    Vec2 from;
    Vec2 to;  ///< of a line
    bool isLine = false;
  };

  std::vector<Want> wants() const;
  std::optional<Line2> lineUnder(const PointerEvent& event, const Scope& scope,
                                 FacetId& facet) const;
  std::optional<Line2> mirrorLine(const Scope& scope, FacetId frame) const;
  std::vector<Line2> linesIn(const Scope& scope, FacetId frame) const;
  std::optional<Line2> nearestEdge(const Scope& scope, FacetId frame, const Line2& line) const;

  Construction kind_ = Construction::ByHand;
  std::optional<FacetName> frame_;
  std::vector<Pick> picks_;
  bool hasMirror_ = false;  ///< a selected line serves as mirror
  Marks hovered_;
};

}  // namespace kiri
