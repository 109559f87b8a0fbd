// SPDX-License-Identifier: GPL-3.0-or-later
// Points as [x, y, z]; poses as the rows of [R t], twelve numbers; matrices as WebGL takes them, by columns.

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / (Math.hypot(...a) || 1), a);

const posed = (p, a) => [
  p[0] * a[0] + p[1] * a[1] + p[2] * a[2] + p[3],
  p[4] * a[0] + p[5] * a[1] + p[6] * a[2] + p[7],
  p[8] * a[0] + p[9] * a[1] + p[10] * a[2] + p[11],
];
const mix = (a, b, share) => a.map((x, i) => x + share * (b[i] - x));
/// A pose on the straight way from one to another.
function poseBetween(a, b, share) {
  const p = mix(a, b, share), x = unit([p[0], p[4], p[8]]), near = [p[1], p[5], p[9]];
  const y = unit(minus(near, times(dot(x, near), x))), z = cross(x, y);
  return [x[0], y[0], z[0], p[3], x[1], y[1], z[1], p[7], x[2], y[2], z[2], p[11]];
}
const matrixOf = (p) => [p[0], p[4], p[8], 0, p[1], p[5], p[9], 0, p[2], p[6], p[10], 0, p[3], p[7], p[11], 1];
const shiftedTo = (a, scale = 1) => [scale, 0, 0, a[0], 0, scale, 0, a[1], 0, 0, scale, a[2]];
/// Of a station: x away from the robot's axis, and turned from there, degrees counter-clockwise.
function standing(degrees, radius, height, turn = 0) {
  const [a, b] = [degrees, degrees + turn].map((angle) => angle * Math.PI / 180), c = Math.cos(b), s = Math.sin(b);
  return [c, -s, 0, Math.cos(a) * radius, s, c, 0, Math.sin(a) * radius, 0, 0, 1, height];
}

/// The largest of 1, 2, 2.5 and 5 times a power of ten that is not above x.
function niceStep(x) {
  const round = 10 ** Math.floor(Math.log10(x));
  return round * [5, 2.5, 2, 1].find((k) => k * round <= x);
}

function product(a, b) {
  const result = new Array(16).fill(0);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}
function perspective(degrees, aspect, near, far) {
  const f = 1 / Math.tan(degrees * Math.PI / 360);
  return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
}
function lookingAt(eye, target, up) {
  const z = unit(minus(eye, target)), x = unit(cross(up, z)), y = cross(z, x);
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1];
}
