// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/nodelet.h>

#include <exception>

#include "scan_cell_common/ros/shutdown_request.h"

namespace scan_cell_common {

/// A nodelet of the suite. If start() throws, one fatal line says why, the manager drops the
/// nodelet, and the process that loads it ends.
class Nodelet : public nodelet::Nodelet {
 protected:
  /// Replaces onInit().
  virtual void start() = 0;

 private:
  void onInit() final {
    set_up_process();
    try {
      start();
    } catch (const std::exception& error) {
      NODELET_FATAL("%s", error.what());
      throw;
    }
  }
};

}  // namespace scan_cell_common
