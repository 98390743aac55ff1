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
  std::string id;         //!< by which it can be opened
  std::string vendor;     //!< as the camera tells it
  std::string model;      //!< as the camera tells it
  std::string serial;     //!< as the camera tells it
  std::string address;    //!< on the network
  std::string transport;  //!< GigEVision or USB3Vision
};

/// All GenICam cameras that answer on the network or on USB. Takes about a second.
std::vector<CameraListing> list_aravis_cameras();

/// Of the transport.
struct AravisOptions {
  int buffers = 32;           //!< frames that may wait to be grabbed
  int packet_size = 0;        //!< [bytes] 0: the largest that comes through
  bool packet_socket = true;  //!< receive below the IP stack where the rights allow it: less load
  bool packet_resend = true;  //!< ask for missing packets again
  bool realtime = true;       //!< receive in a real-time thread where the rights allow it
  bool is_payload = false;    //!< the rows it sends are not those of its sensor
};

/// Opens a GenICam camera with 8 bit grey pixels through Aravis.
/// @param name id, serial number or IP address; empty where only one camera answers
/// @throw scan_cell_common::ConnectionError if it does not answer, is held by another program, or
/// `name` is empty and there is not exactly one
/// @throw MissingFeature if it lacks what every GenICam camera should have
std::unique_ptr<Camera> open_aravis_camera(const std::string& name, const AravisOptions& options);

}  // namespace tecnogamma_camera
