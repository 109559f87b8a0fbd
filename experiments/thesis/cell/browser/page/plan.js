// SPDX-License-Identifier: GPL-3.0-or-later
// The configuration window: the cell from above, as SVG, x to the right and y up; the storage can be dragged.

const SVG = "http://www.w3.org/2000/svg";

function drawn(kind, attributes = {}, parent = null) {
  const element = document.createElementNS(SVG, kind);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (parent) parent.append(element);
  return element;
}

/// Around points of the plan, counter-clockwise.
function convexHull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const hull = [];
    for (const p of list) {
      while (hull.length > 1) {
        const [a, b] = hull.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        hull.pop();
      }
      hull.push(p);
    }
    return hull.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
const flat = (points) => points.map(([x, y]) => `${x.toFixed(4)},${(-y).toFixed(4)}`).join(" ");

function hullOf(part) {
  const points = [];
  for (let i = 0; i < part.points.length; i += 3) points.push([part.points[i], part.points[i + 1]]);
  return convexHull(points);
}

class Plan {
  /// `moved(angle, radius, done)` is told where the storage is dragged to, and when it has come there.
  constructor(svg, cell, moved) {
    this.svg = svg, this.cell = cell, this.moved = moved;
    const station = cell.machine, machinePose = standing(station.home + station.angle, station.radius, 0, station.turn);
    const machineParts = cell.parts.filter((p) => p.carrier === "machine").map(hullOf);
    const corners = machineParts.flat().map((p) => posed(machinePose, [...p, 0]));
    const far = 1.05 * Math.max(cell.bounds.longest / 4, ...[...corners, ...cell.parts.filter((p) => p.carrier === "obstacle").flatMap(hullOf)].map(([x, y]) => Math.max(Math.abs(x), Math.abs(y))));
    this.far = far;
    svg.setAttribute("viewBox", `${-far} ${-far} ${2 * far} ${2 * far}`);
    svg.replaceChildren();
    const every = niceStep(far / 3);
    for (let r = every; r < far; r += every) {
      drawn("circle", {class: "ring thin", r}, svg);
      drawn("text", {x: 0.02 * far, y: -r + 0.05 * far, "font-size": 0.06 * far}, svg).textContent =
        `${+r.toPrecision(3)} ${cell.unit}`;
    }
    this.area = drawn("g", {"aria-hidden": "true"}, svg);
    const place = (element, pose) => element.setAttribute("transform",
      `matrix(${pose[0]} ${-pose[4]} ${-pose[1]} ${pose[5]} ${pose[3]} ${-pose[7]})`);
    this.place = place;

    const machine = drawn("g", {class: "machine thin"}, svg);
    for (const hull of machineParts) drawn("polygon", {points: flat(hull), class: "thin"}, machine);
    place(machine, machinePose);
    this.put(this.label("machine", 0.07), posed(machinePose, [0.17 * far, 0, 0]));

    for (const part of cell.parts.filter((p) => p.carrier === "obstacle")) drawn("polygon", {points: flat(hullOf(part)), class: "obstacle thin"}, svg);
    for (const zone of cell.zones) drawn("polygon", {points: flat(hullOf(zone)), class: "zone thin"}, svg);

    this.aim = drawn("line", {class: "aim", x1: 0, y1: 0}, svg);
    this.handle = drawn("g", {class: "handle", tabindex: 0, role: "slider", "aria-label": "Storage: angle and radius",
                              "aria-valuemin": -180, "aria-valuemax": 180}, svg);
    this.storage = drawn("g", {}, this.handle);
    const decks = cell.parts.filter((p) => p.carrier === "storage");
    for (const part of decks) drawn("polygon", {points: flat(hullOf(part)), class: "grip thin"}, this.storage);
    const deep = decks.flatMap(hullOf).map(([x]) => x);
    this.deck = {front: Math.min(...deep), back: Math.max(...deep)};
    this.slots = cell.slots.map(({name, place}) => ({place, tick: drawn("line", {class: "tick thin", "pointer-events": "none"}, svg), letter: this.label(name, 0.065, "slot")}));
    this.slots.sort((a, b) => a.place[1] - b.place[1]);
    this.storageName = this.label("storage", 0.07, "name");

    const material = cell.parts.find((p) => p.carrier === "material");
    this.material = drawn("polygon", {points: flat(hullOf(material)), class: "material thin"}, svg);
    this.path = drawn("polyline", {class: "path thin"}, svg);
    this.arm = drawn("polyline", {class: "arm", "stroke-width": 0.035 * far}, svg);
    drawn("circle", {class: "joint thin", r: 0.05 * far}, svg);
    this.ball = drawn("circle", {class: "ball free", r: Math.max(cell.sphere, 0.018 * far)}, svg);
    for (const still of [this.material, this.path, this.arm, this.ball]) still.setAttribute("pointer-events", "none");
    this.listen();
  }

  label(text, size, kind = "") {
    const element = drawn("text", {class: kind, "font-size": size * this.far, "text-anchor": "middle", "dominant-baseline": "central", "pointer-events": "none"}, this.svg);
    element.textContent = text;
    return element;
  }
  /// Width and height of the box round an upright text, or a little more.
  static room(text) {
    const size = +text.getAttribute("font-size");
    return [0.75 * size * text.textContent.length, 1.2 * size];
  }
  /// The names of slots stand upright in a row behind the deck, in their order across it, and that of the storage behind them or,
  /// where the plan ends, in front of the deck. No two overlap, whatever the direction of the row.
  nameSlots(pose) {
    const gap = 0.02 * this.far, apart = Math.max(...this.slots.map(({letter}) => Math.hypot(...Plan.room(letter))));
    const first = this.slots[0].place[1], last = this.slots.at(-1).place[1], steps = this.slots.length - 1;
    const every = Math.max(apart, (last - first) / Math.max(1, steps)), row = this.deck.back + gap + apart / 2;
    this.slots.forEach(({place, tick, letter}, i) => {
      const to = posed(pose, [row, (first + last) / 2 + (i - steps / 2) * every, 0]), from = posed(pose, place);
      this.put(letter, to);
      for (const [end, [x, y]] of [[1, from], [2, to]]) tick.setAttribute(`x${end}`, x), tick.setAttribute(`y${end}`, -y);
    });
    const [wide, high] = Plan.room(this.storageName), half = (Math.abs(pose[0]) * wide + Math.abs(pose[4]) * high) / 2;
    const behind = posed(pose, [row + apart / 2 + half, 0, 0]), room = [wide / 2, high / 2];
    this.put(this.storageName, behind.some((x, k) => k < 2 && Math.abs(x) + room[k] > this.far) ? posed(pose, [this.deck.front - gap - half, 0, 0]) : behind);
  }

  put(text, [x, y]) {
    text.setAttribute("x", x), text.setAttribute("y", -y);
  }

  listen() {
    const point = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      return [p.x, -p.y];
    };
    let grabbed = null;
    this.handle.addEventListener("pointerdown", (event) => {
      if (this.fixed) return;
      const [x, y] = point(event);
      grabbed = {azimuth: Math.atan2(y, x) * 180 / Math.PI - this.angle, radius: Math.hypot(x, y) - this.radius};
      this.handle.setPointerCapture(event.pointerId);
      this.handle.focus({preventScroll: true});
      event.preventDefault();
    });
    // A browser may scroll in spite of touch-action on a shape.
    this.handle.addEventListener("touchstart", (event) => this.fixed || event.preventDefault(), {passive: false});
    this.handle.addEventListener("pointermove", (event) => {
      if (!grabbed) return;
      const [x, y] = point(event);
      this.moved(Math.atan2(y, x) * 180 / Math.PI - grabbed.azimuth, Math.hypot(x, y) - grabbed.radius, false);
    });
    const end = () => {
      if (grabbed) grabbed = null, this.moved(this.angle, this.radius, true);
    };
    this.handle.addEventListener("pointerup", end);
    this.handle.addEventListener("pointercancel", end);
    this.handle.addEventListener("keydown", (event) => {
      const turn = {ArrowLeft: 1, ArrowRight: -1}[event.key], out = {ArrowUp: 1, ArrowDown: -1}[event.key];
      if (this.fixed || (!turn && !out)) return;
      event.preventDefault(), event.stopPropagation();
      const far = event.shiftKey ? 10 : 1;
      this.moved(this.angle + far * (turn || 0), this.radius + far * (out || 0) * this.cell.bounds.longest / 1000, true);
    });
  }

  /// Where the storage stands.
  configure(angle, radius, words, fixed) {
    this.angle = angle, this.radius = radius, this.fixed = fixed;
    const pose = standing(this.cell.storage.home + angle, radius, 0, this.cell.storage.turn);
    this.place(this.storage, pose);
    this.aim.setAttribute("x2", pose[3]), this.aim.setAttribute("y2", -pose[7]);
    this.nameSlots(pose);
    this.handle.setAttribute("aria-valuenow", angle);
    this.handle.setAttribute("aria-valuetext", words);
    this.handle.setAttribute("aria-disabled", Boolean(fixed));
  }

  /// Outcomes with the storage at an angle, `wide` degrees of it: sectors of rings, as wide as the radii are apart.
  addArea(angle, wide, places) {
    const half = places.length > 1 ? (places[1].radius - places[0].radius) / 2 : 0;
    const point = (degrees, r) => {
      const a = (this.cell.storage.home + degrees) * Math.PI / 180;
      return [r * Math.cos(a), r * Math.sin(a)];
    };
    for (const {radius, cause} of places) {
      if (cause === "out-of-reach") continue;
      const corners = [-1, -0.5, 0, 0.5, 1].map((k) => angle + k * wide / 2);
      const ring = [...corners.map((a) => point(a, radius - half)), ...corners.reverse().map((a) => point(a, radius + half))];
      const kind = cause === null ? "completed" : cause === "in-the-way" ? "in-the-way" : "other";
      drawn("polygon", {class: `area ${kind}`, points: flat(ring)}, this.area);
    }
  }
  clearArea() { this.area.replaceChildren(); }

  showPath(points) { this.path.setAttribute("points", flat(points)); }

  show(links, sphere, material, touching) {
    const way = [];
    for (const [x, y] of [...links.map((p) => [p[3], p[7]]), sphere])
      if (!way.length || Math.hypot(x - way.at(-1)[0], y - way.at(-1)[1]) > 0.02 * this.far) way.push([x, y]);
    this.arm.setAttribute("points", flat(way));
    this.ball.setAttribute("cx", sphere[0]), this.ball.setAttribute("cy", -sphere[1]);
    this.ball.setAttribute("class", touching ? "ball touching" : "ball free");
    this.material.toggleAttribute("hidden", !material);
    this.material.style.display = material ? "" : "none";
    if (material) this.place(this.material, material);
  }
}
