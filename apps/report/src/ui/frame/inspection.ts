// SPDX-License-Identifier: MIT
// What browser tests may ask of the page, as `window.softcncReport`.
import type {LineRange, RowRange} from '../../data/run_model.ts';
import type {FrameFigures} from '../../view/levels/path_types.ts';
import type {QuantityId} from '../common/quantities.ts';
import {quantitiesOf} from '../common/quantities.ts';
import type {ChartAxis, Session, TabId} from '../common/session.ts';
import type {PathPanel} from '../pictures/path_panel.ts';

export interface Inspection {
  /** Milliseconds from the start of loading to the first picture. */
  readyMs: number;
  /** Of each run: name, time, and sizes as they were decoded. */
  runs(): Array<{
    program: string; status: string; time_s: number; nodes: number; lines: number;
    diagnostics: number
  }>;
  /** The chosen line, or null. */
  selected(): {file: number; line: number}|null;
  /** The stretches that are lit, in seconds from the start. */
  ranges(): Array<{from_s: number; to_s: number}>;
  /** Chooses a line, as a click on it does. */
  pick(line: number, file?: number): void;
  /** The lines that are shown alone, or null. */
  lines(): LineRange|null;
  /** Shows lines alone, as Shift and a click do. */
  pickLines(first: number, last: number, file?: number): void;
  /** Chooses the line that is executed at a time, as a click on the path does. */
  pickAt(seconds: number): void;
  /** The position in mm at a time, from the run that is looked at. */
  positionAt(seconds: number): {x: number; y: number; z: number};
  /** What the charts show, in seconds; null: all. */
  zoom(): {from_s: number; to_s: number}|null;
  quantities(): QuantityId[];
  colourBy(quantity: QuantityId): void;
  show(tab: TabId): void;
  chartsOver(axis: ChartAxis): void;
  frames(): FrameFigures|null;
}

declare global {
  interface Window {
    softcncReport?: Inspection;
  }
}

export function inspect(session: Session, path: PathPanel): void {
  const seconds = ({from, to}: RowRange) =>
      ({from_s: session.run.secondsAt(from), to_s: session.run.secondsAt(to)});
  const inspection: Inspection = {
    readyMs: 0,
    runs: () => session.runs.map((run) => ({
                                   program: run.data.program,
                                   status: run.data.status,
                                   time_s: run.data.time_s,
                                   nodes: run.size,
                                   lines: run.lineCount(0),
                                   diagnostics: run.data.diagnostics.length
                                 })),
    selected: () =>
        session.selection && {file: session.selection.file, line: session.selection.line},
    ranges: () => (session.selection?.ranges ?? []).map(seconds),
    pick: (line, file = 0) => session.select({file, line}),
    lines: () => session.lines,
    pickLines: (first, last, file = 0) => session.setLines({file, first, last}),
    pickAt: (at) => session.selectAt(session.run.rowAtSeconds(at)),
    positionAt: (at) => {
      const row = session.run.rowAtSeconds(at);
      return {
        x: session.run.valueAt('x', row),
        y: session.run.valueAt('y', row),
        z: session.run.valueAt('z', row)
      };
    },
    zoom: () => session.zoom && seconds(session.zoom),
    quantities: () => quantitiesOf(session.runs).map(({id}) => id),
    colourBy: (quantity) => session.setQuantity(quantity),
    show: (tab) => session.show(tab),
    chartsOver: (axis) => session.setAxis(axis),
    frames: () => path.view?.frames() ?? null,
  };
  window.softcncReport = inspection;
  requestAnimationFrame(
      () => requestAnimationFrame(() => (inspection.readyMs = performance.now())));
}
