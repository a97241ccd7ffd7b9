# Pictures and plots, which detect_features --png and --plot write, as a part of the programs: component "pictures". cairo
# draws what is written on them, and the files. Without it the programs are built nevertheless; they then say what was
# missing when one of the options is used.

option(ANIMATED_MESH_FEATURES_WITH_CAIRO "Build pictures and plots into detect_features, for --png and --plot (needs cairo)" ON)

set(ANIMATED_MESH_FEATURES_PICTURES OFF)
if(ANIMATED_MESH_FEATURES_WITH_CAIRO)
  # cairo has no configuration file for CMake, and pkg-config may not be here.
  foreach(part IN ITEMS cairo cairo-svg cairo-pdf)
    string(TOUPPER ${part} variable)
    string(REPLACE "-" "_" variable ${variable})
    find_path(ANIMATED_MESH_FEATURES_${variable}_INCLUDE_DIR ${part}.h PATH_SUFFIXES cairo)
    mark_as_advanced(ANIMATED_MESH_FEATURES_${variable}_INCLUDE_DIR)
  endforeach()
  find_library(ANIMATED_MESH_FEATURES_CAIRO_LIBRARY cairo)
  mark_as_advanced(ANIMATED_MESH_FEATURES_CAIRO_LIBRARY)
  if(ANIMATED_MESH_FEATURES_CAIRO_LIBRARY AND ANIMATED_MESH_FEATURES_CAIRO_INCLUDE_DIR AND
     ANIMATED_MESH_FEATURES_CAIRO_SVG_INCLUDE_DIR AND ANIMATED_MESH_FEATURES_CAIRO_PDF_INCLUDE_DIR)
    set(ANIMATED_MESH_FEATURES_PICTURES ON)
    add_library(Animated_mesh_features_cairo UNKNOWN IMPORTED GLOBAL)
    set_target_properties(Animated_mesh_features_cairo PROPERTIES
      IMPORTED_LOCATION "${ANIMATED_MESH_FEATURES_CAIRO_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${ANIMATED_MESH_FEATURES_CAIRO_INCLUDE_DIR}")
  else()
    message(STATUS "detect_features without --png and --plot: cairo is not here (Debian: libcairo2-dev)")
  endif()
else()
  message(STATUS "detect_features without --png and --plot: ANIMATED_MESH_FEATURES_WITH_CAIRO is off")
endif()

# animated_mesh_features_add_pictures(<target>): gives the programs' library cairo and says so to all who link it, or takes
# from it the sources that draw with it.
function(animated_mesh_features_add_pictures target)
  if(ANIMATED_MESH_FEATURES_PICTURES)
    target_link_libraries(${target} PRIVATE Animated_mesh_features_cairo)
    target_compile_definitions(${target} PUBLIC DETECT_FEATURES_WITH_PICTURES)
  else()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources EXCLUDE REGEX "(^|/)(drawing|plots)/|(^|/)pictures/(Scene_pictures|picture_of_scene|write_png)[.]cpp$|(^|/)compare_animations/write_matrix[.]cpp$")
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
  endif()
endfunction()
