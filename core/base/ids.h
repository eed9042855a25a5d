// Names of things inside one state. An index never leaves the program: files name places.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace kiri {

/// An index into one of the arrays of a state; distinct types keep facets and edges apart.
template <class Tag>
struct Id {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t index = kNone;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t i) : index(static_cast<std::uint32_t>(i)) {}
  constexpr bool isValid() const { return index != kNone; }
  constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FacetId = Id<struct FacetTag>;
using FoldLineId = Id<struct FoldLineTag>;

}  // namespace kiri
