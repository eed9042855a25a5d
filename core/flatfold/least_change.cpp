// Gauss-Newton: each step is the shortest that meets all equations to first order, from the normal
// equations of the rows, damped where equations repeat each other.
// SPDX-License-Identifier: MIT
#include "core/flatfold/least_change.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

using RowMatrix = Eigen::SparseMatrix<double>;

/// Steps after which what has not closed does not close: each squares the miss where it works.
constexpr int kMostSteps = 60;
/// A step that keeps more of the miss than this is at the end of what doubles give.
constexpr double kGain = 0.7;
/// Steps in a row without gain after which no more are tried.
constexpr int kMostIdle = 4;

/// The columns of the equations: one for each direction of each vertex.
class Columns {
 public:
  explicit Columns(const std::vector<VertexFreedom>& freedoms) : freedoms_(freedoms) {
    for (const VertexFreedom& freedom : freedoms) {
      first_.push_back(count_);
      count_ += freedom.directions;
    }
  }
  int count() const { return count_; }

  void add(std::vector<Eigen::Triplet<double>>& entries, int row, VertexId v, Vec2 slope) const {
    const VertexFreedom& freedom = freedoms_[v.index];
    if (freedom.directions > 0)
      entries.emplace_back(row, first_[v.index], dot(slope, freedom.along));
    if (freedom.directions > 1)
      entries.emplace_back(row, first_[v.index] + 1, dot(slope, perpendicular(freedom.along)));
  }
  Vec2 moveOf(std::size_t vertex, const Eigen::VectorXd& x) const {
    const VertexFreedom& freedom = freedoms_[vertex];
    Vec2 move;
    if (freedom.directions > 0) move = freedom.along * x[first_[vertex]];
    if (freedom.directions > 1) move = move + perpendicular(freedom.along) * x[first_[vertex] + 1];
    return move;
  }

 private:
  const std::vector<VertexFreedom>& freedoms_;
  std::vector<int> first_;
  int count_ = 0;
};

/// Rows divided by the lengths of their slopes, so that a miss is a way to go.
struct ScaledRows {
  RowMatrix slopes;
  Eigen::VectorXd misses;

  double worst() const { return misses.size() == 0 ? 0 : misses.lpNorm<Eigen::Infinity>(); }
};

ScaledRows scaledRows(const std::vector<ClosingRow>& rows, const Columns& columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [vertex, slope] : rows[i].slopes)
      columns.add(entries, static_cast<int>(i), vertex, slope);
  }
  ScaledRows scaled;
  const int count = static_cast<int>(rows.size());
  scaled.slopes.resize(count, columns.count());
  scaled.slopes.setFromTriplets(entries.begin(), entries.end());
  scaled.misses.resize(count);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(count);
  for (int c = 0; c < scaled.slopes.outerSize(); ++c) {
    for (RowMatrix::InnerIterator it(scaled.slopes, c); it; ++it)
      squares[it.row()] += it.value() * it.value();
  }
  // Rows that nothing can change stay out of the steps.
  const Eigen::VectorXd scale =
      squares.unaryExpr([](double s) { return s > kVanishing ? 1 / std::sqrt(s) : 0.0; });
  scaled.slopes = scale.asDiagonal() * scaled.slopes;
  for (int i = 0; i < count; ++i)
    scaled.misses[i] = rows[static_cast<std::size_t>(i)].miss * scale[i];
  return scaled;
}

class NormalEquations {
 public:
  /// The shortest move that takes the misses away to first order.
  Eigen::VectorXd solve(const ScaledRows& rows, double damping) {
    RowMatrix normal = rows.slopes * RowMatrix(rows.slopes.transpose());
    RowMatrix identity(normal.rows(), normal.cols());
    identity.setIdentity();
    normal += damping * identity;
    if (!isAnalyzed_) solver_.analyzePattern(normal);
    isAnalyzed_ = true;
    solver_.factorize(normal);
    Eigen::VectorXd weights = solver_.solve(-rows.misses);
    // Damping shortens the step; twice refined, what it takes away is below rounding.
    for (int i = 0; i < 2; ++i) {
      const Eigen::VectorXd rest = -rows.misses - rows.slopes * (rows.slopes.transpose() * weights);
      weights += solver_.solve(rest);
    }
    return rows.slopes.transpose() * weights;
  }

 private:
  Eigen::SimplicialLDLT<RowMatrix> solver_;
  bool isAnalyzed_ = false;
};

std::vector<Vec2> moved(const std::vector<Vec2>& places, const Columns& columns,
                        const Eigen::VectorXd& step, double part) {
  std::vector<Vec2> result = places;
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = result[v] + columns.moveOf(v, step) * part;
  return result;
}

double longestMove(const Columns& columns, const Eigen::VectorXd& step, std::size_t vertices) {
  double longest = 0;
  for (std::size_t v = 0; v < vertices; ++v)
    longest = std::max(longest, length(columns.moveOf(v, step)));
  return longest;
}

}  // namespace

Result<std::vector<Vec2>> leastChange(std::vector<Vec2> places,
                                      const std::vector<VertexFreedom>& freedoms,
                                      const RowsAt& rowsAt, double farthestMove,
                                      const Progress& progress) {
  const Columns columns(freedoms);
  NormalEquations equations;
  ScaledRows rows = scaledRows(rowsAt(places), columns);
  if (columns.count() == 0 || rows.misses.size() == 0) return places;
  double damping = kLoopDamping;
  int idle = 0;
  for (int step = 0; step < kMostSteps && idle < kMostIdle && rows.worst() > 0; ++step) {
    if (!goesOn(progress, static_cast<double>(step) / kMostSteps))
      return Error{ErrorCode::Cancelled, "polishing the crease pattern was stopped"};
    const Eigen::VectorXd move = equations.solve(rows, damping);
    const double longest = longestMove(columns, move, places.size());
    if (!std::isfinite(longest)) break;
    const double part = longest > farthestMove ? farthestMove / longest : 1;
    std::vector<Vec2> next = moved(places, columns, move, part);
    ScaledRows nextRows = scaledRows(rowsAt(next), columns);
    const double before = rows.misses.norm();
    const double now = nextRows.misses.norm();
    idle = now < kGain * before ? 0 : idle + 1;
    if (!(now < before)) {
      damping *= 100;
      continue;
    }
    damping = std::max(damping / 10, kLoopDamping);
    places = std::move(next);
    rows = std::move(nextRows);
  }
  return places;
}

}  // namespace kiri
