// SPDX-License-Identifier: GPL-3.0-or-later
// The worker: asks about the ball at each pixel of the window, first coarsely. A new order ends the one before.

const PASSES = [8, 2];  // pixels of a side of what is painted in one colour
let loading = null, newest = 0;

async function paintWindow(engine, order) {
  const plane = new SeenPlane(order.loops);
  if (engine.takePolygon(order.loops)) return;
  for (const step of PASSES) {
    const across = Math.ceil(order.a.length / step), rows = Math.ceil(order.b.length / step);
    let pause = Date.now() + 40;
    for (let row = 0; row < rows; ++row) {
      const middle = (list, i) => list[Math.min(i * step + (step >> 1), list.length - 1)];
      const centers = new Float64Array(3 * across), b = middle(order.b, row);
      for (let i = 0; i < across; ++i) centers.set(plane.point(middle(order.a, i), b, order.lift), 3 * i);
      const colours = engine.paint(order.question, order.radius, centers);
      postMessage({number: order.number, step, row, colours, last: step === PASSES.at(-1) && row === rows - 1}, [colours.buffer]);
      if (Date.now() < pause) continue;
      await new Promise((resume) => setTimeout(resume));
      if (order.number !== newest) return;
      pause = Date.now() + 40;
    }
  }
}

onmessage = async ({data}) => {
  if (data.wasm) return void (loading = Engine.load(data.wasm));
  newest = data.number;
  const engine = await loading;
  if (data.number === newest) await paintWindow(engine, data);
};
