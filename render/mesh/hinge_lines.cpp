// The lines of folded hinges, each of which two planes show.
// SPDX-License-Identifier: MIT
#include "render/mesh/hinge_lines.h"

namespace kiri {

HingeLines::HingeLines(const FoldedState& state, const HingeBreaks& breaks)
    : state_(state), breaks_(breaks), places_(2 * breaks.intervals()) {}

bool HingeLines::isOwn(FacetId facet, const BoundaryPiece& piece) const {
  if (!piece.edge.isValid()) return false;
  const Edge& edge = state_.pattern[piece.edge];
  return isFoldedHinge(edge) && (edge.left == facet || edge.right == facet);
}

HingeLines::Place& HingeLines::placeAt(const MeshSide& side, const BoundaryPiece& piece,
                                       double part) {
  const double t = piece.from + (piece.to - piece.from) * part;
  return places_[2 * breaks_.intervalAt(piece.edge, t) + (side.showsFront ? 1 : 0)];
}

void HingeLines::notePaper(const MeshSide& side, const BoundaryPiece& piece) {
  const std::vector<double> breaks = breaks_.within(piece.edge, piece.from, piece.to);
  for (std::size_t i = 0; i <= breaks.size(); ++i) {
    const double low = i == 0 ? 0 : breaks[i - 1];
    const double high = i < breaks.size() ? breaks[i] : 1;
    placeAt(side, piece, (low + high) / 2).hasOther = true;
  }
}

void HingeLines::add(const MeshSide& side, const BoundaryPiece& piece, const Points& points,
                     const MeshSegment& segment, const MeshBuilder& builder,
                     std::vector<MeshSegment>& lines) {
  const std::vector<double> breaks = breaks_.within(piece.edge, piece.from, piece.to);
  const FacetId other = across(state_.pattern[piece.edge], side.facet);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double low = i == 0 ? 0 : breaks[i - 1];
    const double high = i < breaks.size() ? breaks[i] : 1;
    Place& place = placeAt(side, piece, (low + high) / 2);
    if (place.line != kNoLine) {
      place.hasOther = true;
      lines[place.line].otherNormal = segment.normal;
      continue;
    }
    place.line = builder.addLine(side, {points[i], points[i + 1]}, segment, lines);
    lines[place.line].otherFacet = other.index;
    lines[place.line].isFromJoined = i > 0;
    lines[place.line].isToJoined = i + 2 < points.size();
  }
}

void HingeLines::settle(std::vector<MeshSegment>& lines) const {
  for (const Place& place : places_) {
    if (place.line == kNoLine || place.hasOther) continue;
    MeshSegment& line = lines[place.line];
    // The same side of the paper, on the other facet.
    const double side = dot(asVec(line.normal), state_.poses[line.facet].normal());
    const Vec3 front = state_.poses[line.otherFacet].normal();
    line.otherNormal = floats(side > 0 ? front : -front);
    line.isCovered = true;
  }
}

}  // namespace kiri
