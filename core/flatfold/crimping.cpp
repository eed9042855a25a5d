// Choices of different creases are free of each other, so a crease that is left of a run is a set
// of possible folds again, and no choice has to be tried. SPDX-License-Identifier: MIT
#include "core/flatfold/crimping.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// Turns the circle so that the run begins at sector 1.
void turnTo(std::size_t first, std::vector<double>& sectors, std::vector<Fold>& folds) {
  const auto by = static_cast<std::ptrdiff_t>((first + sectors.size() - 1) % sectors.size());
  std::rotate(sectors.begin(), sectors.begin() + by, sectors.end());
  std::rotate(folds.begin(), folds.begin() + by, folds.end());
}

SmallRun smallestOf(const std::vector<SmallRun>& runs, const std::vector<double>& sectors) {
  return *std::min_element(runs.begin(), runs.end(), [&](const SmallRun& a, const SmallRun& b) {
    return sectors[a.first] < sectors[b.first];
  });
}

}  // namespace

void FoldCounts::add(Fold fold) {
  (fold == Fold::Mountain ? mountains : fold == Fold::Valley ? valleys : open) += 1;
}

bool FoldCounts::allow(std::size_t difference) const {
  const auto surplus = [&](std::size_t more, std::size_t less) {
    // more + x = less + (open - x) + difference for some x from 0 to open.
    return more <= less + open + difference && less + difference <= more + open;
  };
  return surplus(mountains, valleys) || surplus(valleys, mountains);
}

std::optional<Fold> FoldCounts::majority() const {
  const bool mayBeMountain = mountains <= valleys + open + 1 && valleys + 1 <= mountains + open;
  const bool mayBeValley = valleys <= mountains + open + 1 && mountains + 1 <= valleys + open;
  if (mayBeMountain && mayBeValley) return Fold::Either;
  if (mayBeMountain) return Fold::Mountain;
  if (mayBeValley) return Fold::Valley;
  return std::nullopt;
}

std::vector<SmallRun> smallRuns(const std::vector<double>& sectors, double within) {
  const std::size_t n = sectors.size();
  const auto at = [&](std::size_t i) { return sectors[i % n]; };
  std::vector<SmallRun> runs;
  for (std::size_t i = 0; i < n; ++i) {
    if (at(i + n - 1) <= at(i) + within) continue;
    SmallRun run{i, 1};
    while (run.length < n && std::abs(at(i + run.length) - at(i)) <= within) ++run.length;
    if (run.length < n - 1 && at(i + run.length) > at(i) + within) runs.push_back(run);
  }
  return runs;
}

FoldCounts countsOf(const SmallRun& run, const std::vector<Fold>& folds) {
  FoldCounts counts;
  for (std::size_t i = 0; i <= run.length; ++i) counts.add(folds[(run.first + i) % folds.size()]);
  return counts;
}

bool runFolds(const SmallRun& run, const std::vector<Fold>& folds) {
  return countsOf(run, folds).allow(run.length % 2 == 1 ? 0 : 1);
}

bool foldsFlat(std::vector<double> sectors, std::vector<Fold> folds, double within) {
  while (true) {
    const std::vector<SmallRun> runs = smallRuns(sectors, within);
    if (runs.empty()) {
      FoldCounts counts;
      for (const Fold fold : folds) counts.add(fold);
      return counts.allow(2);
    }
    const SmallRun run = smallestOf(runs, sectors);
    if (!runFolds(run, folds)) return false;
    const std::optional<Fold> left = countsOf(run, folds).majority();
    turnTo(run.first, sectors, folds);
    // Now sectors 1 .. length are the run, between creases 1 .. length + 1.
    const auto length = static_cast<std::ptrdiff_t>(run.length);
    const auto after = run.length + 1;
    if (run.length % 2 == 1) {
      sectors[0] += sectors[after % sectors.size()] - sectors[1];
      sectors.erase(sectors.begin() + 1, sectors.begin() + length + 2);
      folds.erase(folds.begin() + 1, folds.begin() + length + 2);
    } else {
      folds[1] = *left;
      sectors.erase(sectors.begin() + 1, sectors.begin() + length + 1);
      folds.erase(folds.begin() + 2, folds.begin() + length + 2);
    }
  }
}

}  // namespace kiri
