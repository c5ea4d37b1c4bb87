# SPDX-License-Identifier: Apache-2.0
# libndotl (shade, base, core and the verbs), libndotl-workbench (io, data, fit, render), ndotl.
# Sources are collected by folder, so that a new model, format or command touches no build file.

# Appends the C files of src/<folder> to the list named by `out`.
function(ndl_sources out)
    set(all ${${out}})
    foreach(folder ${ARGN})
        file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.c)
        list(APPEND all ${files})
    endforeach()
    set(${out} ${all} PARENT_SCOPE)
endfunction()

# An object library compiled with the project's flags and include folders.
function(ndl_object_library name)
    add_library(${name} OBJECT ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/include
        ${PROJECT_SOURCE_DIR}/src ${ndl_generated})
    target_compile_definitions(${name} PRIVATE NDOTL_BUILD)
    target_link_libraries(${name} PRIVATE ndotl_flags Threads::Threads)
    add_dependencies(${name} ndotl_build_header)
endfunction()

# Batch kernels: two files, compiled once per instruction set. The scalar one is the reference that
# the vector ones are compared with, so it is kept unvectorised.
set(ndl_kernels ${PROJECT_SOURCE_DIR}/src/core/kernels.c
    ${PROJECT_SOURCE_DIR}/src/core/draw_kernels.c)
set(ndl_kernel_objects)

function(ndl_kernel_library isa)
    set(flags)
    if(isa STREQUAL "scalar")
        set(level -O2)
        ndl_known_flags(flags -fno-tree-vectorize -fno-vectorize -fno-slp-vectorize ${ARGN})
    else()
        set(level -O3)
        ndl_known_flags(flags ${ARGN})
    endif()
    if(NDOTL_KERNEL_OPT)
        set(level ${NDOTL_KERNEL_OPT})
    elseif(CMAKE_BUILD_TYPE STREQUAL "Debug")
        set(level -O1)
    endif()
    ndl_object_library(ndotl_kernels_${isa} ${ndl_kernels})
    target_compile_definitions(ndotl_kernels_${isa} PRIVATE NDL_ISA=${isa}
        $<$<STREQUAL:${isa},scalar>:NDL_PLAIN_LOOPS>)
    target_compile_options(ndotl_kernels_${isa} PRIVATE ${level} ${flags})
    set(ndl_kernel_objects ${ndl_kernel_objects} $<TARGET_OBJECTS:ndotl_kernels_${isa}>
        PARENT_SCOPE)
endfunction()

ndl_kernel_library(scalar)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    ndl_kernel_library(x86_64 -march=x86-64)
    ndl_kernel_library(v3 -march=x86-64-v3)
    ndl_kernel_library(v4 -march=x86-64-v4 -mprefer-vector-width=512)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
    ndl_kernel_library(neon)
endif()

ndl_sources(ndl_core_sources base core shade check bake plot shader)
list(REMOVE_ITEM ndl_core_sources ${ndl_kernels})
ndl_object_library(ndotl_objects ${ndl_core_sources})

# Defines lib<name> (shared) and lib<name>_static, for users ndotl::<name> and ndotl::<name>_static.
# The target `ndotl` is the program.
function(ndl_library name file)
    add_library(lib${name} SHARED ${ARGN})
    add_library(lib${name}_static STATIC ${ARGN})
    foreach(export ${name} ${name}_static)
        set_target_properties(lib${export} PROPERTIES OUTPUT_NAME ${file} EXPORT_NAME ${export}
            LINKER_LANGUAGE C)
        target_include_directories(lib${export} PUBLIC
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
        add_library(ndotl::${export} ALIAS lib${export})
    endforeach()
    set_target_properties(lib${name} PROPERTIES VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_link_options(lib${name} PRIVATE ${ndl_sanitize_flags})
    if(NOT NDOTL_SANITIZE AND NOT APPLE)
        target_link_options(lib${name} PRIVATE -Wl,--no-undefined)
    endif()
endfunction()

ndl_library(ndotl ndotl $<TARGET_OBJECTS:ndotl_objects> ${ndl_kernel_objects})
target_link_libraries(libndotl PRIVATE m Threads::Threads)
target_link_libraries(libndotl_static PUBLIC m Threads::Threads)

ndl_sources(ndl_workbench_sources io data fit render)
set(NDOTL_HAS_WORKBENCH OFF)
if(NDOTL_WORKBENCH AND NOT ndl_missing AND ndl_workbench_sources)
    set(NDOTL_HAS_WORKBENCH ON)
    set(ndl_workbench_packages ndl::png ndl::exr ndl::assimp ndl::embree ndl::jansson ndl::stb)
    set(ndl_workbench_files ${NDL_png_LIBRARY} ${NDL_exr_LIBRARY} ${NDL_assimp_LIBRARY}
        ${NDL_embree_LIBRARY} ${NDL_jansson_LIBRARY})
    ndl_object_library(ndotl_workbench_objects ${ndl_workbench_sources})
    target_link_libraries(ndotl_workbench_objects PRIVATE ${ndl_workbench_packages})
    ndl_library(ndotl_workbench ndotl-workbench $<TARGET_OBJECTS:ndotl_workbench_objects>)
    # Internal functions (the parser, threads, errors) are hidden in the shared libndotl: the shared
    # workbench takes a hidden copy of those that it uses, which have no state, from the static one.
    target_link_libraries(libndotl_workbench PUBLIC libndotl
        PRIVATE libndotl_static ${ndl_workbench_files} m Threads::Threads)
    target_link_options(libndotl_workbench PRIVATE -Wl,--exclude-libs,libndotl.a)
    target_link_libraries(libndotl_workbench_static PUBLIC libndotl_static ${ndl_workbench_files})
endif()

# The program; all but its main() is a library, for unit tests and fuzzing.
file(GLOB ndl_cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cli/*.c)
list(REMOVE_ITEM ndl_cli_sources ${PROJECT_SOURCE_DIR}/cli/main.c)
add_library(ndotl_commands STATIC ${ndl_cli_sources})
target_include_directories(ndotl_commands PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/cli
    ${ndl_generated})
add_dependencies(ndotl_commands ndotl_build_header)
target_link_libraries(ndotl_commands PUBLIC ndotl_flags)
if(NDOTL_HAS_WORKBENCH)
    target_compile_definitions(ndotl_commands PUBLIC NDL_WORKBENCH=1)
    target_link_libraries(ndotl_commands PUBLIC libndotl_workbench_static)
endif()
target_link_libraries(ndotl_commands PUBLIC libndotl_static)
add_executable(ndotl cli/main.c)
set_target_properties(ndotl PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_link_libraries(ndotl PRIVATE ndotl_commands)
