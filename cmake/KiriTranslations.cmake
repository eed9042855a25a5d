# The window in other languages: apps/desktop/translations/kirisim_CODE.ts, compiled into the program.
# SPDX-License-Identifier: MIT

# lupdate must know our own marks for sentences. After a sentence has changed: build the target
# kiri_lupdate, translate what is new (linguist, or any editor), and tests/apps/desktop/translations is content.
set(KIRI_LUPDATE_OPTIONS
    -I ${PROJECT_SOURCE_DIR} -locations none -no-obsolete -source-language en
    -tr-function-alias QT_TRANSLATE_NOOP+=KIRI_TEXT -tr-function-alias QT_TR_NOOP+=KIRI_ACTION
    ${PROJECT_SOURCE_DIR}/apps/desktop ${PROJECT_SOURCE_DIR}/editor)

function(kiri_translations target)
  find_package(Qt6 6.4 QUIET COMPONENTS LinguistTools)
  if(NOT Qt6LinguistTools_FOUND)
    message(FATAL_ERROR "Qt's LinguistTools are missing (qt6-tools-dev, qt6-l10n-tools; ./kirisim installs them)")
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/apps/desktop/translations/*.ts)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/translations)
  set(compiled)
  set(lines "<RCC><qresource prefix=\"/translations\">\n")
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    add_custom_command(
      OUTPUT ${folder}/${name}.qm
      COMMAND Qt6::lrelease -silent ${source} -qm ${folder}/${name}.qm
      DEPENDS ${source})
    list(APPEND compiled ${folder}/${name}.qm)
    string(APPEND lines "<file>${name}.qm</file>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/kirisim_translations.qrc CONTENT "${lines}</qresource></RCC>\n")
  add_custom_command(
    OUTPUT ${folder}/qrc_kirisim_translations.cpp
    COMMAND Qt6::rcc --name kirisim_translations ${folder}/kirisim_translations.qrc
            -o ${folder}/qrc_kirisim_translations.cpp
    DEPENDS ${compiled} ${folder}/kirisim_translations.qrc)
  target_sources(${target} PRIVATE ${folder}/qrc_kirisim_translations.cpp)
  set_source_files_properties(${folder}/qrc_kirisim_translations.cpp PROPERTIES SKIP_AUTOGEN ON)
  add_custom_target(kiri_lupdate COMMAND Qt6::lupdate ${KIRI_LUPDATE_OPTIONS} -ts ${sources} VERBATIM)
endfunction()
