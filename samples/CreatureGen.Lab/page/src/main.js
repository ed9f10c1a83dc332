import '@fontsource-variable/fredoka/wght.css';
import '@fontsource-variable/nunito/wght.css';
import './style.css';
import { Frame } from './frame.js';
import { showStills, unfit } from './fitness.js';

const problem = unfit();
if (problem) {
  showStills(problem).catch(() => {});
  window.creatureLab = { ready: Promise.reject(new Error(problem)) };
  window.creatureLab.ready.catch(() => {});
} else {
  const frame = new Frame();
  window.creatureLab = {
    ready: frame.start(),
    glb: (seed, kind) => frame.library.call('GlbOfSeed', String(seed), kind),
    frameCost: () => frame.herd.frameCost(),
    count: () => frame.herd.members.size,
    lab: frame,
  };
  // Kept for times without a network, after the first creature has come.
  const keep = () => navigator.serviceWorker?.register('./sw.js');
  window.creatureLab.keep = keep;
  if (!frame.still) {
    window.creatureLab.ready.then(keep).catch(() => {});
  }
}
