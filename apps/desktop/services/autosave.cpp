// Keeps the journal of the open model up to date.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/autosave.h"

#include <mutex>
#include <utility>

#include "editor/document/journal.h"

namespace kiri::desktop {

/// The journal and who may write to it.
struct Autosave::Desk {
  std::mutex mutex;
  std::optional<Journal> journal;
  std::string folder;
  std::uint64_t age = 0;  ///< counts up when what was asked for before is not wanted any more

  /// The journal is made when there is something to write for the first time.
  Status write(const Model& model, std::size_t count, const std::string& path,
               std::uint64_t askedAt) {
    const std::lock_guard lock(mutex);
    if (askedAt != age) return std::monostate{};
    if (!journal) {
      Result<Journal> opened = Journal::open(folder);
      if (!opened.isOk()) return opened.error();
      journal.emplace(std::move(*opened));
    }
    return journal->note(model, count, path);
  }
  Status clear(std::uint64_t askedAt) {
    const std::lock_guard lock(mutex);
    if (askedAt != age) return std::monostate{};
    return journal ? journal->clear() : Status(std::monostate{});
  }
};

Autosave::Autosave(TaskRunner& runner, const QString& folder, QObject* parent)
    : QObject(parent), desk_(std::make_shared<Desk>()), writing_(runner) {
  desk_->folder = folder.toStdString();
}

Autosave::~Autosave() {
  const std::lock_guard lock(desk_->mutex);
  ++desk_->age;
}

void Autosave::note(const Document& document) {
  const bool isModified = document.isModified();
  const QString path = QString::fromStdString(document.path());
  if (noted_ == document.revision() && wasModified_ == isModified && path_ == path) return;
  noted_ = document.revision();
  wasModified_ = isModified;
  path_ = path;
  if (isEnabled_) write(document);
}

void Autosave::write(const Document& document) {
  auto outcome = std::make_shared<std::optional<Error>>();
  Task task;
  task.work = [desk = desk_, outcome, isModified = document.isModified(), model = document.model(),
               count = document.count(), path = document.path(), age = age_](const Progress&) {
    const Status status = isModified ? desk->write(model, count, path, age) : desk->clear(age);
    if (!status.isOk()) *outcome = status.error();
  };
  task.done = [this, outcome, isModified = document.isModified()] {
    const bool failsNow = outcome->has_value();
    if (failsNow && !hasFailed_) emit failed(QString::fromStdString((*outcome)->message));
    hasFailed_ = failsNow;
    if (isModified && !failsNow) emit written();
  };
  writing_.ask(std::move(task));
}

void Autosave::setEnabled(bool isEnabled) {
  if (isEnabled == isEnabled_) return;
  isEnabled_ = isEnabled;
  noted_.reset();
  if (!isEnabled_) finish();
}

void Autosave::finish() {
  writing_.clear();
  {
    // Waits for a write under way; one that has not got the desk yet comes too late.
    const std::lock_guard lock(desk_->mutex);
    age_ = ++desk_->age;
  }
  const Status status = desk_->clear(age_);
  if (!status.isOk()) emit failed(QString::fromStdString(status.error().message));
  noted_.reset();
}

}  // namespace kiri::desktop
