// Sentences for people that a window may show in another language.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// Marks a sentence for the translators, who find it by this name; the value is the sentence.
/// `context` is the folder of the editor that says it: "editor/tools".
#define KIRI_TEXT(context, sentence) (sentence)

namespace kiri {

/// A sentence in English, and what stands in the places %1, %2... of it. Only sentences marked with
/// KIRI_TEXT are translated; arguments (numbers, names) are not.
struct Phrase {
  std::string text;
  std::vector<std::string> arguments;

  bool isEmpty() const { return text.empty(); }
  bool operator==(const Phrase&) const = default;
};

/// The sentence with its arguments in their places.
std::string inEnglish(const Phrase& phrase);

/// `text`, a translation of a phrase, with the arguments in their places.
std::string withArguments(std::string text, const std::vector<std::string>& arguments);

}  // namespace kiri
