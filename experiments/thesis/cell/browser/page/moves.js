// SPDX-License-Identifier: GPL-3.0-or-later
// The list of moves, and the stretches of the phases.

const lastStopOf = (run, move) => run.stops.findLastIndex((s, k) => k > 0 && s.move === move);

/// Lists the moves; `unit` is of lengths; `go(stop)` is told which end of a move is asked for, `wrongly` puts a wrong stop in words.
function listMoves(run, unit, go, wrongly) {
  const rows = run.moves.map((move, i) => {
    const row = node("tr", "", {"data-move": i});
    const button = node("button", PHASES[move.phase], {type: "button", title: "Go to the end of this move"});
    const end = lastStopOf(run, i);
    button.addEventListener("click", () => go(end));
    const first = node("td", "");
    first.append(button);
    row.append(first, node("td", move.rise ? "straight" : move.joint), node("td", move.rise ? `${signed(move.rise)} ${unit}` : `${signed(move.degrees)}°`, {class: "number"}), move.wrong ? node("td", wrongly(move.wrong), {class: "verdict wrong"}) : node("td", UNTIL[move.until]),
               node("td", move.seconds === null ? "?" : digits(move.seconds, 2), {class: "number"}),
               node("td", move.rise ? "" : `${signed(move.exact, 6)}°`, {class: "number exactly"}));
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
/// Marks the move of a stop.
function showMove(run, move, number) {
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
