# cmake -DSOURCE_DIR=... -DHEADER=... -P revision.cmake : writes the git revision into a header, only when it changes.
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision "unknown")
endif()
set(text "#define OVERTURN_GIT_REVISION \"${revision}\"\n")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE "${HEADER}" "${text}")
endif()
