# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Control charts of the runs of a recipe."""
