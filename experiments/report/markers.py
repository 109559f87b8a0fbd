# SPDX-License-Identifier: GPL-3.0-or-later
"""The generated parts of pages, which stand between two comments."""


def split(path, name):
    """The page before the table `name`, the table, and the page after it."""
    before, begin, rest = path.read_text().partition(f"<!-- {name} table: begin -->\n")
    table, end, after = rest.partition(f"<!-- {name} table: end -->\n")
    if not begin or not end:
        raise SystemExit(f"{path}: no markers of the table '{name}'")
    return before + begin, table, end + after
