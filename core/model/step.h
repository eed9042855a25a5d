// The steps that a model is made of. Steps name places on the paper, never indices (DESIGN section
// 2). SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/vec.h"
#include "core/creases/crease_drawing.h"
#include "core/geometry/bspline.h"

namespace kiri {

/// In which frame a place was given.
enum class Frame {
  Paper,  ///< paper frame, mm: a place on the sheet at rest
  Model,  ///< as drawn on the folded model as it lies: x and y of the model frame, seen from the
          ///< front
};

/// A place in one of the two frames. In the model frame it means the topmost paper there.
struct Place {
  Frame frame = Frame::Paper;
  Vec2 point;
  bool operator==(const Place&) const = default;
};

/// A directed segment. In the paper frame its ends are in the frame of one facet (and may lie
/// beyond it): the facet that holds `facet`, by default the one under the segment's middle.
struct DrawnLine {
  Frame frame = Frame::Paper;
  Vec2 from;
  Vec2 to;
  std::optional<Vec2> facet;  ///< paper frame
  bool operator==(const DrawnLine&) const = default;
};

/// Which layers a step works on.
struct AllLayers {
  bool operator==(const AllLayers&) const = default;
};
/// The `count` uppermost layers along the line, seen from the front.
struct TopLayers {
  int count = 1;
  bool operator==(const TopLayers&) const = default;
};
/// The facets that hold these points.
struct ChosenLayers {
  std::vector<Place> facets;
  bool operator==(const ChosenLayers&) const = default;
};
/// All paper under a cut that is drawn in the model frame, in whatever plane it lies, straight down
/// as seen from the front. For cuts only.
struct ThroughAll {
  bool operator==(const ThroughAll&) const = default;
};
/// What the path itself names: on the sheet the edges that it runs along, and none that lies at the
/// same place of the model; in the model frame all edges there. For tears and mends only.
struct OwnEdges {
  bool operator==(const OwnEdges&) const = default;
};
using LayerChoice = std::variant<AllLayers, TopLayers, ChosenLayers, ThroughAll, OwnEdges>;

/// Which side of the line moves.
enum class Hand { Left, Right };
/// By the line's direction, by a point on that side, or by facets that must move.
struct MovingPoint {
  Place place;
  bool operator==(const MovingPoint&) const = default;
};
struct MovingFacets {
  std::vector<Place> facets;
  bool operator==(const MovingFacets&) const = default;
};
using MovingSide = std::variant<Hand, MovingPoint, MovingFacets>;

/// Seen on the model as it lies: a valley turns the moving side towards the viewer, a mountain
/// away.
enum class FoldType { Valley, Mountain };

struct FoldStep {
  std::string name;  ///< of the fold line; empty: "fold N" with N the step's number
  DrawnLine line;
  FoldType type = FoldType::Valley;
  double angle = 180;  ///< degrees, 0 to 180
  LayerChoice layers = AllLayers{};
  MovingSide moving = Hand::Left;
  bool operator==(const FoldStep&) const = default;
};

/// A fold line by its name, or by a place on one of its hinges.
using FoldLineName = std::variant<std::string, Place>;

struct AngleStep {
  FoldLineName line;
  double angle = 0;  ///< degrees in the fold's own direction, -180 to 180; negative: the other way
  bool operator==(const AngleStep&) const = default;
};

/// How several fold lines move.
enum class Sequence {
  InOrder,   ///< one after the other: unfold from the last named to the first, refold from first to
             ///< last
  Together,  ///< at once, as leaves do (thesis 4.5 B17); the order in which they come to lie is
             ///< found
};

struct UnfoldStep {
  std::vector<FoldLineName> lines;  ///< in the order of folding; empty: all
  Sequence sequence = Sequence::InOrder;
  bool operator==(const UnfoldStep&) const = default;
};

struct RefoldStep {
  std::vector<FoldLineName> lines;  ///< in the order of folding; empty: all that are not folded
  Sequence sequence = Sequence::InOrder;
  bool operator==(const RefoldStep&) const = default;
};

/// A polyline along existing edges, from a vertex to a point.
struct DrawnPath {
  Frame frame = Frame::Paper;
  std::vector<Vec2> points;
  bool operator==(const DrawnPath&) const = default;
};

struct TearStep {
  DrawnPath path;
  LayerChoice layers = OwnEdges{};
  bool operator==(const TearStep&) const = default;
};

struct MendStep {
  DrawnPath path;  ///< empty: everything that can be mended
  LayerChoice layers = OwnEdges{};
  bool operator==(const MendStep&) const = default;
};

struct AddEdgeStep {
  DrawnLine line;
  LayerChoice layers = AllLayers{};
  bool operator==(const AddEdgeStep&) const = default;
};

/// Which paper stays after a cut. No places: all of it stays. A place in the model frame keeps what
/// lies on its side of the cut, in all layers; a place on the paper keeps the connected piece that
/// holds it.
struct Keep {
  std::vector<Place> places;
  bool operator==(const Keep&) const = default;
};

struct StraightCutStep {
  DrawnLine line;
  LayerChoice layers = AllLayers{};
  Keep keep;
  bool operator==(const StraightCutStep&) const = default;
};

struct CurveCutStep {
  Frame frame = Frame::Model;
  std::vector<Vec2> controls;
  std::optional<Vec2>
      facet;  ///< paper frame: whose frame the controls are in; by default the one they start on
  bool isClosed = false;
  SplineEnds ends = SplineEnds::Clamped;
  LayerChoice layers = AllLayers{};
  Keep keep;
  bool operator==(const CurveCutStep&) const = default;
};

enum class TurnAxis { Vertical, Horizontal };
/// Turns the model over about the vertical or horizontal line through the middle of its box.
struct TurnOverStep {
  TurnAxis axis = TurnAxis::Vertical;
  bool operator==(const TurnOverStep&) const = default;
};

/// Turns the model in its plane, counter-clockwise, about a point of the model frame (default:
/// middle of its box).
struct RotateStep {
  double degrees = 0;
  std::optional<Vec2> about;
  bool operator==(const RotateStep&) const = default;
};

struct MoveStep {
  Vec2 by;  ///< mm
  bool operator==(const MoveStep&) const = default;
};

/// An edge of a crease pattern: its ends are positions in PatternStep::vertices.
struct PatternCrease {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Assignment assignment = Assignment::Unassigned;  ///< Border is none: that is the sheet's outline
  double angle = 180;  ///< degrees, target of a hinge as AssignedPattern has it: valley positive
  bool operator==(const PatternCrease&) const = default;
};

/// A whole crease pattern at once, drawn on the flat sheet before anything else is folded, and
/// folded where that is asked for. Layers are chosen when the step is made and named by places on
/// the paper, so that opening a file searches for nothing.
struct PatternStep {
  std::string name;            ///< of its fold lines: "NAME 1", "NAME 2"; empty: "crease"
  std::vector<Vec2> vertices;  ///< paper frame, mm; of creases only
  std::vector<PatternCrease> creases;
  bool isFolded = false;        ///< else the creases are there and flat
  std::optional<Vec2> resting;  ///< in the facet that stays where it is; none: the largest
  /// A point of each facet, from the bottom to the top of every plane, seen from the side that the
  /// front of the resting facet looks to. For planes at right angles to it: seen from the front of
  /// that facet of theirs whose point lies leftmost, then lowest. Empty: searched for.
  std::vector<Vec2> layers;
  std::vector<std::pair<Vec2, Vec2>> exceptions;  ///< (upper, lower): what the list cannot say
  bool operator==(const PatternStep&) const = default;
};

using Action =
    std::variant<FoldStep, AngleStep, UnfoldStep, RefoldStep, TearStep, MendStep, AddEdgeStep,
                 StraightCutStep, CurveCutStep, TurnOverStep, RotateStep, MoveStep, PatternStep>;

/// One operation in a model's history.
struct Step {
  Action action;
  std::string title;
  std::string notes;
  std::string unknown;  ///< fields that the reader did not know, as JSON text, kept for the writer
  bool operator==(const Step&) const = default;
};

}  // namespace kiri
