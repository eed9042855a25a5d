// Text and links in HTML.
// SPDX-License-Identifier: MIT
#include "apps/cli/html.h"

namespace kiri::cli {

std::string htmlText(const std::string& text) {
  constexpr char kFirstPrinted = ' ';
  constexpr char kDelete = '\x7f';
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
      case '\t':
        out += c;
        break;
      default:
        if ((c >= 0 && c < kFirstPrinted) || c == kDelete) break;
        out += c;
    }
  }
  return out;
}

std::string htmlLink(const std::string& path) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '/';
    if (isPlain) {
      out += c;
    } else {
      out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return out;
}

std::string htmlTag(const std::string& name, const std::string& attributes,
                    const std::string& content) {
  return "<" + name + attributes + ">" + content + "</" + name + ">";
}

std::string htmlAttribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + htmlText(value) + "\"";
}

}  // namespace kiri::cli
