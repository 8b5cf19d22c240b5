# cmake -DSOURCE_DIR=... -DHEADER=... -DFLAGS=... -P revision.cmake : writes what is compiled into a header, only when it changes: the
# git revision, for people, and a hash of all sources, which tells programs apart outside git and between commits too.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision "unknown")
endif()
file(GLOB_RECURSE sources RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/src/*.cpp" "${SOURCE_DIR}/src/*.hpp" "${SOURCE_DIR}/src/*.py"
     "${SOURCE_DIR}/generators/*.cpp" "${SOURCE_DIR}/generators/*.hpp")
# Options decide bits.
list(APPEND sources src/CMakeLists.txt .cmake/rooms.cmake .cmake/portable_math.cmake CMakeLists.txt CMakePresets.json)
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 "${SOURCE_DIR}/${source}" digest)
  string(APPEND digests "${digest}  ${source}\n")
endforeach()
string(APPEND digests "${FLAGS}\n")  # CXXFLAGS, -DCMAKE_CXX_FLAGS=..., those of the build type
string(SHA256 sources_sha256 "${digests}")
set(text "#define OVERTURN_GIT_REVISION \"${revision}\"\n#define OVERTURN_SOURCES_SHA256 \"${sources_sha256}\"\n")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE "${HEADER}" "${text}")
endif()
