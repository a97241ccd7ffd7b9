# Makes WORK_DIR/viewer.html, the viewer's page, and WORK_DIR/viewer_page.cpp, a program's copy of it. Run by
# cmake -P, with
#   SOURCE_DIR       the folder viewer/
#   WORK_DIR         for all that is written
#   BUNDLE           the page itself, or empty
#   NODE, NPM        the programs, or empty
#   RENEW_CHECKSUM   to be set when the sources were changed: writes SOURCE_DIR/viewer.sha256
#
# The page is BUNDLE; or made by Node.js; or SOURCE_DIR/dist/viewer.html, which source packages have. A page that was not
# made here must have the checksum in SOURCE_DIR/viewer.sha256, which also says of which sources it is. If there is no page,
# viewer_page.cpp says why, and nothing fails.

cmake_minimum_required(VERSION 3.22...3.31)

set(page_file "${WORK_DIR}/viewer.html")
set(cpp_file "${WORK_DIR}/viewer_page.cpp")

# ---------------------------------------------------------------------------------------------------------- the sources

file(GLOB sources RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/src/*")
list(APPEND sources build.mjs package.json package-lock.json)
list(SORT sources)
set(sums "")
foreach(source IN LISTS sources)
  file(SHA256 "${SOURCE_DIR}/${source}" sum)
  string(APPEND sums "${source} ${sum}\n")
endforeach()
string(SHA256 sources_sum "${sums}")

set(recorded_page "")
set(recorded_sources "")
if(EXISTS "${SOURCE_DIR}/viewer.sha256")
  file(STRINGS "${SOURCE_DIR}/viewer.sha256" lines)
  foreach(line IN LISTS lines)
    if(line MATCHES "^([0-9a-f]+)  viewer.html$")
      set(recorded_page "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^([0-9a-f]+)  sources$")
      set(recorded_sources "${CMAKE_MATCH_1}")
    endif()
  endforeach()
endif()

# ----------------------------------------------------------------------------------------------- nothing new, nothing done

set(bundle_sum "")
if(BUNDLE AND EXISTS "${BUNDLE}")
  file(SHA256 "${BUNDLE}" bundle_sum)
endif()
set(key "${sources_sum} ${recorded_page} ${recorded_sources} ${BUNDLE} ${bundle_sum} ${NODE} ${NPM}")
set(old_key "")
foreach(record IN ITEMS made failed)
  if(EXISTS "${WORK_DIR}/${record}")
    file(READ "${WORK_DIR}/${record}" old_key)
  endif()
endforeach()
if(old_key STREQUAL key AND NOT RENEW_CHECKSUM)
  return()
endif()
file(REMOVE "${WORK_DIR}/made" "${WORK_DIR}/failed" "${page_file}")
file(MAKE_DIRECTORY "${WORK_DIR}")

# -------------------------------------------------------------------------------------------------------------- the page

# Takes a page that was made elsewhere; otherwise sets `reason`.
function(take_page file)
  if(NOT EXISTS "${file}")
    set(reason "${file} is not there" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 "${file}" sum)
  if(NOT sum STREQUAL recorded_page)
    set(reason "${file} has not the checksum in viewer/viewer.sha256" PARENT_SCOPE)
  elseif(NOT sources_sum STREQUAL recorded_sources)
    set(reason "${file} is not of these sources: those in viewer/ were changed" PARENT_SCOPE)
  else()
    file(COPY_FILE "${file}" "${page_file}")
  endif()
endfunction()

# Runs a command in the build folder of the page; otherwise sets `reason`. An npm that finds no network gives up soon, and
# what is in its cache is not fetched again.
function(run_in_build_folder name)
  execute_process(COMMAND ${ARGN}
    WORKING_DIRECTORY "${WORK_DIR}/build"
    TIMEOUT 300
    RESULT_VARIABLE result
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  file(APPEND "${WORK_DIR}/log.txt" "${name}: ${result}\n${output}\n")
  if(NOT result EQUAL 0)
    set(reason "${name} failed (${result}), see ${WORK_DIR}/log.txt" PARENT_SCOPE)
  endif()
endfunction()

set(reason "")
if(BUNDLE)
  take_page("${BUNDLE}")
else()
  if(NODE AND NPM)
    file(REMOVE_RECURSE "${WORK_DIR}/build")
    file(REMOVE "${WORK_DIR}/log.txt")
    foreach(source IN LISTS sources)
      get_filename_component(folder "${source}" DIRECTORY)
      file(COPY "${SOURCE_DIR}/${source}" DESTINATION "${WORK_DIR}/build/${folder}")
    endforeach()
    run_in_build_folder("npm ci" "${NPM}" ci --prefer-offline --ignore-scripts --no-audit --no-fund
      --fetch-retries=1 --fetch-timeout=30000)
    if(NOT reason)
      run_in_build_folder("Node.js" "${NODE}" build.mjs "${page_file}")
    endif()
  else()
    set(reason "neither Node.js with npm nor a ready-made page (viewer/dist) was there")
  endif()
  if(NOT EXISTS "${page_file}" AND EXISTS "${SOURCE_DIR}/dist/viewer.html")
    set(reason "")
    take_page("${SOURCE_DIR}/dist/viewer.html")
  endif()
endif()

if(EXISTS "${page_file}")
  set(reason "")
  file(SHA256 "${page_file}" page_sum)
  if(RENEW_CHECKSUM)
    file(WRITE "${SOURCE_DIR}/viewer.sha256" "${page_sum}  viewer.html\n${sources_sum}  sources\n")
    file(REMOVE "${WORK_DIR}/made")
  elseif(NOT page_sum STREQUAL recorded_page OR NOT sources_sum STREQUAL recorded_sources)
    message("The viewer's sources were changed; build the target viewer_checksum before they are committed.")
  endif()
else()
  message("detect_features without --html: ${reason}")
endif()

# ------------------------------------------------------------------------------------------------------ the page as C++

set(numbers "0")
set(size 0)
if(EXISTS "${page_file}")
  file(SIZE "${page_file}" size)
  file(READ "${page_file}" numbers HEX)
  string(REGEX REPLACE "(................................................)" "\\1\n" numbers "${numbers}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," numbers "${numbers}")
endif()
string(REPLACE "\\" "\\\\" reason "${reason}")
string(REPLACE "\"" "\\\"" reason "${reason}")
set(cpp "// made by cmake/make_viewer_page.cmake

#include <cstddef>

namespace Programs {

extern const unsigned char viewer_page_bytes[];
extern const std::size_t viewer_page_size;
extern const char* const viewer_page_missing;

const unsigned char viewer_page_bytes[] = {
${numbers}
};
const std::size_t viewer_page_size = ${size};
const char* const viewer_page_missing = \"${reason}\";

} // namespace Programs
")
set(old_cpp "")
if(EXISTS "${cpp_file}")
  file(READ "${cpp_file}" old_cpp)
endif()
if(NOT cpp STREQUAL old_cpp)
  file(WRITE "${cpp_file}" "${cpp}")
endif()

if(reason)
  file(WRITE "${WORK_DIR}/failed" "${key}")
elseif(NOT RENEW_CHECKSUM)
  file(WRITE "${WORK_DIR}/made" "${key}")
endif()
