// Whether a single vertex folds flat with given mountains and valleys.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kiri {

/// What a crease may be.
enum class Fold : std::uint8_t { Mountain = 1, Valley = 2, Either = 3 };

/// Counts of creases of each kind.
struct FoldCounts {
  std::size_t mountains = 0;
  std::size_t valleys = 0;
  std::size_t open = 0;

  void add(Fold fold);
  /// True when a choice of the open ones makes mountains and valleys differ by `difference`,
  /// whichever there are more of. Requires the parity of the number of creases.
  bool allow(std::size_t difference) const;
  /// What the creases fold like together when one of them is left over.
  std::optional<Fold> majority() const;
};

/// A run of equal angles between larger ones, by the position of its first sector.
struct SmallRun {
  std::size_t first = 0;
  std::size_t length = 0;
};

/// All such runs around a vertex; `within`: angles that differ by less are equal. None when all
/// angles are equal.
std::vector<SmallRun> smallRuns(const std::vector<double>& sectors, double within);

/// The creases of a run: one more than it has sectors.
FoldCounts countsOf(const SmallRun& run, const std::vector<Fold>& folds);
/// Whether the creases of a run may fold as they say: as many mountains as valleys around an odd
/// number of sectors, one more or less around an even number (Hull).
bool runFolds(const SmallRun& run, const std::vector<Fold>& folds);

/// True when some choice of the open creases folds the vertex flat. Sector i lies between crease i
/// and i + 1; alternate sectors add up to 180 within `within`; the number of creases is even.
/// Exact: runs of smallest angles are folded away, one after the other (Hull, Project Origami;
/// Demaine, O'Rourke, Geometric Folding Algorithms, 12.2).
bool foldsFlat(std::vector<double> sectors, std::vector<Fold> folds, double within);

}  // namespace kiri
