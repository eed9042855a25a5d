// A DXF file as what it is made of: layers, blocks, entities.
// SPDX-License-Identifier: MIT
#include "io/patterns/dxf_entities.h"

#include <cmath>
#include <utility>

#include "io/patterns/dxf_units.h"
#include "io/patterns/plain_number.h"
#include "io/patterns/text_lines.h"

namespace kiri {

namespace {

/// Reads pairs of lines.
class DxfPairs {
 public:
  explicit DxfPairs(std::string_view text) : lines_(text) {}

  /// The next pair; none at the end of the file, or where a group code is none.
  std::optional<DxfPair> next() {
    const std::optional<std::string_view> code = lines_.next();
    if (!code) return std::nullopt;
    const std::optional<double> number = numberOf(*code);
    if (!number || std::floor(*number) != *number || std::abs(*number) > kLargestCode) {
      if (!trimmed(*code).empty()) badLine_ = lines_.number();
      return std::nullopt;
    }
    const std::optional<std::string_view> value = lines_.next();
    if (!value) return std::nullopt;
    return DxfPair{static_cast<int>(*number), trimmed(*value)};
  }

  /// The line that should have been a group code; 0 when all were.
  std::size_t badLine() const { return badLine_; }

 private:
  static constexpr double kLargestCode = 5000;

  TextLines lines_;
  std::size_t badLine_ = 0;
};

/// Sorts pairs into sections, tables, blocks and entities.
class DxfSorter {
 public:
  explicit DxfSorter(DxfFile& file) : file_(file) {}

  /// Entities, vertices and blocks so far.
  std::size_t entityCount() const { return entityCount_; }

  /// False at the end of the drawing.
  bool take(const DxfPair& pair) {
    if (pair.code == 999) return true;
    if (pair.code != 0) {
      takeDetail(pair);
      return true;
    }
    if (pair.value == "EOF") return false;
    if (pair.value == "SECTION" || pair.value == "ENDSEC") {
      section_ = {};
      isSectionNamed_ = pair.value == "ENDSEC";
      block_ = nullptr;
      current_ = nullptr;
    } else if (section_ == "TABLES") {
      isLayer_ = pair.value == "LAYER";
      layer_ = {};
    } else if (section_ == "ENTITIES" || section_ == "BLOCKS") {
      startEntity(pair.value);
    }
    return true;
  }

 private:
  void takeDetail(const DxfPair& pair) {
    if (!isSectionNamed_ && pair.code == 2) {
      section_ = pair.value;
      isSectionNamed_ = true;
    } else if (section_ == "HEADER") {
      if (pair.code == 9) variable_ = pair.value;
      if (pair.code == 70 && variable_ == "$INSUNITS") {
        file_.mmPerUnit = mmOfDxfUnit(numberOf(pair.value).value_or(0));
      }
    } else if (section_ == "TABLES") {
      takeLayer(pair);
    } else if (current_ != nullptr) {
      if (isHead_ && pair.code == 2 && block_ == nullptr) {
        block_ = &file_.blocks[pair.value];
        block_->head.pairs = std::move(head_.pairs);
        current_ = &block_->head.pairs;
      }
      current_->push_back(pair);
    }
  }

  void takeLayer(const DxfPair& pair) {
    if (!isLayer_) return;
    if (pair.code == 2) layer_ = pair.value;
    const std::optional<double> colour = numberOf(pair.value);
    constexpr double kLastColour = 256;
    if (pair.code == 62 && colour && std::abs(*colour) <= kLastColour) {
      file_.layerColours[layer_] = static_cast<int>(std::abs(*colour));  // negative: switched off
    }
  }

  void startEntity(std::string_view type) {
    ++entityCount_;
    isHead_ = section_ == "BLOCKS" && type == "BLOCK";
    if (isHead_) {
      block_ = nullptr;
      head_ = {};
      current_ = &head_.pairs;
      return;
    }
    std::vector<DxfEntity>* target = section_ == "ENTITIES" ? &file_.entities
                                     : block_ != nullptr    ? &block_->entities
                                                            : nullptr;
    if (type == "ENDBLK" || target == nullptr) {
      current_ = nullptr;
      if (type == "ENDBLK") block_ = nullptr;
      return;
    }
    if (type == "VERTEX" && !target->empty() && target->back().type == "POLYLINE") {
      current_ = &target->back().vertices.emplace_back();
      return;
    }
    if (type == "SEQEND") {
      current_ = nullptr;
      return;
    }
    DxfEntity& entity = target->emplace_back();
    entity.type = type;
    current_ = &entity.pairs;
  }

  DxfFile& file_;
  std::size_t entityCount_ = 0;
  std::string_view section_;
  bool isSectionNamed_ = true;
  std::string_view variable_;
  bool isLayer_ = false;
  std::string_view layer_;
  bool isHead_ = false;
  DxfEntity head_;
  DxfBlock* block_ = nullptr;
  std::vector<DxfPair>* current_ = nullptr;
};

}  // namespace

double dxfNumber(const std::vector<DxfPair>& pairs, int code, double otherwise) {
  for (const DxfPair& pair : pairs) {
    if (pair.code != code) continue;
    const std::optional<double> value = numberOf(pair.value);
    return value && isDrawable(*value) ? *value : otherwise;
  }
  return otherwise;
}

double DxfEntity::number(int code, double otherwise) const {
  return dxfNumber(pairs, code, otherwise);
}

std::string_view DxfEntity::text(int code) const {
  for (const DxfPair& pair : pairs) {
    if (pair.code == code) return pair.value;
  }
  return {};
}

Result<DxfFile> parseDxf(std::string_view text, std::string_view fileName) {
  if (withoutMark(text).substr(0, 18) == "AutoCAD Binary DXF") {
    return Error{ErrorCode::BadFile,
                 std::string(fileName) +
                     ": this is a binary DXF file; save it as ASCII DXF in the program it comes "
                     "from"};
  }
  DxfFile file;
  DxfPairs pairs(text);
  DxfSorter sorter(file);
  bool isComplete = false;
  std::size_t count = 0;
  while (const std::optional<DxfPair> pair = pairs.next()) {
    // What the sorter makes of as many pairs stays below 1 GB.
    constexpr std::size_t kMostPairs = 6'000'000;
    constexpr std::size_t kMostEntities = 1'500'000;
    if (++count > kMostPairs || sorter.entityCount() > kMostEntities) {
      return Error{
          ErrorCode::BadFile,
          std::string(fileName) + ": the file holds millions of entities; is this the right file?"};
    }
    if (sorter.take(*pair)) continue;
    isComplete = true;
    break;
  }
  if (isComplete) return file;
  const std::string place = pairs.badLine() == 0
                                ? "the file ends without EOF"
                                : "line " + std::to_string(pairs.badLine()) + " is no group code";
  if (file.entities.empty()) {
    return Error{ErrorCode::BadFile, std::string(fileName) + ": " + place +
                                         " and no entity was found before; is this a DXF file?"};
  }
  file.notes.push_back(place + "; what comes before was read");
  return file;
}

}  // namespace kiri
