// Lists of panel numbers as people write them: "first,2,4-7,last".
// SPDX-License-Identifier: MIT
#include "apps/cli/number_list.h"

#include <algorithm>
#include <optional>

namespace kiri::cli {

namespace {

std::optional<std::size_t> numberOf(const std::string& text, std::size_t last) {
  if (text == "first") return 1;
  if (text == "last") return last;
  constexpr std::size_t kMostDigits = 9;
  if (text.empty() || text.size() > kMostDigits) return std::nullopt;
  std::size_t out = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    out = out * 10 + static_cast<std::size_t>(c - '0');
  }
  return out;
}

}  // namespace

Result<std::vector<std::size_t>> parseNumberList(const std::string& text, std::size_t last) {
  std::vector<std::size_t> out;
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    at = end + 1;
    const std::size_t dash = part.find('-');
    const bool isAll = part == "all";
    const std::optional<std::size_t> from = isAll ? 1 : numberOf(part.substr(0, dash), last);
    const std::optional<std::size_t> to = isAll ? last
                                          : dash == std::string::npos
                                              ? from
                                              : numberOf(part.substr(dash + 1), last);
    if (!from || !to) {
      return Error{ErrorCode::BadValue, "\"" + part +
                                            "\" is no panel; write numbers, ranges and "
                                            "names like first,2,4-7,last"};
    }
    for (const std::size_t number : {*from, *to}) {
      if (number >= 1 && number <= last) continue;
      return Error{ErrorCode::BadValue, "there is no panel " + std::to_string(number) +
                                            "; the panels are 1 to " + std::to_string(last)};
    }
    if (*from > *to) {
      return Error{ErrorCode::BadValue,
                   "the range " + part + " runs backwards; write the lower number first"};
    }
    for (std::size_t i = *from; i <= *to; ++i) out.push_back(i);
  }
  return out;
}

}  // namespace kiri::cli
