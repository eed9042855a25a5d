# Packages from outside, found only when a room of the table asks for them. Reasons: docs/dependencies.md.
# SPDX-License-Identifier: MIT

# Sets <result> to the target that stands for the package named in the table.
macro(kiri_package name result)
  if("${name}" STREQUAL "nlohmann_json")
    find_package(nlohmann_json 3.11 REQUIRED)
    set(${result} nlohmann_json::nlohmann_json)
  elseif("${name}" STREQUAL "CLI11")
    find_package(CLI11 2.1 REQUIRED)
    set(${result} CLI11::CLI11)
  elseif("${name}" STREQUAL "cairo")
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(cairo REQUIRED IMPORTED_TARGET GLOBAL cairo cairo-pdf cairo-svg cairo-png)
    set(${result} PkgConfig::cairo)
  elseif("${name}" STREQUAL "libpng")
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(libpng REQUIRED IMPORTED_TARGET GLOBAL libpng)
    set(${result} PkgConfig::libpng)
  else()
    message(FATAL_ERROR "ARCHITECTURE.md names the package ${name}, which cmake/KiriPackages.cmake does not know")
  endif()
endmacro()
