// SPDX-License-Identifier: GPL-3.0-or-later
// The perspective view: flat triangles, outlines, a shadow on the floor; WebGL 1. It draws what it is told.

const FACES = `
  attribute vec3 at; attribute vec3 facing;
  uniform mat4 pose, view, shadow; uniform vec3 eye;
  varying vec3 normal; varying vec3 place;
  void main() {
    vec4 there = shadow * (pose * vec4(at, 1.0));
    normal = mat3(pose[0].xyz, pose[1].xyz, pose[2].xyz) * facing;
    place = there.xyz / there.w;
    gl_Position = view * there;
  }`;
const FACE_COLOUR = `
  precision mediump float;
  varying vec3 normal; varying vec3 place;
  uniform vec3 eye, sun; uniform vec4 colour; uniform float lit;
  void main() {
    vec3 n = normalize(normal);
    if (dot(n, eye - place) < 0.0) n = -n;
    float light = 0.55 + 0.40 * max(0.0, dot(n, sun)) + 0.15 * max(0.0, dot(n, normalize(eye - place)));
    gl_FragColor = vec4(colour.rgb * mix(1.0, light, lit), colour.a);
  }`;
const LINES = `
  attribute vec3 at; attribute float along;
  uniform mat4 pose, view; uniform vec3 eye; uniform float lift; varying float way;
  void main() {
    vec4 there = pose * vec4(at, 1.0);
    gl_Position = view * vec4(mix(there.xyz, eye, lift), 1.0);  // before the faces that meet there
    way = along;
  }`;
const LINE_COLOUR = `
  precision mediump float;
  varying float way; uniform vec4 colour; uniform float dash;
  void main() {
    if (dash > 0.0 && fract(way / dash) > 0.55) discard;
    gl_FragColor = colour;
  }`;

class Scene {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl", {antialias: true, stencil: true, alpha: false, preserveDrawingBuffer: true});
    if (!gl) throw new Error("no WebGL");
    this.gl = gl;
    this.faces = this.program(FACES, FACE_COLOUR, ["pose", "view", "shadow", "eye", "sun", "colour", "lit"]);
    this.lines = this.program(LINES, LINE_COLOUR, ["pose", "view", "eye", "lift", "colour", "dash"]);
    this.target = [0, 0, 0], this.size = 1, this.split = true, this.closeness = 0.16;
    this.follows = false;  // whether the sphere stays in the middle, in the whole, too
    this.behind = 0;  // degrees: where one sees the stations from, across the robot
    this.look("front");
  }

  program(vertex, fragment, uniforms) {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, "at");
    gl.linkProgram(program);
    const result = {program, second: gl.getAttribLocation(program, vertex === FACES ? "facing" : "along")};
    for (const name of uniforms) result[name] = gl.getUniformLocation(program, name);
    return result;
  }

  buffer(numbers) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    return buffer;
  }

  /// A part of the model, in buffers; what is not drawn any more is given to `forget`.
  mesh(part) {
    const at = [], facing = [], lines = [], along = [];
    const point = (i) => part.points.slice(3 * i, 3 * i + 3);
    for (let i = 0; i < part.triangles.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => point(part.triangles[i + k]));
      const normal = unit(cross(minus(b, a), minus(c, a)));
      for (const corner of [a, b, c]) at.push(...corner), facing.push(...normal);
    }
    for (let i = 0; i < part.outline.length; i += 2) {
      const a = point(part.outline[i]), b = point(part.outline[i + 1]);
      lines.push(...a, ...b);
      along.push(0, Math.hypot(...minus(b, a)));
    }
    return {at: this.buffer(at), facing: this.buffer(facing), corners: at.length / 3, ends: part.face_ends,
            lines: this.buffer(lines), along: this.buffer(along), line_ends: lines.length / 3};
  }
  forget(mesh) {
    for (const key of ["at", "facing", "lines", "along"]) this.gl.deleteBuffer(mesh[key]);
  }

  /// A ball of radius 1, and a ring round it.
  ball() {
    const points = [], triangles = [], sides = 24, rings = 12;
    for (let ring = 0; ring <= rings; ++ring)
      for (let side = 0; side < sides; ++side) {
        const up = Math.PI * ring / rings, around = 2 * Math.PI * side / sides;
        points.push(Math.sin(up) * Math.cos(around), Math.sin(up) * Math.sin(around), Math.cos(up));
      }
    for (let ring = 0; ring < rings; ++ring)
      for (let side = 0; side < sides; ++side) {
        const a = ring * sides + side, b = ring * sides + (side + 1) % sides;
        triangles.push(a, a + sides, b, b, a + sides, b + sides);
      }
    return this.mesh({points, triangles, face_ends: [triangles.length / 3], outline: []});
  }
  /// Circles of radius 1 about the axes.
  rings() {
    const points = [], outline = [], sides = 32;
    for (let axis = 0; axis < 3; ++axis)
      for (let side = 0; side < sides; ++side) {
        const around = 2 * Math.PI * side / sides, point = [Math.cos(around), Math.sin(around), 0];
        points.push(...[0, 1, 2].map((k) => point[(k + axis) % 3]));
        outline.push(axis * sides + side, axis * sides + (side + 1) % sides);
      }
    return this.mesh({points, triangles: [], face_ends: [], outline});
  }
  /// Squares of the floor.
  floor(size, step) {
    const points = [], outline = [];
    const count = Math.ceil(size / step);
    for (let i = -count; i <= count; ++i) {
      points.push(i * step, -count * step, 0, i * step, count * step, 0, -count * step, i * step, 0, count * step, i * step, 0);
      const n = points.length / 3;
      outline.push(n - 4, n - 3, n - 2, n - 1);
    }
    return this.mesh({points, triangles: [], face_ends: [], outline});
  }

  /// A line through points.
  path(points) {
    const outline = points.slice(1).flatMap((_, i) => [i, i + 1]);
    return this.mesh({points: points.flat(), triangles: [], face_ends: [], outline});
  }

  frame(target, size) {
    this.target = target, this.size = size;
    this.look("front");
  }
  look(from) {
    [this.azimuth, this.elevation] = {front: [this.behind - 45, 24], side: [this.behind - 90, 5], top: [-90, 89.9]}[from];
    this.distance = 1, this.near = false;
  }
  /// From where one looks now, but at the sphere.
  lookNear() {
    this.near = true, this.split = false, this.closeness = 0.16;
  }
  /// The whole, and the sphere beside or below it.
  lookSplit() {
    this.near = false, this.split = true, this.closeness = 0.16;
  }
  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.max(-10, Math.min(89.9, this.elevation + elevation));
  }
  /// `close`: in the close view.
  approach(factor, close = this.near) {
    const distance = close ? "closeness" : "distance";
    this[distance] = Math.max(0.05, Math.min(3, this[distance] * factor));
  }

  /// things: [{mesh, pose, colour, shadow, highlight: [face, colour], lines: colour, dash, hollow, flat, through}]; what goes
  /// through is to be seen behind others, paler if it is not hollow, and so are highlights.
  draw(things, colours, sphere) {
    const gl = this.gl, canvas = this.canvas, ratio = Math.min(2, window.devicePixelRatio || 1);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
    gl.clearColor(...colours.view, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);

    gl.enable(gl.SCISSOR_TEST);
    for (const [near, ...box] of this.views(width, height)) {
      gl.viewport(...box);
      gl.scissor(...box);
      this.drawView(near, box[2], box[3], things, sphere);
    }
    gl.disable(gl.SCISSOR_TEST);
  }

  /// Whether each view is the close one, and its place in the picture, from below left.
  views(width, height) {
    if (!this.split) return [[this.near, 0, 0, width, height]];
    if (width > 1.15 * height) {
      const close = Math.round(0.36 * width);
      return [[false, 0, 0, width - close - 4, height], [true, width - close, 0, close, height]];
    }
    const close = Math.round(0.42 * height);
    return [[false, 0, close + 4, width, height - close - 4], [true, 0, 0, width, close]];
  }

  drawView(near, width, height, things, sphere) {
    const gl = this.gl;
    const aspect = width / Math.max(1, height), angle = 32;
    const distance = near ? this.closeness : this.distance;
    const reach = this.size / Math.sin(angle / 2 * Math.PI / 180) / Math.min(1, aspect) * distance * 0.76;
    const a = this.azimuth * Math.PI / 180, e = this.elevation * Math.PI / 180;
    const target = near || this.follows ? sphere : this.target;
    const eye = add(target, times(reach, [Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e)]));
    const view = product(perspective(angle, aspect, Math.max(reach - 2.5 * this.size, reach / 30), reach + 3 * this.size),
                         lookingAt(eye, target, [0, 0, 1]));
    const whole = matrixOf(IDENTITY);

    const fill = (thing, colour, lit, first, count) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, thing.mesh.at);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, thing.mesh.facing);
      gl.enableVertexAttribArray(this.faces.second);
      gl.vertexAttribPointer(this.faces.second, 3, gl.FLOAT, false, 0, 0);
      gl.uniformMatrix4fv(this.faces.pose, false, matrixOf(thing.pose));
      gl.uniform4f(this.faces.colour, ...colour);
      gl.uniform1f(this.faces.lit, lit);
      gl.drawArrays(gl.TRIANGLES, first, count);
    };
    gl.useProgram(this.faces.program);
    gl.uniformMatrix4fv(this.faces.view, false, view);
    gl.uniformMatrix4fv(this.faces.shadow, false, whole);
    gl.uniform3f(this.faces.eye, ...eye);
    const from = (this.behind - 35) * Math.PI / 180, light = unit([Math.cos(from), Math.sin(from), 1.6]);
    gl.uniform3f(this.faces.sun, ...light);
    gl.depthFunc(gl.LEQUAL);
    for (const thing of things) {
      if (thing.hollow) continue;
      fill(thing, [...thing.colour, 1], 1, 0, thing.mesh.corners);
    }
    // Touched faces over themselves.
    const highlight = (thing, alpha, lit) => {
      const [face, colour] = thing.highlight, ends = thing.mesh.ends, begin = face > 0 ? ends[face - 1] : 0;
      fill(thing, [...colour, alpha], lit, 3 * begin, 3 * (ends[face] - begin));
    };
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const thing of things) if (thing.highlight) highlight(thing, thing.hollow ? 0.75 : 1, 0.5);
    gl.depthFunc(gl.GREATER);
    gl.depthMask(false);
    for (const thing of things) {
      if (thing.highlight) highlight(thing, 0.55, 0);
      if (thing.through && !thing.hollow) fill(thing, [...thing.colour, 0.45], 0, 0, thing.mesh.corners);
    }
    gl.depthMask(true);
    gl.depthFunc(gl.LEQUAL);
    // Each point of the floor is darkened once.
    if (this.elevation > 0) {
      const flat = [1, 0, 0, 0, 0, 1, 0, 0, -light[0] / light[2], -light[1] / light[2], 0, 0, 0, 0, 0.0005 * this.size, 1];
      gl.uniformMatrix4fv(this.faces.shadow, false, flat);
      gl.enable(gl.STENCIL_TEST);
      gl.stencilFunc(gl.EQUAL, 0, 255);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
      gl.depthMask(false);
      for (const thing of things) if (thing.shadow) fill(thing, [0, 0, 0, 0.16], 0, 0, thing.mesh.corners);
      gl.depthMask(true);
      gl.disable(gl.STENCIL_TEST);
    }
    gl.disable(gl.BLEND);

    gl.useProgram(this.lines.program);
    gl.uniformMatrix4fv(this.lines.view, false, view);
    gl.uniform3f(this.lines.eye, ...eye);
    for (const thing of things) {
      if (!thing.lines) continue;
      gl.depthFunc(thing.hollow && thing.through ? gl.ALWAYS : gl.LEQUAL);
      gl.bindBuffer(gl.ARRAY_BUFFER, thing.mesh.lines);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, thing.mesh.along);
      gl.enableVertexAttribArray(this.lines.second);
      gl.vertexAttribPointer(this.lines.second, 1, gl.FLOAT, false, 0, 0);
      gl.uniformMatrix4fv(this.lines.pose, false, matrixOf(thing.pose));
      gl.uniform4f(this.lines.colour, ...thing.lines, 1);
      gl.uniform1f(this.lines.dash, thing.dash || 0);
      gl.uniform1f(this.lines.lift, thing.flat ? 0 : 0.002);
      gl.drawArrays(gl.LINES, 0, thing.mesh.line_ends);
    }
  }
}
