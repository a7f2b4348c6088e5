# SPDX-License-Identifier: Apache-2.0
# cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DFLAGS=... -P install_and_build.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)

# A driver of somebody else, built with nothing but the installed headers, as docs/drivers.md says, then found and driven.
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/../../examples/driver -B ${WORK}/driver -DCMAKE_BUILD_TYPE=Release
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
