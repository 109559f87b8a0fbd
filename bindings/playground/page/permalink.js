// SPDX-License-Identifier: GPL-3.0-or-later
// All of the state in the address, each number as the shortest decimal that is read as the same double.

function writePermalink({loops, ball, to, view, question, map}) {
  const points = (loop) => loop.map((p) => p.join(",")).join(";");
  const parts = {
    polygon: loops.map(points).join("|"), ball: [...ball.center, ball.radius].join(","), ...(to ? {to: to.join(",")} : {}),
    view: [view.a, view.b, view.scale].join(","), question, map: map ? 1 : 0,
  };
  return "#" + Object.entries(parts).map(([key, value]) => `${key}=${value}`).join("&");
}

/// Returns the state; null if the text is not one.
function readPermalink(hash) {
  const parts = Object.fromEntries(hash.slice(1).split("&").map((part) => part.split("=").map(decodeURIComponent)));
  const list = (text) => text.split(",").map(Number);
  if (!parts.polygon || !parts.ball || !parts.view) return null;
  const loops = parts.polygon.split("|").map((loop) => loop.split(";").map(list)), numbers = list(parts.ball);
  const [a, b, scale] = list(parts.view), to = parts.to ? list(parts.to) : undefined;
  if ([...loops.flat(2), ...numbers, ...(to ?? []), a, b, scale].some(Number.isNaN) || !loops.flat().every(isPoint) ||
      numbers.length !== 4 || (to && to.length !== 3) || !(scale > 0)) return null;
  return {loops, ball: {center: numbers.slice(0, 3), radius: numbers[3]}, to, view: {a, b, scale},
          question: parts.question === "foot" ? "foot" : "contact", map: parts.map !== "0"};
}
