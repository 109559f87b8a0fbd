# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands before the studies: the verdict's tables, the question and the words."""
