// SPDX-License-Identifier: GPL-3.0-or-later
// What is pasted: a case of the contract, or points, one a line.

class Malformed extends Error {}

function isPoint(p) {
  return Array.isArray(p) && p.length === 3 && p.every((x) => typeof x === "number");
}
function expect(holds, reason) {
  if (!holds) throw new Malformed(`malformed-case: ${reason}`);
}

/// Returns {loops, ball, to} of a case in JSON. A duplicate key goes unnoticed.
function readCase(text) {
  let read;
  try {
    read = JSON.parse(text);
  } catch (error) {
    throw new Malformed(`malformed-case: ${error.message}`);
  }
  const {ball, polygon, motion} = read ?? {};
  expect(ball && isPoint(ball.center) && typeof ball.radius === "number", "ball needs a center of three numbers and a radius");
  expect(polygon && Array.isArray(polygon.outer), "polygon needs a list outer");
  expect(polygon.holes === undefined || Array.isArray(polygon.holes), "holes is not a list");
  expect(motion === undefined || isPoint(motion?.to), "motion needs to, three numbers");
  const loops = [polygon.outer, ...(polygon.holes ?? [])];
  expect(loops.every((loop) => Array.isArray(loop) && loop.every(isPoint)), "a vertex is not three numbers");
  return {loops, ball, to: motion?.to};
}

/// Returns the loops of lines `x y` or `x y z`, a loop ending with an empty line.
function readPoints(text) {
  return text.trim().split(/\n\s*\n/).map((loop) => loop.trim().split("\n").map((line) => {
    const numbers = line.trim().split(/[\s,;]+/).map(Number);
    expect((numbers.length === 2 || numbers.length === 3) && !numbers.some(Number.isNaN), `"${line.trim()}" is not two or three numbers`);
    return numbers.length === 2 ? [...numbers, 0] : numbers;
  }));
}

function readPasted(text) {
  return text.trim().startsWith("{") ? readCase(text) : {loops: readPoints(text)};
}

/// Returns the case as a line of JSON. Numbers are the shortest that are read as the same doubles.
function caseText({loops, ball, to}) {
  const written = {id: "playground", ball, polygon: {outer: loops[0], holes: loops.slice(1)}};
  return JSON.stringify(to ? {...written, motion: {to}} : written);
}
