// What a snap could catch around a pixel, hidden or not.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/snap/snap.h"
#include "editor/view/edges_near.h"
#include "editor/view/neighbourhood.h"
#include "editor/view/seen_places.h"

namespace kiri {

/// Degrees between the directions in which folders lay corners onto edges.
inline constexpr double kFolderStep = 22.5;

/// One thing that a point could be meant to be.
struct Catch {
  SnapKind kind = SnapKind::None;
  Spot spot;            ///< on the facet that has it
  Vec2 at;              ///< pixels
  double pixels = 0;    ///< from the pointer
  double handicap = 0;  ///< pixels that count against it beside what is preferred

  std::optional<EdgeUse> edge;       ///< of the facet: what it lies on
  std::optional<EdgeInView> across;  ///< crossing: the edge of another facet, seen there too
  VertexId vertex;                   ///< vertex
  int part = 0;                      ///< division: so many parts...
  int of = 0;                        ///< ...of so many
  std::optional<double> degrees;     ///< direction of an angle step, 0 to 180

  double score() const { return pixels + handicap; }
};

/// A direction in which a line may be drawn.
struct StepDirection {
  Vec2 from;   ///< start of the line, paper frame of its facet
  Vec2 along;  ///< unit vector
  double degrees = 0;
};

/// What is asked of the surroundings of a pixel.
struct SnapQuestion {
  Vec2 pixels;
  const SnapSettings& settings;
  std::optional<FacetId> frame;
  Spot free;  ///< the point without any snap
  std::optional<StepDirection> direction;
  bool catchesDirection = true;  ///< false: only its meetings with edges
};

/// True when a facet lies in the plane that the question asks about.
bool isInPlane(const Neighbourhood& near, const SnapQuestion& question, FacetId facet);

/// A point of a facet in the paper frame of another facet of its plane (on the sheet: the same
/// point).
Vec2 inFrame(const Neighbourhood& near, const Spot& spot, FacetId frame);

/// Vertices, middles, divisions and crossings of edges, nearest points of edges; by score.
std::vector<Catch> catchesOnPaper(const Neighbourhood& near, SeenPlaces& seen,
                                  const SnapQuestion& question);

/// Points on directions of angle steps and on the grid, by score; they need no paper.
std::vector<Catch> catchesInPlane(const Neighbourhood& near, const SnapQuestion& question);

/// The direction of an angle step that is nearest to the one from `from` to the free point. It
/// counts from the edge that `from` lies on, else from the x axis of the frame's paper. None when
/// the points are one.
std::optional<StepDirection> stepDirection(const Neighbourhood& near, const Spot& free, Vec2 from,
                                           double step);

}  // namespace kiri
