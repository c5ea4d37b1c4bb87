# SPDX-License-Identifier: Apache-2.0
# Install rules: headers, both libraries, the program, pkg-config files, find_package(ndotl).
include(CMakePackageConfigHelpers)

set(ndl_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ndotl)
file(RELATIVE_PATH ndl_pc_to_prefix /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)
string(REGEX REPLACE "/$" "" ndl_pc_to_prefix "${ndl_pc_to_prefix}")

# Installs the pair lib<name>, lib<name>_static as the export set and .pc file of one component.
function(ndl_install name component)
    install(TARGETS lib${name} lib${name}_static EXPORT ${component}Targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
    install(EXPORT ${component}Targets NAMESPACE ndotl:: DESTINATION ${ndl_config_folder}
        COMPONENT ${component})
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${component}.pc.in
        ${PROJECT_BINARY_DIR}/${component}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${component}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component})
endfunction()

ndl_install(ndotl ndotl)
if(NDOTL_HAS_WORKBENCH)
    string(JOIN " " ndl_workbench_libs ${ndl_workbench_files})
    ndl_install(ndotl_workbench ndotl-workbench)
endif()

# Headers of the workbench only with the workbench.
file(GLOB ndl_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/ndotl/*.h
    ${PROJECT_SOURCE_DIR}/include/ndotl/*.def)
set(ndl_workbench_headers ${ndl_headers})
list(FILTER ndl_headers EXCLUDE REGEX "/(render|data|fit)\\.h$")
list(FILTER ndl_workbench_headers INCLUDE REGEX "/(render|data|fit)\\.h$")
install(FILES ${ndl_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ndotl COMPONENT ndotl)
if(NDOTL_HAS_WORKBENCH)
    install(FILES ${ndl_workbench_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ndotl
        COMPONENT ndotl-workbench)
endif()
install(TARGETS ndotl RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ndotl)
file(GLOB ndl_licences ${PROJECT_SOURCE_DIR}/LICENSE*)
install(FILES ${ndl_licences} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ndotl COMPONENT ndotl)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ndotlConfig.cmake.in
    ${PROJECT_BINARY_DIR}/ndotlConfig.cmake INSTALL_DESTINATION ${ndl_config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ndotlConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ndotlConfig.cmake
    ${PROJECT_BINARY_DIR}/ndotlConfigVersion.cmake
    DESTINATION ${ndl_config_folder} COMPONENT ndotl)
