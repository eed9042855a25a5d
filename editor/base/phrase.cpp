// Putting arguments into sentences.
// SPDX-License-Identifier: MIT
#include "editor/base/phrase.h"

#include <cstddef>

namespace kiri {

std::string withArguments(std::string text, const std::vector<std::string>& arguments) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isPlace = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' &&
                         static_cast<std::size_t>(text[i + 1] - '1') < arguments.size();
    if (!isPlace) {
      result += text[i];
      continue;
    }
    result += arguments[static_cast<std::size_t>(text[++i] - '1')];
  }
  return result;
}

std::string inEnglish(const Phrase& phrase) { return withArguments(phrase.text, phrase.arguments); }

}  // namespace kiri
