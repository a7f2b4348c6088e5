# SPDX-License-Identifier: Apache-2.0
# Installs to an empty prefix, then uses that installation as others would: every library, a driver of one's own.
# cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DFLAGS=... -P install_and_build.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)

set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_EXE_LINKER_FLAGS=${LINKER_FLAGS})
run(${configure} -B ${WORK}/build)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
execute_process(COMMAND ${configure} -B ${WORK}/both -DLINK_BOTH=ON RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
if(status EQUAL 0 OR NOT said MATCHES "HAPTICELL_LINKED")
  message(FATAL_ERROR "a program could link the engine and its libraries both: ${said}")
endif()

# A driver of somebody else, built with nothing but the installed headers, as docs/library/drivers.md says, then found and driven.
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/../../examples/driver -B ${WORK}/driver
  -DHAPTICELL_INCLUDE=${WORK}/prefix/include/hapticell -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/driver)
set(ENV{HAPTICELL_DRIVERS} ${WORK}/driver)
run(${WORK}/prefix/bin/hapticell-cli devices --json ${WORK}/devices.json)
file(READ ${WORK}/devices.json listed)
if(NOT listed MATCHES "\"device\": ?\"orbit:first\"")
  message(FATAL_ERROR "the example driver is not listed: ${listed}")
endif()
run(${WORK}/prefix/bin/hapticell-haptic-server --port 0 --device orbit --seconds 0.3)
file(REMOVE_RECURSE ${WORK})
