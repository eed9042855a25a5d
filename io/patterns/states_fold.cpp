// Folded states of a crease pattern as a FOLD file: the pattern, and a folded form for each state.
// SPDX-License-Identifier: MIT
#include "io/patterns/states_fold.h"

#include <algorithm>
#include <utility>

#include "io/json_tree.h"
#include "io/patterns/facet_loops.h"
#include "io/patterns/folded_vertices.h"

namespace kiri {

namespace {

std::string letterOf(Assignment assignment) {
  switch (assignment) {
    case Assignment::Border:
      return "\"B\"";
    case Assignment::Mountain:
      return "\"M\"";
    case Assignment::Valley:
      return "\"V\"";
    case Assignment::Flat:
      return "\"F\"";
    case Assignment::Unassigned:
      return "\"U\"";
    case Assignment::Cut:
      return "\"C\"";
    case Assignment::Join:
      return "\"J\"";
  }
  return "\"U\"";
}

std::string angleOf(Assignment assignment) {
  if (assignment == Assignment::Valley) return "180";
  if (assignment == Assignment::Mountain) return "-180";
  return assignment == Assignment::Unassigned ? "null" : "0";
}

/// Text of one list, a few items on each line: files of this kind are large, so they are not made
/// from a tree.
class ListText {
 public:
  ListText(std::string& out, const std::string& indent, const std::string& name)
      : out_(out), indent_(indent) {
    out_ += ",\n" + indent_ + jsonString(name) + ": [";
  }
  void add(const std::string& item) {
    constexpr std::size_t kWidth = 96;
    if (isEmpty_ || column_ + item.size() > kWidth) {
      out_ += (isEmpty_ ? "\n" : ",\n") + indent_ + "  ";
      column_ = indent_.size() + 2;
    } else {
      out_ += ", ";
      column_ += 2;
    }
    out_ += item;
    column_ += item.size();
    isEmpty_ = false;
  }
  void close() { out_ += isEmpty_ ? "]" : "\n" + indent_ + "]"; }

 private:
  std::string& out_;
  std::string indent_;
  std::size_t column_ = 0;
  bool isEmpty_ = true;
};

std::string pairText(std::uint32_t a, std::uint32_t b) {
  return "[" + std::to_string(a) + ", " + std::to_string(b) + "]";
}

std::string indexText(FacetId facet) {
  return facet.isValid() ? std::to_string(facet.index) : "null";
}

void addPoints(std::string& out, const std::string& indent, const std::string& name,
               const std::vector<Vec2>& points) {
  ListText list(out, indent, name);
  for (const Vec2 p : points) list.add("[" + numberText(p.x) + ", " + numberText(p.y) + "]");
  list.close();
}

void addEdges(std::string& out, const std::string& indent, const std::vector<FoldEdge>& edges) {
  ListText vertices(out, indent, "edges_vertices");
  for (const FoldEdge& e : edges) vertices.add(pairText(e.from, e.to));
  vertices.close();
  ListText faces(out, indent, "edges_faces");
  for (const FoldEdge& e : edges)
    faces.add("[" + indexText(e.left) + ", " + indexText(e.right) + "]");
  faces.close();
}

void addAssignments(std::string& out, const std::string& indent,
                    const std::vector<Assignment>& assignments) {
  ListText letters(out, indent, "edges_assignment");
  for (const Assignment a : assignments) letters.add(letterOf(a));
  letters.close();
  ListText angles(out, indent, "edges_foldAngle");
  for (const Assignment a : assignments) angles.add(angleOf(a));
  angles.close();
}

void addLoops(std::string& out, const std::string& indent, const std::string& name,
              const std::vector<std::vector<std::uint32_t>>& loops) {
  ListText list(out, indent, name);
  for (const std::vector<std::uint32_t>& loop : loops) {
    std::string item;
    for (const std::uint32_t i : loop) item += (item.empty() ? "[" : ", ") + std::to_string(i);
    list.add(item + "]");
  }
  list.close();
}

void addFaces(std::string& out, const std::string& indent,
              const std::vector<std::vector<std::uint32_t>>& faces,
              const std::vector<FoldEdge>& edges) {
  addLoops(out, indent, "faces_vertices", faces);
  addLoops(out, indent, "faces_edges", faceEdges(faces, edges));
}

/// Positions in `problem.pairs` that are written.
std::vector<std::uint32_t> allPairs(const OrderProblem& problem) {
  std::vector<std::uint32_t> out(problem.pairs.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint32_t>(i);
  return out;
}

/// Of every stack the pairs of neighbours: all others of it follow from these.
std::vector<std::uint32_t> neighbourPairs(const OrderProblem& problem, const LayerValues& values) {
  std::vector<std::uint32_t> out;
  for (std::size_t set = 0; set < problem.stacks.size(); ++set) {
    std::vector<FacetId> stack(problem.stacks.begin(set), problem.stacks.end(set));
    std::sort(stack.begin(), stack.end(), [&](FacetId a, FacetId b) {
      if (a == b) return false;
      const std::uint32_t pair = problem.indexOf(std::min(a, b), std::max(a, b));
      return values[pair] == (a > b);  // the lower one first
    });
    for (std::size_t i = 1; i < stack.size(); ++i) {
      out.push_back(
          problem.indexOf(std::min(stack[i - 1], stack[i]), std::max(stack[i - 1], stack[i])));
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void addOrders(std::string& out, const std::string& indent, const FlatMap& map,
               const OrderProblem& problem, const LayerValues& values,
               const std::vector<std::uint32_t>& pairs) {
  ListText list(out, indent, "faceOrders");
  for (const std::uint32_t index : pairs) {
    const FacetPair pair = problem.pairs[index];
    // +1: `a` lies on the side that the front of `b` is turned to.
    const bool isFront = values[index] != map.poses[pair.b.index].isFlipped;
    list.add("[" + std::to_string(pair.a.index) + ", " + std::to_string(pair.b.index) +
             (isFront ? ", 1]" : ", -1]"));
  }
  list.close();
}

std::string attributes(bool isPattern, bool hasCuts, bool hasJoins) {
  return std::string("[\"2D\", \"manifold\", \"orientable\", ") +
         (hasCuts ? "\"cuts\", " : "\"noCuts\", ") + (hasJoins ? "\"joins\", " : "\"noJoins\", ") +
         (isPattern ? "\"nonSelfTouching\"" : "\"selfTouching\"") + "]";
}

/// Everything that all frames of one file share.
struct Sheets {
  const AssignedPattern& creases;
  const FlatMap& map;
  const OrderProblem& problem;
  FacetLoops loops;
  FoldedVertices folded;
  bool hasCuts = false;
  bool hasJoins = false;
};

void addText(std::string& out, const std::string& indent, const char* name,
             const std::string& value) {
  if (!value.empty()) out += ",\n" + indent + "\"" + name + "\": " + jsonString(value);
}

void addHead(std::string& out, const StatesFoldOptions& options, bool hasStates) {
  out += "{\n  \"file_spec\": 1.2";
  addText(out, "  ", "file_creator", options.creator);
  addText(out, "  ", "file_title", options.title);
  addText(out, "  ", "file_description", options.description);
  out += std::string(",\n  \"file_classes\": ") +
         (hasStates ? "[\"singleModel\", \"diagrams\"]" : "[\"singleModel\"]");
}

void addPattern(std::string& out, const Sheets& sheets, const StatesFoldOptions& options) {
  out += ",\n  \"frame_classes\": [\"creasePattern\"]";
  out += ",\n  \"frame_attributes\": " + attributes(true, sheets.hasCuts, sheets.hasJoins);
  addText(out, "  ", "frame_unit", options.unit);
  addPoints(out, "  ", "vertices_coords", sheets.creases.pattern.vertices);
  addEdges(out, "  ", sheets.loops.edges);
  addAssignments(out, "  ", sheets.loops.assignments);
  addFaces(out, "  ", sheets.loops.faces, sheets.loops.edges);
}

/// What the edges of the folded form are, in the order of `edges`.
std::vector<Assignment> assignmentsIn(const Sheets& sheets, const std::vector<FoldEdge>& edges,
                                      const LayerValues& values) {
  std::vector<Assignment> out;
  out.reserve(edges.size());
  for (const FoldEdge& edge : edges) {
    if (!edge.source.isValid()) {
      out.push_back(Assignment::Join);
    } else if (edge.isSplit) {
      out.push_back(Assignment::Border);
    } else {
      out.push_back(foldedAs(sheets.creases, sheets.map, sheets.problem, values, edge.source));
    }
  }
  return out;
}

void addState(std::string& out, const Sheets& sheets, const StateFrame& state,
              const StatesFoldOptions& options, bool isReduced) {
  const std::string in = "      ";
  const FoldedVertices& folded = sheets.folded;
  out += "    {\n      \"frame_classes\": [\"foldedForm\"]";
  addText(out, in, "frame_title", state.title);
  out += ",\n      \"frame_attributes\": " +
         attributes(false, sheets.hasCuts && !folded.isSplit, sheets.hasJoins);
  if (folded.isSplit) {
    out += ",\n      \"frame_inherit\": false";
    addText(out, in, "frame_unit", options.unit);
  } else {
    out += ",\n      \"frame_parent\": 0,\n      \"frame_inherit\": true";
  }
  addPoints(out, in, "vertices_coords", folded.points);
  if (folded.isSplit) {
    addPoints(out, in, "vertices_kiri:paper", folded.paper);
    addEdges(out, in, folded.edges);
    addFaces(out, in, folded.faces, folded.edges);
  }
  addAssignments(out, in, assignmentsIn(sheets, folded.edges, state.values));
  addOrders(out, in, sheets.map, sheets.problem, state.values,
            isReduced ? neighbourPairs(sheets.problem, state.values) : allPairs(sheets.problem));
  if (isReduced) addText(out, in, "kiri:faceOrders", "pairs that follow from others are left out");
  out += "\n    }";
}

std::vector<std::string> lossesOf(const Sheets& sheets, bool isReduced) {
  std::vector<std::string> out;
  for (const Edge& edge : sheets.creases.pattern.edges) {
    if (!edge.isCurved()) continue;
    out.push_back("FOLD has no curves: curved edges became straight");
    break;
  }
  if (sheets.loops.joins > 0)
    out.push_back(
        "FOLD has no holes in faces: they were joined to the outline with join edges (J)");
  if (isReduced)
    out.push_back("face orders that follow from others are left out, the file would be too large");
  return out;
}

}  // namespace

Assignment foldedAs(const AssignedPattern& creases, const FlatMap& map, const OrderProblem& problem,
                    const LayerValues& values, EdgeId edge) {
  if (!creases.isFolded(edge)) return creases.of(edge);
  const Edge& hinge = creases.pattern[edge];
  const FacetId low = std::min(hinge.left, hinge.right);
  const FacetId high = std::max(hinge.left, hinge.right);
  const std::uint32_t pair = problem.indexOf(low, high);
  if (pair == OrderProblem::kNone) return creases.of(edge);
  // A valley brings the fronts together: the facet that lies face down is the upper one.
  return values[pair] == map.poses[low.index].isFlipped ? Assignment::Valley : Assignment::Mountain;
}

WrittenPattern writeStates(const AssignedPattern& creases, const FlatMap& map,
                           const OrderProblem& problem, const std::vector<StateFrame>& states,
                           const StatesFoldOptions& options) {
  FacetLoops loops = facetLoopsOf(creases);
  FoldedVertices folded = foldedVerticesOf(creases, map, loops);
  Sheets sheets{creases, map, problem, std::move(loops), std::move(folded), false, false};
  for (const Assignment a : sheets.loops.assignments) {
    sheets.hasCuts = sheets.hasCuts || a == Assignment::Cut;
    sheets.hasJoins = sheets.hasJoins || a == Assignment::Join;
  }
  const bool isReduced = problem.pairs.size() * states.size() > options.mostOrders;
  WrittenPattern out;
  out.losses = lossesOf(sheets, isReduced);
  addHead(out.text, options, !states.empty());
  addPattern(out.text, sheets, options);
  if (!states.empty()) {
    out.text += ",\n  \"file_frames\": [\n";
    for (std::size_t i = 0; i < states.size(); ++i) {
      addState(out.text, sheets, states[i], options, isReduced);
      out.text += i + 1 < states.size() ? ",\n" : "\n";
    }
    out.text += "  ]";
  }
  out.text += "\n}\n";
  return out;
}

}  // namespace kiri
