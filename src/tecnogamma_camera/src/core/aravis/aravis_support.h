// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arv.h>

#include <memory>
#include <string>

namespace tecnogamma_camera {

struct Unref {
  void operator()(gpointer object) const { g_object_unref(object); }
};
using ArvCameraPtr = std::unique_ptr<ArvCamera, Unref>;
using ArvStreamPtr = std::unique_ptr<ArvStream, Unref>;

/// Turns an error of Aravis into an error of the suite.
/// @param thing what was done, and to which feature
/// @throw MissingFeature, ConnectionError or InvalidParameter; takes the error
[[noreturn]] void throw_aravis_error(const std::string& thing, GError* error);

/// Calls `call(GError**)` and returns what it returns.
/// @throw as throw_aravis_error
template <class Call>
auto aravis(const std::string& thing, const Call& call) {
  GError* error = nullptr;
  if constexpr (std::is_void_v<decltype(call(&error))>) {
    call(&error);
    if (error) throw_aravis_error(thing, error);
  } else {
    auto result = call(&error);
    if (error) throw_aravis_error(thing, error);
    return result;
  }
}

/// @throw MissingFeature naming the feature if the camera does not have it
void require_feature(ArvCamera* camera, const char* feature);

bool has_feature(ArvCamera* camera, const char* feature);

/// The id under which Aravis opens the one camera that `name` means (open_aravis_camera).
/// @throw scan_cell_common::ConnectionError if there is not exactly one
std::string find_aravis_camera(const std::string& name);

/// nullptr as "".
inline std::string to_text(const char* text) {
  return text ? text : "";
}

}  // namespace tecnogamma_camera
