// SPDX-License-Identifier: GPL-3.0-or-later
// Where the window shows a segment whose ends lie far beyond it, so that the rounding of doubles would show.

const FAR = 1e5;  // pixels

/// The double times 2^1074, an integer.
function inSmallestUnits(x) {
  numberView[0] = x;
  const bits = bitsView[0] & 0x7fffffffffffffffn, exponent = bits >> 52n, fraction = bits & 0xfffffffffffffn;
  const size = exponent ? (fraction | 0x10000000000000n) << (exponent - 1n) : fraction;
  return x < 0 ? -size : size;
}

/// numerator / denominator of such units, as the double next to it.
function fromSmallestUnits(numerator, denominator) {
  const quotient = (numerator << 80n) / denominator, size = quotient < 0n ? -quotient : quotient;
  const beyond = Math.max(size.toString(2).length - 60, 0);
  return Number(quotient >> BigInt(beyond)) * 2 ** (beyond - 80 - 537) * 2 ** -537;
}

/// Returns the pixels [x, y] of two points on the segment from p to q: its ends, or points beyond the window.
function segmentOf(view, p, q) {
  const ends = [p, q].map(([a, b]) => [view.x(a), view.y(b)]);
  if (ends.flat().every((pixels) => Math.abs(pixels) < FAR)) return ends;

  // The point of the segment nearest to the middle of the window, exactly, and from there along the segment.
  const [pa, pb, qa, qb, ca, cb] = [...p, ...q, view.a, view.b].map(inSmallestUnits);
  const da = qa - pa, db = qb - pb, squared = da * da + db * db;
  if (!squared) return ends;
  const along = (ca - pa) * da + (cb - pb) * db, t = along < 0n ? 0n : along > squared ? squared : along;
  const offset = (from, by) => fromSmallestUnits(from * squared + t * by, squared) * view.scale;
  const x = view.width / 2 + view.restA + offset(pa - ca, da), y = view.height / 2 - view.restB - offset(pb - cb, db);
  const [dx, dy] = [(q[0] - p[0]) * view.scale, (p[1] - q[1]) * view.scale], length = Math.hypot(dx, dy);
  const share = Number((t << 60n) / squared) * 2 ** -60 * length;
  const moved = (by) => [x + by * dx / length, y + by * dy / length];
  return [moved(-Math.min(share, FAR)), moved(Math.min(length - share, FAR))];
}
