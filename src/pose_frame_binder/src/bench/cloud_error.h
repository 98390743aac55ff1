// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pose_frame_binder {

/// Prints how far the points of clouds are from the truth, by method of binding, for curved and
/// accelerating motion at up to 100 mm/s, beside a perfect binding of the same scan.
void bench_cloud_error();

}  // namespace pose_frame_binder
