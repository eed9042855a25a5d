// Keeps the journal of the open model up to date, so that a crash loses at most the step under the
// hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>

#include "editor/base/task.h"
#include "editor/document/document.h"

namespace kiri::desktop {

/// The window calls `note` after every change of the document (Changed::document). The newest
/// version is written beside the window, whole, as soon as the one before is on disk. A document
/// without unsaved changes has no journal.
///
///   Autosave autosave(runner, journalFolder());
///   session listener:  if (changed.document) autosave.note(session.document());
///   closing in order:  autosave.finish();
///
/// What a killed program left behind: leftoversIn(journalFolder()) in editor/document/journal.h,
/// shown by dialogs/recovery_dialog.
class Autosave final : public QObject {
  Q_OBJECT
 public:
  /// The runner must outlive this object.
  Autosave(TaskRunner& runner, const QString& folder, QObject* parent = nullptr);
  ~Autosave() override;

  void note(const Document& document);
  /// Off: what was written is taken away, and nothing more is written.
  void setEnabled(bool isEnabled);
  bool isEnabled() const { return isEnabled_; }
  /// Waits for what is being written and takes the journal away: the model was saved, or the person
  /// said that its changes may go.
  void finish();

 signals:
  /// A version with unsaved changes is on disk.
  void written();
  /// The journal cannot be written, for the first time since it could: say so in the status bar.
  void failed(const QString& why);

 private:
  struct Desk;
  void write(const Document& document);

  std::shared_ptr<Desk> desk_;  ///< shared with the work under way
  LatestTask writing_;
  std::optional<std::uint64_t> noted_;  ///< revision that was written or is on its way
  std::uint64_t age_ = 0;
  bool wasModified_ = false;
  QString path_;
  bool isEnabled_ = true;
  bool hasFailed_ = false;
};

}  // namespace kiri::desktop
