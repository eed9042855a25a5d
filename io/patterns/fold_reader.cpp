// Reading crease patterns from FOLD files (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_reader.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "io/json_tree.h"
#include "io/patterns/fold_frames.h"
#include "io/patterns/fold_graph.h"
#include "io/patterns/fold_orders.h"
#include "io/patterns/fold_units.h"
#include "io/patterns/fold_unroll.h"
#include "io/patterns/plain_number.h"
#include "io/patterns/tally.h"

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

/// A frame that may be the pattern, read.
struct Candidate {
  FoldFrameView frame;
  FoldGraph graph;
  std::vector<std::string> notes;
};

bool isFoldedForm(const FoldFrameView& frame) { return frame.isOfClass("foldedForm"); }

/// True when no face shows its back: what is drawn is the paper at rest, whatever the class says.
bool showsFrontOnly(const FoldGraph& graph) {
  return !graph.faces.empty() &&
         std::all_of(graph.faces.begin(), graph.faces.end(),
                     [&](const auto& face) { return doubledArea(graph, face) > 0; });
}

bool liesFlat(const Candidate& candidate) {
  if (!isLevel(candidate.graph)) return false;
  return !isFoldedForm(candidate.frame) || showsFrontOnly(candidate.graph);
}

/// Chooses and reads the frame that is the pattern.
class PatternFinder {
 public:
  explicit PatternFinder(const JsonValue& document) : document_(document) {}

  Result<Candidate> find() {
    const std::size_t count = frameCountOf(document_);
    for (std::size_t i = 0; i < count; ++i) {
      if (!isFrameOfClass(frameObject(document_, i), "creasePattern")) continue;
      std::optional<Candidate> found = tryFrame(i);
      if (found && (isLevel(found->graph) || !found->graph.faces.empty())) {
        return std::move(*found);
      }
    }
    std::optional<Candidate> key = tryFrame(0);
    if (key && liesFlat(*key)) return std::move(*key);
    for (std::size_t i = 1; i < count; ++i) {
      if (frameObject(document_, i).find("vertices_coords") == nullptr) continue;
      std::optional<Candidate> other = tryFrame(i);
      if (other && liesFlat(*other) && !isFoldedForm(other->frame)) return std::move(*other);
      if (!key) key = std::move(other);
    }
    if (!key) return *error_;
    return std::move(*key);
  }

 private:
  /// More frames than this are not looked into: each may inherit the whole file.
  static constexpr int kMostTries = 20;

  std::optional<Candidate> tryFrame(std::size_t i) {
    if (++tries_ > kMostTries) return std::nullopt;
    FoldFrameView frame(document_, i);
    std::vector<std::string> notes;
    if (!frame.complaint().empty()) notes.push_back(frame.name() + ": " + frame.complaint());
    Result<FoldGraph> graph = foldGraphOf(frame, notes);
    if (!graph) {
      if (!error_) error_ = graph.error();
      return std::nullopt;
    }
    return Candidate{std::move(frame), std::move(graph).value(), std::move(notes)};
  }

  const JsonValue& document_;
  std::optional<Error> error_;
  int tries_ = 0;
};

bool isDrawablePoint(Vec2 p) { return isDrawable(p.x) && isDrawable(p.y); }

/// A huge form may roll out beyond what can be drawn: such lines are left out, and all faces.
void addEdges(FoldGraph& graph, PatternFile& file) {
  Tally beyond;
  file.drawing.lines.reserve(graph.edges.size());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const FoldGraphEdge& edge = graph.edges[i];
    const Vec2 from = flatten(graph.vertices[edge.from]);
    const Vec2 to = flatten(graph.vertices[edge.to]);
    if (isDrawablePoint(from) && isDrawablePoint(to)) {
      file.drawing.lines.push_back({from, to, edge.assignment, edge.angle});
    } else {
      beyond.add(i);
    }
  }
  beyond.tell(file.notes, "edge", "edges", "too far away to be drawn; left out, with all faces");
  if (beyond.count() > 0) graph.faces.clear();
}

void addFaces(const FoldGraph& graph, CreaseDrawing& drawing) {
  drawing.faces.reserve(graph.faces.size());
  for (const std::vector<std::uint32_t>& face : graph.faces) {
    std::vector<Vec2>& out = drawing.faces.emplace_back();
    out.reserve(face.size());
    for (const std::uint32_t v : face) out.push_back(flatten(graph.vertices[v]));
    if (doubledArea(graph, face) < 0) std::reverse(out.begin(), out.end());
  }
}

std::string frameText(const FoldFrameView& frame, const JsonValue& document, const char* ofFile,
                      const char* ofFrame) {
  const JsonValue* text = document.find(ofFile);
  if (text == nullptr || !text->is(Kind::String)) text = frame.find(ofFrame);
  return text != nullptr && text->is(Kind::String) ? text->text : "";
}

std::optional<double> unitOf(const FoldFrameView& frame, std::vector<std::string>& notes) {
  const JsonValue* size = frame.find(kMmPerUnitKey);
  if (size != nullptr && size->is(Kind::Number) && size->number > 0 && isDrawable(size->number)) {
    return size->number;
  }
  const JsonValue* unit = frame.find("frame_unit");
  if (unit == nullptr || (unit->is(Kind::String) && unit->text == "unit")) return std::nullopt;
  const std::optional<double> known = mmOfFoldUnit(unit->text);
  if (!known) notes.emplace_back("frame_unit is none that FOLD knows and was left out");
  return known;
}

bool startsWith(const std::string& text, std::string_view start) {
  return text.compare(0, start.size(), start) == 0;
}

bool isOurs(const std::string& name) {
  return name == "kiri:losses" || name == kMmPerUnitKey || name == "kiri:faceOrders" ||
         startsWith(name, "edges_kiri:") || startsWith(name, "faces_kiri:") ||
         startsWith(name, "vertices_kiri:");
}

/// Names of arrays that the specification has, beside those that are read: they follow from others.
bool isDerived(const std::string& name) {
  static const std::set<std::string> kNames = {
      "vertices_coords",  "vertices_vertices", "vertices_edges",   "vertices_faces",
      "edges_vertices",   "edges_faces",       "edges_assignment", "edges_foldAngle",
      "edges_foldAngles", "edges_length",      "edges_lengths",    "faces_vertices",
      "faces_edges",      "faces_faces",       "faceOrders",       "edgeOrders"};
  return kNames.count(name) > 0;
}

/// Keeps the keys of others, as JSON text, and tells which cannot be kept.
void keepUnknown(const JsonValue& document, const FoldFrameView& frame, PatternFile& file) {
  JsonValue kept = JsonValue::object();
  std::set<std::string> names;
  std::vector<std::string> lost;
  const auto visit = [&](const JsonValue& object) {
    for (const JsonMember& member : object.members) {
      const std::string& name = member.name;
      if (isDerived(name) || isOurs(name) || !names.insert(name).second) continue;
      if (startsWith(name, "vertices_") || startsWith(name, "edges_") ||
          startsWith(name, "faces_")) {
        lost.push_back(name);
        continue;
      }
      const bool isStandard = (startsWith(name, "file_") || startsWith(name, "frame_")) &&
                              name.find(':') == std::string::npos;
      if (!isStandard) kept.add(name, member.value);
    }
  };
  visit(document);
  if (frame.index() > 0) visit(frame.object());
  if (!kept.members.empty()) file.unknown = compactText(kept);
  if (lost.empty()) return;
  constexpr std::size_t kShown = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(lost.size(), kShown); ++i) {
    list += (i > 0 ? ", " : "") + lost[i];
  }
  if (lost.size() > kShown) list += " and " + std::to_string(lost.size() - kShown) + " more";
  file.notes.push_back(
      "arrays of others over vertices, edges or faces are not kept, for repairs "
      "change what they count: " +
      list);
}

void tellChoice(const JsonValue& document, const FoldFrameView& frame,
                std::vector<std::string>& notes) {
  const std::size_t count = frameCountOf(document);
  if (count == 1) return;
  notes.push_back(frame.name() + " of " + std::to_string(count) +
                  " is the crease pattern that was read; of the others only face orders are");
}

}  // namespace

Result<PatternFile> readFoldPattern(std::string_view text, std::string_view fileName) {
  const Result<JsonValue> document = parseJson(text, fileName);
  if (!document) return document.error();
  const std::string name(fileName);
  if (!document->is(Kind::Object)) {
    return Error{ErrorCode::BadFile,
                 name + ": a FOLD file is one JSON object { \"file_spec\": 1.2, ... }"};
  }
  Result<Candidate> found = PatternFinder(*document).find();
  if (!found) return Error{ErrorCode::BadFile, name + ": " + found.error().message};
  PatternFile file;
  file.format = PatternFormat::Fold;
  tellChoice(*document, found->frame, file.notes);
  file.notes.insert(file.notes.end(), found->notes.begin(), found->notes.end());
  if (!liesFlat(*found)) {
    Result<FoldGraph> rolled = unrolled(found->graph, file.notes);
    if (!rolled) {
      return Error{ErrorCode::BadFile,
                   name + ": " + found->frame.name() + " " + rolled.error().message};
    }
    found->graph = std::move(rolled).value();
  }
  addEdges(found->graph, file);
  if (file.drawing.lines.empty()) {
    return Error{ErrorCode::BadFile, name + ": no edge of the file can be drawn"};
  }
  addFaces(found->graph, file.drawing);
  file.title = frameText(found->frame, *document, "file_title", "frame_title");
  file.author = frameText(found->frame, *document, "file_author", "frame_author");
  file.description = frameText(found->frame, *document, "file_description", "frame_description");
  file.mmPerUnit = unitOf(found->frame, file.notes);
  addOrders(*document, found->frame, found->graph, file);
  keepUnknown(*document, found->frame, file);
  return file;
}

}  // namespace kiri
