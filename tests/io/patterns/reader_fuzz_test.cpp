// Thousands of damaged files of each format: a drawing or a sentence, soon, and never anything
// else. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/creases/repair.h"
#include "core/flatfold/local_conditions.h"
#include "io/file.h"
#include "io/patterns/pattern_file.h"
#include "io/patterns/plain_number.h"
#include "tests/support/pattern_damage.h"

namespace kiri {
namespace {

using test::PatternSeeds;

/// KIRI_FUZZ_COUNT=100000 makes the long run.
int caseCount() {
  const char* wanted = std::getenv("KIRI_FUZZ_COUNT");
  constexpr int kUsual = 1500;
  return wanted != nullptr ? std::atoi(wanted) : kUsual;
}

class RandomDamage : public test::DamageSource {
 public:
  explicit RandomDamage(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t count) override { return random_() % count; }

 private:
  std::mt19937_64 random_;
};

/// Real files of the format beside the checkout, small ones, in a fixed order.
std::vector<std::string> realTexts(const PatternSeeds& seeds) {
  std::vector<std::filesystem::path> paths;
  const std::filesystem::path root = KIRI_SOURCE_DIR "/../shared/data/formats";
  if (!std::filesystem::is_directory(root)) return {};
  constexpr std::uintmax_t kSmall = 12'000;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_regular_file() && entry.file_size() < kSmall &&
        patternFormatOf(entry.path().string()) == patternFormatOf(seeds.fileName)) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> out;
  for (const std::filesystem::path& path : paths) {
    const Result<std::string> text = readFile(path.string());
    if (text) out.push_back(*text);
  }
  return out;
}

void expectDrawable(const PatternFile& file, const std::string& text) {
  ASSERT_FALSE(file.drawing.lines.empty()) << text;
  for (const DrawnCrease& line : file.drawing.lines) {
    for (const double number : {line.from.x, line.from.y, line.to.x, line.to.y}) {
      ASSERT_TRUE(isDrawable(number)) << text;
    }
    ASSERT_LE(std::abs(line.angle.value_or(0)), 180) << text;
  }
}

/// What a program does with a drawing that it has read.
void goTheWholeWay(const PatternFile& file, int number) {
  // Lines that cross all over take their time: large drawings every now and then only.
  const std::size_t mostLines = number % 20 == 0 ? 400 : 60;
  if (file.drawing.lines.size() > mostLines) return;
  const Result<RepairedPattern> pattern = patternOf(file.drawing);
  if (pattern) vertexFaults(pattern->creases);
}

class PatternReaderFuzz : public testing::TestWithParam<std::size_t> {};

TEST_P(PatternReaderFuzz, EveryDamagedFileGivesADrawingOrASentenceSoon) {
  const PatternSeeds& seeds = test::patternSeeds()[GetParam()];
  std::vector<std::string> texts = seeds.texts;
  const std::vector<std::string> real = realTexts(seeds);
  texts.insert(texts.end(), real.begin(), real.end());
  const int count = caseCount();
  int readable = 0;
  double longest = 0;
  for (int i = 0; i < count; ++i) {
    RandomDamage source(static_cast<std::uint64_t>(i) + 1);
    // Our own small seeds come as often as all real files together.
    const std::size_t pick =
        source.below(2) == 0 ? source.below(seeds.texts.size()) : source.below(texts.size());
    std::string text = texts[pick];
    for (std::size_t k = source.below(5); k-- > 0;) test::damage(text, seeds.tokens, source);
    // Of the processor, for other work on the machine is not the reader's fault.
    const std::clock_t start = std::clock();
    SCOPED_TRACE("case " + std::to_string(i) + " of " + seeds.fileName);
    const Result<PatternFile> file = readPattern(text, seeds.fileName);
    if (file) {
      ++readable;
      expectDrawable(*file, text);
      goTheWholeWay(*file, i);
    } else {
      ASSERT_EQ(file.error().message.rfind(seeds.fileName, 0), 0u) << file.error().message;
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    longest = std::max(longest, seconds);
    ASSERT_LT(seconds, 5) << text.substr(0, 2000);
    ASSERT_FALSE(HasFailure());
  }
  RecordProperty("longest_ms", static_cast<int>(longest * 1000));
  EXPECT_GT(readable, count / 20) << "the damages are small enough for some files to stay readable";
}

TEST_P(PatternReaderFuzz, EveryTruncatedFileGivesADrawingOrASentence) {
  const PatternSeeds& seeds = test::patternSeeds()[GetParam()];
  for (const std::string& text : seeds.texts) {
    for (std::size_t length = 0; length < text.size(); ++length) {
      const Result<PatternFile> file = readPattern(text.substr(0, length), seeds.fileName);
      if (file) {
        expectDrawable(*file, text.substr(0, length));
      } else {
        ASSERT_FALSE(file.error().message.empty());
      }
    }
    EXPECT_TRUE(readPattern(text, seeds.fileName).isOk()) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(AllFormats, PatternReaderFuzz, testing::Range<std::size_t>(0, 5),
                         [](const testing::TestParamInfo<std::size_t>& chosen) {
                           return std::string(test::patternSeeds()[chosen.param].fileName + 2);
                         });

}  // namespace
}  // namespace kiri
