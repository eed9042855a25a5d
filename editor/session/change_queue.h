// Changes of the document, one after the other, computed where nobody waits for them.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <memory>

#include "editor/base/task.h"
#include "editor/document/document.h"

namespace kiri {

/// Does what is asked for in the order in which it was asked, each on what the one before has made,
/// so that a quick hand may be faster than the paper.
class ChangeQueue {
 public:
  /// What came of a change: the next history, or why there is none.
  using Ended = std::function<void(Result<History>)>;

  /// `history`: what the next change starts from.
  ChangeQueue(TaskRunner& runner, std::function<const History&()> history);
  ~ChangeQueue();
  ChangeQueue(const ChangeQueue&) = delete;
  ChangeQueue& operator=(const ChangeQueue&) = delete;

  void add(Change change, Phrase what, Ended ended);
  /// Something that takes no time, in its turn.
  void add(std::function<void()> action);
  bool isBusy() const;
  /// Stops what is being computed and forgets what waits; the ended of those is not called, but
  /// that of the running one is, with Cancelled.
  void cancel();

 private:
  struct Shared;
  static void next(const std::shared_ptr<Shared>& shared);
  std::shared_ptr<Shared> shared_;
};

}  // namespace kiri
