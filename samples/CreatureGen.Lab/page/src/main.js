import '@fontsource-variable/fredoka/wght.css';
import '@fontsource-variable/nunito/wght.css';
import './style.css';
import { first, growing, readAddress } from './design.js';
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

/** What is asked of the library before anything else: by the time that the stage is built, the creature has grown. */
function askAhead(library) {
  try {
    const wanted = readAddress(location.hash) ?? first;
    if (!wanted.packed) {
      library.ahead('Prepare', wanted.seed, wanted.kind, wanted.strangeness, wanted.individual);
      library.ahead(...growing(0, wanted));
      library.ahead('Mesh', 0);
      // The first frame takes a hundred times as long as others: it is there while the page takes the mesh.
      library.frame(0, 0, new ArrayBuffer(0)).catch(() => {});
    }
  } catch {
    // The stage tells what is wrong with the address.
  }
}

/** The library starts first: it takes longest. Then a picture is seen, then comes what draws. */
function begin() {
  const library = new Library();
  askAhead(library);
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
