import { h } from '../dom.js';
import { texts } from '../texts.js';

const width = 84;
const height = 104;

/** A family as a tree: a row for each generation, lines from parents to children, a picture of each; a button to go back to anybody. */
export function treeOf(family, back) {
  const places = new Map();
  const rows = family.generations;
  rows.forEach((row, y) => row?.forEach((member, x) => places.set(member, { x: x * width + width / 2, y: y * height })));
  const space = 'http://www.w3.org/2000/svg';
  const lines = document.createElementNS(space, 'svg');
  const across = width * Math.max(...rows.map(row => row?.length ?? 0));
  lines.setAttribute('width', across);
  lines.setAttribute('height', height * rows.length);
  lines.setAttribute('aria-hidden', 'true');
  for (const member of family.members) {
    const to = places.get(member);
    for (const parent of member.parents) {
      const from = places.get(parent);
      const path = document.createElementNS(space, 'path');
      path.setAttribute('d', `M${from.x} ${from.y + 84}C${from.x} ${from.y + 104} ${to.x} ${to.y - 16} ${to.x} ${to.y + 8}`);
      lines.append(path);
    }
  }
  const people = family.members.map(member => {
    const { x, y } = places.get(member);
    const button = h('button', { type: 'button', className: 'relative', 'aria-label': texts.backTo(member.name), 'aria-current': member === family.now ? 'true' : 'false', onclick: () => back(member) },
      member.thumb ? h('img', { src: member.thumb, alt: '', width: 60, height: 60 }) : h('i', {}), h('span', {}, member.name));
    button.style.left = `${x - width / 2}px`;
    button.style.top = `${y}px`;
    return button;
  });
  const tree = h('div', { className: 'tree' }, lines, ...people);
  tree.style.width = `${across}px`;
  tree.style.height = `${height * rows.length}px`;
  return h('div', { className: 'forest', tabIndex: 0, role: 'group', 'aria-label': texts.family }, tree);
}
