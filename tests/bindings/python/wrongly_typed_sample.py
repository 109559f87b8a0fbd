# SPDX-License-Identifier: GPL-3.0-or-later
"""Every marked line is an error, which mypy must find (test_types.py)."""

import touchstone_contact as touchstone

square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
touchstone.filtered.contact([0, 0, 0, 1], "square")  # wrong
touchstone.Mesh.read(3)  # wrong
touchstone.Mesh.of(3)  # wrong
touchstone.Scene().touches([0, 0, 0, 1], objects=3)  # wrong
touchstone.Scene().add(3, square)  # wrong
touchstone.filtered.answer([0, 0, 0, 1], square).relaton  # wrong
touchstone.Scene().touches([0, 0, 0, 1], out=[True])  # wrong
touchstone.Scene().nearest([0, 0, 0, 1], out=touchstone.Hits)  # wrong
touchstone.Relation.word  # wrong
touchstone.TriangleSet().contact([0, 0, 0, 1])  # wrong
