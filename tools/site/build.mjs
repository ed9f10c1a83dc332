// Makes a static site of Markdown: node build.mjs FOLDER ROOT, where ROOT has README.md and docs/, and FOLDER may have docs/api/ already. Exits with 1 if a link leads nowhere.
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, posix, relative, resolve } from 'node:path';
import GithubSlugger from 'github-slugger';
import { Marked } from 'marked';

const [out, root] = [resolve(process.argv[2]), resolve(process.argv[3])];
const style = `:root{color-scheme:light dark}body{font:16px/1.6 system-ui,sans-serif;max-width:62rem;margin:0 auto;padding:0 1rem 4rem}nav{padding:.8rem 0;border-bottom:1px solid #8886;margin-bottom:1.5rem}
nav a{margin-right:1.2rem}a{color:#2a6fb0}img{max-width:100%;height:auto}table{border-collapse:collapse;display:block;overflow-x:auto}td,th{border:1px solid #8886;padding:.25rem .6rem;text-align:left;vertical-align:top}
pre{overflow-x:auto;padding:.8rem;background:#8881;border-radius:6px}code{font-family:ui-monospace,monospace;font-size:.92em}`;

function below(folder, extension) {
  return !existsSync(folder) ? [] : readdirSync(folder).flatMap(name => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? below(path, extension) : extension.some(end => name.endsWith(end)) ? [path] : [];
  });
}

// Pages by their path in the site, as Markdown.
const pages = new Map();
for (const path of [...readdirSync(root).filter(name => name.endsWith('.md')).map(name => join(root, name)), ...below(join(root, 'docs'), ['.md'])]) {
  pages.set(relative(root, path).replaceAll('\\', '/'), readFileSync(path, 'utf8'));
}
for (const path of below(join(out, 'docs/api'), ['.md'])) {
  pages.set(relative(out, path).replaceAll('\\', '/'), readFileSync(path, 'utf8'));
}
for (const path of below(join(root, 'docs'), ['.png', '.webp', '.svg'])) {
  const target = join(out, relative(root, path));
  mkdirSync(dirname(target), { recursive: true });
  cpSync(path, target);
}

const site = name => name === 'README.md' ? 'index.html' : name.replace(/\.md$/, '.html');
const anchors = new Map();
const links = [];
for (const [name, text] of pages) {
  const slugger = new GithubSlugger();
  const own = new Set();
  anchors.set(name, own);
  const marked = new Marked({
    renderer: {
      heading({ tokens, depth, text: words }) {
        const id = slugger.slug(words.replace(/[`*]|\\(?=<)/g, ''));
        own.add(id);
        return `<h${depth} id="${id}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      link({ href, tokens }) {
        const [path, hash] = href.split('#');
        const words = this.parser.parseInline(tokens);
        if (/^[a-z]+:/.test(href)) {
          return `<a href="${href}">${words}</a>`;
        }
        const target = path === '' ? name : posix.normalize(posix.join(posix.dirname(name), path));
        links.push({ from: name, target, hash });
        const shown = pages.has(target) ? posix.relative(posix.dirname(site(name)), site(target)) : path;
        return pages.has(target) ? `<a href="${shown}${hash ? '#' + hash : ''}">${words}</a>` : words;
      },
      image({ href, text: words }) {
        links.push({ from: name, target: posix.normalize(posix.join(posix.dirname(name), href)) });
        return `<img src="${href}" alt="${words}" loading="lazy">`;
      },
    },
  });
  const title = (text.match(/^# (.+)$/m)?.[1] ?? name).replace(/[`\\]/g, '');
  const up = posix.relative(posix.dirname(site(name)), '.') || '.';
  const nav = [['index.html', 'CreatureGen'], ['docs/start.html', 'Start'], ['docs/how-to.html', 'How to'], ['docs/index.html', 'All documents'], ['docs/api/index.html', 'API']]
    .map(([path, words]) => `<a href="${posix.join(up, path)}">${words}</a>`).join('');
  const target = join(out, site(name));
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${title}</title><style>${style}</style></head><body><nav>${nav}</nav>\n${marked.parse(text)}</body></html>\n`);
}

// A link leads to a page and its heading, to a picture, or to a file of the repository, which the site shows as its name.
const broken = links.filter(({ target, hash }) => pages.has(target) ? hash && !anchors.get(target).has(hash) : !existsSync(join(root, target)));
for (const { from, target, hash } of broken) {
  console.error(`${from}: ${target}${hash ? '#' + hash : ''} leads nowhere`);
}
console.log(`${pages.size} pages, ${links.length} links, ${broken.length} broken`);
process.exit(broken.length === 0 ? 0 : 1);
