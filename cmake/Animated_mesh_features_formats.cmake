# Libraries for formats beyond those that the package reads by itself. Each is optional: without it the program
# says so when it meets such a file. Only JSON, read_json.h and write_json.h, the programs cannot do without. Header-only as
# the package is, whoever includes read_json.h, write_json.h, read_gltf.h, read_assimp.h or read_hdf5.h links with the
# library by itself; this is for the programs and tests here.
#
# Defines the target Animated_mesh_features_formats, with a definition ANIMATED_MESH_FEATURES_WITH_... for each library,
# and Animated_mesh_features_formats_text, which names what was found.

add_library(Animated_mesh_features_formats INTERFACE)
set(Animated_mesh_features_formats_text "")

# animated_mesh_features_format(NAME MEANING LIBRARY TARGETS...): an option, and the first of the targets that there is.
function(animated_mesh_features_format name meaning library)
  set(option "ANIMATED_MESH_FEATURES_WITH_${name}")
  if(${option})
    foreach(target IN LISTS ARGN)
      if(TARGET ${target})
        target_link_libraries(Animated_mesh_features_formats INTERFACE ${target})
        target_compile_definitions(Animated_mesh_features_formats INTERFACE ${option})
        set(Animated_mesh_features_formats_text "${Animated_mesh_features_formats_text} ${library}" PARENT_SCOPE)
        return()
      endif()
    endforeach()
    if(${option} STREQUAL "AUTO")
      message(STATUS "Animated_mesh_features: without ${library}, programs do not read ${meaning}")
    else()
      message(FATAL_ERROR "Animated_mesh_features: ${library} is needed, since ${option} is set")
    endif()
  endif()
endfunction()

# 3.9: objects that keep the order of their members
find_package(nlohmann_json 3.9 CONFIG QUIET)
if(TARGET nlohmann_json::nlohmann_json)
  target_link_libraries(Animated_mesh_features_formats INTERFACE nlohmann_json::nlohmann_json)
endif()

foreach(name IN ITEMS GLTF ASSIMP HDF5)
  set(ANIMATED_MESH_FEATURES_WITH_${name} AUTO CACHE STRING
    "Read more formats in programs and tests: ON (required), OFF, AUTO (if the library is found)")
  set_property(CACHE ANIMATED_MESH_FEATURES_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
endforeach()

if(ANIMATED_MESH_FEATURES_WITH_GLTF)
  find_package(TinyGLTF CONFIG QUIET)
endif()
animated_mesh_features_format(GLTF "glTF" tinygltf TinyGLTF::TinyGLTF tinygltf::tinygltf)

# Not by their own configuration files, which bring along what they were built with, whether it is here or not.
function(animated_mesh_features_find_format name header library)
  if(ANIMATED_MESH_FEATURES_WITH_${name})
    find_path(ANIMATED_MESH_FEATURES_${name}_INCLUDE_DIR ${header} PATH_SUFFIXES hdf5/serial)
    find_library(ANIMATED_MESH_FEATURES_${name}_LIBRARY ${library} PATH_SUFFIXES hdf5/serial)
    mark_as_advanced(ANIMATED_MESH_FEATURES_${name}_INCLUDE_DIR ANIMATED_MESH_FEATURES_${name}_LIBRARY)
    if(ANIMATED_MESH_FEATURES_${name}_INCLUDE_DIR AND ANIMATED_MESH_FEATURES_${name}_LIBRARY)
      add_library(Animated_mesh_features_${name} UNKNOWN IMPORTED GLOBAL)
      set_target_properties(Animated_mesh_features_${name} PROPERTIES
        IMPORTED_LOCATION "${ANIMATED_MESH_FEATURES_${name}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${ANIMATED_MESH_FEATURES_${name}_INCLUDE_DIR}")
    endif()
  endif()
endfunction()

animated_mesh_features_find_format(ASSIMP assimp/scene.h assimp)
animated_mesh_features_format(ASSIMP "FBX, Collada and X" assimp Animated_mesh_features_ASSIMP)
animated_mesh_features_find_format(HDF5 hdf5.h hdf5)
animated_mesh_features_format(HDF5 "HDF5" HDF5 Animated_mesh_features_HDF5)
