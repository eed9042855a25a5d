# The preset asan: address and undefined-behaviour sanitizers on everything that is compiled.
# SPDX-License-Identifier: MIT

option(KIRI_SANITIZED "Build with the address and undefined-behaviour sanitizers" OFF)
if(KIRI_SANITIZED)
  # Left out are checks that double the time to compile and find nothing more here: a null pointer and a wrong
  # object size stop at the address sanitizer, and without casts between object types (tools/check_architecture.py
  # looks for them) there is no wrong alignment and no wrong virtual table.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,object-size,alignment,vptr
                      -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  if(KIRI_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
endif()

# Half of the compiler's time goes into headers, and nobody edits in the sanitized build: it compiles eight sources of
# a target at once. That names in unnamed namespaces of one room differ is good for readers too.
function(kiri_compile_together target)
  if(KIRI_SANITIZED)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # A class that a source defines for itself may hold what is in the unnamed namespace of that source; here it
    # looks like a header's.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()
