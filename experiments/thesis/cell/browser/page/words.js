// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and stops of a run in words.

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
  landed: "it lies on its place", raised: "the hand is back", through: "on its way",
};

/// A reason that begins with the name of a phase, in the page's words.
function inWords(reason) {
  const [phase] = Object.keys(PHASES).filter((name) => reason.startsWith(name));
  return phase ? `on the way ${PHASES[phase]}, ${reason.slice(phase.length).trim()}` : reason;
}

/// What is to be said of a stop.
class Sentences {
  constructor(cell, setting, lengthDigits) {
    this.cell = cell, this.setting = setting;
    this.face = (number) => `face ${number} (${cell.material_faces[number]})`;
    this.length = (x) => digits(Math.abs(x), lengthDigits + 1);
    this.wrongly = ({early, gap}) => "Wrong stop: " + (early === null ? "there is no contact on the way" : early > 0 ? `${digits(early, 3)}° early` : `${digits(-early, 3)}° late`) +
      `, ${digits(gap, lengthDigits + 1)} ${cell.unit} from the material`;
  }

  of(run, look, number) {
    if (!run || !run.stops.length) return "The arm is at home.";
    const move = number > 0 ? run.moves[look.move] : null;
    const joint = move && this.cell.robot.joints.findIndex(({name}) => name === move.joint);
    const before = move && run.stops[run.stops.findIndex((s, i) => i > 0 && s.move === look.move) - 1];
    const where = number === 0 ? "home" : !move ? "a move that did not come out"
      : move.rise ? `${PHASES[move.phase]}, straight ${move.rise < 0 ? "down" : "up"} ${this.length(look.sphere[2] - before.sphere[2])} of ${this.length(move.rise)} ${this.cell.unit}`
      : `${PHASES[move.phase]}, ${move.joint} ${signed(look.commanded[joint] - before.commanded[joint])}° of ${signed(move.degrees)}°`;
    const wrong = [...new Set(look.errors.flatMap(({methods}) => methods))];
    const errs = wrong.length ? ` Wrong here: ${wrong.join(", ")}.` : "";
    return `Stop ${number} of ${run.stops.length - 1}: ${where}. ${this.verdict(look)} ${holding(look)}${look.wrong ? ` ${this.wrongly(look.wrong)}.` : ""}${errs}`;
  }
  verdict(look) {
    if (!look.target) return "The sphere touches nothing.";
    const what = `${look.virtual ? "virtual " : ""}material ${look.target === "machine" ? "at the machine" : "in the storage"}`;
    if (look.touched !== null) return `${look.wrong ? `By ${this.setting.drive}, the` : "The"} sphere touches ${this.face(look.touched)} of the ${what}.`;
    return `The sphere touches nothing; nearest is ${this.face(look.nearest)} of the ${what}.`;
  }
}
function holding(look) {
  if (look.grips) return "The gripper takes the material.";
  if (look.puts) return "The gripper puts the material there.";
  return look.place === null ? "The gripper holds the material."
    : look.place === "machine" ? "The material is at the machine." : "The material is in the storage.";
}
