// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows: the map, the doubles as dots, the polygon, the ball and the closest point.

function colourOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name);
}

function drawWindow(canvas, view, plane, {loops, ball, to}, {map, certified, drawn}) {
  const ratio = canvas.width / view.width, pencil = canvas.getContext("2d");
  pencil.setTransform(ratio, 0, 0, ratio, 0, 0);
  pencil.clearRect(0, 0, view.width, view.height);
  if (map && map.width) pencil.drawImage(map, 0, 0);
  drawDots(pencil, view);
  drawLoops(pencil, view, plane, loops, map && map.width > 0);
  if (drawn.length) drawTrace(pencil, drawn);
  if (certified) {
    pencil.lineWidth = 3.5, pencil.strokeStyle = colourOf("--hit");
    for (const edge of certified.edges_hit) drawEdge(pencil, view, plane, loops, edge);
  }
  if (to) drawWay(pencil, view, plane, ball.center, to);
  drawBall(pencil, view, plane, ball, certified);
}

function drawDots(pencil, view) {
  const dots = view.dots();
  if (!dots) return;
  pencil.fillStyle = colourOf("--dot");
  const xs = dots[0].map((a) => view.x(a)), ys = dots[1].map((b) => view.y(b));
  const size = Math.min(6, Math.max(1.5, Math.min(xs[1] - xs[0], ys[0] - ys[1]) / 3));
  for (const y of ys) for (const x of xs) pencil.fillRect(x - size / 2, y - size / 2, size, size);
}

/// Canvases draw badly far outside of themselves.
function near(pixels) {
  return Math.min(Math.max(pixels, -1e7), 1e7);
}

function line(pencil, view, plane, p, q) {
  const [start, end] = segmentOf(view, [p[plane.a], p[plane.b]], [q[plane.a], q[plane.b]]);
  pencil.moveTo(...start);
  pencil.lineTo(...end);
}

function fillFace(pencil, view, plane, loops) {
  const pixels = loops.map((loop) => loop.map((p) => [view.x(p[plane.a]), view.y(p[plane.b])]));
  if (!pixels.flat(2).every((each) => Math.abs(each) < FAR)) return;  // the outline alone shows the polygon
  pencil.beginPath();
  for (const loop of pixels) {
    loop.forEach((p, i) => pencil[i ? "lineTo" : "moveTo"](...p));
    pencil.closePath();
  }
  pencil.fillStyle = colourOf("--face");
  pencil.fill("evenodd");
}

function drawLoops(pencil, view, plane, loops, mapped) {
  if (!mapped) fillFace(pencil, view, plane, loops);
  pencil.beginPath();
  for (const loop of loops) loop.forEach((p, i) => line(pencil, view, plane, p, loop[(i + 1) % loop.length]));
  pencil.lineWidth = 1.75, pencil.strokeStyle = colourOf("--ink");
  pencil.stroke();
  pencil.fillStyle = colourOf("--ink");
  for (const p of loops.flat()) {
    const x = view.x(p[plane.a]), y = view.y(p[plane.b]);
    if (x > -5 && y > -5 && x < view.width + 5 && y < view.height + 5) {
      pencil.beginPath();
      pencil.arc(x, y, 3.5, 0, 7);
      pencil.fill();
    }
  }
}

function drawEdge(pencil, view, plane, loops, edge) {
  const loop = loops.find((each) => edge < each.length || ((edge -= each.length), false));
  if (!loop) return;
  pencil.beginPath();
  line(pencil, view, plane, loop[edge], loop[(edge + 1) % loop.length]);
  pencil.stroke();
}

function drawTrace(pencil, drawn) {
  pencil.beginPath();
  drawn.forEach(([x, y], i) => pencil[i ? "lineTo" : "moveTo"](x, y));
  pencil.lineWidth = 2, pencil.setLineDash([5, 4]), pencil.strokeStyle = colourOf("--accent");
  pencil.stroke();
  pencil.setLineDash([]);
  for (const [x, y] of drawn) pencil.beginPath(), pencil.arc(x, y, 5, 0, 7), pencil.stroke();
}

function drawWay(pencil, view, plane, from, to) {
  pencil.beginPath();
  line(pencil, view, plane, from, to);
  pencil.lineWidth = 2, pencil.setLineDash([2, 5]), pencil.strokeStyle = colourOf("--ball");
  pencil.stroke();
  pencil.setLineDash([]);
}

function drawBall(pencil, view, plane, ball, certified) {
  const x = view.x(ball.center[plane.a]), y = view.y(ball.center[plane.b]), radius = ball.radius * view.scale;
  pencil.lineWidth = 2, pencil.strokeStyle = pencil.fillStyle = colourOf("--ball");
  if (radius < 1e6) {
    pencil.beginPath();
    pencil.arc(near(x), near(y), radius, 0, 2 * Math.PI);
    pencil.globalAlpha = 0.12, pencil.fill(), pencil.globalAlpha = 1;
    pencil.stroke();
  }
  if (certified) {
    const px = view.x(certified.point[plane.a]), py = view.y(certified.point[plane.b]);
    if (Math.hypot(px - x, py - y) < 1e6) {
      pencil.beginPath(), pencil.moveTo(x, y), pencil.lineTo(px, py), pencil.stroke();
      pencil.beginPath(), pencil.rect(px - 4, py - 4, 8, 8);
      pencil.fillStyle = colourOf("--card"), pencil.fill(), pencil.stroke();
    }
  }
  pencil.beginPath(), pencil.arc(x, y, 7, 0, 7);
  pencil.fillStyle = colourOf("--ball"), pencil.fill();
  pencil.lineWidth = 2, pencil.strokeStyle = colourOf("--card"), pencil.stroke();
}
