// A crease pattern with assignments as shapes: paper, creases, facets.
// SPDX-License-Identifier: MIT
#include "render/scene/assigned_items.h"

#include <string>
#include <utility>

#include "core/paper/contours.h"
#include "render/scene/line_looks.h"
#include "render/scene/paper_items.h"

namespace kiri {
namespace {

/// What an edge is drawn as: a group of the picture.
enum class DrawnAs { Flat, Unassigned, Valley, Mountain, Cut };

DrawnAs drawnAs(const AssignedPattern& creases, EdgeId e) {
  if (creases.pattern[e].kind != EdgeKind::Hinge) return DrawnAs::Cut;
  switch (creases.of(e)) {
    case Assignment::Mountain:
      return DrawnAs::Mountain;
    case Assignment::Valley:
      return DrawnAs::Valley;
    case Assignment::Unassigned:
      return DrawnAs::Unassigned;
    case Assignment::Flat:
    case Assignment::Join:
    case Assignment::Border:
    case Assignment::Cut:
      break;
  }
  return DrawnAs::Flat;
}

const char* groupName(DrawnAs kind) {
  switch (kind) {
    case DrawnAs::Flat:
      return "flat";
    case DrawnAs::Unassigned:
      return "unassigned";
    case DrawnAs::Valley:
      return "valley";
    case DrawnAs::Mountain:
      return "mountain";
    case DrawnAs::Cut:
      return "cut";
  }
  return "";
}

Stroke assignedStroke(const AssignedPattern& creases, EdgeId e, const Appearance& appearance,
                      double width) {
  switch (drawnAs(creases, e)) {
    case DrawnAs::Flat:
      return strokeFor(LineKind::Flat, appearance, width / 2);
    case DrawnAs::Valley:
      return strokeFor(LineKind::Valley, appearance, width);
    case DrawnAs::Mountain:
      return strokeFor(LineKind::Mountain, appearance, width);
    case DrawnAs::Cut:
      return strokeFor(
          creases.pattern[e].kind == EdgeKind::Border ? LineKind::Border : LineKind::Cut,
          appearance, width);
    case DrawnAs::Unassigned:
      break;
  }
  Stroke stroke;
  stroke.color = kUnassignedColor;
  stroke.width = width;
  return stroke;
}

Group paperGroup(const CreasePattern& pattern, const Affine& toScene,
                 const Appearance& appearance) {
  std::vector<Loop> loops;
  for (const std::vector<EdgeUse>& contour : contoursOf(pattern)) {
    Loop& loop = loops.emplace_back();
    for (const EdgeUse use : contour) loop.push_back(transformed(toScene, arcOf(pattern, use)));
  }
  FillItem item{std::move(loops), fillOf(appearance, true, toScene)};
  return {"print", "paper", {{std::move(item), "paper", "", {}}}, {}};
}

}  // namespace

std::vector<Group> assignedGroups(const AssignedPattern& creases, const Affine& toScene,
                                  const Appearance& appearance, double width) {
  constexpr char kLetters[] = "BMVFUCJ";
  const CreasePattern& pattern = creases.pattern;
  std::vector<Group> groups{paperGroup(pattern, toScene, appearance)};
  for (const DrawnAs kind :
       {DrawnAs::Flat, DrawnAs::Unassigned, DrawnAs::Valley, DrawnAs::Mountain, DrawnAs::Cut}) {
    Group group{groupName(kind), groupName(kind), {}, {}};
    for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
      const EdgeId e(i);
      const Edge& edge = pattern[e];
      if ((!edge.left.isValid() && !edge.right.isValid()) || drawnAs(creases, e) != kind) continue;
      StrokeItem line{{{transformed(toScene, arcOf(pattern, e))}},
                      assignedStroke(creases, e, appearance, width)};
      const char letter = kLetters[static_cast<std::size_t>(creases.of(e))];
      group.items.push_back({std::move(line),
                             groupName(kind),
                             "edge-" + std::to_string(i),
                             {{"assignment", std::string(1, letter)}}});
    }
    if (!group.items.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<Loop> facetLoops(const CreasePattern& pattern, FacetId facet, const Affine& toScene) {
  std::vector<Loop> loops = regionOf(pattern, facet).loops;
  for (Loop& loop : loops) {
    for (Arc& arc : loop) arc = transformed(toScene, arc);
  }
  return loops;
}

}  // namespace kiri
