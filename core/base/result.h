// A value, or an error that says what is wrong, where, and what to do.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/check.h"
#include "core/base/vec.h"

namespace kiri {

/// What kind of mistake an error reports. The sentence carries the particulars.
enum class ErrorCode {
  BadValue,            ///< a number or choice that no paper allows
  BadFile,             ///< a file that cannot be read as what it claims to be
  NotFound,            ///< a name or place that is not on the paper
  MissesPaper,         ///< a line or curve that does not touch the layers it is meant for
  WouldStretch,        ///< a motion that would tear the paper at a hinge
  Locked,              ///< a fold line that another fold holds fast
  TooThin,             ///< a crease that would leave a sliver
  CurveCrossesItself,  ///< a cutting curve with a loop
  DoesNotSeparate,     ///< a cut that leaves the wanted and the unwanted part joined
  NothingLeft,         ///< a cut that would throw all paper away
  NothingToDo,         ///< a step that would change nothing
  CannotMend,          ///< torn edges whose sides do not lie together
  Cancelled,           ///< the user stopped long work
  Unwritable,          ///< a file that could not be written
};

/// Where an error is seen on the sheet, for an interface to point at.
struct Witness {
  std::vector<Vec2> points;                     ///< paper frame, mm
  std::vector<std::pair<Vec2, Vec2>> segments;  ///< hinges or lines, paper frame, mm
  std::vector<Vec2> facets;                     ///< one interior point for each facet concerned
};

/// The user's or the file's mistake. `message` is one sentence without a full stop that names the
/// place and the remedy.
struct Error {
  ErrorCode code = ErrorCode::BadValue;
  std::string message;
  Witness witness = {};
};

/// Either a value or an Error. Reading the wrong one is a defect and is checked.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  bool isOk() const { return content_.index() == 0; }
  explicit operator bool() const { return isOk(); }

  const T& value() const& {
    KIRI_CHECK(isOk(), std::get<1>(content_).message.c_str());
    return std::get<0>(content_);
  }
  T& value() & {
    KIRI_CHECK(isOk(), std::get<1>(content_).message.c_str());
    return std::get<0>(content_);
  }
  T&& value() && {
    KIRI_CHECK(isOk(), std::get<1>(content_).message.c_str());
    return std::get<0>(std::move(content_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const {
    KIRI_CHECK(!isOk(), "an error is read only where there is one");
    return std::get<1>(content_);
  }

 private:
  std::variant<T, Error> content_;
};

/// The result of work that returns nothing but may fail.
using Status = Result<std::monostate>;

}  // namespace kiri
