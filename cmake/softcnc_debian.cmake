# SPDX-License-Identifier: MIT
# The Debian packages that scripts/package makes by CPack: one for each component of what is
# installed (softcnc_package.cmake).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME softcnc)
set(CPACK_PACKAGE_CONTACT "The softcnc authors <softcnc@softcnc.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(debian_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

execute_process(COMMAND git log -1 --format=%aD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT date)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()

# softcnc_debian_package(COMPONENT PACKAGE SECTION SUMMARY TEXT): names the package of a component,
# and installs its changelog and its copyright, which only packages have.
macro(softcnc_debian_package component package section summary text)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}")
  set(folder ${PROJECT_BINARY_DIR}/debian/${package})
  file(CONFIGURE OUTPUT ${folder}/changelog.Debian @ONLY CONTENT
"${package} (${debian_version}) bookworm; urgency=medium

  * Version ${PROJECT_VERSION}; CHANGELOG.md of the sources lists what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  execute_process(COMMAND ${SOFTCNC_GZIP} -9fnk ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  set(folders ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${folder}/changelog.Debian.gz DESTINATION ${folders})
  install(FILES LICENSE DESTINATION ${folders} RENAME copyright)
endmacro()

if(TARGET softcnc)
  softcnc_debian_package(program softcnc misc "control and simulator for CNC mills"
    "softcnc reads a part program (G-code with lines, arcs and NURBS), computes how
fast a machine may follow it within all of its limits, and moves the machine
or a simulated mill. Reports show where a program is slow, and why.")
endif()
set(library libsoftcnc${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
softcnc_debian_package(library ${library} libs "part programs checked, planned and run - library"
  "Programs in C++ use this shared library to check part programs, to plan their
motion within the limits of a machine, and to run them.")
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
softcnc_debian_package(development libsoftcnc-dev libdevel
  "part programs checked, planned and run - headers"
  "The headers of libsoftcnc, files for CMake and pkg-config, and an archive to
link statically, which also needs the recommended packages.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${library} (= ${debian_version}), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libfmt-dev, libtomlplusplus-dev, libxxhash-dev, libyaml-cpp-dev, libzip-dev, libzstd-dev")
if(TARGET softcnc_python)
  softcnc_debian_package(python python3-softcnc python "part programs in Python, as arrays of numpy"
    "The module softcnc checks, plans and simulates part programs; rows of a run are
arrays of numpy. It has sessions, curves, and limits of one's own.")
  # What Python compiles of the modules comes and goes with them, as Debian's policy asks.
  set(folder ${PROJECT_BINARY_DIR}/debian/python3-softcnc)
  file(WRITE ${folder}/postinst
       "#!/bin/sh\nset -e\n[ \"$1\" != configure ] || py3compile -p python3-softcnc\n")
  file(WRITE ${folder}/prerm "#!/bin/sh\nset -e\npy3clean -p python3-softcnc\n")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${folder}/postinst ${folder}/prerm)
  math(EXPR python_after "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${python_after}), python3-numpy")
endif()
include(CPack)
