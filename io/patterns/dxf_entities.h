// A DXF file as what it is made of: layers, blocks, entities.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kiri {

/// A group code and its value.
struct DxfPair {
  int code = 0;
  std::string_view value;
};

/// One entity: its own pairs, and those of the VERTEX entities that follow a POLYLINE.
struct DxfEntity {
  std::string_view type;
  std::vector<DxfPair> pairs;
  std::vector<std::vector<DxfPair>> vertices;

  /// The number behind a code; `otherwise` where there is none, or none that a drawing may have.
  double number(int code, double otherwise = 0) const;
  std::string_view text(int code) const;
};

struct DxfBlock {
  DxfEntity head;  ///< its base point
  std::vector<DxfEntity> entities;
};

/// Views into the text of the file.
struct DxfFile {
  std::map<std::string_view, int> layerColours;
  std::map<std::string_view, DxfBlock> blocks;
  std::vector<DxfEntity> entities;
  std::optional<double> mmPerUnit;
  std::vector<std::string> notes;
};

/// Errors: BadFile - a line that should be a group code is none.
Result<DxfFile> parseDxf(std::string_view text, std::string_view fileName);

/// The number behind a code in a list of pairs, as DxfEntity::number.
double dxfNumber(const std::vector<DxfPair>& pairs, int code, double otherwise = 0);

}  // namespace kiri
