// SPDX-License-Identifier: MIT
// Takes the data of a report out of its page: JSON, and base64 of a gzip of bytes.
import type { ReportData } from './format.ts';

/** What a page holds. */
export interface Embedded {
  report: ReportData;
  blob: Uint8Array;
}

/** Returns the bytes that a base64 text stands for. White space in it is skipped. */
export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Returns what was compressed with gzip. Rejects where `bytes` are damaged. */
export async function gunzip(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}

/**
 * Returns the data of a page, or null for a page that has none (as it is built). Rejects where they
 * are damaged or of another schema.
 */
export async function embeddedData(page: Document): Promise<Embedded | null> {
  const json = page.getElementById('softcnc-report')?.textContent;
  if (!json) return null;
  const report = JSON.parse(json) as ReportData;
  if (report.schema !== 1)
    throw new Error(`the data have schema ${report.schema}, this page reads schema 1`);
  const data = page.getElementById('softcnc-data');
  const text = data?.textContent?.trim() ?? '';
  data?.remove(); // megabytes of text that nothing needs any more
  return { report, blob: text ? await gunzip(bytesOfBase64(text)) : new Uint8Array(0) };
}
