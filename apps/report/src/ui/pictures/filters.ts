// SPDX-License-Identifier: MIT
// Which parts of the path are shown, and which are shown pale.
import {upperBound} from '../../data/bisection.ts';
import type {RunModel} from '../../data/run_model.ts';
import {dimmed} from '../common/palette.ts';
import type {Session} from '../common/session.ts';
import {spread, type DrawnPath} from './path_layers.ts';

/** Returns which intervals the chosen run, tool and lines leave, or null for all. */
export function visibleNodes(
    session: Session, run: RunModel, index: number, path: DrawnPath): Uint8Array|null {
  const {row} = path.layer;
  if (!session.shown[index]) return new Uint8Array(row.length);
  const ofTool = session.tool === null ?
      null :
      spread(path, Uint8Array.from(run.column('tool'), (tool) => Number(tool === session.tool)), 1);
  if (!session.isPart) return ofTool;
  const visible = new Uint8Array(row.length);
  for (const {from, to} of session.stays[index]!) {
    const first = Math.max(upperBound(row, from), 1);
    for (let i = first; i < row.length && row[i - 1]! < to; ++i) visible[i] = ofTool?.[i] ?? 1;
  }
  return visible;
}

/**
 * Makes pale in `rgb` what the charts do not show, and what another limit binds; returns it. Lines
 * that are shown alone are at other times in another run.
 */
export function dim(session: Session, run: RunModel, rgb: Uint8Array): Uint8Array {
  const zoom = session.isPart && run !== session.run ? null : session.zoom;
  if (session.limit === null && !zoom) return rgb;
  const pale = dimmed(session.dark);
  const limit = session.limit === null ? -1 : run.data.limits.indexOf(session.limit);
  const rowOf = (row: number) => session.rowOf(run, session.xOf(session.run, row));
  const from = zoom ? rowOf(zoom.from) : -Infinity;
  const to = zoom ? rowOf(zoom.to) : Infinity;
  const rows = run.rows;
  const limits = run.column('limit');
  for (let i = 1; i < run.size; ++i) {
    const kept =
        (session.limit === null || limits[i] === limit) && rows[i]! > from && rows[i - 1]! < to;
    if (!kept) rgb.set(pale, 3 * i);
  }
  return rgb;
}
