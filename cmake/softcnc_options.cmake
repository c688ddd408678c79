# SPDX-License-Identifier: MIT
# The options of every target of softcnc.
add_library(softcnc_options INTERFACE)
set(softcnc_warnings_are_errors FALSE)
if(SOFTCNC_WERROR AND "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES
   "^(GNU 12|Clang 14)\\.")
  set(softcnc_warnings_are_errors TRUE)
endif()
target_include_directories(softcnc_options INTERFACE ${PROJECT_SOURCE_DIR}/libs)
target_compile_options(softcnc_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion $<$<BOOL:${softcnc_warnings_are_errors}>:-Werror>
  $<$<CXX_COMPILER_ID:GNU>:-Wshadow>  # clang++ also compares with the other files of a unity build
  -fvisibility=hidden -fvisibility-inlines-hidden  # the library shows include/softcnc alone
  -ffp-contract=off)  # one build, one family of CPUs: the same bytes
if(SOFTCNC_HARDENED)
  target_compile_definitions(softcnc_options INTERFACE _FORTIFY_SOURCE=2)
  target_link_options(softcnc_options INTERFACE -Wl,-z,relro,-z,now)
endif()
if(SOFTCNC_SANITIZE)
  target_compile_options(softcnc_options INTERFACE
    -fsanitize=${SOFTCNC_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(softcnc_options INTERFACE -fsanitize=${SOFTCNC_SANITIZE})
endif()
if(SOFTCNC_SANITIZE MATCHES thread)  # which does not know the fences of readerwriterqueue
  target_compile_options(softcnc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()
if(SOFTCNC_FUZZ)
  # Comparisons are not traced: most are checks of the sanitizers, and tracing them takes longer than
  # everything else. The dictionaries have the words that matter.
  target_compile_options(softcnc_options INTERFACE -fsanitize=fuzzer-no-link
                                                   -fno-sanitize-coverage=trace-cmp)
endif()

# softcnc_precompile(TARGET [HEADER...]): compiles what nearly every file includes, and further
# headers, once for the target.
function(softcnc_precompile target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <deque> <functional> <map> <memory> <optional> <span>
    <string> <string_view> <utility> <variant> <vector> <Eigen/Core> <tl/expected.hpp> ${ARGN})
  # g++ 12 takes strings out of a precompiled header for code of ours, and warns falsely; so it does
  # of std::optional where one file of a unity build is compiled behind many others.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-stringop-overread>)
endfunction()

# softcnc_library(NAME [COMPUTES] STANDS_ON targets...): a library of the sources below its folder. One
# that COMPUTES has its loops over axes and terms unrolled; readers and writers would only grow by
# that.
function(softcnc_library name)
  cmake_parse_arguments(LIBRARY "COMPUTES" "" "STANDS_ON" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(softcnc_${name} STATIC ${sources})
  add_library(softcnc::${name} ALIAS softcnc_${name})
  set_target_properties(softcnc_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(softcnc_${name} PUBLIC softcnc_options ${LIBRARY_STANDS_ON})
  softcnc_precompile(softcnc_${name})
  if(LIBRARY_COMPUTES)
    target_compile_options(softcnc_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
  endif()
  if(SOFTCNC_COVERAGE STREQUAL name)
    target_compile_options(softcnc_${name} PRIVATE --coverage -fprofile-abs-path)
    target_link_options(softcnc_${name} PUBLIC --coverage)
  endif()
endfunction()
