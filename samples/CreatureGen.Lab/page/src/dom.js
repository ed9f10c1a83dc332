/** An element with properties and children. Text is only ever put in as text: names of creatures and files cannot bring markup. */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) {
      element.addEventListener(name.slice(2), value);
    } else if (name in element && name !== 'list' && name !== 'form') {
      element[name] = value;
    } else if (value !== null && value !== undefined) {
      element.setAttribute(name, value);
    }
  }
  element.append(...children.filter(child => child !== null && child !== undefined));
  return element;
}

const drawings = {
  dice: 'M5 3h14a2 2 0 0 1 2 2v14a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2zM8 8h.01M16 8h.01M12 12h.01M8 16h.01M16 16h.01',
  undo: 'M9 14 4 9l5-5M4 9h10a6 6 0 0 1 0 12h-3',
  redo: 'm15 14 5-5-5-5M20 9H10a6 6 0 0 0 0 12h3',
  lock: 'M6 11h12v9H6zM8.5 11V7.5a3.5 3.5 0 0 1 7 0V11',
  grid: 'M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z',
  sun: 'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8M12 2v2M12 20v2M2 12h2M20 12h2M5 5l1.4 1.4M17.6 17.6 19 19M19 5l-1.4 1.4M6.4 17.6 5 19',
  close: 'M6 6l12 12M18 6 6 18',
  heart: 'M12 20s-7-4.6-9-9a4.8 4.8 0 0 1 9-3.6A4.8 4.8 0 0 1 21 11c-2 4.400-9 9-9 9z',
  apple: 'M12 8c-2-2-7-1.500-7 4 0 4 3 8 5 8 1 0 1.300-.5 2-.5s1 .5 2 .5c2 0 5-4 5-8 0-5.500-5-6-7-4zM12 8c0-2 .8-4 3-5',
  push: 'M3 12h11M10 7l5 5-5 5M20 4v16',
  note: 'M9 18V5l10-2v13M9 18a3 3 0 1 1-6 0 3 3 0 0 1 6 0zM19 16a3 3 0 1 1-6 0 3 3 0 0 1 6 0z',
  jump: 'M3 20C6 8 15 6 18 15M18 15l2-5M18 15l-5-2',
  faint: 'M5 6h6l-6 7h6M14 12h5l-5 6h5',
  come: 'M12 3v13M6 11l6 6 6-6M5 21h14',
  loud: 'M4 10v4h3l5 4V6L7 10zM16 9a4 4 0 0 1 0 6M18.500 6.500a8 8 0 0 1 0 11',
  call: 'M4 13a8 5 0 0 1 16 0c-4 6-12 6-16 0zM8 13h8',
  egg: 'M12 3c3.600 0 6.500 5 6.500 9.500a6.500 6.500 0 0 1-13 0C5.500 8 8.400 3 12 3z',
};

/** A drawing of lines, for buttons. It says nothing to a screen reader. */
export function icon(name) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', drawings[name]);
  svg.append(path);
  return svg;
}

/** A labelled row of choices of which one is taken. */
export function choices(label, options, taken, onchoose) {
  const group = h('div', { className: 'choices', role: 'radiogroup', 'aria-label': label });
  const buttons = Object.entries(options).map(([value, text]) =>
    h('button', { type: 'button', role: 'radio', onclick: () => { take(value); onchoose(value); } , 'data-value': value }, text));
  const take = value => {
    for (const button of buttons) {
      const on = button.dataset.value === value;
      button.setAttribute('aria-checked', on);
      button.tabIndex = on ? 0 : -1;
    }
  };
  group.addEventListener('keydown', event => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (step) {
      event.preventDefault();
      const at = buttons.findIndex(button => button.tabIndex === 0);
      const next = buttons[(at + step + buttons.length) % buttons.length];
      next.click();
      next.focus();
    }
  });
  take(taken);
  group.append(...buttons);
  group.take = take;
  return group;
}
