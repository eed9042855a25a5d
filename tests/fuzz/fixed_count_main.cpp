// Drives a fuzz target without libFuzzer: over the files that are named, else over a fixed count of
// inputs that are the same on every machine. Usage: PROGRAM [FILE...] SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr int kInputs = 150;
constexpr std::size_t kLongest = 48;

/// The next number of a small generator (xorshift), so that inputs do not hang on the library.
std::uint32_t next(std::uint32_t& state) {
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}

int runFile(const char* name) {
  std::ifstream file(name, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "cannot read %s\n", name);
    return 2;
  }
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)),
                                std::istreambuf_iterator<char>());
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
  return LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int count, char** names) {
  for (int i = 1; i < count; ++i) {
    if (const int failed = runFile(names[i]); failed != 0) return failed;
  }
  if (count > 1) return 0;
  std::uint32_t state = 2463534242u;
  std::vector<std::uint8_t> input;
  for (int i = 0; i < kInputs; ++i) {
    // Every fourth input is new; the others change a few bytes of the one before, as fuzzers do.
    if (i % 4 == 0) {
      input.assign(2 + next(state) % (kLongest - 1), 0);
      for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(next(state));
    } else {
      for (int k = 0; k < 3; ++k) {
        input[next(state) % input.size()] = static_cast<std::uint8_t>(next(state));
      }
    }
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%d inputs\n", kInputs);
  return 0;
}
