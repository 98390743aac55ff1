add_library(${PROJECT_NAME}_core
  src/core/approval/approval.cpp src/core/clock/utc_time.cpp src/core/disk/folder_lock.cpp
  src/core/disk/to_disk.cpp src/core/recipe/new_recipe.cpp src/core/recipe/places_file.cpp
  src/core/recipe/proof.cpp src/core/recipe/recipe_check.cpp src/core/recipe/recipe_edits.cpp
  src/core/recipe/recipe_file.cpp src/core/recipe/recipe_names.cpp src/core/record/record_names.cpp
  src/core/record/run_record.cpp src/core/record/work_records.cpp src/core/replay/job_folder.cpp
  src/core/replay/replay.cpp src/core/run/again.cpp src/core/run/calls/recipe_reading.cpp
  src/core/run/calls/stage_calls.cpp src/core/run/calls/tool_call.cpp src/core/run/place_check.cpp
  src/core/run/prove.cpp src/core/run/recipe_picture.cpp src/core/run/report/cleaned_away.cpp
  src/core/run/report/figures.cpp src/core/run/run_folder.cpp src/core/run/run_recipe.cpp
  src/core/run/work.cpp src/core/view/waypoints_concerned.cpp)
target_link_libraries(${PROJECT_NAME}_core
  PUBLIC
    ${PROJECT_NAME}_deviation scan_cell::scan_cell_common_core scan_cell::scan_cell_core
    scan_cell::tool_path_stretcher_core scan_cell::tool_paths_core
  PRIVATE
    CLI11::CLI11 scan_cell::cloud_preprocess_core scan_cell::scan_cell_common_yaml
    nlohmann_json::nlohmann_json Boost::filesystem)

# What is shown of a run
add_library(${PROJECT_NAME}_view
  src/core/view/deviation_colours.cpp src/core/view/judged_figures.cpp src/core/view/run_view.cpp)
target_link_libraries(${PROJECT_NAME}_view
  PUBLIC ${PROJECT_NAME}_core ${PROJECT_NAME}_deviation
  PRIVATE CLI11::CLI11 nlohmann_json::nlohmann_json)

# Paths made on a recipe's reference
add_library(${PROJECT_NAME}_design src/core/design/path_option.cpp src/core/design/recipe_path.cpp)
target_link_libraries(${PROJECT_NAME}_design
  PUBLIC ${PROJECT_NAME}_core ${PROJECT_NAME}_path_design)

install(TARGETS ${PROJECT_NAME}_core ${PROJECT_NAME}_design ${PROJECT_NAME}_view
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})

scan_cell_benchmark(bench_replay
  test/replay/bench_replay.cpp test/temporary_folder.cpp)
target_link_libraries(bench_replay ${PROJECT_NAME}_core CLI11::CLI11)

scan_cell_fuzzer(fuzz_recipes
  test/recipe/fuzz_recipes.cpp test/recipe/recipe_targets.cpp)
target_link_libraries(fuzz_recipes ${PROJECT_NAME}_core ${scan_cell_common_LIBRARIES})

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_${PROJECT_NAME}_recipe
    test/made_up_part.cpp test/recipe/recipe_targets.cpp test/recipe/test_fuzz_recipes.cpp
    test/recipe/test_recipe_file.cpp test/temporary_folder.cpp)
  target_link_libraries(test_${PROJECT_NAME}_recipe ${PROJECT_NAME}_core
    ${scan_cell_common_LIBRARIES} scan_cell::scan_cell_common_clouds gtest_main)
  catkin_add_gtest(test_${PROJECT_NAME}_run
    test/made_up_part.cpp test/run/test_cleaned_away.cpp test/run/test_place_check.cpp
    test/run/test_recipe_edits.cpp test/run/test_run.cpp test/run/test_run_folder.cpp
    test/run/test_sight.cpp test/run/test_work_records.cpp test/temporary_folder.cpp
    test/view/test_deviation_colours.cpp test/view/test_judged_figures.cpp
    test/view/test_run_view.cpp)
  target_link_libraries(test_${PROJECT_NAME}_run
    ${PROJECT_NAME}_view scan_cell::cloud_preprocess_core scan_cell::scan_cell_common_clouds
    scan_cell::scan_cell_core nlohmann_json::nlohmann_json gtest_main)
  target_compile_definitions(test_${PROJECT_NAME}_run PRIVATE
    SCANNER_FILE="${CMAKE_CURRENT_SOURCE_DIR}/../scan_cell_sim/config/scanner.yaml")
  add_dependencies(test_${PROJECT_NAME}_run
    clean_cloud deviations edit_path export_path scan seen_waypoints stretch)
  catkin_add_gtest(test_${PROJECT_NAME}_design
    test/design/test_recipe_path.cpp test/made_up_part.cpp test/temporary_folder.cpp)
  target_link_libraries(test_${PROJECT_NAME}_design
    ${PROJECT_NAME}_design scan_cell::scan_cell_common_clouds gtest_main)
  add_dependencies(test_${PROJECT_NAME}_design path)
  catkin_add_gtest(test_${PROJECT_NAME}_replay
    test/made_up_part.cpp test/replay/test_job_folder.cpp test/replay/test_replay.cpp
    test/temporary_folder.cpp)
  target_link_libraries(test_${PROJECT_NAME}_replay
    ${PROJECT_NAME}_core scan_cell::scan_cell_common_clouds gtest_main)
  add_dependencies(test_${PROJECT_NAME}_replay clean_cloud export_path stretch)
endif()
