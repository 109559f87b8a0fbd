// SPDX-License-Identifier: GPL-3.0-or-later
// The window on the plane: which double a pixel shows. Like the contract, it looks along the dropped axis.

/// The plane of a polygon as doubles see it: the axes that are seen, and the height of the plane along the third.
class SeenPlane {
  constructor([outer]) {
    const normal = [0, 0, 0], mean = [0, 0, 0];
    outer.forEach((p, i) => {
      const q = outer[(i + 1) % outer.length];
      for (let k = 0; k < 3; ++k) {
        normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
        mean[k] += p[k] / outer.length;
      }
    });
    const size = normal.map(Math.abs);
    this.dropped = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    [this.a, this.b] = [(this.dropped + 1) % 3, (this.dropped + 2) % 3];
    this.slopeA = -normal[this.a] / normal[this.dropped] || 0;
    this.slopeB = -normal[this.b] / normal[this.dropped] || 0;
    this.base = mean[this.dropped] - (this.slopeA * mean[this.a] + this.slopeB * mean[this.b]);
    this.level = outer.every((p) => p[this.dropped] === outer[0][this.dropped]) ? outer[0][this.dropped] : null;
  }
  heightAt(a, b) {
    return this.level ?? this.base + (this.slopeA * a + this.slopeB * b);
  }
  /// The point at (a, b), that far from the plane along the dropped axis.
  point(a, b, lift) {
    const p = [0, 0, 0];
    [p[this.a], p[this.b], p[this.dropped]] = [a, b, this.heightAt(a, b) + lift];
    return p;
  }
  liftOf(p) {
    return p[this.dropped] - this.heightAt(p[this.a], p[this.b]);
  }
}

/// A window of so many pixels. Its middle is the double (a, b), moved by less than one double, in pixels.
class View {
  constructor({a, b, scale}) {
    Object.assign(this, {a, b, scale, restA: 0, restB: 0, width: 1, height: 1});
  }
  static around(points, plane, width, height) {
    const range = (axis) => [Math.min(...points.map((p) => p[axis])), Math.max(...points.map((p) => p[axis]))];
    const [lowA, highA] = range(plane.a), [lowB, highB] = range(plane.b);
    const scale = 0.78 * Math.min(width / (highA - lowA), height / (highB - lowB));
    return new View({a: lowA + (highA - lowA) / 2, b: lowB + (highB - lowB) / 2, scale: Number.isFinite(scale) && scale > 0 ? scale : 1});
  }
  x(a) {
    return this.width / 2 + this.restA + (a - this.a) * this.scale;
  }
  y(b) {
    return this.height / 2 - this.restB - (b - this.b) * this.scale;
  }
  /// The doubles nearest to what a pixel shows.
  at(x, y) {
    return [this.a + (x - this.width / 2 - this.restA) / this.scale, this.b - (y - this.height / 2 + this.restB) / this.scale];
  }
  moveBy(dx, dy) {
    this.restA += dx;
    this.restB -= dy;
    const a = this.a - this.restA / this.scale, b = this.b - this.restB / this.scale;
    this.restA += (a - this.a) * this.scale;
    this.restB += (b - this.b) * this.scale;
    [this.a, this.b] = [a, b];
  }
  /// Zooms about a pixel, until neighbouring doubles are 80 pixels apart.
  zoom(factor, x, y) {
    const most = 80 / Math.max(spacing(this.a), spacing(this.b), 1e-300), least = 1e-300;
    const scale = Math.min(Math.max(this.scale * factor, least), Math.max(most, this.scale)), real = scale / this.scale;
    const dx = x - this.width / 2, dy = this.height / 2 - y;
    this.restA = dx - (dx - this.restA) * real;
    this.restB = dy - (dy - this.restB) * real;
    this.scale = scale;
    this.moveBy(0, 0);
  }
  /// The doubles of both axes, if dots at them would lie at least 6 pixels apart.
  dots() {
    const [lowA, highB] = this.at(0, 0), [highA, lowB] = this.at(this.width, this.height);
    const across = doublesBetween(lowA, highA, this.width / 6), up = doublesBetween(lowB, highB, this.height / 6);
    return across && up ? [across, up] : null;
  }
}
