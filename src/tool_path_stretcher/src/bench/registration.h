// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bench {

/// Prints how the suite's similarity performs on public registration problems, next to the
/// publishers' results and PCL's.
/// @param data folder with registration/car and registration/bunny; empty: prints that it has none
void print_registration(const std::string& data);

}  // namespace bench
