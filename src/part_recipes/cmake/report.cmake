# Deviations of an object from its reference, and the page of a run
set(deviation ${CMAKE_CURRENT_SOURCE_DIR}/src/core/deviation)
add_library(${PROJECT_NAME}_deviation
  ${deviation}/adapted_part.cpp ${deviation}/deviation_files.cpp ${deviation}/deviations.cpp
  ${deviation}/places.cpp ${deviation}/reference/cloud_reference.cpp
  ${deviation}/reference/mesh_reference.cpp ${deviation}/reference/reference_surface.cpp
  ${deviation}/scene/path_files.cpp ${deviation}/scene/path_reading.cpp
  ${deviation}/scene/path_scene.cpp
  ${deviation}/scene/reference_scene.cpp ${deviation}/statistics.cpp)
target_link_libraries(${PROJECT_NAME}_deviation
  PUBLIC
    scan_cell::scan_cell_common_clouds scan_cell::tool_path_stretcher_core
    scan_cell::tool_paths_core
  PRIVATE
    ${PROJECT_NAME}_path_design scan_cell::scan_cell_common_yaml
    scan_cell::tool_path_programs_core nlohmann_json::nlohmann_json)

foreach(tool deviations report_scene)
  add_executable(${tool} src/tools/${tool}.cpp)
  target_link_libraries(${tool} ${PROJECT_NAME}_deviation CLI11::CLI11)
endforeach()

install(TARGETS ${PROJECT_NAME}_deviation
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS deviations report_scene RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

# The page is drawn by Python; its modules, template, style and scripts lie beside the script
catkin_install_python(PROGRAMS scripts/report_page.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY scripts/report DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
  PATTERN __pycache__ EXCLUDE)

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_${PROJECT_NAME}_deviation
    test/deviation/drawn_surfaces.cpp test/deviation/test_deviations.cpp
    test/deviation/test_places.cpp test/deviation/test_scene.cpp
    test/deviation/test_statistics.cpp)
  target_link_libraries(test_${PROJECT_NAME}_deviation
    ${PROJECT_NAME}_deviation nlohmann_json::nlohmann_json gtest_main)
  catkin_add_gtest(test_${PROJECT_NAME}_deviations_command
    test/deviation/drawn_surfaces.cpp test/deviation/test_deviations_command.cpp)
  target_compile_definitions(test_${PROJECT_NAME}_deviations_command
    PRIVATE DEVIATIONS="$<TARGET_FILE:deviations>" REPORT_SCENE="$<TARGET_FILE:report_scene>")
  target_link_libraries(test_${PROJECT_NAME}_deviations_command
    ${PROJECT_NAME}_deviation nlohmann_json::nlohmann_json gtest_main)
  add_dependencies(test_${PROJECT_NAME}_deviations_command deviations report_scene)
  # In a Chromium without a screen, which draws in software: minutes on a busy computer
  catkin_add_nosetests(test/report TIMEOUT 1200 DEPENDENCIES deviations report_scene stretch)
endif()
