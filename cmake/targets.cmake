# How a folder becomes a library, and what all our own code is compiled with.
add_library(lsos_options INTERFACE)
target_compile_features(lsos_options INTERFACE cxx_std_20)
# -ffp-contract=off: the same sums on every optimisation level (equal logs are a promise).
target_compile_options(lsos_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Wno-sign-conversion -ffp-contract=off
  $<$<BOOL:${LSOS_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  if(LSOS_UNITY)
    # A variable may have the name of a constant of another file.
    target_compile_options(lsos_options INTERFACE -Wno-shadow -Wshadow=local)
  endif()
  # Lets ccache keep what is built with precompiled headers; with those, GCC 12 takes parts of
  # strings for out of bounds that are not.
  target_compile_options(lsos_options INTERFACE
    -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(LSOS_SANITIZE)
  target_compile_options(lsos_options INTERFACE
    -fsanitize=${LSOS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(lsos_options INTERFACE -fsanitize=${LSOS_SANITIZE})
endif()

# What most files include. None of ours: ccache takes a precompiled header whose comments changed
# for the same, but then #pragma once does not know it again and it is read twice.
set(common_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <fmt/format.h> <functional> <limits>
  <map> <memory> <optional> <string> <vector>)

# precompile(lsos_x lsos_base FILE ...): FILE ... are read once, for lsos_base; the others, which
# must be compiled with the same options and definitions, reuse that.
function(precompile target first)
  if(target STREQUAL first)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${first})
  endif()
endfunction()

# lsos_library(plan USES base planet LIBRARIES PkgConfig::tinyxml2)
# USES: our folders that its headers may name. LIBRARIES: third-party, hidden behind it.
function(lsos_library name)
  cmake_parse_arguments(ARG "" "" "USES;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  add_library(lsos_${name} STATIC ${sources})
  target_include_directories(lsos_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM ARG_USES PREPEND lsos_)
  target_link_libraries(lsos_${name} PUBLIC lsos_options ${ARG_USES} PRIVATE ${ARG_LIBRARIES})
  precompile(lsos_${name} lsos_base ${common_headers})
endfunction()

# embed_files(lsos_x assets NAME FILES NAME FILES ...): assets.cpp with a std::string_view lsos::NAME
# each, of the files one after the other. Made again when one of them changes.
function(embed_files target output)
  set(written ${CMAKE_CURRENT_BINARY_DIR}/${output}.cpp)
  set(inputs ${ARGN})
  list(FILTER inputs INCLUDE REGEX "/")
  string(REPLACE ";" "|" words "${ARGN}")
  add_custom_command(OUTPUT ${written}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${written} "-DWORDS=${words}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${inputs} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${written})
endfunction()
