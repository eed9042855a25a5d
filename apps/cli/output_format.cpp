// Which kind of file a command writes: by --format, else by the ending of the name.
// SPDX-License-Identifier: MIT
#include "apps/cli/output_format.h"

#include <algorithm>
#include <cctype>

namespace kiri::cli {

namespace {

std::string listed(const std::vector<std::string>& known, const std::string& before) {
  std::string out;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (i > 0) out += i + 1 == known.size() ? " or " : ", ";
    out += before + known[i];
  }
  return out;
}

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string endingOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : lowered(name.substr(dot + 1));
}

Result<std::string> chooseFormat(const std::string& path, const std::string& format,
                                 const std::vector<std::string>& known) {
  const auto isKnown = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  if (!format.empty()) {
    if (isKnown(lowered(format))) return lowered(format);
    return Error{ErrorCode::BadValue,
                 "--format " + format + " is not known here; it takes " + listed(known, "")};
  }
  if (path == "-") {
    return Error{
        ErrorCode::BadValue,
        "standard output has no name to tell the format by; add --format " + listed(known, "")};
  }
  const std::string ending = endingOf(path);
  if (isKnown(ending)) return ending;
  return Error{ErrorCode::BadValue,
               path + (ending.empty() ? " has no ending" : " ends in ." + ending) +
                   "; this command writes " + listed(known, ".") + " (or say --format)"};
}

}  // namespace kiri::cli
