// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles as the machine holds them: neighbours, and how far apart they lie.

const numberView = new Float64Array(1), bitsView = new BigInt64Array(numberView.buffer);

/// The bits as an integer that grows with the number: -0 and 0 are the same.
function rank(x) {
  numberView[0] = x;
  return bitsView[0] < 0n ? -(bitsView[0] & 0x7fffffffffffffffn) : bitsView[0];
}

/// The double so many doubles above x, or below it.
function neighbour(x, steps = 1) {
  const wanted = rank(x) + BigInt(steps);
  bitsView[0] = wanted < 0n ? -wanted | (-0x7fffffffffffffffn - 1n) : wanted;
  return numberView[0];
}

/// The distance to the next double away from zero.
function spacing(x) {
  const size = Math.abs(x);
  return neighbour(size) - size;
}

/// All doubles from `low` to `high`; nothing if there are more than `most`.
function doublesBetween(low, high, most) {
  if (rank(high) - rank(low) >= BigInt(Math.floor(most))) return null;
  const list = [];
  for (let x = low; x <= high; x = neighbour(x)) list.push(x);
  return list;
}
