// A journal as text.
// SPDX-License-Identifier: MIT
#include <cctype>
#include <sstream>

#include "editor/document/journal.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"

namespace kiri {
namespace {

constexpr const char* kFirstLine = "KiriSim journal 1";
constexpr const char* kHexDigits = "0123456789abcdef";

/// A path may hold any byte but 0; in the head it takes one line.
std::string escaped(const std::string& path) {
  std::string line;
  for (const char c : path) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= ' ' && c != '%') {
      line += c;
    } else {
      line += {'%', kHexDigits[code >> 4], kHexDigits[code & 15]};
    }
  }
  return line;
}

int digitOf(char c) {
  for (int i = 0; i < 16; ++i) {
    if (kHexDigits[i] == c) return i;
  }
  return -1;
}

std::string unescaped(const std::string& line) {
  std::string path;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool isCode = line[i] == '%' && i + 2 < line.size() && digitOf(line[i + 1]) >= 0 &&
                        digitOf(line[i + 2]) >= 0;
    if (isCode) {
      path += static_cast<char>(digitOf(line[i + 1]) * 16 + digitOf(line[i + 2]));
      i += 2;
    } else {
      path += line[i];
    }
  }
  return path;
}

/// The rest of the next line when it starts with `key` and a space.
bool takeLine(std::istringstream& in, const std::string& key, std::string& rest) {
  std::string line;
  if (!std::getline(in, line) || line.rfind(key + " ", 0) != 0) return false;
  rest = line.substr(key.size() + 1);
  return true;
}

bool takeNumber(std::istringstream& in, const std::string& key, std::size_t& number) {
  std::string digits;
  constexpr std::size_t kMostDigits = 9;
  if (!takeLine(in, key, digits) || digits.empty() || digits.size() > kMostDigits) return false;
  number = 0;
  for (const char c : digits) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return false;
    number = number * 10 + static_cast<std::size_t>(c - '0');
  }
  return true;
}

Error damaged(const std::string& fileName) {
  return {ErrorCode::BadFile, fileName + " is no journal, or it was cut off or changed", {}};
}

}  // namespace

std::string writeJournal(const Recovered& content) {
  const std::string model = writeKiri(content.model);
  return std::string(kFirstLine) + "\ncount " + std::to_string(content.count) + "\nbytes " +
         std::to_string(model.size()) + "\npath " + escaped(content.originalPath) + "\n" + model;
}

Result<Recovered> readJournal(const std::string& text, const std::string& fileName) {
  std::istringstream in(text);
  std::string line;
  Recovered content;
  std::size_t bytes = 0;
  if (!std::getline(in, line) || line != kFirstLine || !takeNumber(in, "count", content.count) ||
      !takeNumber(in, "bytes", bytes) || !takeLine(in, "path", line) || in.eof()) {
    return damaged(fileName);
  }
  content.originalPath = unescaped(line);
  const auto head = static_cast<std::size_t>(in.tellg());
  if (text.size() != head + bytes) return damaged(fileName);
  Result<LoadedModel> loaded = readKiri(std::string_view(text).substr(head), fileName);
  if (!loaded) return loaded.error();
  content.model = std::move(loaded->model);
  if (content.count > content.model.steps.size()) return damaged(fileName);
  return content;
}

}  // namespace kiri
