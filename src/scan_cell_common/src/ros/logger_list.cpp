// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/logger_list.h"

#include <ros/names.h>
#include <ros/service_manager.h>

namespace scan_cell_common {

void withdraw_logger_list() {
  ros::ServiceManager::instance()->unadvertiseService(ros::names::resolve("~get_loggers"));
}

}  // namespace scan_cell_common
