// SPDX-License-Identifier: MIT
// Light or dark: as the system has it, until a reader chooses.
import type {Session} from '../common/session.ts';

/** Makes the page follow the session, and the session the system. */
export function followTheme(session: Session): void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const apply = () => (document.documentElement.dataset['theme'] = session.dark ? 'dark' : 'light');
  session.dark = system.matches;
  apply();
  session.on(['theme'], apply);
  system.addEventListener('change', () => session.setDark(system.matches));
}
