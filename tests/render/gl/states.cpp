// States to draw: random ones and those of the examples; pictures kept when a test fails.
// SPDX-License-Identifier: MIT
#include "tests/render/gl/states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "core/model/replay.h"
#include "io/file.h"
#include "render/canvas/png.h"
#include "tests/support/example_files.h"
#include "tests/support/model_text.h"

namespace kiri::test {

FoldedState randomFolded(Random& random) {
  FoldedState state = startOf(randomSheet(random));
  for (int i = 0; i < 10; ++i) {
    const Step step = randomStep(random, state, {});
    if (Result<FoldedState> next = tryAfter(state, textOf(step))) state = std::move(*next);
  }
  for (int i = 0; i < 3 && !state.lines.empty(); ++i) {
    const std::string& name = state.lines[random.below(state.lines.size())].name;
    const std::string angle = std::to_string(random.between(-175, 175));
    if (Result<FoldedState> next = tryAfter(state, "angle " + name + " " + angle))
      state = std::move(*next);
  }
  return state;
}

std::vector<Example> allExamples() {
  std::vector<Example> out;
  for (const std::filesystem::path& file : exampleFilesThatTakeLong()) {
    const Model model = modelInFile(file);
    const Replay steps = *replay(model);
    const std::size_t count = model.steps.size();
    Example& example = out.emplace_back();
    example.name = file.stem().string();
    for (const std::size_t done : {count / 2, count}) example.states.push_back(**steps.after(done));
  }
  return out;
}

namespace {

/// The corners of Miura's folds as numbers of vertices, on the sheet and in space.
class MiuraGrid {
 public:
  explicit MiuraGrid(std::size_t n) : n_(n), side_(200.0 / static_cast<double>(n)) {}

  VertexId vertex(std::size_t i, std::size_t j) const { return VertexId(j * (n_ + 1) + i); }
  FacetId facet(std::size_t i, std::size_t j) const { return FacetId(j * n_ + i); }
  Vec2 onSheet(std::size_t i, std::size_t j) const {
    // A parallelogram with sides 1 and sqrt(0.9), at an angle with cosine 0.24 / sqrt(0.9).
    const double aside = j % 2 == 1 ? 0.24 : 0;
    return Vec2{static_cast<double>(i) + aside, std::sqrt(0.9 - 0.24 * 0.24) * asDouble(j)} * side_;
  }
  Vec3 inSpace(std::size_t i, std::size_t j) const {
    return Vec3{0.8 * asDouble(i) + (j % 2 == 1 ? 0.3 : 0), 0.9 * asDouble(j),
                i % 2 == 1 ? 0.6 : 0} *
           side_;
  }
  Rigid pose(std::size_t i, std::size_t j) const {
    const Vec3 along = normalized(inSpace(i + 1, j) - inSpace(i, j));
    Rigid pose;
    pose.x = along;
    pose.z = normalized(cross(along, inSpace(i, j + 1) - inSpace(i, j)));
    pose.y = cross(pose.z, pose.x);
    const Vec2 start = onSheet(i, j);
    pose.origin = inSpace(i, j) - pose.x * start.x - pose.y * start.y;
    return pose;
  }

 private:
  static double asDouble(std::size_t i) { return static_cast<double>(i); }

  std::size_t n_;
  double side_;
};

/// The angle of a hinge between two facets whose poses are known.
double angleBetween(const Rigid& left, const Rigid& right, Vec3 insideRight) {
  const double turn = angleDegrees(dot(left.z, right.z), length(cross(left.z, right.z)));
  return dot(left.z, insideRight - left.origin) > 0 ? turn : -turn;
}

}  // namespace

FoldedState miura(std::size_t n) {
  const MiuraGrid grid(n);
  FoldedState state(CreasePattern(Tolerance(200 * std::sqrt(2.0))));
  CreasePattern& pattern = state.pattern;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) pattern.vertices.push_back(grid.onSheet(i, j));
  }
  pattern.facets.resize(n * n);
  std::vector<LayerSet> sets;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      state.poses.push_back(grid.pose(i, j));
      sets.push_back({state.poses.back().normal(), {grid.facet(i, j)}, {}});
    }
  }
  const auto addEdge = [&](VertexId from, VertexId to, FacetId left, FacetId right) {
    Edge edge;
    edge.from = from;
    edge.to = to;
    edge.left = left;
    edge.right = right;
    if (left.isValid() && right.isValid()) {
      edge.kind = EdgeKind::Hinge;
      const Rigid& pose = state.poses[right.index];
      const Vec2 inside = grid.onSheet(right.index % n, right.index / n) +
                          grid.onSheet(right.index % n + 1, right.index / n + 1);
      edge.angle = angleBetween(state.poses[left.index], pose, pose.apply(inside / 2));
    }
    pattern.edges.push_back(edge);
    return EdgeId(pattern.edges.size() - 1);
  };
  const FacetId none;
  std::vector<EdgeId> rows((n + 1) * n);
  std::vector<EdgeId> columns((n + 1) * n);
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      rows[j * n + i] =
          addEdge(grid.vertex(i, j), grid.vertex(i + 1, j), j < n ? grid.facet(i, j) : none,
                  j > 0 ? grid.facet(i, j - 1) : none);
      columns[j * n + i] =
          addEdge(grid.vertex(j, i), grid.vertex(j, i + 1), j > 0 ? grid.facet(j - 1, i) : none,
                  j < n ? grid.facet(j, i) : none);
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      pattern[grid.facet(i, j)].border = {{rows[j * n + i], false},
                                          {columns[(i + 1) * n + j], false},
                                          {rows[(j + 1) * n + i], true},
                                          {columns[i * n + j], true}};
    }
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

void keepPicture(const Image& image, const std::string& name) {
  const char* folder = std::getenv("KIRI_FAILED_PICTURES");
  if (folder == nullptr) return;
  const std::string path = std::string(folder) + "/" + name + ".png";
  EXPECT_TRUE(writeFile(path, *encodePng(image, 0))) << path;
}

}  // namespace kiri::test
