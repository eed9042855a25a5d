// The model that is open: its history, its file, and what of it is unsaved.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/model/history.h"
#include "editor/base/phrase.h"

namespace kiri {

/// A change of the document that can be computed beside the window: from one history to the next.
using Change = std::function<Result<History>(const History&, const Progress&)>;

/// A model that is being worked on. Every change can be undone, also that of an earlier step or of
/// the colours, and those that were made before the file was opened: undo and redo walk along the
/// versions. Value semantics; states are shared.
class Document {
 public:
  /// Errors: BadValue - the sheet is no sheet; Cancelled. Steps that do not apply are kept.
  static Result<Document> create(Model model, const Progress& progress = {});
  /// One that a journal kept: only the first `count` steps count, the others were undone. It is
  /// modified until it is saved. Errors: those of create.
  static Result<Document> recovered(Model model, std::size_t count, const Progress& progress = {});

  /// With the steps that were undone, which can be redone.
  const Model& model() const { return history_.model(); }
  const History& history() const { return history_; }
  /// Steps that count; those after them were undone.
  std::size_t count() const { return history_.count(); }
  /// Steps that are shown as done: count(), or fewer after jumpTo.
  std::size_t cursor() const { return history_.cursor(); }
  /// What a file of the document holds: the steps that count. Undone steps are not saved, but stay
  /// here to be redone; looking at an earlier step leaves out none.
  Model modelToSave() const;
  std::shared_ptr<const FoldedState> state() const { return history_.sharedState(); }
  /// After `count` steps; none when a step before does not apply.
  std::shared_ptr<const FoldedState> stateAfter(std::size_t count) const;
  /// Why step `index` (from 0) does not apply; none when it does.
  std::optional<Error> problemOf(std::size_t index) const { return history_.problemOf(index); }

  /// The next version, made by a change from history(). What had been undone is dropped. Nothing
  /// happens to the versions when the model is the same. An empty `what` stands for the step that
  /// was added.
  void become(History next, Phrase what);
  /// After jumpTo, undo comes back from there first.
  bool canUndo() const;
  bool canRedo() const { return !future_.empty(); }
  bool undo();
  bool redo();
  /// True when undo and redo have to replay steps, for so much was changed since that their states
  /// were forgotten: better done with a copy of the document, beside the window.
  bool isUndoLong() const { return cursor() == count() && isLong(past_); }
  bool isRedoLong() const { return isLong(future_); }
  /// States that only undo and redo need are kept as long as they have no more facets in all, the
  /// nearest first. A facet takes about half a kilobyte.
  void keepFacets(std::size_t most);
  /// Shows the model after `count` steps; no change of the model. Steps that were undone are redone
  /// up to there. False when there is nothing to show otherwise.
  bool jumpTo(std::size_t count);
  /// What undo and redo would take back or do again: "fold 3: valley, 180°"; empty: nothing.
  Phrase undoPhrase() const;
  Phrase redoPhrase() const;

  /// Counts up with every change of model or cursor.
  std::uint64_t revision() const { return revision_; }
  /// True when modelToSave() is not what was opened or saved last.
  bool isModified() const;
  void noteSaved() { saved_ = modelToSave(); }
  /// The same when the document may have changed since the file was begun.
  void noteSaved(Model written) { saved_ = std::move(written); }
  const std::string& path() const { return path_; }  ///< empty: never saved
  void setPath(std::string path) { path_ = std::move(path); }

 private:
  /// From one version to its neighbour.
  struct Turn {
    Phrase what;
    std::optional<HistoryDifference> other;  ///< none: the last step was added, no more
  };

  explicit Document(History history);
  static bool isLong(const std::vector<Turn>& turns);
  void forgetFarStates();

  History history_;
  std::vector<Turn> past_;      ///< the last is undone next
  std::vector<Turn> future_;    ///< the last is redone next
  std::optional<Model> saved_;  ///< none: there is no file like it
  std::string path_;
  std::uint64_t revision_ = 0;
  std::size_t facetsKept_ = 1500000;
};

/// The changes that a person makes. A step is added at the cursor, resolved (see
/// core/model/apply.h) so that it means the same whatever becomes of the steps before it. Errors:
/// see History.
Change addStep(Step step);
Change editStep(std::size_t index, Step step);
Change removeStep(std::size_t index);
Change setSheet(SheetSpec sheet);
Change setSides(PaperSide front, PaperSide back);
Change setTitle(std::string title, std::string notes);
Change setOpening(Sequence opening);

}  // namespace kiri
