// What is kept so that a crash loses at most the step under the hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/model.h"

namespace kiri {

/// A model that a crashed or killed program left behind.
struct Leftover {
  std::string file;          ///< of the journal
  std::string originalPath;  ///< of the model; empty: it had never been saved
  std::string title;
  std::size_t steps = 0;  ///< of the model, with those that were undone
  std::size_t count = 0;  ///< steps that count
};

/// One file in a folder of journals: the newest version of the open model, whole at every moment.
/// A lock beside it is held as long as this process lives, however it ends.
class Journal {
 public:
  /// Makes the folder where there is none. Journals of others, and what they left behind, are not
  /// touched. Errors: Unwritable.
  static Result<Journal> open(const std::string& folder);
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;
  /// Lets go of the file; what it holds becomes a leftover.
  ~Journal();

  /// Writes the model down, with the steps that were undone; the first `count` count. Waits for the
  /// disk: call it beside the window, one call at a time. Errors: Unwritable.
  Status note(const Model& model, std::size_t count, const std::string& originalPath);
  /// The document was saved or closed in order: nothing needs to be recovered.
  Status clear();
  const std::string& file() const;

 private:
  struct Held;
  explicit Journal(std::unique_ptr<Held> held);
  std::unique_ptr<Held> held_;
};

/// Journals in the folder that no living process holds, newest first; damaged ones are left out and
/// stay where they are.
std::vector<Leftover> leftoversIn(const std::string& folder);

struct Recovered {
  Model model;
  std::size_t count = 0;
  std::string originalPath;
};
/// For Document::recovered. Errors: BadFile.
Result<Recovered> recover(const Leftover& leftover);
/// Removes it, unless another process holds it by now.
void discard(const Leftover& leftover);

/// A journal as text: a head of lines, then the model as it stands in a .kiri file.
std::string writeJournal(const Recovered& content);
/// Errors: BadFile - not a journal, cut off, or changed.
Result<Recovered> readJournal(const std::string& text, const std::string& fileName);

}  // namespace kiri
