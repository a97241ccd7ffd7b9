# What the Python module needs: a Python with NumPy, its headers, and pybind11's.
#
# Sets Animated_mesh_features_python to whether the module is built, and then
#   Animated_mesh_features_PYTHON        the interpreter
#   Animated_mesh_features_PYTHON_SUFFIX the ending of its extension modules
# and defines the target Animated_mesh_features_pybind11; else Animated_mesh_features_python_missing tells why it is not.
#
# CMake's own FindPython takes the newest Python, which need not be the one that has NumPy; here the first one does that
# has it: python3 on the path, or Debian's. NumPy is needed to run the module, not to build it: whoever sets
# ANIMATED_MESH_FEATURES_PYTHON, or FindPython's Python_EXECUTABLE, as scikit-build-core does for pip, may have it later.

set(ANIMATED_MESH_FEATURES_PYTHON "${Python_EXECUTABLE}" CACHE FILEPATH
  "The Python of the module; empty: the first one with NumPy")
mark_as_advanced(ANIMATED_MESH_FEATURES_PYTHON)
set(Animated_mesh_features_python OFF)
set(Animated_mesh_features_python_missing "ANIMATED_MESH_FEATURES_BUILD_PYTHON is off")

function(animated_mesh_features_find_python)
  if(ANIMATED_MESH_FEATURES_SANITIZE)
    # Python itself would have to be built with them.
    set(Animated_mesh_features_python_missing "sanitizers are on" PARENT_SCOPE)
    return()
  endif()
  set(candidates "${ANIMATED_MESH_FEATURES_PYTHON}")
  set(needed sys)
  if(NOT ANIMATED_MESH_FEATURES_PYTHON)
    set(candidates python3 /usr/bin/python3)
    set(needed numpy)
  endif()
  foreach(candidate IN LISTS candidates)
    execute_process(
      COMMAND "${candidate}" -c "import ${needed}, sys, sysconfig; print(sys.executable, sysconfig.get_path('include'), \
sysconfig.get_config_var('EXT_SUFFIX'), 'y' if sys.version_info >= (3, 8) else 'n', sep=';')"
      OUTPUT_VARIABLE found ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      continue()
    endif()
    list(GET found 0 python)
    list(GET found 1 include)
    list(GET found 2 suffix)
    list(GET found 3 is_new)
    if(is_new STREQUAL "y" AND EXISTS "${include}/Python.h")
      # Of a pybind11 that was installed by pip, that Python knows the place.
      execute_process(COMMAND "${python}" -c "import pybind11; print(pybind11.get_include())"
        OUTPUT_VARIABLE hint ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
      find_path(ANIMATED_MESH_FEATURES_PYBIND11_INCLUDE_DIR pybind11/pybind11.h HINTS "${hint}")
      mark_as_advanced(ANIMATED_MESH_FEATURES_PYBIND11_INCLUDE_DIR)
      if(NOT ANIMATED_MESH_FEATURES_PYBIND11_INCLUDE_DIR)
        set(Animated_mesh_features_python_missing "pybind11 is not here (Debian: pybind11-dev)" PARENT_SCOPE)
        return()
      endif()
      add_library(Animated_mesh_features_pybind11 INTERFACE)
      target_include_directories(Animated_mesh_features_pybind11 SYSTEM INTERFACE
        "${ANIMATED_MESH_FEATURES_PYBIND11_INCLUDE_DIR}" "${include}")
      set(Animated_mesh_features_PYTHON "${python}" PARENT_SCOPE)
      set(Animated_mesh_features_PYTHON_SUFFIX "${suffix}" PARENT_SCOPE)
      set(Animated_mesh_features_python ON PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(Animated_mesh_features_python_missing
    "no Python (3.8 or newer) with its headers and NumPy is here (Debian: python3-dev, python3-numpy)" PARENT_SCOPE)
endfunction()

if(ANIMATED_MESH_FEATURES_BUILD_PYTHON)
  animated_mesh_features_find_python()
endif()
if(Animated_mesh_features_python AND SKBUILD)
  # pip runs as many compilers as Ninja does, whatever memory there is: see job_count in scripts/common.sh.
  cmake_host_system_information(RESULT megabytes QUERY AVAILABLE_PHYSICAL_MEMORY)
  math(EXPR jobs "${megabytes} / 2500 + 1")
  set_property(GLOBAL APPEND PROPERTY JOB_POOLS animated_mesh_features_compilers=${jobs})
  set(CMAKE_JOB_POOL_COMPILE animated_mesh_features_compilers)
endif()
if(Animated_mesh_features_python)
  message(STATUS "Animated_mesh_features: the Python module is built for ${Animated_mesh_features_PYTHON}")
elseif(ANIMATED_MESH_FEATURES_BUILD_PYTHON AND NOT ANIMATED_MESH_FEATURES_BUILD_PYTHON STREQUAL "AUTO")
  message(FATAL_ERROR "Animated_mesh_features: no Python module: ${Animated_mesh_features_python_missing}")
else()
  message(STATUS "Animated_mesh_features: no Python module: ${Animated_mesh_features_python_missing}")
endif()
