# Batches: some sources of a target are compiled as one, so that what they include is read once and not once a source.
# SCAN_CELL_BATCH is how many at most; 1 compiles each alone. A target's property of that name makes its batches smaller.
# A folder's sources share their anonymous namespace: no two may give one name to two things there, tests neither.
#
# CMake's own unity builds name the sources by their whole paths (up to CMake 3.29), so that a compiler cache never finds
# what another checkout compiled.
set(SCAN_CELL_BATCH 8 CACHE STRING "sources of a target that are compiled as one")

# A folder with fewer sources is compiled with the next one.
set(_scan_cell_min_batch 3)

# Writes a batch of the target, which takes it in place of its sources.
function(_scan_cell_write_batch target number)
  set(batch ${CMAKE_CURRENT_BINARY_DIR}/batches/${target}_${number}.cpp)
  set(content "")
  foreach(source ${ARGN})
    string(APPEND content "#include \"${source}\"\n")
  endforeach()
  file(CONFIGURE OUTPUT ${batch} CONTENT "${content}" @ONLY)
  target_sources(${target} PRIVATE ${batch})
endfunction()

# Sources with options or definitions of their own stay alone, and those that say so by CMake's own property for that. One
# source is no batch.
function(_scan_cell_batch target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    get_source_file_property(skips ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(source MATCHES "^[^/].*\\.cpp$" AND NOT options AND NOT definitions AND NOT skips)
      list(APPEND batched ${source})
    else()
      list(APPEND alone ${source})
    endif()
  endforeach()
  list(LENGTH batched count)
  if(count LESS 2)
    return()
  endif()
  set_target_properties(${target} PROPERTIES SOURCES "${alone}" SCAN_CELL_IN_BATCHES ON)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  # A constant within a function may have the name of one in another source.
  target_compile_options(${target} PRIVATE -Wno-shadow -Wno-subobject-linkage)
  get_target_property(max_batch ${target} SCAN_CELL_BATCH)
  if(NOT max_batch OR max_batch GREATER SCAN_CELL_BATCH)
    set(max_batch ${SCAN_CELL_BATCH})
  endif()
  set(number 0)
  foreach(source ${batched})
    get_filename_component(folder ${source} DIRECTORY)
    list(LENGTH batch count)
    if(count EQUAL max_batch OR (count GREATER_EQUAL _scan_cell_min_batch AND NOT folder STREQUAL last_folder))
      _scan_cell_write_batch(${target} ${number} ${batch})
      math(EXPR number "${number} + 1")
      set(batch "")
    endif()
    list(APPEND batch ${source})
    set(last_folder ${folder})
  endforeach()
  _scan_cell_write_batch(${target} ${number} ${batch})
endfunction()

# For the targets of the calling package, when all are known.
function(scan_cell_batch_targets)
  if(SCAN_CELL_BATCH LESS 2)
    return()
  endif()
  get_directory_property(targets BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC|SHARED)_LIBRARY$|EXECUTABLE")
      _scan_cell_batch(${target})
    endif()
  endforeach()
endfunction()

# scan_cell_batches(): for all targets of the calling package.
macro(scan_cell_batches)
  cmake_language(DEFER CALL scan_cell_batch_targets)
endmacro()
