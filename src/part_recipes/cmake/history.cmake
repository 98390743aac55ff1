add_library(${PROJECT_NAME}_history
  src/core/history/chart/run_chart.cpp src/core/history/chart/run_chart_json.cpp
  src/core/history/database/database.cpp
  src/core/history/database/statement.cpp src/core/history/export/aqdef.cpp
  src/core/history/export/history_csv.cpp src/core/history/figure_text.cpp src/core/history/history.cpp
  src/core/history/history_filter.cpp src/core/history/history_rows.cpp
  src/core/history/rebuild.cpp src/core/history/remember.cpp src/core/history/run_folders.cpp
  src/core/statistics/capability.cpp src/core/statistics/individuals_chart.cpp
  src/core/statistics/moments.cpp src/core/statistics/western_electric.cpp)
target_link_libraries(${PROJECT_NAME}_history
  PUBLIC ${PROJECT_NAME}_core
  PRIVATE Boost::headers SQLite::SQLite3 nlohmann_json::nlohmann_json)

add_executable(${PROJECT_NAME}_history_tool
  src/tools/history.cpp src/tools/history_draw.cpp src/tools/history_print.cpp
  src/tools/history_replay.cpp)
set_target_properties(${PROJECT_NAME}_history_tool PROPERTIES OUTPUT_NAME history)
target_link_libraries(${PROJECT_NAME}_history_tool ${PROJECT_NAME}_history CLI11::CLI11)

catkin_install_python(PROGRAMS scripts/history_chart.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY scripts/chart DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
  PATTERN __pycache__ EXCLUDE)
install(TARGETS ${PROJECT_NAME}_history ${PROJECT_NAME}_history_tool
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

add_library(${PROJECT_NAME}_made_runs STATIC EXCLUDE_FROM_ALL
  test/history/made_history.cpp test/history/made_runs.cpp test/temporary_folder.cpp)
target_link_libraries(${PROJECT_NAME}_made_runs PUBLIC ${PROJECT_NAME}_history)
scan_cell_benchmark(bench_history test/history/bench_history.cpp)
target_link_libraries(bench_history
  ${PROJECT_NAME}_made_runs CLI11::CLI11 nlohmann_json::nlohmann_json)

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(test_${PROJECT_NAME}_history
    test/history/test_history.cpp test/history/test_history_chart.cpp
    test/history/test_history_export.cpp test/history/test_history_faults.cpp
    test/history/test_history_kills.cpp test/history/test_statistics.cpp)
  target_link_libraries(test_${PROJECT_NAME}_history
    ${PROJECT_NAME}_made_runs nlohmann_json::nlohmann_json gtest_main)
  catkin_add_gtest(test_${PROJECT_NAME}_approval test/approval/test_approval.cpp)
  target_link_libraries(test_${PROJECT_NAME}_approval ${PROJECT_NAME}_made_runs gtest_main)
  catkin_add_gtest(test_${PROJECT_NAME}_history_tool test/history/test_history_tool.cpp)
  target_compile_definitions(test_${PROJECT_NAME}_history_tool
    PRIVATE HISTORY_TOOL="$<TARGET_FILE:${PROJECT_NAME}_history_tool>")
  target_link_libraries(test_${PROJECT_NAME}_history_tool
    ${PROJECT_NAME}_made_runs nlohmann_json::nlohmann_json gtest_main)
  add_dependencies(test_${PROJECT_NAME}_history_tool ${PROJECT_NAME}_history_tool)
endif()
