// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// How often the calling thread took memory from the heap, by whatever way, in a program that
/// allocations.cpp is linked into. None where a sanitizer has the heap.
std::uint64_t allocations_of_this_thread();
bool counts_allocations();
