# Pictures, which detect_features --png writes, as a part of the program: component "pictures". Without it the program is
# built nevertheless; it then says what was missing when --png is used.

option(ANIMATED_MESH_FEATURES_WITH_PICTURES "Build pictures into detect_features, for --png (needs zlib)" ON)

find_package(ZLIB QUIET)

if(NOT ANIMATED_MESH_FEATURES_WITH_PICTURES)
  message(STATUS "detect_features without --png: ANIMATED_MESH_FEATURES_WITH_PICTURES is off")
elseif(NOT ZLIB_FOUND)
  message(STATUS "detect_features without --png: zlib is not here")
endif()

# animated_mesh_features_add_pictures(<target>): gives the program what it needs for them, if it can be had.
function(animated_mesh_features_add_pictures target)
  if(ANIMATED_MESH_FEATURES_WITH_PICTURES AND ZLIB_FOUND)
    target_link_libraries(${target} PRIVATE ZLIB::ZLIB)
    target_compile_definitions(${target} PRIVATE DETECT_FEATURES_WITH_PICTURES)
  endif()
endfunction()
