// Text and links in HTML.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri::cli {

/// Text between tags or in an attribute; characters that HTML does not allow are left out.
std::string htmlText(const std::string& text);

/// A file's path in a link: what is no letter, digit or mark of file names is written as %XX.
std::string htmlLink(const std::string& path);

/// `<name attributes>content</name>`; `attributes` like ` class="notes"`, `content` is HTML.
std::string htmlTag(const std::string& name, const std::string& attributes,
                    const std::string& content);

/// ` name="value"`, the value escaped.
std::string htmlAttribute(const std::string& name, const std::string& value);

}  // namespace kiri::cli
