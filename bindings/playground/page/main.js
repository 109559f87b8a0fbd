// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page, and what changes it.

const at = (id) => document.getElementById(id);
let engine, map, state, plane, view, answers = null, drawn = null, drawPending = false;

/// Takes a polygon and a ball; refuses what the contract refuses, and then keeps what was there.
function take({loops, ball, to, view: wanted, question, map: mapped}) {
  const asked = ball ?? ballFor(loops);
  const refusal = engine.take({loops, ball: asked, to});
  if (refusal) {
    if (state) engine.takePolygon(state.loops);
    return refuse(refusal);
  }
  state = {loops, ball: asked, to, question: question ?? state?.question ?? "contact", map: mapped ?? state?.map ?? true};
  plane = new SeenPlane(loops);
  state.lift = plane.liftOf(asked.center);
  const box = at("window").getBoundingClientRect();
  view = wanted ? new View(wanted) : View.around(loops.flat(), plane, box.width, box.height);
  at("question").value = state.question, at("mapped").checked = state.map;
  at("pasted").value = caseText(state);
  refuse("");
  resize();
  return true;
}

/// A ball that touches nothing in particular: above the middle, of a fifth of the polygon's size.
function ballFor(loops) {
  const seen = new SeenPlane(loops), size = sizeOf(loops);
  const mean = (axis) => loops[0].reduce((sum, p) => sum + p[axis] / loops[0].length, 0);
  return {center: seen.point(mean(seen.a), mean(seen.b), size / 16), radius: size / 8};
}
function sizeOf(loops) {
  const points = loops.flat();
  return Math.max(...[0, 1, 2].map((axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis]))));
}

function refuse(reason) {
  at("refusal").hidden = !reason;
  at("refusal").textContent = reason;
  return !reason;
}

/// Asks again about the ball, and shows everything.
function changed({window = true} = {}) {
  const {ball, to, loops} = state;
  answers = Object.fromEntries(METHODS.map((method) => [method, engine.answer(method, ball)]));
  showAnswers(at("answers"), answers);
  at("summary").textContent = summaryOf(answers);
  at("first").hidden = !to;
  if (to) at("first").textContent = firstWords(engine.firstContact(ball, to));
  ball.center.forEach((x, axis) => (at("xyz"[axis]).value = x));
  at("radius").value = ball.radius;
  const size = sizeOf(loops);
  at("lift-slider").value = Math.max(-1, Math.min(1, state.lift / size));
  at("radius-slider").value = Math.max(0, Math.min(1, ball.radius / size));
  if (window) repaint();
  draw();
  remember();
}
function firstWords({first, time, momentary, feature: met, point}) {
  if (first === "none") return "On its way the ball touches nothing.";
  return `First contact: ${first} at time ${time}${momentary ? ", momentary" : ""}, ${wordsOf(met)}, at ${point.join(", ")}.`;
}

function repaint() {
  if (!state.map) return map.stop();
  map.order({...state, radius: state.ball.radius, view});
}

function draw() {
  if (drawPending) return;
  drawPending = true;
  requestAnimationFrame(() => {
    drawPending = false;
    drawWindow(at("window"), view, plane, state, {map: state.map ? map.canvas : null, certified: answers?.filtered, drawn: drawn ?? []});
    at("scale").textContent = scaleWords();
    document.body.toggleAttribute("data-painted", map.done);
  });
}
function scaleWords() {
  const across = (view.width / view.scale).toPrecision(3), dots = view.dots() ? "; each dot is a double" : "";
  const share = (count) => `${(100 * count / map.counts.pixels).toPrecision(2)} %`;
  const wrong = state.map && map.done && map.counts ? ` Wrong in this window: fast ${share(map.counts.fast)}, thesis ${share(map.counts.thesis)}.` : "";
  return `The window is ${across} wide, and doubles at its middle lie ${spacing(view.a).toPrecision(2)} apart${dots}.${wrong}`;
}

function remember() {
  const link = writePermalink({...state, view});
  if (location.hash !== link) history.replaceState(null, "", link);
  at("permalink").href = link;
}

function resize() {
  const canvas = at("window"), box = canvas.getBoundingClientRect(), ratio = devicePixelRatio || 1;
  Object.assign(view, {width: Math.round(box.width), height: Math.round(box.height)});
  canvas.width = Math.round(view.width * ratio), canvas.height = Math.round(view.height * ratio);
  changed();
}

/// Puts the ball's centre over a pixel; its height over the plane stays.
function moveBall(x, y) {
  const [a, b] = view.at(x, y);
  setBall({...state.ball, center: plane.point(a, b, state.lift)}, {window: false, lift: state.lift});
}
function setBall(ball, {window, lift = plane.liftOf(ball.center)} = {}) {
  const refusal = engine.checkBall(ball, state.to);
  if (!refuse(refusal)) return;
  Object.assign(state, {ball, lift});
  at("pasted").value = caseText(state);
  changed({window});
}
/// Moves the ball by doubles, or by pixels where a double is less than one.
function stepBall(da, db, one) {
  const {center} = state.ball, moved = [...center];
  const {lift} = state, by = (x, steps) => (one || view.dots() ? neighbour(x, steps) : x + 8 * steps / view.scale);
  if (da) moved[plane.a] = by(center[plane.a], da);
  if (db) moved[plane.b] = by(center[plane.b], db);
  setBall({...state.ball, center: plane.point(moved[plane.a], moved[plane.b], lift)}, {window: false, lift});
}

function zoomAt(factor, x, y) {
  view.zoom(factor, x, y);
  repaint(), draw(), remember();
}
function zoomToBall(factor) {
  zoomAt(factor, view.x(state.ball.center[plane.a]), view.y(state.ball.center[plane.b]));
}

function finishDrawing() {
  const loop = drawn.map(([x, y]) => view.at(x, y)).map(([a, b]) => plane.point(a, b, 0));
  drawn = null;
  at("draw").setAttribute("aria-pressed", false);
  take({loops: [loop], view, ball: state.ball});
  draw();
}

async function start() {
  const wasm = Uint8Array.from(atob(at("wasm").textContent.trim()), (letter) => letter.charCodeAt(0));
  engine = await Engine.load(wasm);
  map = new FailureMap(wasm, draw);
  listen();
  const linked = location.hash.length > 1 ? readPermalink(location.hash) : null;
  if (!(linked && take(linked))) take(SAMPLES.gripper);
  document.body.removeAttribute("aria-busy");
}
