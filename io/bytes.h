// Numbers as the bytes of binary formats: little-endian, whatever the machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace kiri {

inline void appendUint16(std::string& out, std::uint16_t value) {
  for (int shift = 0; shift < 16; shift += 8) out += static_cast<char>(value >> shift & 0xFF);
}

inline void appendUint32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xFFU);
}

/// As an IEEE single; minus zero is written as zero.
inline void appendFloat(std::string& out, double value) {
  const float single = value == 0 ? 0.0F : static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof bits);
  appendUint32(out, bits);
}

}  // namespace kiri
