// SPDX-License-Identifier: GPL-3.0-or-later
// The page: what is asked, what is shown, and in which words.

const at = (id) => document.getElementById(id);
const node = (kind, text, attributes = {}) => {
  const element = document.createElement(kind);
  element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
};
const digits = (x, most) => String(+x.toFixed(most)).replace("-", "−");
const signed = (x, most = 3) => (x > 0 ? "+" : "") + digits(x, most);

const PHASES = {
  "to-storage": "to the storage", "to-machine": "to the machine", "withdraw": "withdrawing", "to-piece": "to the milled piece",
  "back-to-storage": "back to the storage", "to-home": "home",
};
const UNTIL = {
  planned: "as planned", facing: "it faces the place", contact: "the sphere touches", cleared: "it is clear",
};

async function main() {
  const recorded = JSON.parse(at("recorded").textContent);
  const answers = answersOf(recorded);
  let cell;
  try {
    cell = await answers.cell();
  } catch (refused) {
    at("status").textContent = "";
    return complain(refused.message);
  }

  const length = 10 ** (Math.floor(Math.log10(cell.bounds.longest)) - 3);  // a step of lengths
  const lengthDigits = Math.max(0, 1 - Math.round(Math.log10(length)));
  const says = (x) => `${digits(x, lengthDigits)} ${cell.unit}`;
  const setting = structuredClone(cell.setting);
  let run = null, shown = null, wanted = 0, covers = null;

  at("name").textContent = cell.name;
  document.title = `${cell.name} · Touchstone`;
  if (answers.live) at("origin").textContent = `${cell.robot.name}. Every answer on this page is one of the program that serves it.`;
  else
    at("origin").append(`${cell.robot.name}. A recorded run; this page asks no program. `, node("code", "touchstone cell serve"),
                        " lets the storage be moved.");

  // The picture.
  let scene = null;
  try {
    scene = new Scene(at("scene"));
  } catch {
    at("scene").hidden = true, at("no-scene").hidden = false, at("scene-help").hidden = true;
    document.querySelector(".corner").hidden = true;
  }
  const meshes = scene ? cell.parts.map((part) => ({part, mesh: scene.mesh(part)})) : [];
  const materialMesh = scene && meshes.find(({part}) => part.carrier === "material").mesh;
  let ball, rings, floor;
  if (scene) {
    const box = [[Infinity, Infinity, 0], [-Infinity, -Infinity, 0]];
    for (const part of cell.parts) {
      const pose = poseOf(part, cell.links);
      for (let i = 0; i < part.points.length; i += 3) {
        const p = posed(pose, part.points.slice(i, i + 3));
        for (let k = 0; k < 3; ++k) box[0][k] = Math.min(box[0][k], p[k]), box[1][k] = Math.max(box[1][k], p[k]);
      }
    }
    const middle = times(0.5, add(box[0], box[1])), size = Math.hypot(...minus(box[1], box[0])) / 2;
    scene.behind = (cell.storage.home + cell.storage.angle + cell.machine.home + cell.machine.angle) / 2 + 180;
    scene.frame(middle, size);
    ball = scene.ball(), rings = scene.rings();
    floor = scene.floor(1.6 * size, niceStep(size / 6));
  }
  let colours = readColours();

  function poseOf(part, links) {
    if (part.carrier === "link" || part.carrier === "gripper") return links[part.link];
    const storage = setting.storage;
    if (part.carrier === "storage") return standing(cell.storage.home + storage.angle, storage.radius, storage.height);
    if (part.carrier === "machine") return standing(cell.machine.home + cell.machine.angle, cell.machine.radius, cell.machine.height);
    const slot = cell.slots.find(({name}) => name === setting.slot);
    return add3(poseOf({carrier: "storage"}), slot.place);
  }
  function add3(pose, place) {
    const p = posed(pose, place), result = [...pose];
    result[3] = p[0], result[7] = p[1], result[11] = p[2];
    return result;
  }
  function readColours() {
    const style = getComputedStyle(document.documentElement);
    const result = {};
    for (const name of ["view", "floor", "edge", "free", "touching", "wrong", "material", "robot", "gripper", "storage", "machine", "offending"]) {
      const hex = style.getPropertyValue(`--${name}`).trim();
      result[name] = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
    }
    return result;
  }

  /// What is to be seen of a stop; before there is a run, of the arm at home.
  function lookOf(number) {
    const stop = run && run.stops[number];
    if (!stop)
      return {links: cell.links, sphere: cell.home_sphere, material: poseOf({carrier: "material"}, cell.links), place: "storage"};
    const before = number > 0 ? run.stops[number - 1].place : stop.place;
    return {
      ...stop,
      virtual: stop.target !== null && before !== stop.target,  // until this stop the sphere came for a copy
      grips: before !== null && stop.place === null,
      puts: before === null && stop.place !== null,
      errors: run.disagreements.filter((d) => d.stop === number),
      wrong: number > 0 && run.moves[stop.move] && lastStopOf(stop.move) === number ? run.moves[stop.move].wrong : null,
    };
  }
  const lastStopOf = (move) => run.stops.findLastIndex((s, k) => k > 0 && s.move === move);
  /// The parts that touch at what is shown, as the program names them.
  function offends(part, look) {
    return (look.offending || []).some((name) => name === part.name || (part.carrier === "material" && name.startsWith("the material")));
  }

  let asked = false;
  function draw() {
    if (!asked) requestAnimationFrame(() => (asked = false, paint()));
    asked = true;
  }
  function paint() {
    const look = shown || lookOf(0), touching = look.touched !== null && look.touched !== undefined;
    at("plan").plan.show(look.links, look.sphere, look.material, touching);
    if (!scene) return;
    const signal = touching ? colours.touching : colours.free;
    const things = [{mesh: floor, pose: IDENTITY, hollow: true, flat: true, lines: colours.floor}];
    for (const {part, mesh} of meshes) {
      const material = part.carrier === "material";
      const own = covers && (part.carrier === "link" || part.carrier === "gripper");
      things.push({mesh, pose: material ? look.material : poseOf(part, look.links), shadow: true, lines: own ? null : colours.edge,
                   hollow: own, colour: offends(part, look) ? colours.offending : colours[part.carrier === "link" ? "robot" : part.carrier],
                   highlight: material && touching && (!look.virtual || look.puts) ? [look.touched, colours.touching] : null});
    }
    if (look.virtual && !look.puts)
      things.push({mesh: materialMesh, pose: run.materials[look.target], hollow: true, lines: signal, dash: cell.bounds.longest / 500,
                   highlight: touching ? [look.touched, colours.touching] : null});
    for (const {link, balls} of covers || []) things.push({balls, pose: look.links[link], colour: colours.robot, hollow: true});
    const size = cell.sphere;
    if (at("with-sphere").checked) things.push({mesh: ball, pose: shiftedTo(look.sphere, size), colour: signal, shadow: true, through: true});
    if (look.wrong || (look.errors && look.errors.length)) things.push({mesh: rings, pose: shiftedTo(look.sphere, 2.2 * size), hollow: true, lines: colours.wrong});
    scene.draw(things, colours, look.sphere);
  }

  // Words.
  const face = (number) => `face ${number} (${cell.material_faces[number]})`;
  function sentence(look, number) {
    if (!run || !run.stops.length) return "The arm is at home.";
    const move = number > 0 ? run.moves[look.move] : null;
    const joint = move && cell.robot.joints.findIndex(({name}) => name === move.joint);
    const before = move && run.stops[run.stops.findIndex((s, i) => i > 0 && s.move === look.move) - 1];
    const where = number === 0 ? "home" : !move ? "a move that did not come out"
      : `${PHASES[move.phase]}, ${move.joint} ${signed(look.commanded[joint] - before.commanded[joint])}° of ${signed(move.degrees)}°`;
    const wrong = [...new Set(look.errors.flatMap(({methods}) => methods))];
    const errs = wrong.length ? ` Wrong here: ${wrong.join(", ")}.` : "";
    return `Stop ${number} of ${run.stops.length - 1}: ${where}. ${verdict(look)} ${holding(look)}${look.wrong ? ` ${wrongly(look.wrong)}.` : ""}${errs}`;
  }
  const wrongly = ({early, gap}) => "Wrong stop: " + (early === null ? "there is no contact on the way" : early > 0 ? `${digits(early, 3)}° early` : `${digits(-early, 3)}° late`) +
    `, ${digits(gap, lengthDigits + 1)} ${cell.unit} from the material`;
  function verdict(look) {
    if (!look.target) return "The sphere touches nothing.";
    const what = `${look.virtual ? "virtual " : ""}material ${look.target === "machine" ? "at the machine" : "in the storage"}`;
    if (look.touched !== null) return `${look.wrong ? `By ${setting.drive}, the` : "The"} sphere touches ${face(look.touched)} of the ${what}.`;
    return `The sphere touches nothing; nearest is ${face(look.nearest)} of the ${what}.`;
  }
  function holding(look) {
    if (look.grips) return "The gripper takes the material.";
    if (look.puts) return "The gripper puts the material there.";
    return look.place === null ? "The gripper holds the material."
      : look.place === "machine" ? "The material is at the machine." : "The material is in the storage.";
  }
  let said = "";
  function announce(text) {
    if (text !== said) at("live").textContent = said = text;
  }
  /// A sentence; what else was tried is folded, one reason a line: the program parts them by semicolons.
  function complain(text, reasons = "") {
    at("failure").hidden = !text;
    const all = reasons.split("; ");
    at("failure").replaceChildren(text || "");
    if (all.length < 2) return;
    const details = node("details", ""), list = node("ul", "");
    list.append(...all.map((reason) => node("li", reason)));
    details.append(node("summary", `All that was tried (${all.length})`), list);
    at("failure").append(details);
  }
  /// A reason that begins with the name of a phase, in the page's words.
  function inWords(reason) {
    const [phase] = Object.keys(PHASES).filter((name) => reason.startsWith(name));
    return phase ? `on the way ${PHASES[phase]}, ${reason.slice(phase.length).trim()}` : reason;
  }
  function nearestOf(number) {
    const {nearest, elements} = run.separation;
    return Object.keys(MOVERS).filter((mover) => nearest[mover].here[number] !== null)
      .map((mover) => `${MOVERS[mover]} ${digits(nearest[mover].here[number], lengthDigits + 1)} ${cell.unit} from ${elements[nearest[mover].element[number]]}`);
  }
  /// Another pose than that of a stop: where the process fails, or where the arm is jogged to.
  function showPose(look, text) {
    player.pause();
    shown = look;
    at("status").textContent = text;
    announce(text);
    at("answer").replaceChildren();
    at("disagreements").replaceChildren();
    showJoints(look.commanded);
    at("unjog").hidden = !run || !run.stops.length;
    draw();
  }
  function showStuck() {
    showPose({...run.stuck, offending: run.stuck.parts}, `Where it fails: ${inWords(run.stuck.reason)}.`);
  }

  function show(number) {
    const look = shown = lookOf(number);
    at("unjog").hidden = true;
    curve.show(number);
    const text = sentence(look, number), last = at("stop").shownMove;
    at("status").textContent = text;
    // While it runs, a listener is told of moves, not of every stop.
    if (!player.running || look.move !== last || look.grips || look.puts) announce(text);
    at("stop").shownMove = look.move;
    at("stop").value = number;
    at("stop").setAttribute("aria-valuetext", text);

    const answer = [];
    const touching = look.touched !== null && look.touched !== undefined;
    answer.push(["the sphere", node("span", touching ? `touches ${face(look.touched)}` : "touches nothing",
                                    {class: `verdict ${touching ? "touching" : "free"}`})]);
    answer.push(["comes for", !look.target ? "nothing" : `the ${look.virtual ? "virtual " : ""}material ${look.target === "machine" ? "at the machine" : "in the storage"}`]);
    if (look.target)
      answer.push(["nearest", `${face(look.nearest)}, ${digits(look.distance, lengthDigits + 2)} ${cell.unit} from its centre; its radius is ${says(cell.sphere)}`]);
    answer.push(["the material", look.place === null ? "is held by the gripper" : look.place === "machine" ? "is at the machine" : "is in the storage"]);
    if (run && run.stops[number]) answer.push(["least distance", nearestOf(number).join("; ")]);
    const move = number > 0 && run ? run.moves[look.move] : null;
    if (look.wrong) answer.push(["the robot", node("span", wrongly(look.wrong), {class: "verdict wrong"})]);
    if (move && move.contact)
      answer.push(["this move", `the sphere begins to touch after ${digits(move.contact.low, 9)}°, certified to ${(move.contact.high - move.contact.low).toExponential(0)}°`]);
    at("answer").replaceChildren(...answer.flatMap(([term, value]) => {
      const dd = node("dd", "");
      dd.append(value);
      return [node("dt", term), dd];
    }));
    showDisagreements(look);
    showJoints(look.commanded);
    showMove(look.move, number);
    draw();
  }

  function showDisagreements(look) {
    const list = run ? run.disagreements : [], here = look.errors || [];
    const parts = here.map((d) =>
      node("p", `Wrong here: ${d.methods.join(", ")}, on face ${d.face} of ${d.owner}.`, {class: "verdict wrong"}));
    if (run && run.stops.length) {
      const where = new Set(list.map((d) => d.stop)).size;
      const asked = run.methods.reduce((sum, method) => sum + method.asked, 0).toLocaleString("en");
      parts.push(node("p", !list.length ? `No method errs at any stop of this run (${asked} questions to ${run.methods.length} methods).`
        : `${here.length ? "" : "None errs here. "}In this run some method errs at ${where} of ${run.stops.length} stops.`));
    }
    at("disagreements").replaceChildren(...parts);
  }
  function listMethods() {
    at("methods").tBodies[0].replaceChildren(...run.methods.map((method) => {
      const row = node("tr", "");
      row.append(node("th", method.name, {scope: "row"}), node("td", method.asked, {class: "number"}),
                 node("td", method.wrong, {class: method.wrong ? "number verdict wrong" : "number"}));
      return row;
    }));
    at("next-wrong-line").hidden = !run.disagreements.length;
  }

  const bars = cell.robot.joints.map((joint, i) => {
    const row = node("tr", ""), bar = node("div", "", {class: "bar", role: "img"}), mark = node("i", "");
    bar.append(mark);
    const cells = [node("th", joint.name, {scope: "row"}), node("td", "", {class: "number"}), node("td", "", {class: "number"}), node("td", "")];
    const jog = node("input", "", {type: "range", min: joint.lower, max: joint.upper, step: 0.5, "aria-label": `Jog ${joint.name}`});
    jog.addEventListener("input", () => jogTo(i, +jog.value));
    jog.disabled = !answers.live;
    cells[3].append(bar, jog);
    row.append(...cells);
    at("joints").tBodies[0].append(row);
    return {joint, cells, bar, mark, jog};
  });
  let jogged = null, posing = false;
  /// One question at a time; of those that come meanwhile, the last one next.
  async function jogTo(joint, command) {
    const from = jogged || (shown && shown.commanded) || cell.robot.joints.map(({home}) => home);
    jogged = from.map((angle, i) => (i === joint ? command : angle));
    if (posing) return;
    posing = true;
    for (let asked = null; asked !== jogged;) {
      asked = jogged;
      try {
        const pose = await answers.pose({setting, commanded: asked});
        const near = pose.nearest.map(({mover, element, distance}) => `${MOVERS[mover]} ${digits(distance, lengthDigits + 1)} ${cell.unit} from ${element}`);
        showPose({...pose, commanded: asked, material: poseOf({carrier: "material"}), place: "storage", touched: null, target: null,
                  offending: pose.hindrance ? pose.hindrance.parts : []},
                 `Jogged: ${pose.hindrance ? pose.hindrance.what : "nothing is touched"}. Least distance: ${near.join("; ")}.`);
      } catch (refused) {
        if (!(refused instanceof Refused)) throw refused;
        at("status").textContent = `Jogged: ${refused.message}`;
      }
    }
    posing = false;
  }
  function showJoints(commanded) {
    bars.forEach(({joint, cells, bar, mark, jog}, i) => {
      const angle = commanded ? commanded[i] : joint.home;
      if (document.activeElement !== jog) jog.value = angle;
      cells[1].textContent = `${digits(angle, 2)}°`;
      cells[2].textContent = `${signed(+(angle - joint.home).toFixed(3))}°`;
      mark.style.left = `${100 * Math.max(0, Math.min(1, (angle - joint.lower) / (joint.upper - joint.lower)))}%`;
      bar.setAttribute("aria-label", `between ${digits(joint.lower, 1)}° and ${digits(joint.upper, 1)}°`);
      bar.title = bar.getAttribute("aria-label");
    });
  }

  function listMoves() {
    const rows = run.moves.map((move, i) => {
      const row = node("tr", "", {"data-move": i});
      const go = node("button", PHASES[move.phase], {type: "button", title: "Go to the end of this move"});
      const end = lastStopOf(i);
      go.addEventListener("click", () => (player.pause(), player.go(end)));
      const first = node("td", "");
      first.append(go);
      row.append(first, node("td", move.joint), node("td", `${signed(move.degrees)}°`, {class: "number"}), move.wrong ? node("td", wrongly(move.wrong), {class: "verdict wrong"}) : node("td", UNTIL[move.until]),
                 node("td", move.seconds === null ? "?" : digits(move.seconds, 2), {class: "number"}),
                 node("td", `${signed(move.exact, 6)}°`, {class: "number exactly"}));
      return row;
    });
    at("moves").tBodies[0].replaceChildren(...rows);
    // One stretch a phase, as long as it has stops.
    const stretches = [];
    run.stops.forEach((stop, i) => {
      const phase = i > 0 && run.moves[stop.move] ? run.moves[stop.move].phase : stretches.length ? stretches.at(-1).phase : "to-storage";
      if (!stretches.length || stretches.at(-1).phase !== phase) stretches.push({phase, stops: 0});
      ++stretches.at(-1).stops;
    });
    at("phases").replaceChildren(...stretches.map(({phase, stops}) => {
      const span = node("span", stops > run.stops.length / 10 ? PHASES[phase] : "", {"data-phase": phase, title: PHASES[phase]});
      span.style.flex = `${stops} 1 0`;
      return span;
    }));
  }
  function showMove(move, number) {
    const rows = [...at("moves").tBodies[0].rows];
    const now = number > 0 ? rows[move] : null;
    for (const row of rows) {
      row.classList.toggle("now", row === now);
      row.toggleAttribute("aria-current", row === now);
    }
    if (now) {
      const box = at("moves").parentElement, top = now.offsetTop - box.clientHeight / 2;
      if (now.offsetTop < box.scrollTop + 30 || now.offsetTop + now.offsetHeight > box.scrollTop + box.clientHeight) box.scrollTop = top;
    }
    const phase = number > 0 && run && run.moves[move] ? run.moves[move].phase : number === 0 ? "to-storage" : null;
    for (const span of at("phases").children) span.classList.toggle("now", span.dataset.phase === phase);
  }

  // The run.
  const player = new Player(show, () => {
    at("run").textContent = player.running ? "Pause" : "Run";
    if (!player.running && shown) announce(at("status").textContent);
  });
  function showSpeed() {
    at("speed").value = player.speed;
    const rate = `${SPEEDS[player.speed]} stops/s`;
    at("speed-says").textContent = rate;
    at("speed").setAttribute("aria-valuetext", rate);
  }
  const faster = (by) => (player.speed = Math.max(0, Math.min(SPEEDS.length - 1, player.speed + by)), showSpeed());
  at("run").addEventListener("click", () => player.toggle());
  at("first").addEventListener("click", () => player.step(-Infinity));
  at("back").addEventListener("click", () => player.step(-1));
  at("forward").addEventListener("click", () => player.step(1));
  at("last").addEventListener("click", () => player.step(Infinity));
  at("next-wrong").addEventListener("click", () => {
    const where = run.disagreements.map((d) => d.stop);
    player.pause();
    player.go(where.find((stop) => stop > player.stop) ?? where[0]);
  });
  at("stop").addEventListener("input", () => (player.pause(), player.go(+at("stop").value)));
  at("speed").addEventListener("input", () => faster(+at("speed").value - player.speed));
  const curve = new Curve(at("curve"), (stop) => (player.pause(), player.go(stop)));
  function listDistances() {
    curve.load(run, cell.unit);
    const {least, tolerance} = run.separation, cycle = run.times.at(-1);
    at("curve-says").textContent = run.stops.length < 2 ? "" :
      `Small distances are drawn larger. ${cycle === undefined ? "A joint's greatest speed is unknown, so there is no cycle time."
        : `Cycle time ${digits(cycle, 2)} s, one joint after the other at its greatest speed.`} Every distance holds between the stops, too; the bounds differ by at most ${tolerance.toExponential(0)} ${cell.unit}.`;
    const row = ({mover, element, low, high, stop}) => {
      const go = node("button", stop, {type: "button", title: "Go to this stop"}), cellOfStop = node("td", "", {class: "number"});
      go.addEventListener("click", () => (player.pause(), player.go(stop)));
      cellOfStop.append(go);
      const line = node("tr", "");
      line.append(node("td", MOVERS[mover]), node("td", element), node("td", digits(Math.floor(low * 1000) / 1000, 3), {class: "number"}),
                  node("td", digits(high, 3), {class: "number"}), cellOfStop);
      return line;
    };
    at("least").tBodies[0].replaceChildren(...least.map(row));
  }

  /// The area of configuration, in the background: one direction after the other, those far apart first.
  const AREA_STEP = 10;
  let areaOf = "";
  async function askArea() {
    const {storage, ...others} = setting, wanted = JSON.stringify({height: storage.height, ...others});
    if (!answers.live || areaOf === wanted) return;
    areaOf = wanted;
    at("plan").plan.clearArea();
    const angles = [...Array(360 / AREA_STEP).keys()].sort((a, b) => (a * 7) % 36 - (b * 7) % 36).map((i) => i * AREA_STEP - 180);
    let done = 0;
    for (const angle of angles) {
      const places = await answers.area({...setting, storage: {...setting.storage, angle}}).catch(() => null);
      if (areaOf !== wanted) return;
      if (!places) return void (at("area-says").textContent = "");
      at("plan").plan.addArea(angle, AREA_STEP, places);
      at("area-says").textContent = `Area of configuration at this height: blue completes, orange something is in the way, grey another reason; ${++done} of ${angles.length} directions.`;
    }
  }

  const transport = ["first", "back", "run", "forward", "last", "stop"].map(at);
  const usable = (yes) => transport.forEach((control) => (control.disabled = !yes));

  document.addEventListener("keydown", (event) => {
    const own = event.target.closest("input, select, .handle, canvas");
    if (own || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === " " && event.target.closest("button")) return;
    const act = {
      " ": () => player.toggle(), ArrowRight: () => player.step(1), ArrowLeft: () => player.step(-1), Home: () => player.step(-Infinity),
      End: () => player.step(Infinity), "+": () => faster(1), "=": () => faster(1), "-": () => faster(-1), "−": () => faster(-1),
    }[event.key];
    if (!act || !run) return;
    event.preventDefault();
    act();
  });

  // The setting.
  const fields = {
    angle: {least: Math.min(-180, cell.setting.storage.angle), most: Math.max(180, cell.setting.storage.angle), step: 1, says: (x) => `${digits(x, 2)}°`},
    radius: {least: cell.bounds.longest / 40, most: cell.bounds.longest / 4 * 1.2, step: length, says},
    height: {least: 0, most: cell.bounds.longest / 4 * 1.2, step: length, says},
  };
  for (const [name, field] of Object.entries(fields)) {
    const input = at(name), value = cell.setting.storage[name];
    // Steps are counted from the cell's own value.
    input.min = value - Math.floor((value - field.least) / field.step) * field.step;
    input.max = field.most;
    input.step = field.step;
    input.addEventListener("input", () => (setting.storage[name] = +input.value, showSetting()));
    input.addEventListener("change", () => ask());
    const typed = at(`${name}-number`);
    typed.addEventListener("change", () => {
      if (typed.value !== "" && typed.checkValidity()) setting.storage[name] = +typed.value, ask();
      else showSetting();
    });
  }
  for (const span of document.querySelectorAll("[data-unit]")) span.textContent = cell.unit;
  for (const drive of cell.drives) at("drive").append(node("option", drive === "exact" ? "the exact answer" : drive, {value: drive}));
  at("drive").addEventListener("change", () => (setting.drive = at("drive").value, ask()));
  at("preset").append(node("option", "as it is served", {value: 0}), ...(await answers.presets()).map((name, i) => node("option", name, {value: i + 1})));
  at("preset").value = answers.preset || 0;
  at("preset").addEventListener("change", () => (location.search = +at("preset").value ? `?preset=${at("preset").value}` : ""));
  at("with-sphere").addEventListener("change", draw);
  at("covers-label").hidden = !answers.live || !scene;
  at("with-covers").addEventListener("change", async () => {
    const answer = at("with-covers").checked ? await answers.covers() : null;
    covers = answer && answer.covers.map(({link, balls}) => ({link, balls: scene.balls(balls)}));
    draw();
  });
  at("where").addEventListener("click", showStuck);
  at("unjog").addEventListener("click", () => (jogged = null, show(player.stop)));
  for (const slot of cell.slots) at("slot").append(node("option", slot.name, {value: slot.name}));
  const steps = [...new Set([0.1, 0.25, 0.5, 1, 2, 5, cell.setting.step])].sort((a, b) => a - b);
  for (const step of steps) at("step").append(node("option", `${digits(step, 3)}°`, {value: step}));
  at("slot").addEventListener("change", () => (setting.slot = at("slot").value, ask()));
  at("step").addEventListener("change", () => (setting.step = +at("step").value, ask()));
  at("reset").addEventListener("click", () => (Object.assign(setting, structuredClone(cell.setting)), ask()));

  at("plan").plan = new Plan(at("plan"), cell, (angle, radius, done) => {
    const input = at("radius"), step = +input.step;
    setting.storage.angle = Math.round(((angle + 180) % 360 + 360) % 360 - 180);
    const steps = Math.round((radius - input.min) / step);
    setting.storage.radius = Math.max(+input.min, Math.min(+input.max, +(+input.min + steps * step).toFixed(9)));
    showSetting();
    if (done) ask();
  });

  function showSetting() {
    for (const [name, field] of Object.entries(fields)) {
      at(name).value = at(`${name}-number`).value = setting.storage[name];
      at(name).setAttribute("aria-valuetext", field.says(setting.storage[name]));
    }
    at("slot").value = setting.slot;
    at("step").value = setting.step;
    at("drive").value = setting.drive;
    const {angle, radius} = setting.storage;
    at("plan").plan.configure(angle, radius, `angle ${digits(angle, 2)}°, radius ${says(radius)}`, !answers.live);
    const labels = {...cell.labels};
    for (const name of Object.keys(fields)) if (setting.storage[name] !== cell.setting.storage[name]) labels[`storage.${name}`] = "C";
    if (setting.step !== cell.setting.step) labels.step = "C";
    for (const span of document.querySelectorAll("[data-label]")) {
      const label = labels[span.dataset.label];
      span.textContent = label;
      span.classList.toggle("chosen", label === "C");
      span.title = {T: "the thesis's text", S: "another source", D: "derived", C: "chosen"}[label];
      span.setAttribute("aria-label", span.title);
    }
    if (run && !same(run.setting, setting)) forget();
    draw();
  }
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  /// The run of another setting is not shown.
  function forget() {
    player.pause();
    run = null, shown = null, jogged = null, player.count = 0;
    usable(false);
    at("where").hidden = true;
    complain("");
    show(0);
    at("status").textContent = "The storage is being moved; the program is asked when it is let go.";
  }

  /// One question at a time; of those that come meanwhile, the last one next.
  async function ask() {
    showSetting();
    ++wanted;
    if (document.body.hasAttribute("aria-busy")) return;
    document.body.setAttribute("aria-busy", "true");
    at("asked").textContent = answers.live ? "The program runs the process …" : "";
    for (let asked = 0; asked !== wanted;) {
      asked = wanted;
      const heard = await answers.run(setting).then((answer) => () => take(answer), (refused) => () => refuse(refused));
      if (asked === wanted) heard();
    }
    at("asked").textContent = "";
    document.body.removeAttribute("aria-busy");
    askArea();
  }
  function refuse(refused) {
    if (!(refused instanceof Refused)) throw refused;
    run = null, shown = null, jogged = null, player.count = 0;
    usable(false);
    at("where").hidden = true;
    show(0);
    at("moves").tBodies[0].replaceChildren(), at("phases").replaceChildren();
    at("status").textContent = "There is no run. The arm is shown at home.";
    announce("");
    complain(`This cell cannot be run: ${refused.message}`);
  }
  function take(answer) {
    run = answer, jogged = null;
    const end = run.stops.length - 1;
    complain(run.failure && `${end < 0 ? "The process does not begin" : `The process does not come out; it ends after stop ${end}`}: ` +
             `${inWords(run.stuck.reason)}.`, run.failure);
    at("where").hidden = !run.stuck;
    if (scene && run.stand) {
      const stand = meshes.find(({part}) => part.name === run.stand.name);
      scene.forget(stand.mesh);
      stand.part = run.stand, stand.mesh = scene.mesh(run.stand);
    }
    usable(end > 0);
    at("stop").max = Math.max(0, end);
    listMoves();
    listMethods();
    listDistances();
    player.load(run.stops);
    if (end < 0) show(0);
    showSetting();
    if (run.stuck) showStuck();
  }

  if (!answers.live) {
    const typed = Object.keys(fields).map((name) => `${name}-number`);
    for (const control of [...Object.keys(fields), ...typed, "slot", "step", "drive", "preset", "reset"].map(at)) control.disabled = true;
    at("jog-help").hidden = true;
    at("plan-help").textContent = "From above, as it was recorded.";
  }

  // The view.
  if (scene) {
    const canvas = at("scene"), pointers = new Map();
    let spread = 0;
    const closeAt = (event) => {
      const box = canvas.getBoundingClientRect(), x = event.clientX - box.left, y = box.bottom - event.clientY;
      return scene.views(box.width, box.height).some(([near, left, below, width, height]) => near && x >= left && x <= left + width && y >= below && y <= below + height);
    };
    const apart = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      canvas.setPointerCapture(event.pointerId);
      if (pointers.size === 2) spread = apart();
    });
    canvas.addEventListener("pointermove", (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      if (pointers.size === 1) scene.turn(-0.4 * (event.clientX - last[0]), 0.4 * (event.clientY - last[1]));
      if (pointers.size === 2) scene.approach(spread / apart(), closeAt(event)), spread = apart();
      draw();
    });
    const end = (event) => pointers.delete(event.pointerId);
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      scene.approach(Math.exp(event.deltaY / 800), closeAt(event));
      draw();
    }, {passive: false});
    canvas.addEventListener("keydown", (event) => {
      const act = {
        ArrowLeft: () => scene.turn(-5, 0), ArrowRight: () => scene.turn(5, 0), ArrowUp: () => scene.turn(0, 5), ArrowDown: () => scene.turn(0, -5),
        "+": () => scene.approach(0.9), "=": () => scene.approach(0.9), "-": () => scene.approach(1 / 0.9),
      }[event.key];
      if (!act) return;
      event.preventDefault();
      act();
      draw();
    });
    for (const button of document.querySelectorAll("[data-look]"))
      button.addEventListener("click", () => {
        const look = button.dataset.look;
        look === "near" ? scene.lookNear() : look === "split" ? scene.lookSplit() : scene.look(look);
        document.querySelector("[data-look=split]").setAttribute("aria-pressed", scene.split);
        draw();
      });
    new ResizeObserver(draw).observe(canvas);
  }
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (colours = readColours(), draw()));

  showSpeed();
  showSetting();
  usable(false);
  await ask();
}

main();
