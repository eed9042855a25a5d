// Crease patterns of other programs: any bytes give a drawing or a sentence, and what was drawn
// can be repaired and checked. SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>

#include "core/creases/repair.h"
#include "core/flatfold/local_conditions.h"
#include "io/patterns/pattern_file.h"
#include "tests/support/pattern_damage.h"

namespace {

/// Decisions from the bytes of the input, two for each.
class BytesDamage : public kiri::test::DamageSource {
 public:
  BytesDamage(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool isEmpty() const { return at_ >= size_; }
  std::size_t below(std::size_t count) override { return (next() * 256 + next()) % count; }

 private:
  std::size_t next() { return at_ < size_ ? data_[at_++] : 0; }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace

/// The first byte chooses the format; when it is even the rest is how to damage a seed, else it is
/// the file itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kiri;
  if (size < 2) return 0;
  const test::PatternSeeds& seeds = test::patternSeeds()[data[0] / 2 % 5];
  std::string text;
  if (data[0] % 2 == 0) {
    BytesDamage source(data + 1, size - 1);
    text = seeds.texts[source.below(seeds.texts.size())];
    while (!source.isEmpty()) test::damage(text, seeds.tokens, source);
  } else {
    for (std::size_t i = 1; i < size; ++i) text += static_cast<char>(data[i]);
  }
  const Result<PatternFile> file = readPattern(text, seeds.fileName);
  constexpr std::size_t kMostLines = 400;
  if (!file || file->drawing.lines.size() > kMostLines) return 0;
  const Result<RepairedPattern> pattern = patternOf(file->drawing);
  if (pattern) vertexFaults(pattern->creases);
  return 0;
}
