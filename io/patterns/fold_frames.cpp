// The frames of a FOLD file, and which of them is the crease pattern.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_frames.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/check.h"

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

/// The frame that `frame` inherits from; none when it inherits nothing. Sets the complaint when
/// what the file says makes no sense.
std::optional<std::size_t> parentOf(const JsonValue& frame, std::size_t count,
                                    std::string& complaint) {
  const JsonValue* inherits = frame.find("frame_inherit");
  if (inherits == nullptr || !inherits->is(Kind::Bool) || !inherits->boolean) return std::nullopt;
  const JsonValue* parent = frame.find("frame_parent");
  if (parent == nullptr) return 0;
  const double number = parent->is(Kind::Number) ? parent->number : -1;
  if (number < 0 || std::floor(number) != number || number >= static_cast<double>(count)) {
    complaint = "its frame_parent is no frame of the file; nothing was inherited";
    return std::nullopt;
  }
  return static_cast<std::size_t>(number);
}

}  // namespace

std::size_t frameCountOf(const JsonValue& document) {
  const JsonValue* frames = document.find("file_frames");
  return 1 + (frames != nullptr && frames->is(Kind::Array) ? frames->items.size() : 0);
}

const JsonValue& frameObject(const JsonValue& document, std::size_t index) {
  if (index == 0) return document;
  const JsonValue* frames = document.find("file_frames");
  KIRI_CHECK(frames != nullptr && index <= frames->items.size(), "a frame is one of the file");
  return frames->items[index - 1];
}

bool isFrameOfClass(const JsonValue& frameObject, std::string_view word) {
  const JsonValue* classes = frameObject.find("frame_classes");
  if (classes == nullptr) return false;
  if (classes->is(Kind::String)) return classes->text == word;
  return std::any_of(classes->items.begin(), classes->items.end(), [&](const JsonValue& item) {
    return item.is(Kind::String) && item.text == word;
  });
}

FoldFrameView::FoldFrameView(const JsonValue& document, std::size_t index) : index_(index) {
  const std::size_t count = frameCountOf(document);
  name_ = count == 1 ? "the file" : "frame " + std::to_string(index);
  std::set<std::size_t> seen;
  std::optional<std::size_t> next = index;
  while (next) {
    if (!seen.insert(*next).second) {
      complaint_ = "its frame_parent leads back to itself; the loop was cut";
      break;
    }
    const JsonValue* frame = &frameObject(document, *next);
    chain_.push_back(frame);
    next = parentOf(*frame, count, complaint_);
  }
}

const JsonValue* FoldFrameView::find(std::string_view key) const {
  for (const JsonValue* frame : chain_) {
    const JsonValue* value = frame->find(key);
    if (value != nullptr && !value->is(Kind::Null)) return value;
  }
  return nullptr;
}

const JsonValue* FoldFrameView::findOwn(std::string_view key) const {
  const JsonValue* value = chain_.front()->find(key);
  return value == nullptr || value->is(Kind::Null) ? nullptr : value;
}

}  // namespace kiri
