# The manual: target doc, which makes doc/html in the build folder by doc/manual/make_manual.py. It is no part of the
# default target.

find_package(Python3 COMPONENTS Interpreter QUIET)
find_program(ANIMATED_MESH_FEATURES_DOXYGEN doxygen DOC "makes the manual")
set(ANIMATED_MESH_FEATURES_MATHJAX "" CACHE PATH
  "The folder of MathJax 2, which the manual's formulas are shown by; empty: where Debian's libjs-mathjax has it")
mark_as_advanced(ANIMATED_MESH_FEATURES_DOXYGEN)

if(NOT Python3_EXECUTABLE OR NOT ANIMATED_MESH_FEATURES_DOXYGEN)
  message(STATUS "No target doc: it needs doxygen and Python 3")
  return()
endif()

set(arguments "")
if(ANIMATED_MESH_FEATURES_MATHJAX)
  set(arguments --mathjax "${ANIMATED_MESH_FEATURES_MATHJAX}")
endif()
add_custom_target(doc
  COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/doc/manual/make_manual.py"
    --output "${PROJECT_BINARY_DIR}/doc" --doxygen "${ANIMATED_MESH_FEATURES_DOXYGEN}" ${arguments}
  COMMENT "The manual"
  VERBATIM)
