// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <vector>

namespace scan_cell_common {

/// An Embree scene of one mesh, for rays and for nearest_in_scene(). Embree keeps the points in
/// single precision. Users of this header must link Embree.
class TriangleScene {
 public:
  /// @param points [m]
  /// @param triangles indices of their corners
  TriangleScene(const std::vector<Eigen::Vector3d>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    fill(geometry, points, triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~TriangleScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  TriangleScene(const TriangleScene&) = delete;
  TriangleScene& operator=(const TriangleScene&) = delete;

  RTCScene scene() const { return scene_; }  //!< valid while this object lives

 private:
  /// Room for `count` elements of three numbers.
  template <class Number>
  static Number* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                        std::size_t count) {
    auto* const numbers = static_cast<Number*>(
        rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(Number), count));
    if (numbers == nullptr) throw std::bad_alloc();
    return numbers;
  }

  static void fill(RTCGeometry geometry, const std::vector<Eigen::Vector3d>& points,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    auto* corner =
        buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points.size());
    for (const Eigen::Vector3d& point : points) {
      Eigen::Map<Eigen::Vector3f>{corner} = point.cast<float>();
      corner += 3;
    }
    auto* index =
        buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.size());
    for (const auto& triangle : triangles)
      index = std::copy(triangle.begin(), triangle.end(), index);
  }

  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace scan_cell_common
