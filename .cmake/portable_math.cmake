# The last bits of sin, exp, log and the like are part of a campaign's answer, and glibc rounds them otherwise where the
# CPU has FMA. musl's functions (MIT licence; one code for every x86-64, as fast) are linked whole into every program
# under their C names: whoever calls, our code, the templates of std::complex, GSL or FFTW, gets these by the loader's rule
# that the program's own symbols come first. The test portable/math holds every program's imports against that.
set(functions acos acosh asin asinh atan atan2 atanh cabs cbrt cos cosh erf exp exp2 expm1 hypot log log10 log1p log2 pow sin
    sincos sinh tan tanh)
set(helpers __cos __expo2 __math_divzero __math_invalid __math_oflow __math_uflow __math_xflow __rem_pio2
    __rem_pio2_large __sin __tan exp_data log2_data log_data pow_data)

string(REPLACE gnu musl triple "${CMAKE_LIBRARY_ARCHITECTURE}")
find_file(MUSL_LIBC libc.a PATHS /usr/lib/${triple} /usr/local/musl/lib NO_DEFAULT_PATH DOC "musl's static C library")
overturn_require("${MUSL_LIBC}" musl-dev)
execute_process(COMMAND "${CMAKE_AR}" t "${MUSL_LIBC}" OUTPUT_VARIABLE members COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" members "${members}")

set(folder "${PROJECT_BINARY_DIR}/generated/portable_math")
set(archive "${folder}/libportable_math.a")
set(taken "")
foreach(name IN LISTS functions helpers)
  list(FILTER members EXCLUDE REGEX "^$")
  set(found ${members})
  list(FILTER found INCLUDE REGEX "^${name}[.]l?o$")
  if(NOT found)
    message(FATAL_ERROR "${MUSL_LIBC} has no ${name} (is it musl's?). Install musl-dev or name musl's: cmake -DMUSL_LIBC=.../libc.a")
  endif()
  list(GET found 0 member)
  list(APPEND taken "${member}")
endforeach()
if(NOT EXISTS "${archive}" OR "${MUSL_LIBC}" IS_NEWER_THAN "${archive}" OR "${CMAKE_CURRENT_LIST_FILE}" IS_NEWER_THAN "${archive}")
  file(REMOVE_RECURSE "${folder}")
  file(MAKE_DIRECTORY "${folder}")
  execute_process(COMMAND "${CMAKE_AR}" x "${MUSL_LIBC}" ${taken} WORKING_DIRECTORY "${folder}" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${CMAKE_AR}" rcsD "${archive}" ${taken} WORKING_DIRECTORY "${folder}" COMMAND_ERROR_IS_FATAL ANY)
endif()
file(SHA256 "${archive}" OVERTURN_LIBM)
string(SUBSTRING "${OVERTURN_LIBM}" 0 8 OVERTURN_LIBM)
set(OVERTURN_LIBM "musl ${OVERTURN_LIBM}")  # its version stands nowhere in it
add_library(overturn_portable_math STATIC IMPORTED GLOBAL)
set_target_properties(overturn_portable_math PROPERTIES IMPORTED_LOCATION "${archive}")
