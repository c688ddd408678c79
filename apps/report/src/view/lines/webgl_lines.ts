// SPDX-License-Identifier: MIT
// Draws strips by WebGL 2: each node is two vertices, moved apart in the vertex shader to half of
// the line's width, mitred where two intervals meet; edges are smoothed by the fragment shader.
// Where paths cover the screen several times, lines of one pixel show the same in a third of the
// time (of a browser that draws in software).

import type { Camera, Vector } from '../common/camera.ts';
import type { Rgb, Theme } from '../common/theme.ts';
import { kBegins, kMostNodes, type Strips } from '../levels/strips.ts';
import * as line from './renderer.ts';
import { stripProgram, thinProgram, type Program, type Uniforms } from './webgl_programs.ts';

const kStride = 20; // Bytes of a vertex: three floats, the length along the strip, the look.
const kAlong = 12, kLook = 16; // Where they begin.
// Lines of one pixel leave no gaps where paths at their full width cover the rectangle that they
// lie in this often, times the pixels of the device per CSS pixel.
const kDenseCoverage = 2.3;
const kAll = 0, kInner = 1, kAtOnce = 2; // Values of `pass`.
const kRestart = 0xffffffff;

/** Indices of one way to draw a slot. */
interface Elements {
  array: WebGLVertexArrayObject;
  indices: WebGLBuffer;
  count: number;
}

/** Buffers of one slot. */
interface Slot {
  vertices: WebGLBuffer;
  strips: Elements;
  thin: Elements;
  nodes: number;
}

/** What a vertex shader reads: location, numbers, the type of them, and the byte they begin at. */
type Attribute = [location: number, size: number, isFloat: boolean, offset: number];

function createElements(gl: WebGL2RenderingContext, vertices: WebGLBuffer, stride: number,
  attributes: Attribute[]): Elements {
  const elements = { array: gl.createVertexArray(), indices: gl.createBuffer(), count: 0 };
  gl.bindVertexArray(elements.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements.indices);
  for (const [location, size, isFloat, offset] of attributes) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, !isFloat, stride,
      offset);
  }
  gl.bindVertexArray(null);
  return elements;
}

function createSlot(gl: WebGL2RenderingContext): Slot {
  const vertices = gl.createBuffer();
  // The node before is two vertices back, the one after two vertices on.
  const before = 0, here = 2 * kStride, after = 4 * kStride;
  return {
    vertices,
    strips: createElements(gl, vertices, kStride, [
      [0, 3, true, before], [1, 3, true, here], [2, 3, true, after], [3, 4, false, here + kLook],
      [4, 4, false, after + kLook], [5, 1, true, here + kAlong],
    ]),
    thin: createElements(gl, vertices, 2 * kStride,
      [[0, 3, true, here], [1, 4, false, here + kLook]]),
    nodes: 0,
  };
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

/** Returns indices with `each` vertices per node, one strip after another with a restart between. */
function packIndices(strips: Strips, each: 1 | 2): Uint32Array<ArrayBuffer> {
  const indices = new Uint32Array((each + 1) * strips.count);
  let n = 0;
  for (let i = 0; i < strips.count; i++) {
    if (i > 0 && (strips.look[4 * i + 3]! & kBegins) !== 0) indices[n++] = kRestart;
    for (let k = 0; k < each; k++) indices[n++] = each * i + k;
  }
  return indices.slice(0, n);
}

/** Draws strips by WebGL 2. */
export class WebGlLines implements line.LineRenderer {
  readonly canvas: HTMLCanvasElement;
  private readonly gl: WebGL2RenderingContext;
  private readonly smooth: Program;
  private readonly thin: Program;
  private readonly slots: [Slot, Slot];
  private ratio = 1;

  private constructor(canvas: HTMLCanvasElement, gl: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.gl = gl;
    this.smooth = stripProgram(gl);
    this.thin = thinProgram(gl);
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
    gl.bindBuffer(gl.ARRAY_BUFFER, slot.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, packVertices(strips), gl.DYNAMIC_DRAW);
    this.setIndices(slot.strips, packIndices(strips, 2));
    this.setIndices(slot.thin, packIndices(strips, 1));
    slot.nodes = strips.count;
  }

  draw(camera: Camera, theme: Theme, scene: line.Scene): number {
    const gl = this.gl;
    const [r, g, b] = theme.background;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(r / 255, g / 255, b / 255, 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    let vertices = 0;
    if (scene.isCoarse || (scene.coverage > kDenseCoverage * this.ratio && !this.isFew())) {
      vertices += this.drawThin(camera, theme, scene.radius);
      this.use(this.smooth, camera, theme, scene.radius);
    } else {
      this.use(this.smooth, camera, theme, scene.radius);
      gl.enable(gl.BLEND);
      vertices += camera.mode === '3d' ? this.drawInSpace() : this.drawSmooth(0);
    }
    gl.enable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    return vertices + this.drawSmooth(1);
  }

  destroy(): void {
    this.gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /** Whether the paths can be drawn twice within the budget of vertices. */
  private isFew(): boolean {
    return 2 * this.slots[0].nodes + this.slots[1].nodes <= kMostNodes;
  }

  private setIndices(elements: Elements, indices: Uint32Array<ArrayBuffer>): void {
    const gl = this.gl;
    gl.bindVertexArray(elements.array);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
    gl.bindVertexArray(null);
    elements.count = indices.length;
  }

  /** Draws the paths by lines of one pixel. */
  private drawThin(camera: Camera, theme: Theme, radius: number): number {
    const gl = this.gl;
    this.use(this.thin, camera, theme, radius);
    gl.disable(gl.BLEND);
    if (camera.mode === '3d') gl.enable(gl.DEPTH_TEST);
    else gl.disable(gl.DEPTH_TEST);
    this.drawElements(this.slots[0].thin, gl.LINE_STRIP);
    return this.slots[0].nodes;
  }

  /**
   * Draws with depth: first what hides, then all with its smoothed edges; at once where both
   * together would be too many vertices.
   */
  private drawInSpace(): number {
    const gl = this.gl, u = this.smooth.uniforms;
    gl.enable(gl.DEPTH_TEST);
    gl.uniform1i(u.pass, this.isFew() ? kInner : kAtOnce);
    let vertices = this.drawSmooth(0);
    gl.depthMask(false);
    gl.uniform1i(u.pass, kAll);
    if (this.isFew()) vertices += this.drawSmooth(0);
    return vertices;
  }

  /** Draws the strips of one slot with smoothed edges. */
  private drawSmooth(index: line.Slot): number {
    const gl = this.gl, u = this.smooth.uniforms;
    const half = (index === 0 ? line.kLineWidth : line.kHighlightWidth) / 2 * this.ratio;
    const core = index === 0 ? 0 : line.kHighlightCore / 2 * this.ratio;
    gl.uniform1f(u.halfWidth, half + 0.5);
    gl.uniform3f(u.halfWidths, half, line.kRapidWidth / 2 * this.ratio, core);
    this.drawElements(this.slots[index].strips, gl.TRIANGLE_STRIP);
    return 2 * this.slots[index].nodes;
  }

  private drawElements({ array, count }: Elements, mode: number): void {
    if (count === 0) return;
    this.gl.bindVertexArray(array);
    this.gl.drawElements(mode, count, this.gl.UNSIGNED_INT, 0);
    this.gl.bindVertexArray(null);
  }

  private use({ program, uniforms }: Program, camera: Camera, theme: Theme, radius: number): void {
    this.gl.useProgram(program);
    this.setCamera(uniforms, camera, radius);
    this.setColours(uniforms, theme);
    this.gl.uniform1i(uniforms.pass, kAll);
  }

  private setCamera(u: Uniforms, camera: Camera, radius: number): void {
    const gl = this.gl;
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

  private setColours(u: Uniforms, theme: Theme): void {
    const gl = this.gl;
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
