# SPDX-License-Identifier: Apache-2.0
# What every target of the project shares.
include(GNUInstallDirs)
find_package(Threads REQUIRED)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)  # By 8 a sixth more to compile; more than 16 make an edit of one source slow to try.

find_program(HAPTICELL_CCACHE ccache)
if(HAPTICELL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this ccache leaves out whatever uses a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${HAPTICELL_CCACHE}")
endif()

find_program(HAPTICELL_LLD ld.lld)
if(HAPTICELL_LLD)  # Some hundred programs are linked: a fraction of the time of GNU's linker.
  add_link_options(-fuse-ld=lld)
endif()

# Of a function whose unlikely part is unreachable g++ leaves an empty piece with an unwind entry of its own, at the address
# of the piece that follows. Where that one throws, the unwinder takes the empty entry, finds nothing that goes on, and the
# program ends. tests/architecture/unwind_entries.py sees to it that no such entry is left.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-reorder-blocks-and-partition>)

add_library(hapticell_warnings INTERFACE)
target_compile_options(hapticell_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # Of several sources in one, g++ takes all but the first for headers, and warns of what headers should not have.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
  # g++ 12 sees an overlap in `"text" + std::string` that is not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${HAPTICELL_WARNINGS_AS_ERRORS}>:-Werror>)

# For what has a precompiled header: with one, g++ 12 gives other names to that overlap.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  set(HAPTICELL_PRECOMPILED_WARNINGS -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
endif()

# Linked by whatever includes asio, Boost's or its own: it decides by what a source included before it whether it allocates
# by aligned_alloc() or by operator new, and all must decide alike, or one source frees what another made.
# tests/architecture/asio_users.py sees to it.
add_library(hapticell_asio INTERFACE)
target_compile_definitions(hapticell_asio INTERFACE ASIO_DISABLE_STD_ALIGNED_ALLOC BOOST_ASIO_DISABLE_STD_ALIGNED_ALLOC)

# For sources that call what dlsym() finds: C functions, of whose types clang's -fsanitize=function knows nothing.
set(HAPTICELL_CALLS_FOUND_SYMBOLS $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=function>)

# What most sources without Qt include, parsed once for all libraries. The preset `dev` does without, so that each source
# still names what it uses.
find_package(glm REQUIRED)
find_package(tl-expected REQUIRED)
set(HAPTICELL_COMMON_HEADERS <glm/glm.hpp> <glm/gtc/quaternion.hpp> <tl/expected.hpp> <algorithm> <array> <cmath> <cstdint>
  <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers> <optional> <span> <string> <string_view> <utility> <vector>)
add_library(hapticell_common_headers OBJECT EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/cmake/common_headers.cpp")
target_compile_definitions(hapticell_common_headers PRIVATE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)  # As geometry's.
target_link_libraries(hapticell_common_headers PRIVATE glm::glm tl::expected hapticell_warnings)
target_precompile_headers(hapticell_common_headers PRIVATE ${HAPTICELL_COMMON_HEADERS})
# Folders, parted by ";", whose libraries are compiled without the sanitizers that the flags ask for: they compute from values
# that others have read, and sanitizers make them three times as long to compile and to run (preset `input`).
set(HAPTICELL_UNSANITIZED_FOLDERS "" CACHE STRING "Folders compiled without the sanitizers of the flags")
if(HAPTICELL_UNSANITIZED_FOLDERS)
  add_library(hapticell_unsanitized_headers OBJECT EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/cmake/common_headers.cpp")
  target_compile_definitions(hapticell_unsanitized_headers PRIVATE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)
  target_compile_options(hapticell_unsanitized_headers PRIVATE -fno-sanitize=all)
  target_link_libraries(hapticell_unsanitized_headers PRIVATE glm::glm tl::expected hapticell_warnings)
  target_precompile_headers(hapticell_unsanitized_headers PRIVATE ${HAPTICELL_COMMON_HEADERS})
endif()

# Another build folder of the same sources, whose libraries of these folders are taken instead of being compiled again: they
# are the ones that ./check has made. g++ and clang call each other by the same rules, and both use libstdc++.
set(HAPTICELL_BUILT "" CACHE PATH "A build folder from which the libraries of HAPTICELL_UNSANITIZED_FOLDERS are taken")

# hapticell_find_headers(HEADERS): which precompiled headers a library of the present folder takes.
function(hapticell_find_headers headers)
  set(${headers} hapticell_common_headers PARENT_SCOPE)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE folder)
  foreach(unsanitized IN LISTS HAPTICELL_UNSANITIZED_FOLDERS)
    cmake_path(IS_PREFIX unsanitized "${folder}" is_within)
    if(is_within)
      set(${headers} hapticell_unsanitized_headers PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

add_executable(hapticell_program_headers EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/cmake/program_headers.cpp")  # A program's flags are others.
target_compile_definitions(hapticell_program_headers PRIVATE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)
target_link_libraries(hapticell_program_headers PRIVATE glm::glm tl::expected hapticell_warnings)
target_precompile_headers(hapticell_program_headers PRIVATE ${HAPTICELL_COMMON_HEADERS})

# For what waits for the user, files or the network: a fifth to a third less to compile than by -O3, and nobody feels the
# difference. Of an inline function that two libraries both hold, the linker takes the first: hapticell::engine holds these
# libraries after all others. A program that links the engine's static libraries has others first, too, or feels nothing.
# With less known of the flow, g++ warns of values that are always set.
set(HAPTICELL_SELDOM_RUN "$<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>")

# What the sources of all libraries are compiled for: another program's sources find the headers as <folder/file.h>.
add_library(hapticell_interface INTERFACE)
add_library(hapticell::interface ALIAS hapticell_interface)
set_target_properties(hapticell_interface PROPERTIES EXPORT_NAME interface)
target_include_directories(hapticell_interface INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/hapticell>)
target_compile_features(hapticell_interface INTERFACE cxx_std_20)
target_compile_definitions(hapticell_interface INTERFACE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)
target_link_libraries(hapticell_interface INTERFACE glm::glm tl::expected)

# A program links the engine's folders as libraries of their own, or all of them as hapticell::engine; with both it would
# have two of each state. CMake refuses what links both.
function(hapticell_linked_as target way)
  set_target_properties(${target} PROPERTIES INTERFACE_HAPTICELL_LINKED ${way} COMPATIBLE_INTERFACE_STRING HAPTICELL_LINKED)
endfunction()

# hapticell_add_library(NAME [INTERNAL] [SELDOM_RUN] SOURCES ... [HEADERS ...] [PUBLIC libs...] [PRIVATE libs...]
#                       [PRECOMPILED <headers>...])
#
# A library with the alias hapticell::NAME. HEADERS are public (docs/library/index.md): they are installed, and what they declare is
# seen outside of hapticell::engine. They are found as "folder/file.h" from the project's root, and as <folder/file.h> under
# include/hapticell once installed. Headers that only the project uses stand among the SOURCES. INTERNAL: for the project's own
# programs; it is neither installed nor part of hapticell::engine. SELDOM_RUN: HAPTICELL_SELDOM_RUN. Sources with
# flags of their own skip what is precompiled.
function(hapticell_add_library name)
  cmake_parse_arguments(ARG "INTERNAL;SELDOM_RUN" "" "SOURCES;HEADERS;PUBLIC;PRIVATE;PRECOMPILED" ${ARGN})
  set(target hapticell_${name})
  hapticell_find_headers(headers)
  set(built "")
  if(HAPTICELL_BUILT AND headers STREQUAL hapticell_unsanitized_headers)
    set(ARG_SOURCES "${PROJECT_SOURCE_DIR}/cmake/common_headers.cpp")  # Which is empty.
    set(ARG_PRECOMPILED "")
    cmake_path(RELATIVE_PATH CMAKE_CURRENT_BINARY_DIR BASE_DIRECTORY "${PROJECT_BINARY_DIR}" OUTPUT_VARIABLE folder)
    set(built "${HAPTICELL_BUILT}/${folder}/${CMAKE_STATIC_LIBRARY_PREFIX}${target}${CMAKE_STATIC_LIBRARY_SUFFIX}")
    list(PREPEND ARG_PUBLIC $<BUILD_INTERFACE:${built}>)
  endif()
  add_library(${target} STATIC ${ARG_SOURCES} ${ARG_HEADERS})
  add_library(hapticell::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(${target} PUBLIC hapticell::interface ${ARG_PUBLIC}
    PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:hapticell_warnings>)
  target_compile_options(${target} PRIVATE ${HAPTICELL_PRECOMPILED_WARNINGS})
  set(engine_part HAPTICELL_ENGINE_LIBRARIES)
  if(ARG_SELDOM_RUN)
    target_compile_options(${target} PRIVATE ${HAPTICELL_SELDOM_RUN})
    set(engine_part HAPTICELL_SELDOM_RUN_LIBRARIES)
  endif()
  if(headers STREQUAL hapticell_unsanitized_headers)
    target_compile_options(${target} PRIVATE -fno-sanitize=all)
  endif()
  if(ARG_PRECOMPILED)  # Besides the common ones; such a library parses its own.
    target_precompile_headers(${target} PRIVATE ${HAPTICELL_COMMON_HEADERS} ${ARG_PRECOMPILED})
  else()
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
  if(ARG_INTERNAL OR HAPTICELL_SERVER_ONLY)
    return()
  endif()
  hapticell_linked_as(${target} static)
  set_property(GLOBAL APPEND PROPERTY HAPTICELL_BUILT_LIBRARIES ${built})
  set_property(GLOBAL APPEND PROPERTY HAPTICELL_LIBRARIES ${target})
  set_property(GLOBAL APPEND PROPERTY ${engine_part} ${target})
  foreach(header IN LISTS ARG_HEADERS)
    cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE folder)
    cmake_path(GET header PARENT_PATH below)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hapticell/${folder}/${below})
  endforeach()
endfunction()

# hapticell_add_bundle(NAME LIBRARY...): hapticell::NAME stands for all libraries of a folder's sub-folders.
function(hapticell_add_bundle name)
  set(target hapticell_${name})
  add_library(${target} INTERFACE)
  add_library(hapticell::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  list(TRANSFORM ARGN PREPEND hapticell::)
  target_link_libraries(${target} INTERFACE ${ARGN})
  set_property(GLOBAL APPEND PROPERTY HAPTICELL_LIBRARIES ${target})
endfunction()

# hapticell_add_executable(NAME SOURCES ... [LIBRARIES ...] [WITHOUT_HEADERS]): a program in bin/. One with Qt, or without the
# geometry, is compiled by flags with which the common precompiled headers do not go.
function(hapticell_add_executable name)
  cmake_parse_arguments(ARG "WITHOUT_HEADERS" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} hapticell_warnings)
  if(NOT ARG_WITHOUT_HEADERS)
    target_compile_options(${name} PRIVATE ${HAPTICELL_PRECOMPILED_WARNINGS})
    target_precompile_headers(${name} REUSE_FROM hapticell_program_headers)
  endif()
endfunction()
