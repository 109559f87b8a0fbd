// SPDX-License-Identifier: GPL-3.0-or-later
// The library: bindings.cpp, called with the contract's words. Used by the page and by the worker of the map.

const METHODS = ["fast", "thesis", "filtered", "exact"];
const SIDES = ["in_front", "behind", "intersects"], PLACES = ["inside", "boundary", "outside"];
const RELATIONS = ["separate", "touching", "overlapping"], KINDS = ["face", "edge", "vertex"], FIRSTS = ["start", "way", "none"];
const STAGES = ["double", "permanent", "double-double", "fixed-integer", "unlimited"];

class Engine {
  static async load(bytes) {
    const engine = new Engine();
    const cannot = (name) => () => { throw new Error(`the library called ${name}`); };
    const imports = {};
    for (const {module, name} of WebAssembly.Module.imports(await WebAssembly.compile(bytes)))
      (imports[module] ||= {})[name] = cannot(name);
    Object.assign(imports.env ||= {}, {
      setTempRet0() {},
      emscripten_notify_memory_growth() {},
      emscripten_memcpy_big: (to, from, count) => new Uint8Array(engine.wasm.memory.buffer).copyWithin(to, from, from + count),
      emscripten_resize_heap: (bytes) => engine.grow(bytes >>> 0),
    });
    engine.wasm = (await WebAssembly.instantiate(bytes, imports)).instance.exports;
    engine.wasm._initialize();
    return engine;
  }

  grow(bytes) {
    try {
      this.wasm.memory.grow(Math.ceil((bytes - this.wasm.memory.buffer.byteLength) / 65536));
      return 1;
    } catch {
      return 0;
    }
  }

  /// The buffer, with room for so many numbers. A call may move the memory, so that the view is made anew after it.
  put(values, room = values.length) {
    this.at = this.wasm.room(Math.max(room, values.length));
    this.room = Math.max(room, values.length);
    this.numbers().set(values);
  }
  numbers() {
    return new Float64Array(this.wasm.memory.buffer, this.at, this.room);
  }
  refusal() {
    const bytes = new Uint8Array(this.wasm.memory.buffer, this.wasm.refusal());
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  /// Takes the loops, outer loop first. Returns why they are refused, `code: reason`, or "".
  takePolygon(loops) {
    this.put([...loops.map((loop) => loop.length), ...loops.flat(2)]);
    this.edges = loops.flat().length;
    return this.wasm.take_polygon(loops.length) ? "" : this.refusal();
  }

  /// Takes a case. Returns why it is refused, the first reason in the contract's order, or "".
  take({loops, ball, to}) {
    const finite = [...loops.flat(2), ...ball.center, ball.radius, ...(to || [])].every(Number.isFinite);
    return finite ? this.checkBall(ball, to) || this.takePolygon(loops) : "not-finite: a number is beyond the finite doubles";
  }

  /// Returns why the ball, and where it moves to, is refused, or "".
  checkBall({center, radius}, to) {
    this.put([...center, radius, ...(to || [])]);
    return this.wasm.check_ball(to ? 1 : 0) ? "" : this.refusal();
  }

  /// Returns the method's answer; what it does not compute is undefined.
  answer(method, {center, radius}) {
    this.put([...center, radius], 18 + this.edges);
    this.wasm.answer(METHODS.indexOf(method));
    const n = Array.from(this.numbers());
    const has = n[3] >= 0, index = n[6];
    return {
      plane: SIDES[n[0]], plane_tangent: has ? n[1] === 1 : undefined, foot: PLACES[n[2]], edges_hit: n.slice(18, 18 + n[17]),
      relation: RELATIONS[n[3]], contact: n[4] === 1,
      nearest: has ? feature(n[5], index) : undefined, point: has ? n.slice(7, 10) : undefined,
      distance: has ? n[10] : undefined, contact_normal: has ? n.slice(11, 14) : undefined, depth: has ? n[14] : undefined,
      off_plane: has ? n[15] : undefined, stage: STAGES[n[16]],
    };
  }

  /// Returns the first contact on the way of the ball to `to`, as a case expects it.
  firstContact({center, radius}, to, exact = false) {
    this.put([...center, radius, ...to], 16);
    this.wasm.first_contact(exact ? 1 : 0);
    const n = Array.from(this.numbers()), first = FIRSTS[n[0]];
    if (first === "none")
      return {contact: false, first, time: null, momentary: null, feature: null, point: null, contact_normal: null, depth: null};
    return {
      contact: true, first, time: n[1], momentary: first === "way" ? n[2] === 1 : null, feature: feature(n[3], n[4]),
      point: n.slice(5, 8), contact_normal: n.slice(8, 11), depth: n[11],
    };
  }

  /// Returns a colour for each centre: the certified answer (0 yes or inside, 1 boundary, 2 no or outside), 4 if fast
  /// differs from it, 8 if the thesis does.
  paint(question, radius, centers) {
    this.put([radius, ...centers]);
    const at = this.wasm.paint(centers.length / 3, question === "foot" ? 1 : 0);
    return new Uint8Array(this.wasm.memory.buffer, at, centers.length / 3).slice();
  }
}

function feature(kind, index) {
  return KINDS[kind] === "face" ? {kind: "face"} : {kind: KINDS[kind], index};
}
