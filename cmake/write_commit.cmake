# SPDX-License-Identifier: Apache-2.0
# Writes the header that names the commit: cmake -DSOURCE=... -DHEADER=... -P write_commit.cmake. It is written only where the
# commit has become another one. HAPTICELL_COMMIT in the environment goes before, for builds from a release's files.
set(commit "$ENV{HAPTICELL_COMMIT}")
if(commit STREQUAL "")
  find_program(GIT git)
  if(GIT AND EXISTS "${SOURCE}/.git")
    execute_process(COMMAND "${GIT}" -C "${SOURCE}" rev-parse --short=12 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
endif()
if(NOT commit MATCHES "^[0-9a-f]+$")
  set(commit unknown)
endif()
set(text "#define HAPTICELL_COMMIT \"${commit}\"\n")
set(before "")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" before)
endif()
if(NOT before STREQUAL text)
  file(WRITE "${HEADER}" "${text}")
endif()
