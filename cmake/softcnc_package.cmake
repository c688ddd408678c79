# SPDX-License-Identifier: MIT
# What cmake --install installs: the program with its man page, completions and example programs; the
# library; and its headers, with the target softcnc::softcnc for find_package(softcnc CONFIG) and a
# file for pkg-config. Each component is a Debian package (softcnc_debian.cmake).
include(CMakePackageConfigHelpers)
find_program(SOFTCNC_GZIP gzip)

if(TARGET softcnc)
  install(TARGETS softcnc COMPONENT program)
  install(DIRECTORY programs DESTINATION ${CMAKE_INSTALL_DATADIR}/softcnc COMPONENT program)
  find_package(Python3 COMPONENTS Interpreter)
  if(Python3_FOUND AND SOFTCNC_GZIP AND NOT CMAKE_CROSSCOMPILING)
    set(manual ${PROJECT_BINARY_DIR}/manual)
    set(generate ${PROJECT_SOURCE_DIR}/scripts/parts/generate)
    add_custom_command(
      OUTPUT ${manual}/softcnc.1.gz ${manual}/softcnc.bash ${manual}/_softcnc ${manual}/softcnc.fish
      COMMAND Python3::Interpreter -B ${generate}/manual.py ${manual} $<TARGET_FILE:softcnc>
      COMMAND ${SOFTCNC_GZIP} -9fn ${manual}/softcnc.1
      DEPENDS softcnc ${generate}/manual.py ${generate}/options.py docs/cli.md
      VERBATIM)
    add_custom_target(softcnc_manual ALL DEPENDS ${manual}/softcnc.1.gz)
    set(share ${CMAKE_INSTALL_DATADIR})
    install(FILES ${manual}/softcnc.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
            COMPONENT program OPTIONAL)
    install(FILES ${manual}/softcnc.bash DESTINATION ${share}/bash-completion/completions
            RENAME softcnc COMPONENT program OPTIONAL)
    install(FILES ${manual}/_softcnc DESTINATION ${share}/zsh/vendor-completions
            COMPONENT program OPTIONAL)
    install(FILES ${manual}/softcnc.fish DESTINATION ${share}/fish/vendor_completions.d
            COMPONENT program OPTIONAL)
  endif()
endif()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/softcnc)
install(TARGETS softcnc_library EXPORT softcnc
        LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS softcnc_archive EXPORT softcnc ARCHIVE COMPONENT development)
install(DIRECTORY include/softcnc TYPE INCLUDE COMPONENT development)
install(EXPORT softcnc NAMESPACE softcnc:: DESTINATION ${package_folder}
        FILE softcnc-targets.cmake COMPONENT development)
configure_package_config_file(cmake/softcnc-config.cmake.in softcnc-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(softcnc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/softcnc-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/softcnc-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

file(RELATIVE_PATH up_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/softcnc.pc.in softcnc.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/softcnc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
if(PROJECT_IS_TOP_LEVEL AND SOFTCNC_GZIP)
  include(cmake/softcnc_debian.cmake)
endif()
