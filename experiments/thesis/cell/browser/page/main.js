// SPDX-License-Identifier: GPL-3.0-or-later
// The page: what is asked, and what is shown.

async function main() {
  const recorded = JSON.parse(at("recorded").textContent);
  const variation = recorded ? {piece: "", changes: []} : variationOf(location.search);
  const answers = answersOf(recorded, variation);
  let cell;
  try {
    cell = await answers.cell();
  } catch (refused) {
    at("status").textContent = "";
    complain(refused.message);
    if (variation.changes.length) {
      const back = node("a", "Take the last change back", {href: addressOf({...variation, changes: variation.changes.slice(0, -1)})});
      at("failure").append(" ", back, ".");
    }
    return;
  }

  const length = 10 ** (Math.floor(Math.log10(cell.bounds.longest)) - 3);  // a step of lengths
  const lengthDigits = Math.max(0, 1 - Math.round(Math.log10(length)));
  const says = (x) => `${digits(x, lengthDigits)} ${cell.unit}`;
  const setting = structuredClone(cell.setting);
  let run = null, shown = null, wanted = 0;

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
    at("scene").hidden = true, at("no-scene").hidden = false, at("scene-help").hidden = at("follow").parentElement.hidden = true;
    document.querySelector(".corner").hidden = true;
  }
  const meshes = scene ? cell.parts.map((part) => ({part, mesh: scene.mesh(part)})) : [];
  const zones = scene ? cell.zones.map((zone) => ({zone, mesh: scene.mesh(zone)})) : [];
  const materialMesh = scene && meshes.find(({part}) => part.carrier === "material").mesh;
  let ball, rings, floor, path = null;
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

  function poseOf(part, links, closed) {
    if (part.carrier === "finger" && closed) return add3(links[part.link], times(closed[part.finger], part.closes));
    if (["link", "gripper", "finger"].includes(part.carrier)) return links[part.link];
    if (part.carrier === "obstacle") return IDENTITY;
    const storage = setting.storage;
    if (part.carrier === "storage") return standing(cell.storage.home + storage.angle, storage.radius, storage.height, cell.storage.turn);
    if (part.carrier === "machine") return standing(cell.machine.home + cell.machine.angle, cell.machine.radius, cell.machine.height, cell.machine.turn);
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
    for (const name of ["view", "floor", "edge", "free", "touching", "wrong", "material", "robot", "gripper", "finger", "storage", "machine", "obstacle", "zone", "offending"]) {
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
      wrong: number > 0 && run.moves[stop.move] && lastStopOf(run, stop.move) === number ? run.moves[stop.move].wrong : null,
    };
  }
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
      things.push({mesh, pose: material ? look.material : poseOf(part, look.links, look.closed), shadow: true, lines: colours.edge,
                   colour: offends(part, look) ? colours.offending : colours[part.carrier === "link" ? "robot" : part.carrier],
                   highlight: material && touching && (!look.virtual || look.puts) ? [look.touched, colours.touching] : null});
    }
    if (look.virtual && !look.puts)
      things.push({mesh: materialMesh, pose: run.materials[look.target], hollow: true, lines: signal, dash: cell.bounds.longest / 500,
                   highlight: touching ? [look.touched, colours.touching] : null});
    const in_ = run && shown === look ? run.triggers.filter(({after, until}) => after <= player.stop && player.stop < until).map(({zone}) => zone) : [];
    for (const {zone, mesh} of zones)
      things.push({mesh, pose: IDENTITY, hollow: true, dash: cell.bounds.longest / 300,
                   lines: in_.includes(zone.name) || (look.offending || []).includes(zone.name) ? colours.touching : colours.zone});
    if (path) things.push({mesh: path, pose: IDENTITY, hollow: true, through: true, flat: true, lines: colours.free});
    const size = cell.sphere;
    if (at("with-sphere").checked) things.push({mesh: ball, pose: shiftedTo(look.sphere, size), colour: signal, shadow: true, through: true});
    if (look.wrong || (look.errors && look.errors.length)) things.push({mesh: rings, pose: shiftedTo(look.sphere, 2.2 * size), hollow: true, through: true, lines: colours.wrong});
    scene.draw(things, colours, look.sphere);
  }

  /// The path of the sphere on the whole run, if it is asked for.
  function showPath() {
    const points = run && at("with-path").checked ? run.stops.map(({sphere}) => sphere) : [];
    at("plan").plan.showPath(points);
    if (path) scene.forget(path);
    path = scene && points.length ? scene.path(points) : null;
    draw();
  }

  const sentences = new Sentences(cell, setting, lengthDigits);
  const {face, wrongly} = sentences;
  const sentence = (look, number) => sentences.of(run, look, number);
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
    const {grip, landing} = (run && run.transfers.findLast(({stop}) => stop <= number)) || {};
    answer.push(["the material", look.place !== null ? `${look.place === "machine" ? "is at the machine" : "is in the storage"}${landing ? `, on ${landing.support}` : ""}`
      : grip ? `is held at ${grip.faces.map((faces) => faces.map(face).join(", ")).join(" and ")}; the fingers are ${says(grip.opening)} apart` : "sticks to the gripper"]);
    if (run && run.stops[number]) answer.push(["least distance", nearestOf(number).join("; ")]);
    if (run && run.waits[number]) answer.push(["the arm waits", `${digits(run.waits[number], 3)} s`]);
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
    showMove(run, look.move, number);
    draw();
  }

  /// On the way from a stop to the next: what is said is said of the stop.
  function showBetween(number, share) {
    const look = lookOf(number), next = run.stops[number + 1];
    shown = {...look, links: look.links.map((pose, i) => poseBetween(pose, next.links[i], share)), sphere: mix(look.sphere, next.sphere, share),
             material: look.place === null ? poseBetween(look.material, next.material, share) : look.material};
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

  const joints = new Joints(cell, answers, () => setting, (pose, asked) => {
    const near = pose.nearest.map(({mover, element, distance}) => `${MOVERS[mover]} ${digits(distance, lengthDigits + 1)} ${cell.unit} from ${element}`);
    showPose({...pose, commanded: asked, material: poseOf({carrier: "material"}), place: "storage", touched: null, target: null,
              offending: pose.hindrance ? pose.hindrance.parts : []},
             `Jogged: ${pose.hindrance ? pose.hindrance.what : "nothing is touched"}. Least distance: ${near.join("; ")}.`);
  });
  const showJoints = (commanded) => joints.show(commanded);

  // The run.
  const player = new Player(show, showBetween, () => {
    at("run").textContent = player.running ? "Pause" : "Run";
    if (!player.running && shown) announce(at("status").textContent);
  });
  function showSpeed() {
    at("speed").value = player.speed;
    const rate = player.timed === false ? `${STOPS * RATES[player.speed]} stops/s` : `${RATES[player.speed]} × real time`;
    at("speed-says").textContent = rate;
    at("speed").setAttribute("aria-valuetext", rate);
  }
  const faster = (by) => (player.speed = Math.max(0, Math.min(RATES.length - 1, player.speed + by)), showSpeed());
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
    const {least, tolerance} = run.separation;
    at("curve-says").textContent = run.stops.length < 2 ? "" :
      `Small distances are drawn larger. ${run.cycle[0].toUpperCase()}${run.cycle.slice(1)}. Every distance holds between the stops, too; the bounds differ by at most ${tolerance.toExponential(0)} ${cell.unit}.`;
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
  at("with-path").addEventListener("change", showPath);
  new Elements(cell, variation, answers.live);
  at("where").addEventListener("click", showStuck);
  at("unjog").addEventListener("click", () => (joints.forget(), show(player.stop)));
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
  function showNoRun() {
    run = null, shown = null, joints.forget(), player.count = 0;
    usable(false);
    showPath();
    at("where").hidden = true;
    show(0);
  }
  /// The run of another setting is not shown.
  function forget() {
    player.pause();
    showNoRun();
    complain("");
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
    showNoRun();
    at("moves").tBodies[0].replaceChildren(), at("phases").replaceChildren();
    at("status").textContent = "There is no run. The arm is shown at home.";
    announce("");
    complain(`This cell cannot be run: ${refused.message}`);
  }
  function take(answer) {
    run = answer, joints.forget();
    const end = run.stops.length - 1;
    complain(run.failure && `${end < 0 ? "The process does not begin" : `The process does not come out; it ends after stop ${end}`}: ` +
             `${inWords(run.stuck.reason)}.`, run.refused.join("; "));
    at("where").hidden = !run.stuck;
    if (scene && run.stand) {
      const stand = meshes.find(({part}) => part.name === run.stand.name);
      scene.forget(stand.mesh);
      stand.part = run.stand, stand.mesh = scene.mesh(run.stand);
    }
    usable(end > 0);
    at("stop").max = Math.max(0, end);
    listMoves(run, cell.unit, (stop) => (player.pause(), player.go(stop)), wrongly);
    listMethods();
    listDistances();
    listTriggers(cell, run, (stop) => (player.pause(), player.go(stop)));
    showPath();
    player.load(run);
    showSpeed();
    if (end < 0) show(0);
    showSetting();
    const wished = +location.hash.slice(1);  // #137: the page begins at this stop
    if (run.stuck) showStuck();
    else if (wished > 0) player.go(wished);
  }

  if (!answers.live) {
    const typed = Object.keys(fields).map((name) => `${name}-number`);
    for (const control of [...Object.keys(fields), ...typed, "slot", "step", "drive", "preset", "reset"].map(at)) control.disabled = true;
    at("jog-help").hidden = true;
    at("plan-help").textContent = "From above, as it was recorded.";
  }

  if (scene) listenToView(scene, draw);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (colours = readColours(), draw()));

  showSpeed();
  showSetting();
  usable(false);
  await ask();
}

main();
