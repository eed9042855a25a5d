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
