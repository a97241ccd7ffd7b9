# Animated_mesh_features::compiled: what a detection with the policies of either preset is made of, in float and in double,
# compiled once, in a static library. Whoever links it compiles the rest, some seconds; other policies are compiled as
# without it. Results are the same, bit for bit.
#
# It was compiled for the processor's baseline, with or without oneTBB: use it with the same options (-march, NDEBUG).
#
# Without ANIMATED_MESH_FEATURES_BUILD_COMPILED the target exists, too, but is not built unless something links it.

file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/Animated_mesh_features/*.cpp")
add_library(Animated_mesh_features_compiled STATIC ${sources})
add_library(Animated_mesh_features::compiled ALIAS Animated_mesh_features_compiled)
target_link_libraries(Animated_mesh_features_compiled PUBLIC Animated_mesh_features)
target_compile_definitions(Animated_mesh_features_compiled PUBLIC CGAL_ANIMATED_MESH_FEATURES_COMPILED)
set_target_properties(Animated_mesh_features_compiled PROPERTIES
  EXPORT_NAME compiled
  POSITION_INDEPENDENT_CODE ON
  CXX_EXTENSIONS OFF)
if(NOT ANIMATED_MESH_FEATURES_BUILD_COMPILED)
  set_target_properties(Animated_mesh_features_compiled PROPERTIES EXCLUDE_FROM_ALL ON)
endif()

# What an installed one needs to be used with, see Animated_mesh_featuresConfig.cmake.in.
if(Animated_mesh_features_TBB)
  set(Animated_mesh_features_compiled_with_TBB ON)
else()
  set(Animated_mesh_features_compiled_with_TBB OFF)
endif()
