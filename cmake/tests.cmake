# SPDX-License-Identifier: Apache-2.0
# How tests are declared. Labels: `full` is every test, `quick` those that run all day, and the name
# of the test's folder in tests/; the target tests_<folder> builds the programs of a folder.
# Every test gets NDOTL_SOURCE (this tree), NDOTL_BUILD (the build folder) and NDOTL_BIN (the
# program) in its environment; NDOTL_TEST_DATA, when set, names the folder of real input and is
# inherited from the caller. A test that cannot run prints the reason and exits with 77.

find_path(NDL_CMOCKA_INCLUDE cmocka.h)
find_library(NDL_CMOCKA_LIBRARY cmocka)
find_program(NDL_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(NDL_PYTHON NAMES python3)
mark_as_advanced(NDL_CMOCKA_INCLUDE NDL_CMOCKA_LIBRARY NDL_PYTHON)

function(ndl_test_properties name timeout)
    set(labels ${ARGN})
    if(NOT labels)
        set(labels quick)
    endif()
    set(environment "NDOTL_SOURCE=${PROJECT_SOURCE_DIR}" "NDOTL_BUILD=${PROJECT_BINARY_DIR}"
        "NDOTL_BUILD_TYPE=${CMAKE_BUILD_TYPE}" "NDOTL_SANITIZE=${NDOTL_SANITIZE}"
        "NDOTL_CC=${CMAKE_C_COMPILER}" "PYTHONDONTWRITEBYTECODE=1"
        "UBSAN_OPTIONS=print_stacktrace=1" "NDOTL_BIN=$<TARGET_FILE:ndotl>")
    set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT ${timeout}
        LABELS "${labels};full;${NDL_TEST_FOLDER}" ENVIRONMENT "${environment}")
endfunction()

# ndl_add_test(<name> SOURCES <c files> [LIBS <targets>] [LABELS quick|full] [ARGS <...>]
#              [TIMEOUT <seconds>] [WORKBENCH])
# A cmocka program that may include headers of src/ and tests/support. WORKBENCH: it needs
# libndotl-workbench, and does not exist when that is left out.
function(ndl_add_test name)
    cmake_parse_arguments(A "WORKBENCH" "TIMEOUT" "SOURCES;LIBS;LABELS;ARGS" ${ARGN})
    if(A_WORKBENCH AND NOT NDOTL_HAS_WORKBENCH)
        return()
    endif()
    add_executable(test_${name} ${A_SOURCES})
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src
        ${PROJECT_SOURCE_DIR}/tests/support ${ndl_generated})
    target_include_directories(test_${name} SYSTEM PRIVATE ${NDL_CMOCKA_INCLUDE})
    target_link_libraries(test_${name} PRIVATE ndotl_flags ${A_LIBS})
    if(NDOTL_HAS_WORKBENCH AND A_WORKBENCH)
        target_link_libraries(test_${name} PRIVATE libndotl_workbench_static
            ${ndl_workbench_packages})
    endif()
    target_link_libraries(test_${name} PRIVATE libndotl_static ${NDL_CMOCKA_LIBRARY})
    add_dependencies(test_${name} ndotl_build_header)
    add_dependencies(tests_${NDL_TEST_FOLDER} test_${name})
    ndl_add_command_test(${name} COMMAND test_${name} ${A_ARGS} LABELS ${A_LABELS}
        TIMEOUT ${A_TIMEOUT})
endfunction()

# ndl_add_command_test(<name> COMMAND <...> [LABELS quick|full] [TIMEOUT <seconds>])
function(ndl_add_command_test name)
    cmake_parse_arguments(A "" "TIMEOUT" "COMMAND;LABELS" ${ARGN})
    if(NOT A_TIMEOUT)
        set(A_TIMEOUT 120)
    endif()
    add_test(NAME ${name} COMMAND ${A_COMMAND})
    ndl_test_properties(${name} ${A_TIMEOUT} ${A_LABELS})
endfunction()

# ndl_add_python_test(<name> SCRIPT <file> [ARGS <...>] [LABELS quick|full] [TIMEOUT <seconds>])
function(ndl_add_python_test name)
    cmake_parse_arguments(A "" "SCRIPT;TIMEOUT" "ARGS;LABELS" ${ARGN})
    get_filename_component(script ${A_SCRIPT} ABSOLUTE)
    ndl_add_command_test(${name} COMMAND ${NDL_PYTHON} ${script} ${A_ARGS}
        LABELS ${A_LABELS} TIMEOUT ${A_TIMEOUT})
endfunction()
