# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapters of the report, one a study."""
