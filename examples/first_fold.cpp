// The first fold: a square of paper, folded along its diagonal. README shows this program.
// SPDX-License-Identifier: MIT
#include <iostream>

#include "core/model/apply.h"

int main() {
  const kiri::FoldedState sheet = kiri::flatState(*kiri::squareSheet(150));  // mm
  kiri::FoldStep diagonal;
  diagonal.line.from = {0, 0};
  diagonal.line.to = {150, 150};
  kiri::Step step;
  step.action = diagonal;
  const kiri::Result<kiri::FoldedState> folded = kiri::apply(sheet, step, 1);
  if (!folded) {
    std::cerr << folded.error().message << "\n";
    return 1;
  }
  std::cout << folded->pattern.facets.size() << " facets, " << areaOf(folded->pattern) << " mm2\n";
}
