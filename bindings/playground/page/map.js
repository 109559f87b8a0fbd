// SPDX-License-Identifier: GPL-3.0-or-later
// The failure map: where in the window each method differs from the certified answer, as the worker paints it.

class FailureMap {
  /// Calls `changed` whenever more is painted.
  constructor(wasm, changed) {
    const source = document.getElementById("worker").textContent;
    this.worker = new Worker(URL.createObjectURL(new Blob([source], {type: "text/javascript"})));
    this.worker.postMessage({wasm});
    this.worker.onmessage = ({data}) => this.take(data);
    Object.assign(this, {changed, number: 0, canvas: document.createElement("canvas"), done: false, counts: null});
  }

  /// Paints the window anew for a ball of this radius, that far from the plane.
  order({loops, radius, lift, question, view}) {
    const {width, height} = view;
    Object.assign(this, {number: this.number + 1, done: false, counts: {pixels: 0, fast: 0, thesis: 0}});
    this.canvas.width = width, this.canvas.height = height;
    const a = Float64Array.from({length: width}, (_, x) => view.at(x + 0.5, 0)[0]);
    const b = Float64Array.from({length: height}, (_, y) => view.at(0, y + 0.5)[1]);
    this.worker.postMessage({number: this.number, loops, radius, lift, question, a, b});
  }
  stop() {
    ++this.number;
    this.canvas.width = 0;
    this.done = true;
  }

  take({number, step, row, colours, last}) {
    if (number !== this.number) return;
    const pencil = this.canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
    const shades = this.shades ||= new Map();
    const shade = (colour) => {
      const name = colour & 12 ? ["--fast", "--thesis", "--both"][(colour >> 2) - 1] : ["--in", "--on", "--out"][colour];
      if (!shades.has(name)) shades.set(name, style.getPropertyValue(name));
      return shades.get(name);
    };
    for (let i = 0; i < colours.length;) {
      let end = i + 1;
      while (end < colours.length && colours[end] === colours[i]) ++end;
      pencil.fillStyle = shade(colours[i]);
      pencil.fillRect(i * step, row * step, (end - i) * step, step);
      i = end;
    }
    if (step === 2)
      for (const colour of colours) {
        ++this.counts.pixels;
        if (colour & 4) ++this.counts.fast;
        if (colour & 8) ++this.counts.thesis;
      }
    this.done = last;
    this.changed();
  }
  forgetShades() {
    this.shades = null;
  }
}
