set(_scan_cell_cmake ${CMAKE_CURRENT_LIST_DIR})
include(${_scan_cell_cmake}/batches.cmake)
include(${_scan_cell_cmake}/precompiled_headers.cmake)

# scan_cell_package([pcl] [json]): C++17, warnings as errors, batches and precompiled headers for all targets of the calling
# package; pcl, json: most of its sources include PCL's points, nlohmann's JSON.
macro(scan_cell_package)
  set(CMAKE_CXX_STANDARD 17)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)
  # A library whose source changed is not linked again into all that use it.
  set(CMAKE_LINK_DEPENDS_NO_SHARED ON)
  # PCL's targets bring VTK and Qt along. Not every toolchain leaves out by default what is not used, and none does under
  # sanitizers.
  add_link_options(-Wl,--as-needed)
  add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror)
  if(CATKIN_ENABLE_TESTING)
    cmake_language(DEFER CALL _scan_cell_check_tests)  # before their sources are batches
  endif()
  scan_cell_batches()
  scan_cell_precompile(${ARGN})
endmacro()

# Refuses a test/**/test_*.cpp of the calling package that no test is made of: it would pass by never running.
function(_scan_cell_check_tests)
  file(GLOB_RECURSE tests RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} test/test_*.cpp)
  get_directory_property(targets BUILDSYSTEM_TARGETS)
  list(FILTER targets INCLUDE REGEX "^test_")
  foreach(target ${targets})
    get_target_property(sources ${target} SOURCES)
    list(REMOVE_ITEM tests ${sources})
  endforeach()
  if(tests)
    message(FATAL_ERROR "${PROJECT_NAME}: no target test_... has these tests among its sources: ${tests}")
  endif()
endfunction()

# scan_cell_find_core(PACKAGE...): makes the targets scan_cell::... of these packages' libraries without ROS known: of this
# workspace, or installed.
macro(scan_cell_find_core)
  foreach(_scan_cell_core ${ARGN})
    if(NOT TARGET scan_cell::${_scan_cell_core}_core)
      find_package(${_scan_cell_core}_core REQUIRED)
    endif()
  endforeach()
endmacro()

# scan_cell_export_core(TARGETS target... [DEPENDS "what find_dependency() takes"...]): exports the calling package's
# libraries without ROS as scan_cell::target, for programs that know neither catkin nor ROS:
# find_package(PACKAGE_core), from the devel space and where it is installed. Call it after their
# install(TARGETS ... EXPORT PACKAGE_core); they take the include directory from here.
function(scan_cell_export_core)
  cmake_parse_arguments(CORE "" "" "TARGETS;DEPENDS" ${ARGN})
  set(name ${PROJECT_NAME}_core)
  foreach(target ${CORE_TARGETS})
    add_library(scan_cell::${target} ALIAS ${target})
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
    target_compile_features(${target} PUBLIC cxx_std_17)
    # They find each other where they are installed, whatever the loader's path.
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "\$ORIGIN")
  endforeach()

  set(config "include(CMakeFindDependencyMacro)\n")
  foreach(dependency ${CORE_DEPENDS})
    string(APPEND config "find_dependency(${dependency})\n")
  endforeach()
  string(APPEND config "include(\"\${CMAKE_CURRENT_LIST_DIR}/${name}Targets.cmake\")\n")
  set(folder ${CATKIN_DEVEL_PREFIX}/lib/cmake/${name})
  file(WRITE ${folder}/${name}Config.cmake "${config}")
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${folder}/${name}ConfigVersion.cmake
    VERSION ${${PROJECT_NAME}_VERSION} COMPATIBILITY SameMinorVersion)
  export(EXPORT ${name} NAMESPACE scan_cell:: FILE ${folder}/${name}Targets.cmake)
  install(EXPORT ${name} NAMESPACE scan_cell:: FILE ${name}Targets.cmake
    DESTINATION lib/cmake/${name})
  install(FILES ${folder}/${name}Config.cmake ${folder}/${name}ConfigVersion.cmake
    DESTINATION lib/cmake/${name})
endfunction()

# A program that only the target COLLECTION builds.
function(_scan_cell_extra_program collection name)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  install(TARGETS ${name} OPTIONAL RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  if(NOT TARGET ${collection})
    add_custom_target(${collection})
  endif()
  add_dependencies(${collection} ${name})
endfunction()

# scan_cell_fuzzer(NAME SOURCE...): a program of make fuzz; link it as any other. With LIBFUZZER among the flags
# (scripts/libfuzzer.sh) clang's libFuzzer brings its main().
function(scan_cell_fuzzer name)
  _scan_cell_extra_program(fuzzers ${name} ${ARGN})
  if(CMAKE_CXX_FLAGS_RELWITHDEBINFO MATCHES "LIBFUZZER")
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  endif()
endfunction()

# scan_cell_benchmark(NAME SOURCE...): a program of make bench; link it as any other.
function(scan_cell_benchmark name)
  _scan_cell_extra_program(benchmarks ${name} ${ARGN})
endfunction()

# scan_cell_tests(): before the tests of the calling package. They run in networks of their own (own_network.py), so
# that ctest may run them beside each other.
macro(scan_cell_tests)
  find_package(rostest REQUIRED)
  # catkin begins the command of every test with it.
  set(CATKIN_ENV ${PYTHON_EXECUTABLE} ${_scan_cell_cmake}/own_network.py ${CATKIN_ENV})
endmacro()
