# Paths for parts that have none

set(path_design ${CMAKE_CURRENT_SOURCE_DIR}/src/core/path_design)
add_library(${PROJECT_NAME}_path_design
  ${path_design}/border/border.cpp
  ${path_design}/border/border_distance.cpp
  ${path_design}/border/links.cpp
  ${path_design}/border/offset.cpp
  ${path_design}/border/offset_runs.cpp
  ${path_design}/border/offset_sources.cpp
  ${path_design}/border/smoothed_border.cpp
  ${path_design}/from_edge.cpp
  ${path_design}/from_picks.cpp
  ${path_design}/from_slices.cpp
  ${path_design}/path_builder.cpp
  ${path_design}/path_parameters.cpp
  ${path_design}/picks_file.cpp
  ${path_design}/raster_frame.cpp
  ${path_design}/spline.cpp
  ${path_design}/surface/cloud_sheet.cpp
  ${path_design}/surface/corner_normals.cpp
  ${path_design}/surface/mesh_search.cpp
  ${path_design}/surface/part_mesh.cpp
  ${path_design}/surface/reference.cpp
  ${path_design}/surface/smoothed_cloud.cpp
  ${path_design}/surface/winding.cpp
  ${path_design}/trace/bends.cpp
  ${path_design}/trace/slice.cpp
  ${path_design}/trace/stepping.cpp
  ${path_design}/trace/trace.cpp
  ${path_design}/trace/waypoints.cpp)
target_link_libraries(${PROJECT_NAME}_path_design
  PUBLIC
    scan_cell::scan_cell_common_clouds scan_cell::scan_cell_common_core
    scan_cell::tool_path_stretcher_core scan_cell::tool_paths_core
  PRIVATE Boost::headers embree)

add_executable(path src/tools/path.cpp)
target_link_libraries(path ${PROJECT_NAME}_path_design CLI11::CLI11)

install(TARGETS ${PROJECT_NAME}_path_design
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS path RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_${PROJECT_NAME}_path_design
    test/path_design/shapes.cpp test/path_design/test_from_edge.cpp
    test/path_design/test_from_picks.cpp test/path_design/test_from_slices.cpp
    test/path_design/test_path_tool.cpp test/path_design/test_stretched.cpp)
  target_compile_definitions(test_${PROJECT_NAME}_path_design
    PRIVATE DOCUMENT="${PROJECT_SOURCE_DIR}/../../docs/making_a_path.md"
    PATH_TOOL="$<TARGET_FILE:path>")
  target_link_libraries(test_${PROJECT_NAME}_path_design
    ${PROJECT_NAME}_path_design gtest_main)
  add_dependencies(test_${PROJECT_NAME}_path_design path)
endif()
