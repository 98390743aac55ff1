# Paths that a person edits

add_library(${PROJECT_NAME}_path_edits src/core/path_edits/edited_report.cpp)
target_link_libraries(${PROJECT_NAME}_path_edits
  PUBLIC scan_cell::tool_path_stretcher_core scan_cell::tool_paths_core
  PRIVATE nlohmann_json::nlohmann_json)

add_executable(edit_path src/tools/edit_path.cpp)
target_link_libraries(edit_path
  ${PROJECT_NAME}_path_edits ${PROJECT_NAME}_deviation scan_cell::tool_path_programs_core
  CLI11::CLI11)

install(TARGETS ${PROJECT_NAME}_path_edits
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS edit_path RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_${PROJECT_NAME}_edit_path
    test/made_up_part.cpp test/path_edits/test_edit_path.cpp test/temporary_folder.cpp)
  target_compile_definitions(test_${PROJECT_NAME}_edit_path
    PRIVATE EDIT_PATH="$<TARGET_FILE:edit_path>" STRETCH="$<TARGET_FILE:stretch>")
  target_link_libraries(test_${PROJECT_NAME}_edit_path
    ${PROJECT_NAME}_path_edits scan_cell::scan_cell_common_clouds
    scan_cell::tool_path_programs_core nlohmann_json::nlohmann_json gtest_main)
  add_dependencies(test_${PROJECT_NAME}_edit_path edit_path stretch)
endif()
