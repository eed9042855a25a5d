// The frames of a FOLD file, and which of them is the crease pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/json_tree.h"

namespace kiri {

/// 1 and the number of file_frames, objects or not.
std::size_t frameCountOf(const JsonValue& document);

/// The object of a frame, as it stands in the file. Requires an index below the count.
const JsonValue& frameObject(const JsonValue& document, std::size_t index);

/// True when the frame's own frame_classes holds the word.
bool isFrameOfClass(const JsonValue& frameObject, std::string_view word);

/// One frame with what it inherits (frame_parent, frame_inherit; FOLD 1.2). Points into the
/// document, which must stay.
class FoldFrameView {
 public:
  /// Frame 0 is the document itself, frame i > 0 the i-th of file_frames. Requires an index below
  /// frameCountOf(document).
  FoldFrameView(const JsonValue& document, std::size_t index);

  std::size_t index() const { return index_; }
  /// "frame 3", or "the file" for frame 0 of a file that has no others.
  const std::string& name() const { return name_; }
  /// The member, own or inherited; none when there is none or it is null.
  const JsonValue* find(std::string_view key) const;
  /// The same without what is inherited.
  const JsonValue* findOwn(std::string_view key) const;
  /// True when the frame's own frame_classes holds the word.
  bool isOfClass(std::string_view word) const { return isFrameOfClass(object(), word); }
  /// What is wrong with the frame's parents: a sentence, empty when nothing is.
  const std::string& complaint() const { return complaint_; }
  /// The frame's own object.
  const JsonValue& object() const { return *chain_.front(); }

 private:
  std::size_t index_ = 0;
  std::string name_;
  std::string complaint_;
  std::vector<const JsonValue*> chain_;  // the frame, its parent, its parent's parent, ...
};

}  // namespace kiri
