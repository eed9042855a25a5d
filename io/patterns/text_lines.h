// A text line by line, whatever the line ends of its system.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace kiri {

inline constexpr std::string_view kBlanks = " \t\r\n\f\v";

inline bool isBlankOrComma(char c) { return c == ',' || kBlanks.find(c) != std::string_view::npos; }

/// The text without blanks around it.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The text without the mark that some programs put before UTF-8.
inline std::string_view withoutMark(std::string_view text) {
  return text.substr(0, 3) == "\xEF\xBB\xBF" ? text.substr(3) : text;
}

/// Walks through the lines of a text. Lines end with LF, CR LF or CR.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(withoutMark(text)) {}

  /// The next line without its end; none after the last.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    ++number_;
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
      rest_ = {};
    } else {
      const bool isPair = rest_.substr(end, 2) == "\r\n";
      rest_.remove_prefix(end + (isPair ? 2 : 1));
    }
    return line;
  }

  /// The number of the line that next() gave last, from 1.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

}  // namespace kiri
