// SPDX-License-Identifier: GPL-3.0-or-later
// Which stop of the run is shown, and when the next one is.

const SPEEDS = [2, 5, 10, 25, 50, 100, 250];  // stops a second

class Player {
  /// `show(stop)` draws; `changed()` is told when it runs or pauses.
  constructor(show, changed) {
    this.show = show, this.changed = changed;
    this.moves = [], this.count = 0, this.stop = 0, this.speed = 3, this.running = false;
    this.calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  }

  load(stops) {
    this.pause();
    this.count = stops.length;
    this.ends = stops.map((stop, i) => (i + 1 === stops.length || stops[i + 1].move !== stop.move ? i : -1)).filter((i) => i >= 0);
    this.go(0);
  }
  go(stop) {
    this.stop = Math.max(0, Math.min(this.count - 1, stop));
    if (this.count) this.show(this.stop);
  }
  step(by) {
    this.pause();
    this.go(this.stop + by);
  }
  toggle() { this.running ? this.pause() : this.start(); }
  start() {
    if (this.count < 2) return;
    if (this.stop === this.count - 1) this.go(0);
    this.running = true;
    this.changed();
    if (this.calm.matches) return this.leap();
    let last = performance.now(), due = 0;
    const frame = (now) => {
      if (!this.running) return;
      due += (now - last) / 1000 * SPEEDS[this.speed];
      last = now;
      const whole = Math.floor(due);
      due -= whole;
      if (whole > 0) this.go(this.stop + whole);
      if (this.stop === this.count - 1) this.pause();
      else this.frame = requestAnimationFrame(frame);
    };
    this.frame = requestAnimationFrame(frame);
  }
  /// Without motion: the end of every move, one after the other.
  leap() {
    const next = this.ends.find((end) => end > this.stop);
    if (next === undefined) return this.pause();
    this.go(next);
    this.timer = setTimeout(() => this.running && this.leap(), 25000 / SPEEDS[this.speed]);
  }
  pause() {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
    const was = this.running;
    this.running = false;
    if (was) this.changed();
  }
}
