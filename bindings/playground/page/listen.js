// SPDX-License-Identifier: GPL-3.0-or-later
// Pointers, the wheel, keys, fields and buttons.

function listen() {
  listenToWindow(at("window"));
  listenToFields();
  addEventListener("resize", resize);
  addEventListener("hashchange", () => { const linked = readPermalink(location.hash); if (linked) take(linked); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { map.forgetShades(); repaint(); draw(); });
}

function listenToWindow(canvas) {
  const pointers = new Map();
  let holdsBall = false, spread = 0;
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const middle = () => [0, 1].map((i) => [...pointers.values()].reduce((sum, p) => sum + p[i] / pointers.size, 0));
  const apart = () => { const [p, q] = [...pointers.values()]; return Math.hypot(p[0] - q[0], p[1] - q[1]); };

  canvas.addEventListener("pointerdown", (event) => {
    const [x, y] = place(event);
    pointers.set(event.pointerId, [x, y]);
    canvas.setPointerCapture(event.pointerId);
    if (drawn) return addCorner(x, y);
    if (pointers.size === 2) spread = apart();
    const {center} = state.ball;
    holdsBall = pointers.size === 1 && Math.hypot(view.x(center[plane.a]) - x, view.y(center[plane.b]) - y) < 24;
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last || drawn) return;
    const [x, y] = place(event);
    pointers.set(event.pointerId, [x, y]);
    if (pointers.size === 2) {
      const now = apart();
      zoomAt(now / spread, ...middle());
      spread = now;
    } else if (holdsBall) {
      moveBall(x, y);
    } else {
      view.moveBy(x - last[0], y - last[1]);
      repaint(), draw(), remember();
    }
  });
  const end = (event) => pointers.delete(event.pointerId);
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("dblclick", (event) => { if (!drawn) moveBall(...place(event)); });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomAt(Math.exp(-event.deltaY / 300), ...place(event));
  }, {passive: false});
  canvas.addEventListener("keydown", (event) => {
    const one = event.shiftKey;
    const act = {
      ArrowLeft: () => stepBall(-1, 0, one), ArrowRight: () => stepBall(1, 0, one), ArrowUp: () => stepBall(0, 1, one),
      ArrowDown: () => stepBall(0, -1, one), "+": () => zoomToBall(2), "=": () => zoomToBall(2), "-": () => zoomToBall(0.5),
      Enter: () => drawn && drawn.length > 2 && finishDrawing(),
      Escape: () => { drawn = null; at("draw").setAttribute("aria-pressed", false); draw(); },
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

/// A corner of the polygon that is drawn; at the first one, the end of it.
function addCorner(x, y) {
  if (drawn.length > 2 && Math.hypot(drawn[0][0] - x, drawn[0][1] - y) < 16) return finishDrawing();
  drawn.push([x, y]);
  draw();
}

function listenToFields() {
  const number = (id) => (at(id).value.trim() === "" ? NaN : Number(at(id).value));
  for (const id of ["x", "y", "z", "radius"])
    at(id).addEventListener("change", () => setBall({center: [number("x"), number("y"), number("z")], radius: number("radius")}));
  at("lift-slider").addEventListener("input", () => {
    const {center} = state.ball, lift = sizeOf(state.loops) * number("lift-slider");
    setBall({...state.ball, center: plane.point(center[plane.a], center[plane.b], lift)}, {lift});
  });
  at("radius-slider").addEventListener("input", () => setBall({...state.ball, radius: sizeOf(state.loops) * number("radius-slider")}));
  at("less").addEventListener("click", () => setBall({...state.ball, radius: Math.max(0, neighbour(state.ball.radius, -1))}));
  at("more").addEventListener("click", () => setBall({...state.ball, radius: neighbour(state.ball.radius)}));
  at("touch").addEventListener("click", () => setBall({...state.ball, radius: answers.filtered.distance}));
  at("question").addEventListener("change", () => { state.question = at("question").value; changed(); });
  at("mapped").addEventListener("change", () => { state.map = at("mapped").checked; changed(); });
  at("in").addEventListener("click", () => zoomToBall(4));
  at("out").addEventListener("click", () => zoomToBall(0.25));
  at("whole").addEventListener("click", () => take({...state, view: undefined}));
  at("draw").addEventListener("click", () => {
    drawn = drawn ? null : [];
    at("draw").setAttribute("aria-pressed", drawn !== null);
    draw();
  });
  at("take").addEventListener("click", () => {
    try {
      take(readPasted(at("pasted").value));
    } catch (error) {
      if (!(error instanceof Malformed)) throw error;
      refuse(error.message);
    }
  });
  for (const name of Object.keys(SAMPLES)) at("sample").append(new Option(name, name));
  at("sample").addEventListener("change", () => take(structuredClone(SAMPLES[at("sample").value])));
}
