// The model that is open: its history, its file, what is unsaved, and its journal.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/model/replay.h"
#include "editor/base/phrase.h"

namespace kiri {

/// A change of the document that can be computed beside the window: from one history to the next.
using Change = std::function<Result<History>(const History&, const Progress&)>;

/// A model that is being worked on. Every change can be undone, also that of an earlier step or of
/// the colours: undo and redo walk along the versions. Value semantics; states are shared.
class Document {
 public:
  /// Errors: BadValue - the sheet is no sheet.
  static Result<Document> create(Model model);

  const Model& model() const;
  const History& history() const;
  /// Steps that count as done.
  std::size_t cursor() const;
  std::shared_ptr<const FoldedState> state() const;
  /// After `count` steps; none when a step before does not apply.
  std::shared_ptr<const FoldedState> stateAfter(std::size_t count) const;
  std::optional<Error> problemOf(std::size_t index) const;

  /// The next version. What had been undone is dropped.
  void become(History next, Phrase what);
  bool canUndo() const;
  bool canRedo() const;
  bool undo();
  bool redo();
  /// Shows the model after `count` steps; no change of the model, and undo goes back.
  bool jumpTo(std::size_t count);
  Phrase undoPhrase() const;  ///< "Undo fold 3", empty when there is nothing to undo
  Phrase redoPhrase() const;

  /// Counts up with every change of model or cursor.
  std::uint64_t revision() const;
  bool isModified() const;
  void noteSaved();
  const std::string& path() const;  ///< empty: never saved
  void setPath(std::string path);
};

/// The changes that a person makes.
Change addStep(Step step);
Change editStep(std::size_t index, Step step);
Change removeStep(std::size_t index);
Change setSheet(SheetSpec sheet);
Change setSides(PaperSide front, PaperSide back);
Change setTitle(std::string title, std::string notes);

}  // namespace kiri
