# SPDX-License-Identifier: MIT
# What every target of softcnc is compiled with.
add_library(softcnc_options INTERFACE)
target_include_directories(softcnc_options INTERFACE ${PROJECT_SOURCE_DIR}/libs)
target_compile_options(softcnc_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  -ffp-contract=off)  # one build, one family of CPUs: the same bytes
if(SOFTCNC_SANITIZE)
  target_compile_options(softcnc_options INTERFACE
    -fsanitize=${SOFTCNC_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(softcnc_options INTERFACE -fsanitize=${SOFTCNC_SANITIZE})
endif()
if(SOFTCNC_SANITIZE MATCHES thread)  # which does not know the fences of readerwriterqueue
  target_compile_options(softcnc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()
if(SOFTCNC_FUZZ)
  # Comparisons are not traced: most are checks of the sanitizers, and to trace them takes longer than
  # all the rest. The words that count stand in the dictionaries.
  target_compile_options(softcnc_options INTERFACE -fsanitize=fuzzer-no-link
                                                   -fno-sanitize-coverage=trace-cmp)
endif()

if(SOFTCNC_LTO AND NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  message(FATAL_ERROR "SOFTCNC_LTO is for g++ alone, and this is ${CMAKE_CXX_COMPILER_ID}")
endif()

# softcnc_for_link_time(TARGET): compiled for both ways of linking, as the program is and as tests are.
function(softcnc_for_link_time target)
  if(SOFTCNC_LTO)
    target_compile_options(${target} PRIVATE -flto=auto -ffat-lto-objects)
    target_link_options(${target} INTERFACE
      $<IF:$<BOOL:$<TARGET_PROPERTY:SOFTCNC_LINK_TIME>>,-flto=auto,-fno-lto>)
  endif()
endfunction()

# softcnc_room(NAME [COMPUTES] STANDS_ON targets...): one room of the house, made of the sources in its
# folder. One that COMPUTES is optimised for it: its loops over axes and terms are unrolled. Readers
# and writers only grow by that.
function(softcnc_room name)
  cmake_parse_arguments(ROOM "COMPUTES" "" "STANDS_ON" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(softcnc_${name} STATIC ${sources})
  add_library(softcnc::${name} ALIAS softcnc_${name})
  target_link_libraries(softcnc_${name} PUBLIC softcnc_options ${ROOM_STANDS_ON})
  softcnc_for_link_time(softcnc_${name})
  if(ROOM_COMPUTES)
    target_compile_options(softcnc_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
  endif()
  if(SOFTCNC_COVERAGE STREQUAL name)
    target_compile_options(softcnc_${name} PRIVATE --coverage -fprofile-abs-path)
    target_link_options(softcnc_${name} PUBLIC --coverage)
  endif()
endfunction()
