import { h } from '../dom.js';
import { texts } from '../texts.js';

/** Panels of which one is shown, by their names; arrow keys go from tab to tab. Fills `root` and answers what shows one. */
export function fillTabs(root, panels, onshow) {
  const tabs = h('div', { className: 'tabs', role: 'tablist', 'aria-label': texts.title });
  const pages = Object.entries(panels).map(([name, panel]) => h('section', { id: `panel-${name}`, role: 'tabpanel', 'aria-labelledby': `tab-${name}`, tabIndex: 0 }, panel.root));
  const show = name => {
    for (const tab of tabs.children) {
      const on = tab.id === `tab-${name}`;
      tab.setAttribute('aria-selected', on);
      tab.tabIndex = on ? 0 : -1;
    }
    for (const page of pages) {
      page.hidden = page.id !== `panel-${name}`;
    }
    onshow(name);
  };
  tabs.append(...Object.keys(panels).map(name => h('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onclick: () => show(name) }, texts.tabs[name])));
  tabs.addEventListener('keydown', event => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step) {
      const all = [...tabs.children];
      const next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
      next.click();
      next.focus();
    }
  });
  root.append(tabs, ...pages);
  return show;
}
