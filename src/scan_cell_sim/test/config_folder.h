// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

inline const std::string kConfig = CONFIG_FOLDER;  //!< shipped with the simulator
