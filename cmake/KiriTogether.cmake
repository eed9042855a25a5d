# Several sources compiled at once, in builds in which nobody edits.
# SPDX-License-Identifier: MIT

set(KIRI_TOGETHER "" CACHE STRING "What is compiled several sources at once: nothing (empty), tests or all")
set_property(CACHE KIRI_TOGETHER PROPERTY STRINGS "" tests all)

# Half of the compiler's time goes into headers: eight sources of a target are compiled at once. That names in unnamed
# namespaces of one room differ is good for readers too.
function(kiri_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  # A class that a source defines for itself may hold what is in the unnamed namespace of that source; here it
  # looks like a header's.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# Sources of the product: in the release build each is compiled by itself, which proves that its header stands alone.
function(kiri_layer_together target)
  if(KIRI_TOGETHER STREQUAL "all")
    kiri_compile_together(${target})
  endif()
endfunction()

# Sources of tests, which take as long to compile as the product and then run once.
function(kiri_test_together target)
  if(KIRI_TOGETHER)
    kiri_compile_together(${target})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()
