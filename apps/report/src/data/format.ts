// SPDX-License-Identifier: MIT
// The data of a report as `softcnc report` writes them (schema 1): JSON, and a blob of bytes.

/** A part of the blob. */
export interface Slice {
  offset: number;
  bytes: number;
}

/** Integers in the blob: zigzag LEB128 of values or of their differences, times `scale`. */
export interface Column extends Slice {
  count: number;
  scale: number;
  order: 0|1|2;
}

export type Axis = 'x'|'y'|'z';
export type Severity = 'error'|'warning'|'note';

export interface AxisLimit {
  axis: Axis;
  velocity_mm_s: number;
  acceleration_mm_s2: number;
  jerk_mm_s3: number;
  min_mm?: number|null;
  max_mm?: number|null;
}

export interface ToolTime {
  tool: number;
  cutting_s: number;
  rapid_s: number;
  dwell_s: number;
  rest_s: number;
}

export interface Figure {
  name: string;
  value: number;
  unit: string;
}

export interface WorstLine {
  file: number;
  line: number;
  lost_s: number;
  seconds: number;
  limit: string;
  sentence: string;
}

export interface Diagnostic {
  file: number;
  line: number;
  column: number;
  length?: number;  // characters from `column` on
  severity: Severity;
  code: string;
  message: string;
  help?: string;
}

/** Names of the columns of nodes; those that a run does not know are missing. */
export type NodeColumn =
    |'row'|'x'|'y'|'z'|'s'|'v'|'feed'|'motion'|'limit'|'tool'|'acceleration_use'|'jerk_use'|
    'chord_error_um'|'contour_um'|'deviation_um'|'rmax_um'|'rmax_target_um';

export interface SurfaceData {
  step_mm: number;
  columns: number;
  rows: number;
  origin_mm: [number, number, number];
  heights: Column;
  heights_step: number;
  region_mm: number;
  region_columns: number;
  region_rows: number;
  rmax_um: Column;
  target_um: Column;
  regions_judged: number;
  regions_missed: number;
  rmax_max_um: number;
  rmax_mean_um: number;
}

/** The origin of a work system, in machine coordinates. */
export interface OriginData {
  name: string;  // G54
  at_mm: [number, number, number];
}

/** What a program states of its workpiece. */
export interface WorkpieceData {
  name: string;
  file?: number;       // and the line that states it; 0: the program itself
  line: number;
  edges_mm: number[];  // x1 y1 z1 x2 y2 z2 of each edge, in machine coordinates
}

export interface RunData {
  program: string;
  source: 'program'|'trace'|'recording';
  machine: string;
  machine_file?: string;
  method?: string;
  status: 'done'|'stopped'|'alarm'|'error';
  time_s: number;
  length_mm: number;
  setpoints: number;
  period_s: number;
  blocks: number;
  axes: Axis[];
  axis_limits: AxisLimit[];
  origins?: OriginData[];
  workpieces?: WorkpieceData[];
  limits: string[];
  time_by_limit_s: Array<{limit: string; seconds: number}>;
  tools: ToolTime[];
  rests?: {count: number; seconds: number};  // at corners; not known of rows alone
  figures: Figure[];
  worst_lines: WorstLine[];
  files: Array<{name: string; text?: Slice}>;
  diagnostics: Diagnostic[];
  error_um: number;
  error_mm_s: number;
  nodes: Partial<Record<NodeColumn, Column>>;
  spans: {row: Column; line: Column; file: Column};
  lines: {file: Column; line: Column; ms: Column; lost_ms: Column};
  surface?: SurfaceData;
}

export interface Comparison {
  time_s: [number, number];
  names: [string, string];
  by_limit: Array<{limit: string; a_s: number; b_s: number}>;
  by_line: Array<{file: string; line: number; a_s: number; b_s: number}>;
  distance_um: number;
  distance_error_um: number;                // a smaller one may be none
  distance_at: {t_s: number; run: number};  // in which run: 0 or 1
  contour_um?: [number|null, number|null];  // the largest contour error of each run
  machine?: Array<{key: string; a: string; b: string}>;  // values that differ
}

export interface WhatIf {
  time_s: number;
  rows: Array<{
    axis: Axis; limit: 'velocity' | 'acceleration' | 'jerk'; factor: number; time_s: number;
    won_s: number;
  }>;
}

export interface ReportData {
  schema: number;
  softcnc: string;
  runs: RunData[];
  comparison?: Comparison;
  what_if?: WhatIf;
}
