# How the command-line programs, the examples and the tests of this package are compiled.

function(animated_mesh_features_set_up target)
  target_link_libraries(${target} PRIVATE Animated_mesh_features::Animated_mesh_features)
  # The generators of test animations are shared by programs, examples and tests.
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/examples/Animated_mesh_features")
  target_compile_definitions(${target} PRIVATE ANIMATED_MESH_FEATURES_VERSION="${PROJECT_VERSION}")
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 $<$<BOOL:${ANIMATED_MESH_FEATURES_WERROR}>:/WX>)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra $<$<BOOL:${ANIMATED_MESH_FEATURES_WERROR}>:-Werror>)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ tells of this where it inlines, so that headers of CGAL and OpenMesh are not exempt although they are system
      # headers; theirs are false alarms.
      target_compile_options(${target} PRIVATE -Wno-error=maybe-uninitialized)
    endif()
  endif()
  if(ANIMATED_MESH_FEATURES_SANITIZE)
    # An undefined behaviour must end the program with an error, or no test would fail on it.
    target_compile_options(${target} PRIVATE
      -fsanitize=${ANIMATED_MESH_FEATURES_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
    target_link_options(${target} PRIVATE -fsanitize=${ANIMATED_MESH_FEATURES_SANITIZE})
    target_compile_definitions(${target} PRIVATE CGAL_ANIMATED_MESH_FEATURES_BASELINE_ONLY)
    if(ANIMATED_MESH_FEATURES_SANITIZE MATCHES "undefined")
      # CGAL 5.5's Eigen_sparse_matrix::swap(), in the heat method, swaps a bool that has no value yet.
      target_compile_options(${target} PRIVATE -fno-sanitize=bool)
      if(ANIMATED_MESH_FEATURES_SANITIZE MATCHES "address")
        # What is read or written out of place is found by the sanitizer of addresses; checks of every pointer before that
        # take more than half of the time that it takes to compile.
        target_compile_options(${target} PRIVATE -fno-sanitize=null,object-size,pointer-overflow)
      endif()
    endif()
    if(ANIMATED_MESH_FEATURES_SANITIZE MATCHES "thread")
      # Plain threads in the place of TBB: why is told there.
      target_include_directories(${target} BEFORE PRIVATE "${PROJECT_SOURCE_DIR}/test/thread_sanitizer")
      # CGAL's search trees would bring TBB's own headers beside them. Long tests leave out what is not parallel.
      target_compile_definitions(${target} PRIVATE CGAL_DISABLE_TBB_STRUCTURE_IN_KD_TREE
        ANIMATED_MESH_FEATURES_TEST_THREADS_ONLY)
    endif()
  endif()
endfunction()

option(ANIMATED_MESH_FEATURES_PRECOMPILE "Precompile what most units of programs and tests include" ON)

option(ANIMATED_MESH_FEATURES_UNITY "Compile each folder of the programs' sources as one unit" ON)

# What takes most of the time that a unit takes to be read.
set(animated_mesh_features_precompiled
  <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h> <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
  <algorithm> <iostream> <string> <vector>)

# animated_mesh_features_precompile(<target> [<other>]): precompiles it for the units of a target, or shares what was
# precompiled for another one, which is compiled with the same options.
function(animated_mesh_features_precompile target)
  if(ANIMATED_MESH_FEATURES_PRECOMPILE AND ARGC GREATER 1)
    target_precompile_headers(${target} REUSE_FROM ${ARGV1})
  elseif(ANIMATED_MESH_FEATURES_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${animated_mesh_features_precompiled})
  endif()
endfunction()

function(animated_mesh_features_add_executable target)
  add_executable(${target} ${ARGN})
  animated_mesh_features_set_up(${target})
endfunction()

# Compiles quickly rather than to run quickly, and with all assertions: these come after CMAKE_CXX_FLAGS_<CONFIG> on the
# command line.
function(animated_mesh_features_keep_checks target)
  if(NOT MSVC)
    separate_arguments(optimization UNIX_COMMAND "${ANIMATED_MESH_FEATURES_TEST_OPTIMIZATION}")
    target_compile_options(${target} PRIVATE ${optimization} -UNDEBUG)
  endif()
endfunction()

# animated_mesh_features_check(<target>): for examples and tests, all checks. They share the compiled library, with the same
# checks, in place of compiling the same detection each; one that is to be installed has none, and is not theirs.
function(animated_mesh_features_check target)
  animated_mesh_features_keep_checks(${target})
  if(NOT ANIMATED_MESH_FEATURES_BUILD_COMPILED)
    target_link_libraries(${target} PRIVATE Animated_mesh_features_compiled)
  endif()
endfunction()

if(NOT ANIMATED_MESH_FEATURES_BUILD_COMPILED)
  animated_mesh_features_set_up(Animated_mesh_features_compiled)
  animated_mesh_features_keep_checks(Animated_mesh_features_compiled)
endif()

# Programs under sanitizers run several times longer.
set(ANIMATED_MESH_FEATURES_TEST_TIMEOUT 300)
if(ANIMATED_MESH_FEATURES_SANITIZE)
  set(ANIMATED_MESH_FEATURES_TEST_TIMEOUT 1200)
endif()

# A CTest test with a folder of its own to run in, so that tests can run beside each other whatever files they write.
# Exit code 77 means: could not run here.
function(animated_mesh_features_add_test name)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/run/${name}")
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY "${folder}")
  set_tests_properties(${name} PROPERTIES
    TIMEOUT ${ANIMATED_MESH_FEATURES_TEST_TIMEOUT}
    SKIP_RETURN_CODE 77)
  if(ANIMATED_MESH_FEATURES_SANITIZE MATCHES "address")
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT
      "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/test/leaks_of_libraries.supp:print_suppressions=0")
  endif()
endfunction()
