# SPDX-License-Identifier: Apache-2.0
# hapticell::engine: every library of the folders geometry ... feel as one shared library, for the project's own programs and
# for those of others (docs/library/index.md). The haptic server, the importer and the drivers link the libraries themselves:
# they are small and stand alone.
get_property(hapticell_engine_libraries GLOBAL PROPERTY HAPTICELL_ENGINE_LIBRARIES)
# Last: the linker takes the first of equal inline functions, and that has to be the faster one.
get_property(hapticell_seldom_run_libraries GLOBAL PROPERTY HAPTICELL_SELDOM_RUN_LIBRARIES)
list(APPEND hapticell_engine_libraries ${hapticell_seldom_run_libraries})

set(hapticell_engine_objects ${hapticell_engine_libraries})
list(TRANSFORM hapticell_engine_objects REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
add_library(hapticell_engine SHARED ${hapticell_engine_objects})
add_library(hapticell::engine ALIAS hapticell_engine)
set_target_properties(hapticell_engine PROPERTIES EXPORT_NAME engine OUTPUT_NAME hapticell-engine LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin" BUILD_RPATH "$ORIGIN" INSTALL_RPATH "$ORIGIN")
# The libraries once more, for what they link of others: all that they hold is there already.
target_link_libraries(hapticell_engine PRIVATE ${hapticell_engine_libraries} PUBLIC hapticell::interface)
# Those that another build has made, whole, after those of this one: of what both hold inline, this one's is taken.
get_property(hapticell_built_libraries GLOBAL PROPERTY HAPTICELL_BUILT_LIBRARIES)
if(hapticell_built_libraries)
  target_link_libraries(hapticell_engine PRIVATE -Wl,--whole-archive ${hapticell_built_libraries} -Wl,--no-whole-archive)
endif()
# Calls within the library are bound when it is linked, as in a program. What is not of hapticell's namespace is not shown.
set(hapticell_engine_symbols "${PROJECT_SOURCE_DIR}/cmake/engine_symbols.map")
target_link_options(hapticell_engine PRIVATE -Wl,-Bsymbolic-functions
  "-Wl,--version-script=${hapticell_engine_symbols}")
set_property(TARGET hapticell_engine PROPERTY LINK_DEPENDS "${hapticell_engine_symbols}")
hapticell_linked_as(hapticell_engine shared)
