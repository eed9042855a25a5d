// PNG images from and to bytes.
// SPDX-License-Identifier: MIT
#include "render/canvas/png.h"

#include <png.h>

#include <cmath>
#include <cstdint>

namespace kiri {
namespace {

constexpr int kLargest = 16384;

void appendBigEndian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

/// The check sum of PNG chunks (ISO 3309).
std::uint32_t crcOf(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  }
  return ~crc;
}

/// The chunk that says how many pixels make a metre.
std::string resolutionChunk(double dpi) {
  constexpr double kInchInMetres = 0.0254;
  const auto perMetre = static_cast<std::uint32_t>(std::round(dpi / kInchInMetres));
  std::string content = "pHYs";
  appendBigEndian(content, perMetre);
  appendBigEndian(content, perMetre);
  content += '\1';  // the unit is the metre
  std::string chunk;
  appendBigEndian(chunk, static_cast<std::uint32_t>(content.size() - 4));
  chunk += content;
  appendBigEndian(chunk, crcOf(content));
  return chunk;
}

}  // namespace

Result<Image> decodePng(const std::string& bytes) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  const auto fail = [&](const std::string& why) {
    png_image_free(&header);
    return Error{ErrorCode::BadFile, why + "; give a PNG image", {}};
  };
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
    return fail(std::string("not a PNG image that can be read: ") + header.message);
  }
  if (header.width > kLargest || header.height > kLargest) {
    return fail("the image is " + std::to_string(header.width) + " x " +
                std::to_string(header.height) + " pixels, more than " + std::to_string(kLargest) +
                " on a side");
  }
  header.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, image.rgba.data(), 0, nullptr) == 0) {
    return fail(std::string("the PNG image is damaged: ") + header.message);
  }
  return image;
}

Result<std::string> encodePng(const Image& image, double dpi) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGBA;
  // One byte a row for its filter; what does not shrink grows by less than a 64th in blocks and
  // chunks.
  const std::size_t raw = image.rgba.size() + static_cast<std::size_t>(image.height);
  std::string bytes(raw + raw / 64 + 4096, '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr) ==
      0) {
    return Error{ErrorCode::BadValue,
                 std::string("the image cannot be written as PNG: ") + header.message,
                 {}};
  }
  bytes.resize(size);
  constexpr std::size_t kAfterHeader = 8 + 25;  // signature and IHDR chunk
  if (dpi > 0) bytes.insert(kAfterHeader, resolutionChunk(dpi));
  return bytes;
}

}  // namespace kiri
