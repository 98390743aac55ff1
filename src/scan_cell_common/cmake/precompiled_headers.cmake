# Precompiled headers: one for each kind of target, by what the target links (ROS, CLI11, GoogleTest) and what its package
# uses throughout (pcl, json), shared by all targets of the workspace that have the kind; of ROS one a package, since its
# headers take the package's name.

# Of a package; below that a header of ROS costs more than it saves (4 s to make it, 1 s saved a source).
set(_scan_cell_min_ros_sources 4)

set(_scan_cell_headers_core
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <optional> <random> <set>
  <sstream> <string> <vector> <Eigen/Geometry> <fmt/format.h>)
set(_scan_cell_headers_ros <ros/ros.h>)
set(_scan_cell_headers_cli <CLI/CLI.hpp>)
set(_scan_cell_headers_gtest <gtest/gtest.h>)
set(_scan_cell_headers_pcl <pcl/PolygonMesh.h> <pcl/point_cloud.h> <pcl/point_types.h>)
set(_scan_cell_headers_json <nlohmann/json.hpp>)

# GCC takes a precompiled header only where each macro that it asks for is set alike: these come with Boost's and
# fmt's targets, which not all targets link.
macro(_scan_cell_same_macros)
  add_compile_definitions(BOOST_ALL_NO_LIB BOOST_DATE_TIME_DYN_LINK BOOST_FILESYSTEM_DYN_LINK
    BOOST_IOSTREAMS_DYN_LINK BOOST_SERIALIZATION_DYN_LINK BOOST_SYSTEM_DYN_LINK FMT_SHARED)
endmacro()

# Makes the target `name`, which precompiles the headers of the kind.
function(_scan_cell_precompile_headers name kind)
  string(REPLACE _ ";" parts ${kind})
  foreach(part ${parts})
    list(APPEND headers ${_scan_cell_headers_${part}})
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// precompiled headers\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  find_package(Eigen3 REQUIRED)
  find_package(fmt REQUIRED)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen fmt::fmt)
  if(kind MATCHES "gtest")
    target_compile_options(${name} PRIVATE -DGTEST_HAS_PTHREAD=1)
  endif()
  if(kind MATCHES "pcl")
    target_include_directories(${name} SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  endif()
  target_precompile_headers(${name} PRIVATE ${headers})
endfunction()

# core, what the package uses throughout, and ros, cli, gtest where the target links them, with _ between them.
function(_scan_cell_kind target result)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  set(kind ${_scan_cell_core_kind})
  if("${libraries}" MATCHES "roscpp|_ros(;|$)")
    string(APPEND kind _ros)
  endif()
  if("${libraries}" MATCHES "CLI11")
    string(APPEND kind _cli)
  endif()
  if("${libraries}" MATCHES "gtest")
    string(APPEND kind _gtest)
  endif()
  set(${result} ${kind} PARENT_SCOPE)
endfunction()

# For the targets of the calling package, when all are known. Batches read their headers only once anyway: to precompile
# them takes longer than it saves.
function(scan_cell_precompile_targets)
  get_directory_property(targets BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(sources ${target} SOURCES)
    get_target_property(in_batches ${target} SCAN_CELL_IN_BATCHES)
    if(in_batches)
      continue()
    endif()
    if(type MATCHES "^(STATIC|SHARED|OBJECT|MODULE)_LIBRARY$|EXECUTABLE" AND "${sources}" MATCHES "\\.cpp")
      _scan_cell_kind(${target} kind)
      list(APPEND kinds ${kind})
      list(APPEND targets_${kind} ${target})
      list(LENGTH sources count)
      math(EXPR sources_${kind} "0${sources_${kind}} + ${count}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES kinds)
  foreach(kind ${kinds})
    if(kind MATCHES "_ros" AND sources_${kind} LESS _scan_cell_min_ros_sources)
      string(REPLACE _ros "" precompiled scan_cell_precompiled_${kind})
    elseif(kind MATCHES "_ros")
      set(precompiled ${PROJECT_NAME}_precompiled_${kind})
      _scan_cell_precompile_headers(${precompiled} ${kind})
    else()
      set(precompiled scan_cell_precompiled_${kind})
    endif()
    foreach(target ${targets_${kind}})
      target_precompile_headers(${target} REUSE_FROM ${precompiled})
      if(precompiled MATCHES "_ros")
        # GCC forgets the pragma by which boost/function_template.hpp silences it (GCC bug 64117)
        target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
      endif()
    endforeach()
  endforeach()
endfunction()

# scan_cell_precompile([pcl] [json]): for all targets of the calling package, which it adds after this, and what most of its
# sources include.
macro(scan_cell_precompile)
  # the same for libraries and programs: they share the headers
  add_compile_options(-fPIC -pthread)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options(-fpch-preprocess)  # or ccache passes them by
  endif()
  _scan_cell_same_macros()
  string(REPLACE ";" _ _scan_cell_core_kind "core;${ARGN}")
  string(REGEX REPLACE "_$" "" _scan_cell_core_kind ${_scan_cell_core_kind})
  if(NOT TARGET scan_cell_precompiled_${_scan_cell_core_kind})
    add_subdirectory(${_scan_cell_cmake}/precompiled ${CMAKE_BINARY_DIR}/precompiled/${_scan_cell_core_kind})
  endif()
  cmake_language(DEFER CALL scan_cell_precompile_targets)
endmacro()
