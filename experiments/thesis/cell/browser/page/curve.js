// SPDX-License-Identifier: GPL-3.0-or-later
// The distance of everything that moves from the nearest thing that stands, along the run.

const MOVERS = {arm: "arm and gripper", "held material": "held material", sphere: "sphere"};

class Curve {
  /// `go(stop)` is told where the curve is clicked.
  constructor(svg, go) {
    this.svg = svg, this.width = 1000, this.height = 180;
    svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    svg.addEventListener("click", (event) => {
      if (!this.along) return;
      const box = svg.getBoundingClientRect(), at = (event.clientX - box.left) / box.width * this.along.at(-1);
      const next = this.along.findIndex((x) => x >= at);
      go(next < 0 ? this.along.length - 1 : next);
    });
  }

  /// Roots of distances: small ones matter. Along the axis goes time, or the number of the stop where speeds are unknown.
  load(run, unit) {
    const {nearest} = run.separation;
    this.svg.replaceChildren();
    this.along = run.stops.length > 1 ? (run.times.length ? run.times : run.stops.map((_, i) => i)) : null;
    if (!this.along) return;
    const most = Math.max(1e-9, ...Object.values(nearest).flatMap(({here}) => here.filter((d) => d !== null)));
    const x = (i) => this.width * this.along[i] / this.along.at(-1), y = (d) => this.height * (1 - Math.sqrt(d / most)) * 0.94 + 4;
    const every = niceStep(most / 4);
    for (const d of [every / 10, every / 2, every, 2 * every, 3 * every].filter((d) => d < 0.97 * most)) {
      drawn("line", {class: "grid", x1: 0, x2: this.width, y1: y(d), y2: y(d)}, this.svg);
      drawn("text", {x: 4, y: y(d) - 3, "font-size": 15}, this.svg).textContent = `${+d.toPrecision(3)} ${unit}`;
    }
    for (const mover of Object.keys(MOVERS)) {
      const {here} = nearest[mover];
      for (let begin = 0; begin < here.length;) {
        if (here[begin] === null) { ++begin; continue; }
        let end = begin;
        while (end < here.length && here[end] !== null) ++end;
        const points = here.slice(begin, end).map((d, k) => `${x(begin + k).toFixed(1)},${y(d).toFixed(1)}`).join(" ");
        drawn("polyline", {class: `line ${mover.split(" ")[0]}`, points}, this.svg);
        begin = end;
      }
    }
    this.x = x;
    this.cursor = drawn("line", {class: "cursor", y1: 0, y2: this.height}, this.svg);
    this.show(0);
  }

  show(stop) {
    if (!this.along) return;
    for (const end of ["x1", "x2"]) this.cursor.setAttribute(end, this.x(stop));
  }
}
