// SPDX-License-Identifier: MIT
#include "core/layers/topmost.h"

#include <algorithm>
#include <set>

namespace kiri {

std::vector<std::size_t> topmost(const std::vector<Cover>& covers, int count, double tolerance) {
  std::vector<double> breaks;
  for (const Cover& c : covers) {
    breaks.push_back(c.from);
    breaks.push_back(c.to);
  }
  std::sort(breaks.begin(), breaks.end());
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i + 1] - breaks[i] <= tolerance) continue;
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    std::vector<std::pair<double, std::size_t>> here;
    for (const Cover& c : covers) {
      if (c.from < middle && middle < c.to) here.push_back({-c.height, c.id});
    }
    std::sort(here.begin(), here.end());
    for (std::size_t k = 0; k < here.size() && k < static_cast<std::size_t>(count); ++k) {
      chosen.insert(here[k].second);
    }
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace kiri
