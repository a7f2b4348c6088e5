# SPDX-License-Identifier: Apache-2.0
# Installs to an empty prefix, builds examples/ against it as their README.md says, runs each and looks at what it prints.
# cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCOMPILER=... -DFLAGS=... -P run_examples.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()

# example(NAME [ARGUMENT...] PRINTS REGEX...): it ends well and prints what each of them describes.
function(example name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "PRINTS")
  execute_process(COMMAND ${WORK}/build/${name} ${ARG_UNPARSED_ARGUMENTS} TIMEOUT 60 RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name} ended with ${status}:\n${output}${said}")
  endif()
  foreach(wanted IN LISTS ARG_PRINTS)
    if(NOT output MATCHES "${wanted}")
      message(FATAL_ERROR "${name} does not print \"${wanted}\":\n${output}${said}")
    endif()
  endforeach()
  message(STATUS "${name}\n${output}")
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/examples -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)

# Spheres are of triangles, which lie within the true ones by a few tenths of a millimetre.
example(mesh_distance PRINTS "0\\.0 +50\\.[0-9]+ +0\\.0 0\\.0 10\\.0" "is inside the plate")
example(inverse_kinematics ${SOURCE}/examples/data/arm.urdf
  PRINTS "nearest to rest: solved, off by 0\\.0000" "the tip stands at 0\\.4500 0\\.2000 0\\.3500")
example(mannequin_reach PRINTS "P5F +1\\.5[0-9]" "P95M +1\\.8[0-9]" "grasps up to [12]\\.[0-9]+ m")
example(posture_score PRINTS "standing +RULA 3  REBA  1  OWAS 1121" "stooping +RULA 6  REBA  7  OWAS 2121" "bent by 60 degrees: REBA 3")
example(retime_path PRINTS "as fast as can be" "at 100 mm/s +6\\.[0-9]+ s" "of the limits: (9[0-9]|100) %|(9[0-9]|100) % of the acc")
# 150 g weigh 1.47 N.
example(own_device_force_loop PRINTS "1500 ms: height +-[12]\\.[0-9]+ mm, force +1\\.4[0-9] N")
example(haptic_client PRINTS "connected to" "the wall is felt")
# The drawer's front is 200 mm before its middle, the post's face 25 mm before its own: it stops at 0.275 m.
example(own_manipulator PRINTS "hand at 0\\.24 m, drawer at 0\\.240 m" "hand at 0\\.64 m, drawer at 0\\.27[45] m")
example(read_step ${SOURCE}/tests/importer/references/part_plate.stp PRINTS "^step, 0\\.001 m per unit" "plate: [0-9]+ triangles")
# The box stands 50 mm high, its bottom 20 mm over the table; the hand would press it 10 mm deep.
example(session_without_window PRINTS "most force [1-6]\\.[0-9] N" "touched table from 1\\.[0-9]+ to [23]\\.[0-9]+ s" "deepest 0\\.0")
file(REMOVE_RECURSE ${WORK})
