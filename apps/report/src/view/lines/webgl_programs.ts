// SPDX-License-Identifier: MIT
// The shaders of the view of a path.

const kStripVertexShader = `#version 300 es
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

const kStripFragmentShader = `#version 300 es
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

// Lines of one pixel of the device: one vertex for each node.
const kThinVertexShader = `#version 300 es
precision highp float;
layout(location = 0) in vec3 here;
layout(location = 1) in vec4 look;
uniform vec3 right, up, towards, target, rapid;
uniform vec2 halfScreen;
uniform float scale, depth;
flat out vec4 colour;
void main() {
  vec3 p = here - target;
  bool isRapid = (int(look.a * 255.0 + 0.5) & 2) != 0;
  colour = vec4(isRapid ? rapid : look.rgb, 1.0);
  float order = float(gl_VertexID) * 4e-8;
  gl_Position = vec4(vec2(dot(right, p), dot(up, p)) * scale / halfScreen,
                     -dot(towards, p) * depth - order, 1.0);
}`;

const kThinFragmentShader = `#version 300 es
precision mediump float;
flat in vec4 colour;
out vec4 result;
void main() { result = colour; }`;

const kUniforms = ['right', 'up', 'towards', 'target', 'halfScreen', 'scale', 'depth', 'halfWidth',
  'dash', 'rapid', 'core', 'casing', 'halfWidths', 'rapidAlpha', 'dashDrawn',
  'pass'] as const;
export type Uniforms = Record<(typeof kUniforms)[number], WebGLUniformLocation | null>;

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

/** A linked program and the places of its uniforms. */
export interface Program {
  program: WebGLProgram;
  uniforms: Uniforms;
}

function link(gl: WebGL2RenderingContext, vertexShader: string, fragmentShader: string): Program {
  const program = gl.createProgram();
  gl.attachShader(program, compile(gl, gl.VERTEX_SHADER, vertexShader));
  gl.attachShader(program, compile(gl, gl.FRAGMENT_SHADER, fragmentShader));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(`the shaders do not link: ${gl.getProgramInfoLog(program) ?? ''}`);
  }
  const uniforms: Partial<Uniforms> = {};
  for (const name of kUniforms) uniforms[name] = gl.getUniformLocation(program, name);
  return { program, uniforms: uniforms as Uniforms };
}

/** Returns the program of strips, which are as wide as their lines and smoothed. */
export function stripProgram(gl: WebGL2RenderingContext): Program {
  return link(gl, kStripVertexShader, kStripFragmentShader);
}

/** Returns the program of lines of one pixel. */
export function thinProgram(gl: WebGL2RenderingContext): Program {
  return link(gl, kThinVertexShader, kThinFragmentShader);
}
