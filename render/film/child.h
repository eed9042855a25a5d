// A program that runs beside ours and reads what we send it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kiri {

/// One run of another program: its standard input is ours to fill, what it says on standard error
/// is kept for the message, should it fail. It is not reached by a Ctrl-C in the terminal, and ends
/// with this object at the latest.
class Child {
 public:
  /// Starts `words[0]`, found in PATH, with the other words as its arguments; no shell is between.
  /// Errors: NotFound - there is no such program; Unwritable - it cannot be started.
  static Result<Child> start(const std::vector<std::string>& words);

  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Sends bytes to its standard input; waits until they are taken, asking `progress` now and then
  /// whether to go on. Errors: Unwritable - it stopped reading; the message ends with what it said
  /// last; Cancelled - it was ended.
  Status send(const void* bytes, std::size_t count, const Progress& progress = {});
  /// Closes its standard input and waits for its end, asking `progress` now and then whether to go
  /// on. Errors: Unwritable - it failed, with what it said last; Cancelled - it was ended.
  Status finish(const Progress& progress = {});

 private:
  Child(int process, int input, int said, std::string name)
      : process_(process), input_(input), said_(said), name_(std::move(name)) {}
  void closeInput();
  void kill();
  Error failure(int status);
  std::string lastWords() const;

  int process_ = -1;  ///< below zero: it has ended
  int input_ = -1;
  int said_ = -1;  ///< a file without a name that it writes its standard error to
  std::string name_;
};

}  // namespace kiri
