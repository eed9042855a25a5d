// Sparse least squares on the loops: a few rows for each loop, one column for each free hinge.
// SPDX-License-Identifier: MIT
#include "core/linkage/closure.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

constexpr int kMostRounds = 25;       // of Newton's method
constexpr int kPatience = 6;          // rounds that must bring the angles nearer to a solution
constexpr int kNearestRounds = 5;     // in which the nearest solution is sought
constexpr int kRefinements = 3;       // of each damped least-squares solution
constexpr double kLongestStep = 0.5;  // radians in one round: beyond, the equations are another's
constexpr double kDegree = 180 / std::numbers::pi;

/// Six numbers that vanish when the loop closes: half the antisymmetric part of the rotation, and
/// the shift of the centre as part of the sheet.
using Rows = std::array<double, 6>;

Rows missOf(const Rigid& turn, double size) {
  return {(turn.y.z - turn.z.y) / 2, (turn.z.x - turn.x.z) / 2, (turn.x.y - turn.y.x) / 2,
          turn.origin.x / size,      turn.origin.y / size,      turn.origin.z / size};
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double errorOf(const HingeLoop& loop, const Rigid& turn, double size) {
  const double rotation =
      std::max({largest(turn.x - Vec3{1, 0, 0}), largest(turn.y - Vec3{0, 1, 0}),
                largest(turn.z - Vec3{0, 0, 1})});
  return loop.isVertex ? rotation : std::max(rotation, largest(turn.origin) / size);
}

/// Calls visit(hinge, rate) for every crossing: how a turn of the hinge, by one radian a unit of
/// time, turns and shifts what comes behind it.
template <class Visit>
void visitRates(const HingeLoop& loop, const FoldAngles& angles, double size, Visit visit) {
  Rigid before;
  for (const Crossing& c : loop.crossings) {
    const Vec3 axis = before.direction(c.direction) * c.sign;
    const Vec3 shift = cross(axis, -before.apply(c.point)) / size;
    visit(c.hinge, Rows{axis.x, axis.y, axis.z, shift.x, shift.y, shift.z});
    before = compose(before, turnOf(c, angles));
  }
}

int rowsOf(const HingeLoop& loop) { return loop.isVertex ? 3 : 6; }

}  // namespace

/// The equations linearised at some angles.
struct Closure::Solver {
  Eigen::SparseMatrix<double> rates;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> normal;

  /// `scale`: factor of each column, or empty.
  Solver(const Closure& closure, const FoldAngles& angles, const std::vector<double>& scale) {
    int row = 0;
    std::vector<Eigen::Triplet<double>> entries;
    for (const HingeLoop& loop : closure.loops_) {
      visitRates(loop, angles, closure.size_, [&](EdgeId hinge, const Rows& rate) {
        const int column = closure.column_[hinge.index];
        if (column < 0) return;
        const double factor = scale.empty() ? 1 : scale[static_cast<std::size_t>(column)];
        for (int i = 0; i < rowsOf(loop); ++i)
          entries.emplace_back(row + i, column, factor * rate[static_cast<std::size_t>(i)]);
      });
      row += rowsOf(loop);
    }
    const int columns = static_cast<int>(closure.free_.size());
    rates.resize(row, columns);
    rates.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> matrix = rates * rates.transpose();
    Eigen::SparseMatrix<double> damping(row, row);
    damping.setIdentity();
    matrix += kLoopDamping * damping;
    normal.compute(matrix);
  }

  Eigen::VectorXd missing(const Closure& closure, const FoldAngles& angles) const;

  /// The shortest x for which rates * x is nearest to `wanted`: a sum of rows of `rates`, so that
  /// no rounding gets into what the loops leave free.
  Eigen::VectorXd leastSquares(const Eigen::VectorXd& wanted) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(rates.cols());
    for (int i = 0; i < kRefinements; ++i)
      x += rates.transpose() * normal.solve(wanted - rates * x);
    return x;
  }
};

Closure::Closure(const CreasePattern& pattern, const std::vector<EdgeId>& changing,
                 const std::vector<EdgeId>& free)
    : size_(pattern.tolerance.sheetSize()),
      isChanging_(pattern.edges.size(), false),
      column_(pattern.edges.size(), -1),
      free_(free) {
  for (const EdgeId e : changing) isChanging_[e.index] = true;
  for (std::size_t i = 0; i < free.size(); ++i) column_[free[i].index] = static_cast<int>(i);
  for (HingeLoop& loop : loopsOf(pattern)) {
    const bool changes = std::any_of(loop.crossings.begin(), loop.crossings.end(),
                                     [&](const Crossing& c) { return isChanging_[c.hinge.index]; });
    if (changes) loops_.push_back(std::move(loop));
  }
}

double Closure::error(const FoldAngles& angles) const {
  double worst = 0;
  for (const HingeLoop& loop : loops_)
    worst = std::max(worst, errorOf(loop, turnOf(loop, angles), size_));
  return worst;
}

bool Closure::close(FoldAngles& angles) const { return solve(angles, nullptr); }

bool Closure::closeKeepingSigns(FoldAngles& angles, const FoldAngles& origin) const {
  return solve(angles, &origin);
}

bool Closure::solve(FoldAngles& angles, const FoldAngles* origin) const {
  const FoldAngles guess = angles;
  FoldAngles best = angles;
  double least = HUGE_VAL;
  double beforehand = HUGE_VAL;
  for (int round = 0; round < kMostRounds; ++round) {
    const double now = error(angles);
    // Rounding alone is left when what was closed gets no better.
    const bool isDone = now == 0 || free_.empty() || (least <= kClosedLoop && now > least / 2);
    if (now < least) {
      least = now;
      best = angles;
    }
    if (isDone) break;
    // What does not come nearer in several rounds has no solution near by.
    if (round % kPatience == 0) {
      if (least > beforehand / 4) break;
      beforehand = least;
    }
    const bool goesOn = origin ? multiply(angles, *origin) : shift(angles, guess, round);
    if (!goesOn) break;
  }
  angles = best;
  return least <= kClosedLoop;
}

/// What the loops miss, negative, to be made up for.
Eigen::VectorXd Closure::Solver::missing(const Closure& closure, const FoldAngles& angles) const {
  Eigen::VectorXd miss(rates.rows());
  int row = 0;
  for (const HingeLoop& loop : closure.loops_) {
    const Rows m = missOf(turnOf(loop, angles), closure.size_);
    for (int i = 0; i < rowsOf(loop); ++i) miss[row++] = -m[static_cast<std::size_t>(i)];
  }
  return miss;
}

bool Closure::shift(FoldAngles& angles, const FoldAngles& guess, int round) const {
  const Solver solver(*this, angles, {});
  Eigen::VectorXd wanted = solver.missing(*this, angles);
  // In the first rounds, back to the guess along what the loops leave free: so the nearest solution
  // is found, not the one that the order of the rounds leads to.
  Eigen::VectorXd back = Eigen::VectorXd::Zero(solver.rates.cols());
  if (round < kNearestRounds) {
    for (std::size_t i = 0; i < free_.size(); ++i)
      back[static_cast<Eigen::Index>(i)] =
          (guess[free_[i].index] - angles[free_[i].index]) / kDegree;
    wanted -= solver.rates * back;
  }
  const Eigen::VectorXd step = back + solver.leastSquares(wanted);
  const double most = step.cwiseAbs().maxCoeff();
  if (!std::isfinite(most)) return false;
  const double part = most > kLongestStep ? kLongestStep / most : 1;
  for (std::size_t i = 0; i < free_.size(); ++i)
    angles[free_[i].index] += kDegree * part * step[static_cast<Eigen::Index>(i)];
  return true;
}

bool Closure::multiply(FoldAngles& angles, const FoldAngles& origin) const {
  std::vector<double> scale;
  double unit = 0;
  for (const EdgeId e : free_) {
    scale.push_back(angles[e.index] - origin[e.index]);
    unit = std::max(unit, std::abs(scale.back()));
  }
  if (unit == 0) return false;
  for (double& s : scale) s /= unit;
  const Solver solver(*this, angles, scale);
  const Eigen::VectorXd step =
      solver.leastSquares(solver.missing(*this, angles)) * (kDegree / unit);
  const double most = step.cwiseAbs().maxCoeff();
  if (!std::isfinite(most)) return false;
  const double part = most > 1 ? 1 / most : 1;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double start = origin[free_[i].index];
    double& angle = angles[free_[i].index];
    angle = start + (angle - start) * std::exp(part * step[static_cast<Eigen::Index>(i)]);
  }
  return true;
}

void Closure::project(const FoldAngles& angles, FoldAngles& rates) const {
  if (loops_.empty() || free_.empty()) return;
  const Solver solver(*this, angles, {});
  Eigen::VectorXd miss = Eigen::VectorXd::Zero(solver.rates.rows());
  int row = 0;
  for (const HingeLoop& loop : loops_) {
    visitRates(loop, angles, size_, [&](EdgeId hinge, const Rows& rate) {
      for (int i = 0; i < rowsOf(loop); ++i)
        miss[row + i] -= rate[static_cast<std::size_t>(i)] * rates[hinge.index];
    });
    row += rowsOf(loop);
  }
  const Eigen::VectorXd step = solver.leastSquares(miss);
  for (std::size_t i = 0; i < free_.size(); ++i)
    rates[free_[i].index] += step[static_cast<Eigen::Index>(i)];
}

std::vector<EdgeId> Closure::worstLoop(const FoldAngles& angles) const {
  const HingeLoop* worst = nullptr;
  double most = -1;
  for (const HingeLoop& loop : loops_) {
    const double miss = errorOf(loop, turnOf(loop, angles), size_);
    if (miss <= most) continue;
    most = miss;
    worst = &loop;
  }
  std::vector<EdgeId> hinges;
  if (!worst) return hinges;
  for (const Crossing& c : worst->crossings) {
    if (isChanging_[c.hinge.index]) hinges.push_back(c.hinge);
  }
  std::sort(hinges.begin(), hinges.end());
  hinges.erase(std::unique(hinges.begin(), hinges.end()), hinges.end());
  return hinges;
}

}  // namespace kiri
