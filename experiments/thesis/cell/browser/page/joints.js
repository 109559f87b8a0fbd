// SPDX-License-Identifier: GPL-3.0-or-later
// The table of joints: their angles in their limits, and jogging.

class Joints {
  /// `pose(answer, commanded)` is told what the program says of a jogged arm.
  constructor(cell, answers, setting, pose) {
    this.cell = cell, this.answers = answers, this.setting = setting, this.pose = pose;
    this.jogged = null, this.posing = false, this.commanded = cell.robot.joints.map(({home}) => home);
    this.bars = cell.robot.joints.map((joint, i) => {
      const row = node("tr", ""), bar = node("div", "", {class: "bar", role: "img"}), mark = node("i", "");
      bar.append(mark);
      const cells = [node("th", joint.name, {scope: "row"}), node("td", "", {class: "number"}), node("td", "", {class: "number"}), node("td", "")];
      const jog = node("input", "", {type: "range", min: joint.lower, max: joint.upper, step: 0.5, "aria-label": `Jog ${joint.name}`});
      jog.addEventListener("input", () => this.jogTo(i, +jog.value));
      jog.disabled = !answers.live;
      cells[3].append(bar, jog);
      row.append(...cells);
      at("joints").tBodies[0].append(row);
      return {joint, cells, bar, mark, jog};
    });
  }

  forget() { this.jogged = null; }

  /// One question at a time; of those that come meanwhile, the last one next.
  async jogTo(joint, command) {
    this.jogged = (this.jogged || this.commanded).map((angle, i) => (i === joint ? command : angle));
    if (this.posing) return;
    this.posing = true;
    for (let asked = null; asked !== this.jogged && this.jogged;) {
      asked = this.jogged;
      try {
        this.pose(await this.answers.pose({setting: this.setting(), commanded: asked}), asked);
      } catch (refused) {
        if (!(refused instanceof Refused)) throw refused;
        at("status").textContent = `Jogged: ${refused.message}`;
      }
    }
    this.posing = false;
  }

  show(commanded) {
    this.commanded = commanded || this.cell.robot.joints.map(({home}) => home);
    this.bars.forEach(({joint, cells, bar, mark, jog}, i) => {
      const angle = commanded ? commanded[i] : joint.home;
      if (document.activeElement !== jog) jog.value = angle;
      cells[1].textContent = `${digits(angle, 2)}°`;
      cells[2].textContent = `${signed(+(angle - joint.home).toFixed(3))}°`;
      mark.style.left = `${100 * Math.max(0, Math.min(1, (angle - joint.lower) / (joint.upper - joint.lower)))}%`;
      bar.setAttribute("aria-label", `between ${digits(joint.lower, 1)}° and ${digits(joint.upper, 1)}°`);
      bar.title = bar.getAttribute("aria-label");
    });
  }
}
