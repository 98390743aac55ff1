// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CalibrateAction.h>
#include <scan_cell_msgs/PreviewWork.h>
#include <scan_cell_msgs/ScanAction.h>
#include <scan_cell_msgs/StretchToolPathAction.h>
#include <scan_cell_msgs/WorkAction.h>

#include <functional>
#include <optional>
#include <string>

#include "scan_cell/ros/cell_watcher.h"
#include "scan_cell/scan_program.h"

namespace scan_cell {

/// The cell's calibration: the files with which its nodes were started, as the nodes name them.
struct CalibrationFiles {
  std::string scanner;  //!< scanner model; empty: not known
  std::string cell;     //!< where robot and tool are; empty: not known
};

/// Uses a running cell as a person does: scan, get the clean cloud, adapt a path. Calls block;
/// callbacks of the node must be served by another thread (ros::AsyncSpinner). While a goal is in
/// progress, SIGINT, SIGTERM and SIGHUP cancel it, and the call returns its result. If this process
/// dies, even by SIGKILL, the cell cancels a scan or a calibration by itself.
class CellClient {
 public:
  struct Names {
    std::string scan = "/scan_cell/scan";                  //!< action
    std::string calibrate = "/scan_cell/calibrate";        //!< action
    std::string work = "/scan_cell/work";                  //!< action
    std::string preview = "/scan_cell/preview_work";       //!< service
    std::string state = "/scan_cell/state";                //!< topic
    std::string stretch = "/tool_path_stretcher/stretch";  //!< action
    std::string clean_cloud = "/preprocess/clean_cloud";   //!< topic, result of the preprocessing
    std::string report = "/preprocess/report";  //!< topic, reports of the preprocessing stages
    std::string frames = "/calibrated_frames";  //!< node with the calibration's files
    std::string camera = "/camera";             //!< node
  };

  /// @param what the present activity @param progress 0 .. 1
  using Progress = std::function<void(const std::string& what, double progress)>;

  CellClient(ros::NodeHandle node, const Names& names);

  /// @param timeout [s] to wait for the cell's action server and for it to accept the scan
  /// @throw ConnectionError if the cell is not there or goes away
  scan_cell_msgs::ScanResult scan(const ScanProgram& program, const std::string& scan_id,
                                  double timeout, const Progress& progress);

  /// Scans as scan() and waits for the preprocessing of the cloud.
  /// @param result filled as soon as the scan has ended
  /// @throw Refused if the scan did not finish or a stage of preprocessing failed, with its reason
  sensor_msgs::PointCloud2 scan_clean(const ScanProgram& program, const std::string& scan_id,
                                      double timeout, const Progress& progress,
                                      scan_cell_msgs::ScanResult& result);

  /// Records a calibration session, and computes the model if the goal names an output.
  /// @throw ConnectionError if the cell is not there or goes away
  scan_cell_msgs::CalibrateResult calibrate(const scan_cell_msgs::CalibrateGoal& goal,
                                            double timeout, const Progress& progress);

  /// @throw ConnectionError if the stretcher is not there or goes away
  scan_cell_msgs::StretchToolPathResult stretch(const scan_cell_msgs::StretchToolPathGoal& goal,
                                                double timeout, const Progress& progress);

  /// Runs an adapted path.
  /// @throw ConnectionError if the cell is not there or goes away
  scan_cell_msgs::WorkResult work(const scan_cell_msgs::WorkGoal& goal, double timeout,
                                  const Progress& progress);

  /// What the robot would do with that goal; the cell also shows it on ~work_preview. Nothing
  /// moves.
  /// @throw ConnectionError if the cell is not there
  scan_cell_msgs::PreviewWorkResponse preview(const scan_cell_msgs::WorkGoal& goal,
                                              double timeout) const;

  CalibrationFiles calibration_files() const;  //!< of the running cell

  /// The camera's region between scans, from its node; none: there is no such node.
  std::optional<CameraRegion> camera_region() const;

 private:
  ros::NodeHandle node_;
  Names names_;
  CellWatcher watcher_;
};

}  // namespace scan_cell
