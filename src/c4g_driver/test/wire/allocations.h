// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// How often the calling thread allocated memory on the heap, in any way, in a program that links
/// allocations.cpp. 0 if a sanitizer owns the heap.
std::uint64_t allocations_of_this_thread();
bool counts_allocations();
