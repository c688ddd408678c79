// SPDX-License-Identifier: MIT
// Which parts of the path are shown, and which are shown pale.
import type {RunModel} from '../../data/run_model.ts';
import {dimmed} from '../common/palette.ts';
import type {Session} from '../common/session.ts';

/** Returns which intervals the chosen run and tool leave, or null for all. */
export function visibleNodes(session: Session, run: RunModel, index: number): Uint8Array|null {
  if (!session.shown[index]) return new Uint8Array(run.size);
  if (session.tool === null) return null;
  return Uint8Array.from(run.column('tool'), (tool) => Number(tool === session.tool));
}

/** Makes pale in `rgb` what the charts do not show, and what another limit binds; returns it. */
export function dim(session: Session, run: RunModel, rgb: Uint8Array): Uint8Array {
  const {zoom} = session;
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
