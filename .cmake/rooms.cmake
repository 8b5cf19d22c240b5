# A room is one library under src/ (or generators/). ROOMS lists the only other rooms it may include from; the
# `layering` test holds every #include against these lists, which are written to rooms.txt in the build tree.
set(OVERTURN_ROOMS_FILE "${PROJECT_BINARY_DIR}/rooms.txt")
file(WRITE "${OVERTURN_ROOMS_FILE}" "")

add_library(overturn_options INTERFACE)
# Contracting a*b+c differently in two places would break bit-equality between ranks, builds and kernels.
# Paths below the source tree: what is built does not depend on where the tree lies.
target_compile_options(overturn_options INTERFACE "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=")
target_compile_options(overturn_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                  -Wno-sign-conversion)
target_compile_definitions(overturn_options INTERFACE OVERTURN_CHECKED=$<BOOL:${OVERTURN_CHECKED}>)
if(OVERTURN_WERROR)
  target_compile_options(overturn_options INTERFACE -Werror)
endif()
if(OVERTURN_FUZZ)
  target_compile_options(overturn_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(OVERTURN_SANITIZE OR OVERTURN_FUZZ)
  target_compile_options(overturn_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                                    -fno-omit-frame-pointer)
  target_link_options(overturn_options INTERFACE -fsanitize=address,undefined)
endif()

set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)

# Other people's headers, parsed once instead of in every file: `base` by all rooms; `light`, with JSON, by those that
# read, keep and write around the work, whose time goes into compiling: they are optimised less. Every file still
# includes what it uses: .ci/run reads each alone without these (.ci/read.py).
set(OVERTURN_BASE_HEADERS <algorithm> <array> <chrono> <cmath> <cstdint> <cstring> <filesystem> <functional> <map> <memory>
    <numbers> <optional> <span> <string> <string_view> <utility> <vector> <fmt/format.h> <fmt/ranges.h>)
foreach(kind base light)
  set(precompiled overturn_precompiled_${kind})
  add_library(${precompiled} OBJECT "${PROJECT_SOURCE_DIR}/.cmake/precompiled.cpp")
  target_link_libraries(${precompiled} PRIVATE overturn_options fmt::fmt nlohmann_json::nlohmann_json)
  target_precompile_headers(${precompiled} PRIVATE ${OVERTURN_BASE_HEADERS})
endforeach()
target_precompile_headers(overturn_precompiled_light PRIVATE <nlohmann/json.hpp>)
target_compile_options(overturn_precompiled_light PRIVATE -O1)

# So many files of a room are compiled at a time where CMAKE_UNITY_BUILD is on: what they keep to themselves must bear
# names of its own in the room (-DCMAKE_UNITY_BUILD_BATCH_SIZE=0 finds all that do not).
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 6)
endif()

# overturn_room(name [BASE dir] [LOW_OPT] [NO_UNITY] ROOMS ... EXTERNAL ...)
# All files of the folder BASE/name (BASE: default src/) and of its folder `detail`, whose headers are the room's own: no
# other room may include them. Headers are included as "room/file.hpp". LOW_OPT: the room reads, keeps or writes, which no
# campaign waits for.
# NO_UNITY: its files are never compiled several at a time, so that what they keep to themselves may bear the same names.
function(overturn_room name)
  cmake_parse_arguments(ARG "LOW_OPT;NO_UNITY" "BASE" "ROOMS;EXTERNAL" ${ARGN})
  if(NOT ARG_BASE)
    set(ARG_BASE "${PROJECT_SOURCE_DIR}/src")
  endif()
  set(folder "${ARG_BASE}/${name}")
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp" "${folder}/detail/*.cpp")
  file(GLOB headers CONFIGURE_DEPENDS "${folder}/*.hpp" "${folder}/detail/*.hpp")
  list(FILTER headers EXCLUDE REGEX "-inl[.]hpp$")  # included once per instruction set, never alone
  if(name STREQUAL cli)
    list(REMOVE_ITEM sources "${folder}/main.cpp")
  endif()
  set(target overturn_${name})
  add_library(${target} STATIC ${sources})
  if(ARG_NO_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
  # What is compiled once per instruction set is a unit of its own in any case.
  foreach(source IN LISTS sources)
    file(STRINGS "${source}" per_target REGEX "hwy/foreach_target" LIMIT_COUNT 1)
    if(per_target)
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${ARG_BASE}" FILES ${headers})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC overturn_options ${ARG_EXTERNAL})
  if(ARG_LOW_OPT)
    target_compile_options(${target} PRIVATE -O1)
    if(CMAKE_UNITY_BUILD_BATCH_SIZE)
      math(EXPR batch "2 * ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
      set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${batch})
    endif()
    target_precompile_headers(${target} REUSE_FROM overturn_precompiled_light)
  else()
    target_precompile_headers(${target} REUSE_FROM overturn_precompiled_base)
  endif()
  foreach(room IN LISTS ARG_ROOMS)
    target_link_libraries(${target} PUBLIC overturn_${room})
  endforeach()
  string(JOIN " " allowed ${ARG_ROOMS})
  file(RELATIVE_PATH base "${PROJECT_SOURCE_DIR}" "${folder}")
  file(APPEND "${OVERTURN_ROOMS_FILE}" "${name}|${base}|${allowed}\n")
endfunction()
