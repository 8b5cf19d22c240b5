# A room is one library under src/ (or generators/). ROOMS lists the only other rooms it may include from; the
# `layering` test holds every #include against these lists, which are written to rooms.txt in the build tree.
set(OVERTURN_ROOMS_FILE "${PROJECT_BINARY_DIR}/rooms.txt")
file(WRITE "${OVERTURN_ROOMS_FILE}" "")

add_library(overturn_options INTERFACE)
# Contracting a*b+c differently in two places would break bit-equality between ranks, builds and kernels.
target_compile_options(overturn_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                  -Wsign-conversion -Wno-sign-conversion)
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

# overturn_room(name [BASE dir] HEADERS ... SOURCES ... ROOMS ... EXTERNAL ...)
# Headers are included as "room/file.hpp" from BASE (default src/).
function(overturn_room name)
  cmake_parse_arguments(ARG "" "BASE" "HEADERS;SOURCES;ROOMS;EXTERNAL" ${ARGN})
  if(NOT ARG_BASE)
    set(ARG_BASE "${PROJECT_SOURCE_DIR}/src")
  endif()
  list(TRANSFORM ARG_HEADERS PREPEND "${ARG_BASE}/")
  list(TRANSFORM ARG_SOURCES PREPEND "${ARG_BASE}/")
  set(target overturn_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${ARG_BASE}" FILES ${ARG_HEADERS})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC overturn_options ${ARG_EXTERNAL})
  foreach(room IN LISTS ARG_ROOMS)
    target_link_libraries(${target} PUBLIC overturn_${room})
  endforeach()
  string(JOIN " " allowed ${ARG_ROOMS})
  file(RELATIVE_PATH base "${PROJECT_SOURCE_DIR}" "${ARG_BASE}/${name}")
  file(APPEND "${OVERTURN_ROOMS_FILE}" "${name}|${base}|${allowed}\n")
endfunction()
