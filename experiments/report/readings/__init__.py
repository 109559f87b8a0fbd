# SPDX-License-Identifier: GPL-3.0-or-later
"""What the data of each study say, as numbers: for the report and for the paper."""
