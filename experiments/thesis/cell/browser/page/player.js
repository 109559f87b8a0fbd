// SPDX-License-Identifier: GPL-3.0-or-later
// Which stop of the run is shown, and when the next one is: a run is played in its own time.

const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10];  // of its own time
const STOPS = 25;                             // a second, where that is unknown

class Player {
  /// `show(stop)` draws a stop, `between(stop, share)` the way to the next one; `changed()` is told when it runs or pauses.
  constructor(show, between, changed) {
    this.show = show, this.between = between, this.changed = changed;
    this.count = 0, this.stop = 0, this.speed = 3, this.running = false;
    this.calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  }

  load({stops, times, waits}) {
    this.pause();
    this.count = stops.length, this.timed = times.length > 0;
    this.arrives = this.timed ? times : stops.map((_, i) => i / STOPS);
    this.leaves = this.timed ? times.map((time, i) => time + waits[i]) : this.arrives;
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
    let last = performance.now(), clock = this.arrives[this.stop];
    const frame = (now) => {
      if (!this.running) return;
      clock += Math.max(0, now - last) / 1000 * RATES[this.speed];
      last = now;
      const {arrives, leaves} = this, next = arrives.findIndex((time) => time > clock);
      const stop = next < 0 ? this.count - 1 : next - 1;
      if (stop > this.stop) this.go(stop);
      if (next < 0 && clock >= leaves[stop]) return this.pause();
      if (next > 0) this.between(stop, Math.max(0, (clock - leaves[stop]) / (arrives[next] - leaves[stop])));
      this.frame = requestAnimationFrame(frame);
    };
    this.frame = requestAnimationFrame(frame);
  }
  /// Without motion: the end of every move, one after the other.
  leap() {
    const next = this.ends.find((end) => end > this.stop);
    if (next === undefined) return this.pause();
    this.go(next);
    this.timer = setTimeout(() => this.running && this.leap(), 1000 / RATES[this.speed]);
  }
  pause() {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
    const was = this.running;
    this.running = false;
    if (!was) return;
    this.go(this.stop);
    this.changed();
  }
}
