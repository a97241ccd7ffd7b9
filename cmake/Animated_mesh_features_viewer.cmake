# The viewer, which detect_features --html writes, as a part of the program: component "viewer".
#
# Its page is made from viewer/ by Node.js when the program is built, or taken as it is: see viewer/README.md. Whatever is
# missing for that, the program is built; it then says what was missing when --html is used.

option(ANIMATED_MESH_FEATURES_WITH_VIEWER "Build the viewer into detect_features, for --html (needs zlib)" ON)
set(ANIMATED_MESH_FEATURES_VIEWER_BUNDLE "" CACHE FILEPATH
  "The viewer's page, made elsewhere from the same sources; empty: made by Node.js, or from viewer/dist")

find_package(ZLIB QUIET)
find_program(ANIMATED_MESH_FEATURES_NODE NAMES node nodejs DOC "Node.js, which makes the viewer's page")
find_program(ANIMATED_MESH_FEATURES_NPM npm DOC "fetches what the viewer's page is made of")
mark_as_advanced(ANIMATED_MESH_FEATURES_NODE ANIMATED_MESH_FEATURES_NPM)

set(ANIMATED_MESH_FEATURES_VIEWER_FOLDER "${PROJECT_BINARY_DIR}/viewer")
set(ANIMATED_MESH_FEATURES_VIEWER_PAGE "${ANIMATED_MESH_FEATURES_VIEWER_FOLDER}/viewer.html")
set(animated_mesh_features_viewer_arguments
  "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}/viewer"
  "-DWORK_DIR=${ANIMATED_MESH_FEATURES_VIEWER_FOLDER}"
  "-DBUNDLE=${ANIMATED_MESH_FEATURES_VIEWER_BUNDLE}"
  "-DNODE=$<$<BOOL:${ANIMATED_MESH_FEATURES_NODE}>:${ANIMATED_MESH_FEATURES_NODE}>"
  "-DNPM=$<$<BOOL:${ANIMATED_MESH_FEATURES_NPM}>:${ANIMATED_MESH_FEATURES_NPM}>")

if(NOT ANIMATED_MESH_FEATURES_WITH_VIEWER)
  message(STATUS "detect_features without --html: ANIMATED_MESH_FEATURES_WITH_VIEWER is off")
elseif(NOT ZLIB_FOUND)
  message(STATUS "detect_features without --html: zlib is not here")
endif()

# animated_mesh_features_add_viewer(<target>): gives the programs' library zlib, or takes from it what compresses with it,
# and the page, if it can be had.
function(animated_mesh_features_add_viewer target)
  if(ZLIB_FOUND)
    target_link_libraries(${target} PRIVATE ZLIB::ZLIB)
  else()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources EXCLUDE REGEX "(^|/)page/deflated[.]cpp$")
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
  endif()
  if(NOT ANIMATED_MESH_FEATURES_WITH_VIEWER OR NOT ZLIB_FOUND)
    return()
  endif()
  # There from the beginning: tools that go through all sources need not wait for the page.
  set(source "${ANIMATED_MESH_FEATURES_VIEWER_FOLDER}/viewer_page.cpp")
  if(NOT EXISTS "${source}")
    file(WRITE "${source}" "")
  endif()
  # What failed is tried again when CMake is run again, not in each build.
  file(REMOVE "${ANIMATED_MESH_FEATURES_VIEWER_FOLDER}/failed")
  add_custom_target(viewer_page
    COMMAND "${CMAKE_COMMAND}" ${animated_mesh_features_viewer_arguments}
      -P "${PROJECT_SOURCE_DIR}/cmake/make_viewer_page.cmake"
    BYPRODUCTS "${source}"
    COMMENT "The viewer's page"
    VERBATIM)
  add_dependencies(${target} viewer_page)
  target_sources(${target} PRIVATE "${source}")
  target_compile_definitions(${target} PRIVATE DETECT_FEATURES_WITH_VIEWER)

  # For those who change the viewer.
  add_custom_target(viewer_checksum
    COMMAND "${CMAKE_COMMAND}" ${animated_mesh_features_viewer_arguments} -DRENEW_CHECKSUM=ON
      -P "${PROJECT_SOURCE_DIR}/cmake/make_viewer_page.cmake"
    COMMENT "Renewing viewer/viewer.sha256"
    VERBATIM)
  # A source package that can be built without Node.js: what is committed, and the page.
  set(name "Animated_mesh_features-${PROJECT_VERSION}")
  add_custom_target(source_package
    COMMAND git -C "${PROJECT_SOURCE_DIR}" archive --format=tar.gz -o "${PROJECT_BINARY_DIR}/${name}.tar.gz"
      "--prefix=${name}/viewer/dist/" "--add-file=${ANIMATED_MESH_FEATURES_VIEWER_PAGE}" "--prefix=${name}/" HEAD
    DEPENDS viewer_page
    COMMENT "${name}.tar.gz"
    VERBATIM)
endfunction()
