// Reading DXF (docs/formats/dxf.md).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/tolerance.h"
#include "io/patterns/dxf_curves.h"
#include "io/patterns/dxf_entities.h"
#include "io/patterns/dxf_format.h"
#include "io/patterns/dxf_layers.h"
#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

double radiansOf(double degrees) { return degrees * std::numbers::pi / 180; }

/// How the inside of a block lies in the drawing.
struct Placing {
  Vec2 along = {1, 0};
  Vec2 across = {0, 1};
  Vec2 shift;

  Vec2 operator()(Vec2 p) const {
    // What is placed nowhere in particular keeps its bits.
    if (along == Vec2{1, 0} && across == Vec2{0, 1} && shift == Vec2{}) return p;
    return along * p.x + across * p.y + shift;
  }
  Placing after(const Placing& inner) const {
    return {along * inner.along.x + across * inner.along.y,
            along * inner.across.x + across * inner.across.y, (*this)(inner.shift)};
  }
  double stretch() const { return std::max(length(along), length(across)); }
};

/// Layer and colour of the INSERT that an entity stands in.
struct Surroundings {
  Placing placing;
  std::string_view layer = "0";
  int colour = 7;
  int depth = 0;
};

class DxfDrawer {
 public:
  DxfDrawer(const DxfFile& dxf, PatternFile& file) : dxf_(dxf), file_(file) {}

  void draw() {
    measure();
    drawAll(dxf_.entities, {});
  }

  /// A sentence when there was too much to draw; else empty.
  const std::string& complaint() const { return complaint_; }

  void tell() {
    std::vector<std::string>& notes = file_.notes;
    for (const auto& [type, count] : left_) {
      notes.push_back(std::to_string(count) + " " + type +
                      (count == 1 ? " entity was left out" : " entities were left out"));
    }
    if (curves_ > 0) {
      notes.push_back(std::to_string(curves_) +
                      (curves_ == 1 ? " curve became a polyline" : " curves became polylines"));
    }
    if (tilted_ > 0) {
      notes.push_back("heights (z) of " + std::to_string(tilted_) + " entities were left out");
    }
    if (coloured_ > 0) {
      notes.push_back(std::to_string(coloured_) +
                      " lines stand on layers whose names say nothing of creases; their colours "
                      "were taken (reds mountain, blues valley, greens, black and white border, "
                      "magenta unassigned, others auxiliary)");
    }
    freeBorders();
  }

 private:
  using Lines = std::vector<Vec2>;

  static constexpr std::size_t kMostLines = 1'000'000;
  static constexpr int kDeepest = 16;

  /// The size of what is drawn, to know how fine curves must be.
  void measure() {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto look = [&](const std::vector<DxfPair>& pairs) {
      for (const DxfPair& pair : pairs) {
        const bool isPlace =
            (pair.code >= 10 && pair.code <= 13) || (pair.code >= 20 && pair.code <= 23);
        if (!isPlace) continue;
        const double value = numberOf(pair.value).value_or(kLargestDrawn * 2);
        if (!isDrawable(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    };
    double radius = 0;
    const auto lookAt = [&](const DxfEntity& entity) {
      look(entity.pairs);
      for (const std::vector<DxfPair>& vertex : entity.vertices) look(vertex);
      if (entity.type == "ARC" || entity.type == "CIRCLE") {
        radius = std::max(radius, std::abs(entity.number(40)));
      }
    };
    for (const DxfEntity& entity : dxf_.entities) lookAt(entity);
    for (const auto& [name, block] : dxf_.blocks) {
      for (const DxfEntity& entity : block.entities) lookAt(entity);
    }
    const double size = std::max(high > low ? high - low : 0, radius);
    tolerance_ = Tolerance(size > 0 ? size : 1).flattening();
  }

  void drawAll(const std::vector<DxfEntity>& entities, const Surroundings& around) {
    for (const DxfEntity& entity : entities) {
      if (!complaint_.empty()) return;
      constexpr double kPaperSpace = 1;
      if (entity.number(67) == kPaperSpace) {
        ++left_["paper space"];
      } else {
        drawEntity(entity, around);
      }
    }
  }

  void drawEntity(const DxfEntity& entity, const Surroundings& around) {
    if (!countWork(entity)) return;
    if (entity.type == "INSERT") {
      insert(entity, around);
      return;
    }
    const double tolerance = tolerance_ / std::max(around.placing.stretch(), tolerance_);
    std::optional<Lines> points = pointsOf(entity, tolerance);
    if (!points) return;
    // Seen from below, as entities are that were drawn on the back of the plane.
    if (entity.type != "LINE" && entity.number(230, 1) < 0) {
      for (Vec2& p : *points) p.x = -p.x;
    }
    if (entity.number(30) != 0 || entity.number(38) != 0) ++tilted_;
    const Assignment assignment = assignmentOf(entity, around);
    for (std::size_t i = 0; i + 1 < points->size(); ++i) {
      addLine(around.placing((*points)[i]), around.placing((*points)[i + 1]), assignment);
    }
  }

  void addLine(Vec2 from, Vec2 to, Assignment assignment) {
    std::vector<DrawnCrease>& lines = file_.drawing.lines;
    if (!isDrawable(from.x) || !isDrawable(from.y) || !isDrawable(to.x) || !isDrawable(to.y)) {
      ++left_["oversized"];
    } else if (lines.size() >= kMostLines) {
      complaint_ = "more than " + std::to_string(kMostLines) +
                   " lines come of its entities and blocks; no crease pattern is that large";
    } else {
      lines.push_back({from, to, assignment, std::nullopt});
    }
  }

  /// The entity as points; none when it is left out, which is counted.
  std::optional<Lines> pointsOf(const DxfEntity& entity, double tolerance) {
    const Vec2 start{entity.number(10), entity.number(20)};
    if (entity.type == "LINE") return Lines{start, {entity.number(11), entity.number(21)}};
    Lines points;
    if (entity.type == "LWPOLYLINE" || entity.type == "POLYLINE") {
      points = polylineOf(entity, tolerance);
    } else if (entity.type == "ARC" || entity.type == "CIRCLE") {
      const bool isArc = entity.type == "ARC";
      const double radius = std::abs(entity.number(40));
      points =
          ellipsePoints(start, {radius, 0}, {0, radius}, isArc ? radiansOf(entity.number(50)) : 0,
                        isArc ? radiansOf(entity.number(51)) : 0, tolerance);
      if (!isArc) points.back() = points.front();
      ++curves_;
    } else if (entity.type == "ELLIPSE") {
      const Vec2 major{entity.number(11), entity.number(21)};
      points = ellipsePoints(start, major, perpendicular(major) * entity.number(40, 1),
                             entity.number(41), entity.number(42), tolerance);
      ++curves_;
    } else if (entity.type == "SPLINE") {
      points = splinePoints(entity, tolerance);
      if (!points.empty()) ++curves_;
    } else {
      ++left_[std::string(entity.type.substr(0, kShownType))];
      return std::nullopt;
    }
    if (points.size() >= 2) return points;
    ++left_["senseless " + std::string(entity.type)];
    return std::nullopt;
  }

  /// A field of bits; nonsense is 0.
  static int bitsOf(double number) {
    constexpr double kMostBits = 65535;
    return number >= 0 && number <= kMostBits ? static_cast<int>(number) : 0;
  }

  struct Corner {
    Vec2 place;
    double bulge = 0;
  };

  Lines polylineOf(const DxfEntity& entity, double tolerance) {
    std::vector<Corner> corners;
    constexpr int kMeshes = 16 + 64;
    const int flags = bitsOf(entity.number(70));
    if (entity.type == "POLYLINE" && (flags & kMeshes) != 0) return {};
    if (entity.type == "POLYLINE") {
      for (const std::vector<DxfPair>& vertex : entity.vertices) {
        constexpr int kSplineFrame = 16;
        if ((bitsOf(dxfNumber(vertex, 70)) & kSplineFrame) != 0) continue;
        corners.push_back({{dxfNumber(vertex, 10), dxfNumber(vertex, 20)}, dxfNumber(vertex, 42)});
      }
    } else {
      for (const DxfPair& pair : entity.pairs) {
        const double value = numberOf(pair.value).value_or(0);
        if (!isDrawable(value)) continue;
        if (pair.code == 10) corners.push_back({{value, 0}, 0});
        if (pair.code == 20 && !corners.empty()) corners.back().place.y = value;
        if (pair.code == 42 && !corners.empty()) corners.back().bulge = value;
      }
    }
    if (corners.empty()) return {};
    const bool isClosed = (flags & 1) != 0;
    if (isClosed) corners.push_back(corners.front());
    Lines out = {corners.front().place};
    bool isCurved = false;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const Lines part =
          bulgePoints(corners[i].place, corners[i + 1].place, corners[i].bulge, tolerance);
      isCurved = isCurved || part.size() > 2;
      out.insert(out.end(), part.begin() + 1, part.end());
    }
    if (isCurved) ++curves_;
    return out;
  }

  void insert(const DxfEntity& entity, const Surroundings& around) {
    const auto block = dxf_.blocks.find(entity.text(2));
    if (block == dxf_.blocks.end() || around.depth >= kDeepest) {
      ++left_[block == dxf_.blocks.end() ? "INSERT of an unknown block" : "too deep INSERT"];
      return;
    }
    const double turn = radiansOf(entity.number(50));
    const Vec2 along = Vec2{std::cos(turn), std::sin(turn)};
    const Vec2 base{block->second.head.number(10), block->second.head.number(20)};
    constexpr double kMostCopies = 1000;
    const double columns = std::clamp(std::floor(entity.number(70, 1)), 1.0, kMostCopies);
    const double rows = std::clamp(std::floor(entity.number(71, 1)), 1.0, kMostCopies);
    Surroundings inside = around;
    ++inside.depth;
    inside.layer = layerOf(entity, around);
    inside.colour = colourOf(entity, around);
    for (double row = 0; row < rows; ++row) {
      for (double column = 0; column < columns; ++column) {
        if (!complaint_.empty() || !countInsert()) return;
        const Vec2 place = Vec2{entity.number(10), entity.number(20)} +
                           along * (column * entity.number(44)) +
                           perpendicular(along) * (row * entity.number(45));
        Placing own{along * entity.number(41, 1), perpendicular(along) * entity.number(42, 1), {}};
        if (turn == 0) own = {{entity.number(41, 1), 0}, {0, entity.number(42, 1)}, {}};
        own.shift = place - own.along * base.x - own.across * base.y;
        inside.placing = around.placing.after(own);
        drawAll(block->second.entities, inside);
      }
    }
  }

  /// Blocks in blocks may be many, and work without making any line.
  bool countInsert() {
    constexpr std::size_t kMostInserts = 200'000;
    if (++inserts_ <= kMostInserts) return true;
    complaint_ = "its blocks are inserted more than " + std::to_string(kMostInserts) +
                 " times; no crease pattern needs that";
    return false;
  }

  bool countWork(const DxfEntity& entity) {
    constexpr std::size_t kSplineWork = 300;
    constexpr std::size_t kMostWork = 30'000'000;
    const std::size_t size = 1 + entity.pairs.size() + entity.vertices.size();
    work_ += entity.type == "SPLINE" ? kSplineWork * size : size;
    if (work_ <= kMostWork) return true;
    complaint_ = "its blocks and curves are too much to draw; no crease pattern needs that";
    return false;
  }

  static std::string_view layerOf(const DxfEntity& entity, const Surroundings& around) {
    const std::string_view layer = entity.text(8);
    return layer.empty() || layer == "0" ? around.layer : layer;
  }

  int colourOf(const DxfEntity& entity, const Surroundings& around) const {
    constexpr double kByLayer = 256;
    constexpr double kTrue = 420;
    constexpr double kLargestTrue = 0xFFFFFF;
    const double trueColour = entity.number(static_cast<int>(kTrue), -1);
    if (trueColour >= 0 && trueColour <= kLargestTrue) {
      return indexOfTrueColour(static_cast<unsigned>(trueColour));
    }
    const double colour = entity.number(62, kByLayer);
    if (colour == 0) return around.colour;
    if (colour > 0 && colour < kByLayer) return static_cast<int>(colour);
    const auto known = dxf_.layerColours.find(layerOf(entity, around));
    return known == dxf_.layerColours.end() ? 7 : known->second;
  }

  Assignment assignmentOf(const DxfEntity& entity, const Surroundings& around) {
    if (const auto byName = assignmentOfLayer(layerOf(entity, around))) return *byName;
    ++coloured_;
    return assignmentOfColour(colourOf(entity, around));
  }

  /// A drawing all of one kind says nothing of borders: they are found as the outline then.
  void freeBorders() {
    std::vector<DrawnCrease>& lines = file_.drawing.lines;
    const bool isAllBorder = std::all_of(lines.begin(), lines.end(), [](const DrawnCrease& line) {
      return line.assignment == Assignment::Border;
    });
    if (!isAllBorder || coloured_ == 0) return;
    for (DrawnCrease& line : lines) line.assignment = Assignment::Unassigned;
    file_.notes.emplace_back(
        "neither layers nor colours tell creases from borders; all lines were taken as "
        "unassigned, the border will be the outline");
  }

  static constexpr std::size_t kShownType = 40;

  const DxfFile& dxf_;
  PatternFile& file_;
  double tolerance_ = 0;
  std::map<std::string, std::size_t> left_;
  std::size_t curves_ = 0;
  std::size_t tilted_ = 0;
  std::size_t coloured_ = 0;
  std::size_t inserts_ = 0;
  std::size_t work_ = 0;
  std::string complaint_;
};

}  // namespace

Result<PatternFile> readDxfPattern(std::string_view text, std::string_view fileName) {
  const Result<DxfFile> dxf = parseDxf(text, fileName);
  if (!dxf) return dxf.error();
  PatternFile file;
  file.format = PatternFormat::Dxf;
  file.mmPerUnit = dxf->mmPerUnit;
  file.notes = dxf->notes;
  DxfDrawer drawer(*dxf, file);
  drawer.draw();
  const std::string name(fileName);
  if (!drawer.complaint().empty()) {
    return Error{ErrorCode::BadFile, name + ": " + drawer.complaint()};
  }
  drawer.tell();
  if (file.drawing.lines.empty()) {
    std::string sentence =
        name + ": the file holds no line, polyline or arc that could be a crease";
    if (!file.notes.empty()) sentence += " (" + file.notes.back() + ")";
    return Error{ErrorCode::BadFile, sentence};
  }
  return file;
}

}  // namespace kiri
