// Bytes on the heap, counted as they are taken and given back.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace kiri::bench {

/// Bytes that this program holds on the heap now, as the allocator rounds them.
std::size_t heapBytes();

}  // namespace kiri::bench
