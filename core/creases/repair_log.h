// What was repaired, gathered while it happens and told in sentences.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/creases/repair.h"

namespace kiri {

/// Counts repairs by kind; the first few places of each are kept.
class RepairLog {
 public:
  /// One more repair at `place`, where a point was moved by `distance`.
  void add(RepairKind kind, Vec2 place, double distance = 0);
  std::size_t countOf(RepairKind kind) const { return entries_[indexOf(kind)].count; }
  /// Kinds that occurred, in their order, with a sentence each.
  std::vector<Repair> repairs() const;

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(RepairKind::IgnoredFaces) + 1;
  static std::size_t indexOf(RepairKind kind) { return static_cast<std::size_t>(kind); }

  std::array<Repair, kKinds> entries_;
};

}  // namespace kiri
