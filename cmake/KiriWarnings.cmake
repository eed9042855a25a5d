# The warnings of our own code, as a target: kiri_warnings.
# SPDX-License-Identifier: MIT

add_library(kiri_warnings INTERFACE)
target_compile_options(
  kiri_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wconversion
            -Wsign-conversion
            -Wshadow
            -Wold-style-cast
            -Wdouble-promotion
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            # g++ 12 is wrong about these two: std::variant members and std::string + (bug 105329).
            # Both are found for true by the sanitizers.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            $<$<BOOL:${KIRI_WERROR}>:-Werror>)
