// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Put before a function: compiles it for 32 byte vectors, too, where the processor has them. Which
/// one runs is chosen when the program is loaded. The code is the same, and so are its results. Not
/// under the thread sanitizer: the choice is made before the sanitizer is initialised.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define TECNOGAMMA_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define TECNOGAMMA_VECTOR_CLONES
#endif

/// Put before a template that such functions call: it is compiled into each of them.
#define TECNOGAMMA_INLINE inline __attribute__((always_inline))
