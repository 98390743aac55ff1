foreach(tool recipe run)
  add_executable(${PROJECT_NAME}_${tool} src/tools/${tool}.cpp)
  set_target_properties(${PROJECT_NAME}_${tool} PROPERTIES OUTPUT_NAME ${tool})
  target_link_libraries(${PROJECT_NAME}_${tool}
    ${PROJECT_NAME}_core ${PROJECT_NAME}_history CLI11::CLI11)
endforeach()

add_executable(${PROJECT_NAME}_node src/ros/design_service.cpp src/ros/markers.cpp src/ros/part_recipes_node.cpp
  src/ros/recipe_services.cpp src/ros/run_display.cpp src/ros/run_markers.cpp src/ros/run_server.cpp)
target_include_directories(${PROJECT_NAME}_node PRIVATE src/ros)
target_link_libraries(${PROJECT_NAME}_node
  ${PROJECT_NAME}_design ${PROJECT_NAME}_history ${PROJECT_NAME}_view ${catkin_LIBRARIES})
add_dependencies(${PROJECT_NAME}_node ${catkin_EXPORTED_TARGETS})

install(TARGETS
    ${PROJECT_NAME}_node ${PROJECT_NAME}_recipe ${PROJECT_NAME}_run
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
catkin_install_python(PROGRAMS scripts/recipe_picture.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

if(CATKIN_ENABLE_TESTING)
  catkin_add_nosetests(test/replay/test_slurm.py TIMEOUT 600
    DEPENDENCIES ${PROJECT_NAME}_history_tool ${PROJECT_NAME}_recipe ${PROJECT_NAME}_run clean_cloud deviations stretch)
endif()
