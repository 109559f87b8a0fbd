// SPDX-License-Identifier: GPL-3.0-or-later
// What the cell consists of: things are added, removed and moved by changes of the cell's file, as `--set` takes them. They
// stand in the page's address, so that the browser's back button takes one back.

/// What the address says: which piece, and which changes.
function variationOf(search) {
  const query = new URLSearchParams(search);
  return {piece: query.get("piece") || "", changes: query.getAll("change")};
}
const isVaried = ({piece, changes}) => piece !== "" || changes.length > 0;

/// The address of another variation, with the same preset.
function addressOf({piece, changes}) {
  const query = new URLSearchParams(), preset = new URLSearchParams(location.search).get("preset");
  if (preset) query.set("preset", preset);
  if (piece) query.set("piece", piece);
  for (const change of changes) query.append("change", change);
  return `?${query}`;
}

class Elements {
  constructor(cell, variation, live) {
    this.cell = cell, this.variation = variation;
    at("elements-section").hidden = !cell.elements.length;
    at("elements").tBodies[0].replaceChildren(...cell.elements.map((element) => this.row(element, live)));
    at("undo").hidden = !live || !variation.changes.length;
    at("undo").addEventListener("click", () => this.go({...variation, changes: variation.changes.slice(0, -1)}));
    at("adding").hidden = !live;
    at("add").addEventListener("click", () => this.change(...this.added(at("kind").value)));
    at("piece-line").hidden = cell.pieces.length < 2;
    for (const piece of cell.pieces) at("piece").append(node("option", piece, {value: piece}));
    at("piece").value = cell.piece;
    at("piece").disabled = !live;
    at("piece").addEventListener("change", () => this.go({...variation, piece: at("piece").value}));
  }

  go(variation) { location.search = addressOf(variation); }
  /// Of changes of one value in a row only the last one counts.
  change(...changes) {
    const all = [...this.variation.changes], path = (text) => text.split("=")[0];
    for (const change of changes) {
      if (all.length && path(all.at(-1)) === path(change)) all.pop();
      all.push(change);
    }
    this.go({...this.variation, changes: all});
  }

  row(element, live) {
    const row = node("tr", "", {"data-key": element.key}), fields = node("td", "", {class: "element-fields"}), last = node("td", "");
    for (const field of element.fields) fields.append(this.field(element, field, live));
    if (element.listed && live) {
      const remove = node("button", "Remove", {type: "button", "aria-label": `Remove ${element.name}`});
      remove.addEventListener("click", () => this.change(`${element.key}=null`));
      last.append(remove);
    }
    row.append(node("td", element.kind === "zone" ? "virtual object" : element.kind), node("th", element.name, {scope: "row"}), last, fields);
    return row;
  }
  field(element, {path, value}, live) {
    const name = path.split(".").at(-1), label = node("label", `${{move: "place"}[name] || name} `);
    if (typeof value === "boolean") {
      const box = node("input", "", {type: "checkbox", "aria-label": `${element.name}: stops the robot`});
      box.checked = value, box.disabled = !live;
      box.addEventListener("change", () => this.change(`${path}=${box.checked}`));
      label.append(box);
      return label;
    }
    const numbers = [].concat(value), inputs = numbers.map((number, i) => {
      const input = node("input", "", {type: "number", step: "any", "aria-label": `${element.name}: ${name} ${numbers.length > 1 ? "xyz"[i] : ""}`.trim()});
      input.value = +number.toFixed(6), input.disabled = !live;
      return input;
    });
    for (const input of inputs)
      input.addEventListener("change", () => {
        if (inputs.some((each) => each.value === "" || !each.checkValidity())) return;
        const given = inputs.map((each) => +each.value);
        this.change(`${path}=${Array.isArray(value) ? JSON.stringify(given) : given[0]}`);
      });
    label.append(...inputs);
    return label;
  }

  /// The changes that add a thing, in front of the robot where nothing stands, or as a copy of the first one.
  added(kind) {
    const list = {storage: "storages", machine: "machines", robot: "robots"}[kind] || (kind.startsWith("zone") ? "zones" : "obstacles");
    const index = this.cell.elements.filter(({key}) => key.startsWith(`${list}[`)).length;
    const names = new Set(this.cell.elements.map((element) => element.name));
    const short = kind.split("-").at(-1);
    let number = 2;
    while (names.has(`${short}-${number}`)) ++number;
    const key = `${list}[${index}]`, name = `${short}-${number}`, size = this.cell.bounds.longest / 80, far = this.cell.bounds.longest / 6;
    const round = (x) => +x.toPrecision(2);
    const cube = {from: [-size, -size, 0].map(round), to: [size, size, 4 * size].map(round)};
    const shapes = {
      "box": {box: cube},
      "cylinder": {cylinder: {from: [0, 0, 0], to: [0, 0, round(4 * size)], radius: round(size), sides: 24}},
      "zone-face": {face: [[0, -3, 0], [0, 3, 0], [0, 3, 6], [0, -3, 6]].map((p) => p.map((x) => round(x * size)))},
      "zone-box": {box: cube},
      "zone-sphere": {sphere: {at: [0, 0, 0], radius: round(2 * size)}},
      "zone-capsule": {capsule: {from: [0, 0, 0], to: [0, 0, round(4 * size)], radius: round(size)}},
    };
    if (shapes[kind]) return [`${key}=${JSON.stringify({name, ...shapes[kind], move: [round(far), 0, 0]})}`];
    const first = this.cell.elements.find((element) => element.kind === kind);
    const copy = [`${key}=@${first.key}`, `${key}.name=${name}`];
    if (kind !== "robot") return [...copy, `${key}.angle=${kind === "storage" ? 90 : 180}`];
    return [...copy, ...(first.listed ? [] : [`${key}.gripper=@gripper`]), `${key}.place=[${round(-3 * far)}, 0]`, `${key}.turn=180`];
  }
}

/// What has come into which virtual object.
function listTriggers(cell, run, go) {
  at("triggers-part").hidden = !cell.zones.length;
  at("triggers").tBodies[0].replaceChildren(...run.triggers.map(({zone, mover, part, after, degrees, until}) => {
    const row = node("tr", ""), stop = node("td", "", {class: "number"}), button = node("button", after, {type: "button", title: "Go to this stop"});
    button.addEventListener("click", () => go(after));
    stop.append(button);
    row.append(node("th", zone, {scope: "row"}), node("td", `${MOVERS[mover]}: ${part}`), stop,
               node("td", `${digits(degrees, 3)}°`, {class: "number"}), node("td", until, {class: "number"}));
    return row;
  }));
  at("triggers-say").textContent = run.triggers.length ? "What is not listed is certainly outside, between the stops, too." : "Nothing comes into a virtual object on this run.";
}
