# SPDX-License-Identifier: Apache-2.0
"""Does a ball touch a planar polygon, possibly non-convex and with holes, where, and how sure is the answer?

    import touchstone
    square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    touchstone.filtered.answer([0.5, 0.25, 1, 1], square).relation    # 'touching'
    touchstone.filtered.contact([[0.5, 0.25, 1, 1], [0.5, 0.25, 2, 1]], square)    # array([True, False])

A ball is a row x, y, z, r; many balls are an array of n x 4, which is not copied where it is of doubles and C-contiguous.
Coordinates are doubles taken as exact real numbers. The paths ask the same questions: `filtered` is exact at about the
price of `fast`; `exact` states the truth by an exact kernel; `fast` is plain doubles, and wrong near a boundary. Batches
let other threads go on. What the contract does not accept raises Rejected: a ValueError with a `code` and a sentence.
"""

from ._touchstone import Answer, Polygon, Rejected, __version__, exact, fast, filtered

for _kind in (Answer, Polygon, Rejected):
    _kind.__module__ = __name__  # where users find them

__all__ = ["Answer", "Polygon", "Rejected", "__version__", "exact", "fast", "filtered"]
