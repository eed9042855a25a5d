// Counting what is wrong with the parts of a file, to say each kind once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kiri {

/// How often something happened, and where first.
class Tally {
 public:
  void add(std::size_t place) {
    if (count_ == 0) first_ = place;
    ++count_;
  }
  std::size_t count() const { return count_; }
  std::size_t first() const { return first_; }

  /// Adds "3 edges (the first: 7) <what>" to the notes when something happened.
  void tell(std::vector<std::string>& notes, const std::string& one, const std::string& many,
            const std::string& what) const {
    if (count_ == 0) return;
    const std::string place = count_ == 1 ? " (" + std::to_string(first_) + ") "
                                          : " (the first: " + std::to_string(first_) + ") ";
    notes.push_back(std::to_string(count_) + " " + (count_ == 1 ? one : many) + place + what);
  }

 private:
  std::size_t count_ = 0;
  std::size_t first_ = 0;
};

}  // namespace kiri
