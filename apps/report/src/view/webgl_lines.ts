// SPDX-License-Identifier: MIT
// Draws strips by WebGL 2: each node is two vertices, moved apart in the vertex shader to half of
// the line's width, mitred where two intervals meet; edges are smoothed by the fragment shader.

import type { Camera, Vector } from './camera.ts';
import * as line from './renderer.ts';
import { kBegins, kMostNodes, type Strips } from './strips.ts';
import type { Rgb, Theme } from './theme.ts';

const kVertexShader = `#version 300 es
precision highp float;
layout(location = 0) in vec3 before;
layout(location = 1) in vec3 here;
layout(location = 2) in vec3 after;
layout(location = 3) in vec4 look;
layout(location = 4) in vec4 lookAfter;
layout(location = 5) in float along;
uniform vec3 right, up, towards, target;
uniform vec2 halfScreen;  // device px
uniform float scale;      // device px per mm
uniform float depth;      // 1 per mm
uniform float halfWidth;  // device px, with the smoothed edge
uniform float dash;       // dashes per mm
flat out vec4 colour;
out float across;
out float dashes;
vec2 place(vec3 p) { return vec2(dot(right, p - target), dot(up, p - target)) * scale; }
vec2 direction(vec2 d) { float n = length(d); return n > 1e-4 ? d / n : vec2(0.0); }
void main() {
  vec2 p = place(here);
  vec2 incoming = direction(p - place(before));
  vec2 outgoing = direction(place(after) - p);
  bool begins = (int(look.a * 255.0 + 0.5) & 1) != 0;
  bool ends = (int(lookAfter.a * 255.0 + 0.5) & 1) != 0;
  if (begins) incoming = outgoing;
  if (ends) outgoing = incoming;
  if (incoming == vec2(0.0)) incoming = outgoing;
  if (outgoing == vec2(0.0)) outgoing = incoming;
  if (incoming == vec2(0.0)) incoming = outgoing = vec2(1.0, 0.0);
  vec2 sum = incoming + outgoing;
  float n = length(sum);
  vec2 mean = n > 0.3 ? sum / n : incoming;
  float mitre = n > 0.3 ? min(2.0 / n, 2.0) : 1.0;
  float side = (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
  vec2 q = p + vec2(-mean.y, mean.x) * (side * mitre * halfWidth);
  colour = look;
  across = side * halfWidth;
  dashes = along * dash;
  // Of moves in one place the later one is seen.
  float order = float(gl_VertexID) * 2e-8;
  gl_Position = vec4(q / halfScreen, -dot(towards, here - target) * depth - order, 1.0);
}`;

const kFragmentShader = `#version 300 es
precision highp float;
flat in vec4 colour;
in float across;
in float dashes;
uniform vec3 rapid, core, casing;
uniform vec3 halfWidths;  // device px: cutting moves, rapids; core of highlighted stretches or 0
uniform float rapidAlpha, dashDrawn;
uniform int pass;  // 0: all; 1: inner parts only; 2: all at once, with depth
out vec4 result;
void main() {
  float d = abs(across);
  gl_FragDepth = gl_FragCoord.z;
  if (halfWidths.z > 0.0) {
    float inner = clamp(halfWidths.z + 0.5 - d, 0.0, 1.0);
    float outer = clamp(halfWidths.x + 0.5 - d, 0.0, 1.0);
    result = vec4(mix(casing, core, inner) * outer, outer);
    return;
  }
  bool isRapid = (int(colour.a * 255.0 + 0.5) & 2) != 0;
  if (isRapid && fract(dashes) > dashDrawn) discard;
  float alpha = clamp((isRapid ? halfWidths.y : halfWidths.x) + 0.5 - d, 0.0, 1.0);
  if (isRapid) alpha *= rapidAlpha;
  if (alpha < 0.08) discard;
  // Smoothed edges must not hide what lies farther away. Where both are drawn at once, they are
  // moved to the far end.
  if (pass == 1 && alpha < 0.95 && !isRapid) discard;
  if (pass == 2 && !isRapid) {
    if (alpha < 0.6) gl_FragDepth = 1.0;
    else alpha = 1.0;
  }
  result = vec4((isRapid ? rapid : colour.rgb) * alpha, alpha);
}`;

const kUniforms = ['right', 'up', 'towards', 'target', 'halfScreen', 'scale', 'depth', 'halfWidth',
  'dash', 'rapid', 'core', 'casing', 'halfWidths', 'rapidAlpha', 'dashDrawn',
  'pass'] as const;
type Uniforms = Record<(typeof kUniforms)[number], WebGLUniformLocation | null>;

const kStride = 20; // Bytes of a vertex: three floats, the length along the strip, the look.
const kAll = 0, kInner = 1, kAtOnce = 2; // Values of `pass`.
const kRestart = 0xffffffff;

/** Buffers of one slot. */
interface Slot {
  array: WebGLVertexArrayObject;
  vertices: WebGLBuffer;
  indices: WebGLBuffer;
  indexCount: number;
  nodes: number;
}

function compile(gl: WebGL2RenderingContext, kind: number, source: string): WebGLShader {
  const shader = gl.createShader(kind);
  if (shader === null) throw new Error('WebGL has no shader left');
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
    throw new Error(`a shader does not compile: ${gl.getShaderInfoLog(shader) ?? ''}`);
  }
  return shader;
}

function link(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  gl.attachShader(program, compile(gl, gl.VERTEX_SHADER, kVertexShader));
  gl.attachShader(program, compile(gl, gl.FRAGMENT_SHADER, kFragmentShader));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(`the shaders do not link: ${gl.getProgramInfoLog(program) ?? ''}`);
  }
  return program;
}

function createSlot(gl: WebGL2RenderingContext): Slot {
  const slot = {
    array: gl.createVertexArray(), vertices: gl.createBuffer(), indices: gl.createBuffer(),
    indexCount: 0, nodes: 0,
  };
  gl.bindVertexArray(slot.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, slot.vertices);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, slot.indices);
  // The node before is two vertices back, the one after two vertices on.
  const floats: Array<[number, number, number]> = [[0, 3, 0], [1, 3, 2], [2, 3, 4]];
  for (const [location, size, vertex] of floats) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, kStride, vertex * kStride);
  }
  gl.enableVertexAttribArray(3);
  gl.vertexAttribPointer(3, 4, gl.UNSIGNED_BYTE, true, kStride, 2 * kStride + 16);
  gl.enableVertexAttribArray(4);
  gl.vertexAttribPointer(4, 4, gl.UNSIGNED_BYTE, true, kStride, 4 * kStride + 16);
  gl.enableVertexAttribArray(5);
  gl.vertexAttribPointer(5, 1, gl.FLOAT, false, kStride, 2 * kStride + 12);
  gl.bindVertexArray(null);
  return slot;
}

/** Returns the vertices of strips: each node twice, with an empty node before and after all. */
function packVertices(strips: Strips): ArrayBuffer {
  const n = strips.count;
  const bytes = new ArrayBuffer((n + 2) * 2 * kStride);
  const floats = new Float32Array(bytes), words = new Uint8Array(bytes);
  const p = strips.position, look = strips.look;
  for (let i = 0; i < n; i++) {
    for (let side = 0; side < 2; side++) {
      const at = 2 * (i + 1) + side;
      floats[5 * at] = p[3 * i]!;
      floats[5 * at + 1] = p[3 * i + 1]!;
      floats[5 * at + 2] = p[3 * i + 2]!;
      floats[5 * at + 3] = strips.along[i]!;
      for (let k = 0; k < 4; k++) words[kStride * at + 16 + k] = look[4 * i + k]!;
    }
  }
  for (let side = 0; side < 2; side++) words[kStride * (2 * (n + 1) + side) + 19] = kBegins;
  return bytes;
}

/** Returns the indices of triangle strips, one strip after another with a restart between. */
function packIndices(strips: Strips): Uint32Array<ArrayBuffer> {
  const indices = new Uint32Array(3 * strips.count);
  let n = 0;
  for (let i = 0; i < strips.count; i++) {
    if (i > 0 && (strips.look[4 * i + 3]! & kBegins) !== 0) indices[n++] = kRestart;
    indices[n++] = 2 * i;
    indices[n++] = 2 * i + 1;
  }
  return indices.slice(0, n);
}

/** Draws strips by WebGL 2. */
export class WebGlLines implements line.LineRenderer {
  readonly canvas: HTMLCanvasElement;
  private readonly gl: WebGL2RenderingContext;
  private readonly uniforms: Uniforms;
  private readonly program: WebGLProgram;
  private readonly slots: [Slot, Slot];
  private ratio = 1;

  private constructor(canvas: HTMLCanvasElement, gl: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.gl = gl;
    this.program = link(gl);
    const uniforms: Partial<Uniforms> = {};
    for (const name of kUniforms) uniforms[name] = gl.getUniformLocation(this.program, name);
    this.uniforms = uniforms as Uniforms;
    this.slots = [createSlot(gl), createSlot(gl)];
  }

  /** Returns a renderer on this canvas, or null where the browser has no WebGL 2. */
  static create(canvas: HTMLCanvasElement): WebGlLines | null {
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: true });
    if (gl === null) return null;
    try {
      return new WebGlLines(canvas, gl);
    } catch (error) {
      console.warn(error);
      return null;
    }
  }

  resize(width: number, height: number, ratio: number): void {
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
  }

  setStrips(index: line.Slot, strips: Strips): void {
    const gl = this.gl, slot = this.slots[index];
    const indices = packIndices(strips);
    gl.bindVertexArray(slot.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, slot.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, packVertices(strips), gl.DYNAMIC_DRAW);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
    gl.bindVertexArray(null);
    slot.indexCount = indices.length;
    slot.nodes = strips.count;
  }

  draw(camera: Camera, theme: Theme, radius: number): number {
    const gl = this.gl;
    const [r, g, b] = theme.background;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(r / 255, g / 255, b / 255, 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.program);
    this.setCamera(camera, radius);
    this.setColours(theme);
    gl.uniform1i(this.uniforms.pass, kAll);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const vertices = camera.mode === '3d' ? this.drawInSpace() :
      this.drawSlot(0, line.kLineWidth, 0);
    gl.disable(gl.DEPTH_TEST);
    return vertices + this.drawSlot(1, line.kHighlightWidth, line.kHighlightCore);
  }

  destroy(): void {
    this.gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /**
   * Draws with depth: first what hides, then all with its smoothed edges; at once where both
   * together would be too many vertices.
   */
  private drawInSpace(): number {
    const gl = this.gl;
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    const isFew = 2 * this.slots[0].nodes + this.slots[1].nodes <= kMostNodes;
    gl.uniform1i(this.uniforms.pass, isFew ? kInner : kAtOnce);
    let vertices = this.drawSlot(0, line.kLineWidth, 0);
    gl.depthMask(false);
    gl.uniform1i(this.uniforms.pass, kAll);
    if (isFew) vertices += this.drawSlot(0, line.kLineWidth, 0);
    return vertices;
  }

  /** Draws the strips of one slot; returns how many vertices they have. */
  private drawSlot(index: line.Slot, width: number, core: number): number {
    const gl = this.gl, slot = this.slots[index], u = this.uniforms;
    if (slot.indexCount === 0) return 0;
    const half = width / 2 * this.ratio;
    gl.uniform1f(u.halfWidth, half + 0.5);
    gl.uniform3f(u.halfWidths, half, line.kRapidWidth / 2 * this.ratio, core / 2 * this.ratio);
    gl.bindVertexArray(slot.array);
    gl.drawElements(gl.TRIANGLE_STRIP, slot.indexCount, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
    return 2 * slot.nodes;
  }

  private setCamera(camera: Camera, radius: number): void {
    const gl = this.gl, u = this.uniforms;
    const { right, up, towards } = camera.basis();
    const vector = (at: WebGLUniformLocation | null, v: Vector): void => {
      gl.uniform3f(at, v[0], v[1], v[2]);
    };
    vector(u.right, right);
    vector(u.up, up);
    vector(u.towards, towards);
    vector(u.target, camera.target);
    gl.uniform2f(u.halfScreen, camera.width / 2 * this.ratio, camera.height / 2 * this.ratio);
    gl.uniform1f(u.scale, camera.scale * this.ratio);
    const away = Math.hypot(...camera.target);
    gl.uniform1f(u.depth, camera.mode === '3d' ? 1 / (1.02 * (radius + away) + 1e-6) : 0);
    gl.uniform1f(u.dash, camera.scale / line.kDash);
  }

  private setColours(theme: Theme): void {
    const gl = this.gl, u = this.uniforms;
    const colour = (at: WebGLUniformLocation | null, c: Rgb): void => {
      gl.uniform3f(at, c[0] / 255, c[1] / 255, c[2] / 255);
    };
    colour(u.rapid, theme.rapid);
    colour(u.core, theme.highlight);
    colour(u.casing, theme.casing);
    gl.uniform1f(u.rapidAlpha, line.kRapidAlpha);
    gl.uniform1f(u.dashDrawn, line.kDashDrawn);
  }
}
