// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bench {

/// Prints how the suite's similarity fares on public registration problems, beside what their
/// publishers give and PCL finds.
/// @param data folder with registration/car and registration/bunny; empty: says that it has none
void print_registration(const std::string& data);

}  // namespace bench
