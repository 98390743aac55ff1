// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <ros/ros.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <tecnogamma_camera/CameraConfig.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "parameters.h"
#include "scan_cell_common/ros/nodelet.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace tecnogamma_camera {

/// Publishes ~profiles, ~image_raw, ~camera_info, ~frame_info and diagnostics; serves
/// ~set_acquisition.
class CameraNodelet : public scan_cell_common::Nodelet, public AcquisitionListener {
 private:
  void start() override;
  void advertise();
  RecordingKinds recordings() const;
  void start_reconfigure();

  void on_frame(const NumberedFrame& frame) override;
  void on_connected(const CameraDescription& camera) override;
  void on_ended(const std::string& recording) override;
  void on_trouble(const std::string& reason) override;

  std::string fault_of_model(const CameraDescription& camera) const;
  void publish_profile(const NumberedFrame& frame);
  void publish_image(const NumberedFrame& frame);
  bool set_acquisition(scan_cell_msgs::SetAcquisition::Request& request,
                       scan_cell_msgs::SetAcquisition::Response& response);
  std::uint32_t set_and_show(AcquisitionMode mode, Trigger trigger,
                             const scan_cell_msgs::CameraSettings& settings);
  Tuning tuning() const;
  void tune(const Tuning& tuning);
  void show(const CameraSettings& settings);
  void reconfigure(CameraConfig& config);
  void change_tuning(CameraConfig& config);
  void change_exposure(CameraConfig& config);
  void change_region(CameraConfig& config);
  void publish_diagnostics(const ros::WallTimerEvent& event);

  Parameters parameters_;
  std::optional<scan_cell_common::ScannerModel> model_;
  ros::Publisher profiles_;
  ros::Publisher images_;
  ros::Publisher camera_infos_;
  ros::Publisher frame_infos_;
  ros::ServiceServer set_acquisition_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  AcquisitionState diagnosed_;
  std::uint64_t profiles_to_image_ = 0;

  mutable std::mutex detector_mutex_;
  Tuning tuning_;
  std::shared_ptr<const PeakDetector> detector_;  // as tuning_ has it

  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<CameraConfig>> reconfigure_;
  CameraConfig config_;

  std::unique_ptr<Acquisition>
      acquisition_;  // last: its thread uses all of the above, and ends first
};

}  // namespace tecnogamma_camera
