// Every text of the page, in one place.

export const texts = {
  title: 'Creature lab',
  stage: 'The creature in its surroundings. Arrow keys turn the view, plus and minus zoom.',
  seed: 'Seed',
  kind: 'Kind',
  kinds: { walking: 'Walks', flying: 'Flies', swimming: 'Swims' },
  hatch: 'Hatch',
  dice: 'A creature nobody has seen',
  today: 'Creature of the day',
  grid: 'Many at once',
  tabs: { make: 'Make', meet: 'Meet', breed: 'Breed', keep: 'Keep' },
  traits: { size: 'Size', girth: 'Girth', neck: 'Neck', head: 'Head', snout: 'Snout', eyes: 'Eyes', legs: 'Legs', stoutness: 'Stoutness', tail: 'Tail', wings: 'Wings, fins', ornaments: 'Ornaments', pattern: 'Pattern', colour: 'Colour', strangeness: 'Strangeness' },
  lock: name => `Keep ${name.toLowerCase()} as it is`,
  undo: 'Undo',
  redo: 'Redo',
  random: 'Surprise me',
  nudge: 'Nudge',
  reset: 'As it was born',
  looks: { skin: 'Skin', wire: 'Wire', bones: 'Bones', capsules: 'Capsules' },
  look: 'Show',
  counts: facts => `${number(facts.triangles)} triangles, ${number(facts.vertices)} vertices, ${facts.joints} joints`,
  repaired: 'Changed so that it can stand:',
  facts: {
    plan: 'Build', body: 'Cousin of', mass: 'Weight', length: 'Length', pace: 'Walking pace', flight: 'Cruise', legs: 'Pairs of legs', generation: 'Generation',
  },
  neighbours: 'Neighbours',
  call: name => `Call ${name}`,
  come: 'Come here',
  push: 'Push',
  wander: 'Wander',
  stay: 'Stay',
  sound: 'Sound of footsteps',
  hint: 'Double-click the ground to send it there. Click a neighbour to call it. Drag to look around.',
  cost: (ms, count) => `${count} alive · the library takes ${ms.toFixed(1)} ms of a frame`,
  partner: 'The other parent',
  partnerSeed: 'a seed',
  mutation: 'Surprise',
  litter: 'Have a litter of nine',
  brooding: n => `Hatching ${n} of 9`,
  pick: name => `Raise ${name}`,
  picked: name => `${name} has grown up.`,
  litterHint: 'Nine children of these two, just born. Pick one: it grows up, and can be a parent in its turn.',
  family: 'Family',
  name: 'Name',
  save: 'Keep in my collection',
  saved: name => `${name} is in your collection.`,
  share: 'Copy its address',
  shared: 'The address is on your clipboard.',
  addressIs: 'Its address is in the address bar.',
  photo: 'Picture',
  glb: 'GLB',
  whole: 'GLB, textured and animated',
  json: 'Blueprint',
  open: 'Open a file…',
  download: 'Take it home',
  pictureHint: 'The picture holds the whole creature: drop it on this page, or give it to “creaturegen build”.',
  collection: 'My collection',
  empty: 'Nobody yet.',
  remove: name => `Let ${name} go`,
  exportAll: 'Export all',
  working: 'Working…',
  waking: 'Waking up…',
  filters: { all: 'All', small: 'Small', medium: 'Middling', large: 'Large', anyBuild: 'Any build', size: 'Size', plan: 'Build', strange: 'Strangeness' },
  close: 'Close',
  dropHere: 'Drop a picture, a GLB or a blueprint to meet its creature',
  noWebGl: 'This browser cannot draw: WebGL 2 is missing or switched off.',
  noWasm: 'This browser cannot run the library: WebAssembly is missing or switched off.',
  stopped: reason => `The library could not be started: ${reason}`,
  badSeed: text => `“${text.slice(0, 30)}” is no seed; a seed is a whole number from 0 to 18446744073709551615.`,
  tooLarge: (name, size) => `${name.slice(0, 60)} has ${Math.ceil(size / 1e6)} MB; at most 32 MB are read.`,
  badFile: (name, reason) => `${name.slice(0, 60)} holds no creature that can be read: ${reason}`,
  badAddress: reason => `This address cannot be read: ${reason}`,
};

export function number(value) {
  return value.toLocaleString('en-GB');
}

/** Words of the library's names: `manyLegged` becomes “many legged”. */
export const words = name => name.replace(/([A-Z])/g, ' $1').toLowerCase();

export function weight(kg) {
  return kg < 0.1 ? `${(kg * 1000).toPrecision(2)} g` : kg < 10 ? `${kg.toPrecision(2)} kg` : `${number(Number(kg.toPrecision(3)))} kg`;
}

export function length(metres) {
  return metres < 1 ? `${Number((metres * 100).toPrecision(2))} cm` : `${metres.toFixed(2)} m`;
}

export const plural = (count, one, many) => (count === 1 ? `1 ${one}` : `${count} ${many}`);
