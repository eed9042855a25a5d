// The open session, and Qt signals for what changes in it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/session_hub.h"

#include <utility>

namespace kiri::desktop {

SessionHub::SessionHub(TaskRunner& runner, QObject* parent)
    : QObject(parent),
      runner_(runner),
      session_(std::make_unique<Session>(runner, [this](const Changed& what) { note(what); })) {}

SessionHub::~SessionHub() = default;

void SessionHub::note(const Changed& what) {
  gathered_.document |= what.document;
  gathered_.shown |= what.shown;
  gathered_.marks |= what.marks;
  gathered_.view |= what.view;
  gathered_.tool |= what.tool;
  gathered_.busy |= what.busy;
  gathered_.selection |= what.selection;
  gathered_.pattern |= what.pattern;
  if (isWaiting_) return;
  isWaiting_ = true;
  QMetaObject::invokeMethod(this, &SessionHub::flush, Qt::QueuedConnection);
}

void SessionHub::flush() {
  isWaiting_ = false;
  const Changed what = std::exchange(gathered_, {});
  emit changed(what);
  if (what.document) emit documentChanged();
  if (what.tool) emit toolChanged();
  if (what.shown) emit shownChanged();
  if (what.view) emit viewChanged();
  if (what.marks) emit marksChanged();
  if (what.selection) emit selectionChanged();
  if (what.busy) emit busyChanged();
  if (what.pattern) emit patternChanged();
}

}  // namespace kiri::desktop
