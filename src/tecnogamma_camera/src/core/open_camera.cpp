// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "open_camera.h"

#include "payload/decoding_camera.h"
#include "recording/folder_recording.h"

namespace tecnogamma_camera {
namespace {

constexpr const char* kImage = "image";
constexpr const char* kTecnogamma = "tecnogamma_relief";
constexpr const char* kPhotonfocus = "photonfocus_3d03";

/// nullptr for images.
std::unique_ptr<PayloadDecoder> make_decoder(const PayloadOptions& options) {
  if (options.format == kImage) return nullptr;
  if (options.format == kTecnogamma) return std::make_unique<TecnogammaDecoder>(options.tecnogamma);
  if (options.format == kPhotonfocus)
    return std::make_unique<Photonfocus3D03Decoder>(options.photonfocus);
  throw scan_cell_common::InvalidParameter("payload", options.format,
                                           "give image, tecnogamma_relief or photonfocus_3d03");
}

std::unique_ptr<Camera> open_source(const std::string& name, const CameraOptions& options,
                                    RecordingKinds kinds, bool is_payload) {
  kinds.emplace("folder", open_folder_recording);
  const std::size_t colon = name.find(':');
  const auto kind = kinds.find(name.substr(0, colon));
  if (colon == std::string::npos || kind == kinds.end()) {
    AravisOptions stream = options.stream;
    stream.is_payload = is_payload;
    return open_aravis_camera(name, stream);
  }
  return std::make_unique<RecordedCamera>(kind->second(name.substr(colon + 1)), options.playback,
                                          is_payload);
}

}  // namespace

const std::vector<std::string>& payload_names() {
  static const std::vector<std::string> names = {kImage, kTecnogamma, kPhotonfocus};
  return names;
}

std::unique_ptr<Camera> open_camera(const std::string& name, const CameraOptions& options,
                                    const RecordingKinds& kinds) {
  std::unique_ptr<PayloadDecoder> decoder = make_decoder(options.payload);
  std::unique_ptr<Camera> camera = open_source(name, options, kinds, decoder != nullptr);
  if (!decoder) return camera;
  return std::make_unique<DecodingCamera>(std::move(camera), std::move(decoder));
}

}  // namespace tecnogamma_camera
