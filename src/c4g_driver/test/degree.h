// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

inline constexpr double kDegree = M_PI / 180;  //!< [rad]
