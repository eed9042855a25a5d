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
  std::size_t steps = 0;
  std::size_t cursor = 0;
};

/// One file in a folder of journals, held (locked) by this process for as long as it lives: the
/// newest version of the open model, whole at every moment.
class Journal {
 public:
  /// Errors: Unwritable.
  static Result<Journal> open(const std::string& folder);
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;
  ~Journal();

  /// Writes the model down. Errors: Unwritable.
  Status note(const Model& model, std::size_t cursor, const std::string& originalPath);
  /// The document was saved or closed in order: nothing needs to be recovered.
  Status clear();
  const std::string& file() const;

 private:
  Journal() = default;
  struct Held;
  std::unique_ptr<Held> held_;
};

/// Journals in the folder that no living process holds, newest first; damaged ones are left out and
/// stay where they are.
std::vector<Leftover> leftoversIn(const std::string& folder);
struct Recovered {
  Model model;
  std::size_t cursor = 0;
  std::string originalPath;
};
/// Errors: BadFile.
Result<Recovered> recover(const Leftover& leftover);
void discard(const Leftover& leftover);

}  // namespace kiri
