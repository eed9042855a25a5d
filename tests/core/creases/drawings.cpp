// SPDX-License-Identifier: MIT
#include "tests/core/creases/drawings.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "io/patterns/pattern_file.h"

namespace kiri::test {
namespace {

std::string patternFolder() { return std::string(KIRI_SOURCE_DIR) + "/../shared/data/patterns/"; }

std::size_t countIn(const std::string& text) { return text.empty() ? 0 : std::stoul(text); }

Assignment assignmentOf(const std::string& letter) {
  static const std::map<std::string, Assignment> letters{
      {"B", Assignment::Border}, {"M", Assignment::Mountain},   {"V", Assignment::Valley},
      {"F", Assignment::Flat},   {"U", Assignment::Unassigned}, {"C", Assignment::Cut},
      {"J", Assignment::Join}};
  const auto it = letters.find(letter);
  return it == letters.end() ? Assignment::Unassigned : it->second;
}

/// Groups of edges that hang together, and vertices in use.
struct Groups {
  std::size_t groups = 0;
  std::size_t vertices = 0;
};

Groups groupsIn(const CreasePattern& pattern) {
  std::vector<std::uint32_t> parent(pattern.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v];
    return v;
  };
  std::set<std::uint32_t> used;
  for (const Edge& edge : pattern.edges) {
    parent[root(edge.from.index)] = root(edge.to.index);
    used.insert(edge.from.index);
    used.insert(edge.to.index);
  }
  std::set<std::uint32_t> roots;
  for (const std::uint32_t v : used) roots.insert(root(v));
  return {roots.size(), used.size()};
}

char letterOf(Assignment assignment) {
  return std::string("BMVFUCJ").at(static_cast<std::size_t>(assignment));
}

Vec2 placeOf(const std::string& word) {
  const std::size_t comma = word.find(',');
  return {std::stod(word.substr(0, comma)), std::stod(word.substr(comma + 1))};
}

}  // namespace

CreaseDrawing drawn(const std::string& text) {
  CreaseDrawing drawing;
  std::stringstream statements(text);
  for (std::string statement; std::getline(statements, statement, ';');) {
    std::stringstream words(statement);
    std::string kind;
    if (!(words >> kind)) continue;
    std::vector<Vec2> places;
    std::optional<double> angle;
    for (std::string word; words >> word;) {
      if (word.find(',') == std::string::npos) {
        angle = std::stod(word);
      } else {
        places.push_back(placeOf(word));
      }
    }
    if (kind == "face") {
      drawing.faces.push_back(places);
      continue;
    }
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      drawing.lines.push_back({places[i], places[i + 1], assignmentOf(kind), angle});
  }
  return drawing;
}

std::vector<std::string> linesOf(const AssignedPattern& creases, double step) {
  std::vector<std::string> lines;
  const auto number = [&](double x) { return std::to_string(std::lround(x / step)); };
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    const Edge& edge = creases.pattern.edges[e];
    std::string from, to;
    for (std::string* end : {&from, &to}) {
      const Vec2 p = creases.pattern[end == &from ? edge.from : edge.to];
      *end = number(p.x) + "," + number(p.y);
    }
    if (to < from) std::swap(from, to);
    lines.push_back(from + " " + to + " " + letterOf(creases.assignments[e]) + " " +
                    std::to_string(std::lround(edge.angle)));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<KnownPattern> knownPatterns() {
  std::vector<KnownPattern> result;
  std::ifstream in(patternFolder() + "conformance.csv");
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (cells.size() < 11) continue;
    KnownPattern known{cells[0], countIn(cells[1]), countIn(cells[2]), countIn(cells[3]),
                       -1,       cells[10] == "yes"};
    if (!cells[5].empty()) known.badVertices = std::stoi(cells[5]);
    result.push_back(known);
  }
  return result;
}

std::optional<CreaseDrawing> knownDrawing(const std::string& file) {
  std::ifstream in(patternFolder() + file);
  std::stringstream text;
  text << in.rdbuf();
  const Result<PatternFile> read = readPattern(text.str(), file);
  if (!read) return std::nullopt;
  return read->drawing;
}

std::vector<std::string> mapViolations(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  std::vector<std::string> wrong;
  std::vector<int> uses(2 * pattern.edges.size(), 0);
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) {
    const Facet& facet = pattern.facets[f];
    double twice = 0;
    for (std::size_t i = 0; i < facet.border.size(); ++i) {
      const EdgeUse use = facet.border[i];
      ++uses[2 * use.edge.index + (use.isReversed ? 1 : 0)];
      const Edge& edge = pattern[use.edge];
      if ((use.isReversed ? edge.right : edge.left) != FacetId(f))
        wrong.push_back("facet " + std::to_string(f) + " is not beside its edge");
      twice += cross(pattern[startOf(pattern, use)], pattern[endOf(pattern, use)]);
    }
    for (std::size_t loop = 0; loop <= facet.holeStarts.size(); ++loop) {
      const std::size_t begin = loop == 0 ? 0 : facet.holeStarts[loop - 1];
      const std::size_t end =
          loop < facet.holeStarts.size() ? facet.holeStarts[loop] : facet.border.size();
      for (std::size_t i = begin; i < end; ++i) {
        const EdgeUse next = facet.border[i + 1 < end ? i + 1 : begin];
        if (endOf(pattern, facet.border[i]) != startOf(pattern, next))
          wrong.push_back("the border of facet " + std::to_string(f) + " is open");
      }
    }
    if (!(twice > 0)) wrong.push_back("facet " + std::to_string(f) + " has no area");
  }
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    const bool isLeft = edge.left.isValid();
    const bool isRight = edge.right.isValid();
    const std::string name = "edge " + std::to_string(e);
    if (uses[2 * e] != (isLeft ? 1 : 0) || uses[2 * e + 1] != (isRight ? 1 : 0))
      wrong.push_back(name + " is not used once on each side with paper");
    if (edge.kind == EdgeKind::Border && isLeft == isRight)
      wrong.push_back(name + " is a border without paper on one side");
    if (edge.kind != EdgeKind::Border && !(isLeft && isRight))
      wrong.push_back(name + " has no paper on one side");
    if (edge.kind == EdgeKind::Hinge && edge.left == edge.right)
      wrong.push_back(name + " is a hinge with one facet");
  }
  const Groups groups = groupsIn(pattern);
  if (groups.vertices != pattern.vertices.size()) wrong.emplace_back("a vertex is not used");
  return wrong;
}

}  // namespace kiri::test
