import '@fontsource-variable/fredoka/wght.css';
import '@fontsource-variable/nunito/wght.css';
import './style.css';
import { unfit, showStills } from './fitness.js';
import { Library } from './library.js';
import { showStill } from './still.js';

const problem = unfit();
if (problem) {
  showStills(problem).catch(() => {});
  window.creatureLab = { ready: Promise.reject(new Error(problem)) };
  window.creatureLab.ready.catch(() => {});
} else {
  begin();
}

/** The library starts first: it takes longest. Then a picture is seen, then comes what draws. */
function begin() {
  const library = new Library();
  showStill();
  const page = import('./frame.js').then(({ Frame }) => {
    const frame = new Frame(library);
    window.creatureLab.lab = frame;
    return frame;
  });

  // Kept for times without a network, after the first creature has come.
  const keep = () => navigator.serviceWorker?.register('./sw.js');
  window.creatureLab = {
    ready: page.then(frame => frame.start()),
    glb: (seed, kind) => library.call('GlbOfSeed', String(seed), kind),
    frameCost: () => window.creatureLab.lab?.herd.frameCost() ?? 0,
    count: () => window.creatureLab.lab?.herd.members.size ?? 0,
    keep,
    lab: null,
  };
  window.creatureLab.ready.then(() => window.creatureLab.lab.theatre.still || keep()).catch(() => {});
  page.catch(showStills);
}
