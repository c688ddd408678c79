# SPDX-License-Identifier: MIT
# What cmake --install installs of the library: headers, the target softcnc::softcnc for
# find_package(softcnc CONFIG), and a file for pkg-config.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/softcnc)
install(TARGETS softcnc_library EXPORT softcnc)
install(DIRECTORY include/softcnc TYPE INCLUDE)
install(EXPORT softcnc NAMESPACE softcnc:: DESTINATION ${package_folder}
        FILE softcnc-targets.cmake)
configure_package_config_file(cmake/softcnc-config.cmake.in softcnc-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(softcnc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/softcnc-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/softcnc-config-version.cmake
        DESTINATION ${package_folder})

file(RELATIVE_PATH up_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/softcnc.pc.in softcnc.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/softcnc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
