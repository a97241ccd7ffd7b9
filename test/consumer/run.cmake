# Installs the package if need be, then configures, builds and runs the consumer in the current folder.
#
# WAY: find_package, relocated (installed, then moved to another folder), add_subdirectory or FetchContent;
# SOURCE_DIR, BINARY_DIR: the package's; the others: as the package's own build has them.

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
file(REMOVE_RECURSE "${folder}/build" "${folder}/installed" "${folder}/moved here")
unset(ENV{DESTDIR})

set(way ${WAY})
set(installed "")
if(WAY STREQUAL "find_package" OR WAY STREQUAL "relocated")
  set(way find_package)
  set(installed "${folder}/installed")
  run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${installed}" --component development)
  if(WAY STREQUAL "relocated")
    file(RENAME "${installed}" "${folder}/moved here")
    set(installed "${folder}/moved here")
  endif()
endif()

set(options
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DLAUNCHER=${CXX_COMPILER_LAUNCHER}"
  "-DANIMATED_MESH_FEATURES_WITH_TBB=${WITH_TBB}"
  "-DEXPECT_TBB=${EXPECT_TBB}"
  "-DWAY=${way}"
  "-DVERSION=${VERSION}"
  # The consumer has no build type on purpose: see there.
  -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON)
foreach(package IN ITEMS CGAL Eigen3 Boost TBB)
  if(${package}_DIR)
    list(APPEND options "-D${package}_DIR=${${package}_DIR}")
  endif()
endforeach()
if(installed)
  list(APPEND options "-DCMAKE_PREFIX_PATH=${installed}" "-DINSTALLED=${installed}")
else()
  list(APPEND options "-DSOURCE_DIR=${SOURCE_DIR}")
endif()

run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/test/consumer" -B "${folder}/build" -G "${GENERATOR}" ${options})
run("${CMAKE_COMMAND}" --build "${folder}/build")

find_program(consumer NAMES consumer PATHS "${folder}/build" "${folder}/build/Debug" NO_DEFAULT_PATH REQUIRED)
run("${consumer}")
