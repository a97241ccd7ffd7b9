# What the package needs, looked for in the same way when it is built and when an installed one is used.
#
# Sets Animated_mesh_features_missing to a message, or to an empty string, and Animated_mesh_features_TBB to a boolean.
#
# Minimum versions are tested afterwards: CGAL's and Eigen's own version files accept one major version only, and this
# package works with several.

set(ANIMATED_MESH_FEATURES_WITH_TBB AUTO CACHE STRING
  "Use oneTBB for CGAL::Parallel_tag: ON (required), OFF, AUTO (if found)")
set_property(CACHE ANIMATED_MESH_FEATURES_WITH_TBB PROPERTY STRINGS AUTO ON OFF)

set(Animated_mesh_features_missing "")
set(Animated_mesh_features_TBB FALSE)

if(NOT TARGET Threads::Threads)
  set(THREADS_PREFER_PTHREAD_FLAG TRUE)
  find_package(Threads QUIET)
endif()
find_package(CGAL CONFIG QUIET)
# CONFIG: CGAL puts a FindEigen3 of its own on the module path, which defines no target in some versions.
find_package(Eigen3 CONFIG QUIET)
find_package(Boost QUIET)

if(NOT TARGET Threads::Threads)
  set(Animated_mesh_features_missing "a threads library is needed")
elseif(NOT TARGET CGAL::CGAL OR CGAL_VERSION VERSION_LESS 5.5)
  set(Animated_mesh_features_missing "CGAL 5.5 or newer is needed (found: '${CGAL_VERSION}')")
elseif(NOT TARGET Eigen3::Eigen OR Eigen3_VERSION VERSION_LESS 3.4)
  set(Animated_mesh_features_missing "Eigen 3.4 or newer is needed (found: '${Eigen3_VERSION}')")
elseif(NOT TARGET Boost::headers OR Boost_VERSION VERSION_LESS 1.74)
  set(Animated_mesh_features_missing "Boost 1.74 or newer is needed (found: '${Boost_VERSION}')")
endif()

if(ANIMATED_MESH_FEATURES_WITH_TBB)
  find_package(TBB CONFIG QUIET)
  # oneTBB is 2021 and later; what came before has other headers.
  if(TARGET TBB::tbb AND NOT TBB_VERSION VERSION_LESS 2021)
    set(Animated_mesh_features_TBB TRUE)
  elseif(NOT ANIMATED_MESH_FEATURES_WITH_TBB STREQUAL "AUTO" AND NOT Animated_mesh_features_missing)
    set(Animated_mesh_features_missing
      "oneTBB is needed (found: '${TBB_VERSION}'), since ANIMATED_MESH_FEATURES_WITH_TBB is set")
  endif()
endif()

# Does what CGAL's CGAL_TBB_support does. BUILD_INTERFACE keeps it out of what is exported.
function(animated_mesh_features_use_tbb target)
  set(libraries TBB::tbb)
  if(TARGET TBB::tbbmalloc)
    list(APPEND libraries TBB::tbbmalloc)
  endif()
  set(definitions CGAL_LINKED_WITH_TBB NOMINMAX)
  foreach(item IN LISTS libraries)
    target_link_libraries(${target} INTERFACE $<BUILD_INTERFACE:${item}>)
  endforeach()
  foreach(item IN LISTS definitions)
    target_compile_definitions(${target} INTERFACE $<BUILD_INTERFACE:${item}>)
  endforeach()
endfunction()
