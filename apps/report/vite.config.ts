// SPDX-License-Identifier: MIT
// Builds the page as one file: scripts and styles inside, nothing fetched.
import {createHash} from 'node:crypto';
import {defineConfig, type Plugin} from 'vite';

/** The page is written under this name; `softcnc report` embeds it. */
const PAGE = 'report.html';

/** Text that may stand within a script element: an end tag in a string is escaped. */
function asScript(code: string): string {
  return code.trim().replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '\\x3C!--');
}

/** What the sources allow and the built page replaces by the hash of its one script. */
const INLINE = `script-src 'unsafe-inline'`;

/** A source of the Content Security Policy that allows this script alone. */
function hashOf(script: string): string {
  return `'sha256-${createHash('sha256').update(script).digest('base64')}'`;
}

/**
 * Moves every script and style that Vite has made into the page, at the end of its body and head.
 */
function singleFile(): Plugin {
  return {
    name: 'softcnc-single-file',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('the build has no index.html');
      let html = String(page.source)
                     .replace(/<script [^>]*src="[^"]*"[^>]*><\/script>\s*/g, '')
                     .replace(/<link rel="stylesheet"[^>]*>\s*/g, '');
      for (const [name, item] of Object.entries(bundle)) {
        if (item === page) continue;
        // Replacements are functions, since a text may hold `$&`.
        if (item.type === 'chunk') {
          const script = asScript(item.code);
          html = html.replace('</body>', () => `<script type="module">${script}</script>\n</body>`)
                     .replace(INLINE, () => `script-src ${hashOf(script)}`);
        } else if (name.endsWith('.css'))
          html = html.replace(
              '</head>', () => `<style>${String(item.source).trim()}</style>\n</head>`);
        else
          throw new Error(`the page cannot hold ${name}`);
        delete bundle[name];
      }
      page.fileName = PAGE;
      page.source = html;
    },
  };
}

export default defineConfig({
  plugins: [singleFile()],
  build: {
    target: 'es2022',
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    reportCompressedSize: false,
    rollupOptions: {output: {inlineDynamicImports: true}},
  },
});
