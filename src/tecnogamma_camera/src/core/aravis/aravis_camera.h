// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

/// One line of a list of cameras.
struct CameraListing {
  std::string id;         //!< to open it
  std::string vendor;     //!< as the camera reports it
  std::string model;      //!< as the camera reports it
  std::string serial;     //!< as the camera reports it
  std::string address;    //!< on the network
  std::string transport;  //!< GigEVision or USB3Vision
};

/// All GenICam cameras that answer on the network or on USB. Takes about a second.
std::vector<CameraListing> list_aravis_cameras();

/// Options of the transport.
struct AravisOptions {
  int buffers = 32;           //!< frames that may wait to be grabbed
  int packet_size = 0;        //!< [bytes] 0: the largest the network passes
  bool packet_socket = true;  //!< receive below the IP stack if permitted: less load
  bool packet_resend = true;  //!< ask for missing packets again
  bool realtime = true;       //!< receive in a real-time thread if permitted
  bool is_payload = false;    //!< the rows it sends are not sensor rows
};

/// Opens a GenICam camera with 8 bit grey pixels through Aravis.
/// @param name id, serial number or IP address; empty: the only camera that answers
/// @throw scan_cell_common::ConnectionError if it does not answer, is held by another program, or
/// `name` is empty and there is not exactly one
/// @throw MissingFeature if it lacks what every GenICam camera should have
std::unique_ptr<Camera> open_aravis_camera(const std::string& name, const AravisOptions& options);

}  // namespace tecnogamma_camera
