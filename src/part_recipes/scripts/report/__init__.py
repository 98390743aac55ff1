# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a run."""
