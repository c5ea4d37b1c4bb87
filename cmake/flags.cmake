# SPDX-License-Identifier: Apache-2.0
# The flags of every C file of the project, as the interface target ndotl_flags.
include(CheckCCompilerFlag)

set(CMAKE_C_STANDARD 11)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Appends the flags that the compiler knows to the list named by `out`.
function(ndl_known_flags out)
    set(known ${${out}})
    foreach(flag ${ARGN})
        string(MAKE_C_IDENTIFIER "NDL_HAS${flag}" has)
        check_c_compiler_flag("-Werror ${flag}" ${has})
        if(${has})
            list(APPEND known ${flag})
        endif()
    endforeach()
    set(${out} ${known} PARENT_SCOPE)
endfunction()

# The first line makes the bits equal on every compiler and instruction set; the others let sqrtf
# and comparisons vectorise without changing a result.
set(ndl_flags)
ndl_known_flags(ndl_flags -ffp-contract=off
    -fno-math-errno -fno-trapping-math -fopenmp-simd
    -Wall -Wextra -Wpedantic -Wshadow -Wdouble-promotion -Wno-pass-failed)
if(NDOTL_WERROR)
    list(APPEND ndl_flags -Werror)
endif()

set(ndl_sanitize_flags)
if(NDOTL_SANITIZE)
    set(ndl_sanitize_flags -fsanitize=${NDOTL_SANITIZE} -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
endif()

add_library(ndotl_flags INTERFACE)
target_compile_options(ndotl_flags INTERFACE ${ndl_flags} ${ndl_sanitize_flags})
target_link_options(ndotl_flags INTERFACE ${ndl_sanitize_flags})
target_compile_definitions(ndotl_flags INTERFACE _POSIX_C_SOURCE=200809L)
if(NDOTL_FUZZ)
    if(NOT CMAKE_C_COMPILER_ID MATCHES "Clang")
        message(FATAL_ERROR "NDOTL_FUZZ needs clang: configure with -DCMAKE_C_COMPILER=clang")
    endif()
    target_compile_options(ndotl_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
