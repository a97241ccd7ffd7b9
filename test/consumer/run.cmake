# Configures, builds and runs the consumer in the current folder.
#
# WAY: find_package, compiled, add_subdirectory or FetchContent; SOURCE_DIR, BINARY_DIR: the package's; the others: as the
# package's own build has them. With find_package the package is installed first; the consumer is configured with it there,
# and once more, and built, after it was moved to another folder. With compiled, the compiled library is built and installed
# first.

foreach(variable IN ITEMS WAY SOURCE_DIR BINARY_DIR GENERATOR CXX_COMPILER VERSION)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "${variable} is not given")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

set(folder "${CMAKE_CURRENT_BINARY_DIR}")
file(REMOVE_RECURSE "${folder}/build" "${folder}/library" "${folder}/installed" "${folder}/moved here")
unset(ENV{DESTDIR})

set(options
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DLAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DANIMATED_MESH_FEATURES_WITH_TBB=${WITH_TBB}"
  "-DEXPECT_TBB=${EXPECT_TBB}"
  "-DWAY=${WAY}"
  "-DVERSION=${VERSION}"
  # The consumer has no build type on purpose: see there.
  -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON)
foreach(package IN ITEMS CGAL Eigen3 Boost TBB)
  if(${package}_DIR)
    list(APPEND options "-D${package}_DIR=${${package}_DIR}")
  endif()
endforeach()

function(configure)
  run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/test/consumer" -B "${folder}/build" -G "${GENERATOR}" ${options} ${ARGN})
endfunction()

if(WAY STREQUAL "find_package")
  run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${folder}/installed" --component development)
  configure("-DCMAKE_PREFIX_PATH=${folder}/installed" "-DINSTALLED=${folder}/installed")
  file(REMOVE_RECURSE "${folder}/build")
  file(RENAME "${folder}/installed" "${folder}/moved here")
  configure("-DCMAKE_PREFIX_PATH=${folder}/moved here" "-DINSTALLED=${folder}/moved here")
elseif(WAY STREQUAL "compiled")
  # As one unit and without optimisation: that is compiled most quickly.
  run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${folder}/library" -G "${GENERATOR}" ${options}
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_UNITY_BUILD=ON
    -DANIMATED_MESH_FEATURES_BUILD_COMPILED=ON -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF
    -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF)
  run("${CMAKE_COMMAND}" --build "${folder}/library" --target Animated_mesh_features_compiled)
  run("${CMAKE_COMMAND}" --install "${folder}/library" --prefix "${folder}/installed" --component development)
  configure("-DCMAKE_PREFIX_PATH=${folder}/installed")
else()
  configure("-DSOURCE_DIR=${SOURCE_DIR}")
endif()
run("${CMAKE_COMMAND}" --build "${folder}/build")

find_program(consumer NAMES consumer PATHS "${folder}/build" "${folder}/build/Debug" NO_DEFAULT_PATH REQUIRED)
run("${consumer}")
