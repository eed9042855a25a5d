# Benchmarks: each folder below benchmarks/ that holds *_bench.cpp becomes one program.
# SPDX-License-Identifier: MIT

find_package(benchmark QUIET)
if(NOT benchmark_FOUND)
  message(STATUS "Google Benchmark not found: no benchmarks (./test installs it)")
  return()
endif()
if(NOT TARGET kiri_oracles)
  message(STATUS "no benchmarks without the tests' library of models (KIRI_TESTS, GoogleTest)")
  return()
endif()

file(GLOB_RECURSE bench_files RELATIVE ${PROJECT_SOURCE_DIR}/benchmarks CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/benchmarks/*_bench.cpp)
set(bench_rooms)
foreach(file IN LISTS bench_files)
  get_filename_component(room ${file} DIRECTORY)
  list(APPEND bench_rooms "${room}")
endforeach()
list(REMOVE_DUPLICATES bench_rooms)
kiri_all_layers(bench_layers)
foreach(room IN LISTS bench_rooms)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/benchmarks/${room}/*.cpp)
  string(REPLACE "/" "_" suffix ${room})
  add_executable(kiri_bench_${suffix} ${sources})
  target_include_directories(kiri_bench_${suffix} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(kiri_bench_${suffix} PRIVATE kiri_oracles ${bench_layers} kiri_warnings
                                             benchmark::benchmark_main)
endforeach()
