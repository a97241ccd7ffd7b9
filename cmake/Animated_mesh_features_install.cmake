# Headers, the package files for find_package(), the compiled library if there is one, and the command-line programs
# (component "programs").

include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Animated_mesh_features")

install(TARGETS Animated_mesh_features EXPORT Animated_mesh_features_targets)
install(EXPORT Animated_mesh_features_targets
  FILE Animated_mesh_features_targets.cmake
  NAMESPACE Animated_mesh_features::
  DESTINATION "${package_folder}"
  COMPONENT development)
if(ANIMATED_MESH_FEATURES_BUILD_COMPILED)
  install(TARGETS Animated_mesh_features_compiled EXPORT Animated_mesh_features_compiled_targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    COMPONENT development)
  install(EXPORT Animated_mesh_features_compiled_targets
    FILE Animated_mesh_features_compiled_targets.cmake
    NAMESPACE Animated_mesh_features::
    DESTINATION "${package_folder}"
    COMPONENT development)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN "*.inl")

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/Animated_mesh_featuresConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/Animated_mesh_featuresConfig.cmake"
  INSTALL_DESTINATION "${package_folder}"
  NO_SET_AND_CHECK_MACRO)
if(ANIMATED_MESH_FEATURES_BUILD_COMPILED)
  set(independent "") # of the processor
else()
  set(independent ARCH_INDEPENDENT)
endif()
# Before version 1.0 a minor version may change an interface.
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Animated_mesh_featuresConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion
  ${independent})
install(FILES
  "${PROJECT_BINARY_DIR}/Animated_mesh_featuresConfig.cmake"
  "${PROJECT_BINARY_DIR}/Animated_mesh_featuresConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/Animated_mesh_features_dependencies.cmake"
  DESTINATION "${package_folder}"
  COMPONENT development)

# The page that detect_features --html fills; there is none if it could not be made.
if(DEFINED ANIMATED_MESH_FEATURES_VIEWER_PAGE)
  install(FILES "${ANIMATED_MESH_FEATURES_VIEWER_PAGE}"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/Animated_mesh_features"
    COMPONENT programs
    OPTIONAL)
endif()

# The add-on for Blender, a single file.
install(FILES "${PROJECT_SOURCE_DIR}/python/blender/import_animated_mesh_features.py"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/Animated_mesh_features"
  COMPONENT programs)

if(TARGET detect_features)
  set(texts "${PROJECT_BINARY_DIR}/texts")
  foreach(text IN ITEMS
      "detect_features.1|${CMAKE_INSTALL_MANDIR}/man1"
      "detect_features|${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
      "_detect_features|${CMAKE_INSTALL_DATADIR}/zsh/site-functions"
      "detect_features.fish|${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
    string(REPLACE "|" ";" text "${text}")
    list(GET text 0 file)
    list(GET text 1 destination)
    install(FILES "${texts}/${file}" DESTINATION "${destination}" COMPONENT programs OPTIONAL)
  endforeach()
endif()

foreach(program IN ITEMS compare_animations detect_features evaluate_features make_animation simplify_animation)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT programs)
  endif()
endforeach()
