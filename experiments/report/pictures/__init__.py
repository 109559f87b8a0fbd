# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of each study: pictures/NAME.py has `main(folder)`, which draws what lies there. See draw.py."""
