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
  traits: { size: 'Size', girth: 'Girth', neck: 'Neck', head: 'Head', snout: 'Snout', eyes: 'Eyes', legs: 'Legs', arms: 'Arms', stoutness: 'Stoutness', tail: 'Tail', wings: 'Wings, fins', ornaments: 'Ornaments', pattern: 'Pattern', colour: 'Colour', strangeness: 'Strangeness' },
  lock: name => `Keep ${name.toLowerCase()} as it is`,
  undo: 'Undo',
  redo: 'Redo',
  random: 'Surprise me',
  nudge: 'Nudge',
  reset: 'As it was born',
  looks: { skin: 'Skin', flat: 'Facets', wire: 'Wire', bones: 'Bones', capsules: 'Capsules', feet: 'Feet' },
  gaits: 'Gait: a row for each foot, filled while it stands',
  dragHint: 'Pull on its body, head, tail, legs, arms or wings, or on a slider.',
  pulled: (name, value) => `${name} ${value.toFixed(2)} ×`,
  palette: 'Parts',
  parts: { horns: 'Horns', antlers: 'Antlers', ears: 'Ears', feelers: 'Feelers', tusks: 'Tusks', jaws: 'Jaws', spikes: 'Spikes', plates: 'Plates', tuft: 'Tuft', mane: 'Mane', frill: 'Frill', shell: 'Shell', wings: 'Wings', insectWings: 'Insect wings', fins: 'Fins', tailEnd: 'Tail end', club: 'Club', lure: 'Lure', eyes: 'Other eyes', coat: 'Other coat' },
  takePart: name => `Take ${name.toLowerCase()} off`,
  refused: name => `${name} did not stay on:`,
  play: 'Play',
  deeds: { pet: 'Pet it', feed: 'Feed it', push: 'Push it', dance: 'Let it dance', jump: 'Let it jump', call: 'Let it call', faint: 'Let it drop' },
  told: {
    petted: 'It likes that.', fed: 'It has smelled the fruit.', jumps: 'Hop!', cannotJump: 'It does not jump.', faints: 'It drops, and gets up in a moment.', fell: 'Over it goes.', rose: 'On its feet again.', staggers: 'It staggers.',
    ate: 'It has eaten.',
  },
  refuses: (act, reason) => `It will not ${act}: ${reason}.`,
  canDo: 'Ask it to',
  acts: { Sit: 'sit', Lie: 'lie down', Sniff: 'sniff', Eat: 'graze', Drink: 'drink', Shake: 'shake', Scratch: 'scratch', Groom: 'groom', Bite: 'bite', Claw: 'claw', Kick: 'kick', TailSweep: 'sweep its tail', Threaten: 'threaten', Submit: 'submit', Dance: 'dance', Call: 'call' },
  mood: 'Mood',
  moods: { calm: 'Calm', glad: 'Glad', afraid: 'Afraid', angry: 'Angry', sad: 'Sad', excited: 'Excited' },
  backTo: name => `Go back to ${name}`,
  towards: 'Breed towards',
  goals: { fast: 'speed', stable: 'a firm stand', tall: 'height', strange: 'strangeness', distinct: 'variety' },
  evolve: 'Evolve',
  evolveStop: 'Stop here',
  evolveHint: 'Generation after generation is born of the best; the best one stands before you.',
  evolving: (n, best) => `Generation ${n}, best ${best.toPrecision(3)}`,
  evolved: n => `The best of ${n} generations has come.`,
  loop: 'Loop',
  importAll: 'Import',
  imported: n => `${n} came to your collection.`,
  who: { seeds: 'Everybody', species: 'Its species', family: 'Its family' },
  child: 'a child',
  stills: 'Here are pictures of some creatures instead:',
  look: 'Show',
  counts: facts => `${number(facts.triangles)} triangles, ${number(facts.vertices)} vertices, ${facts.joints} joints`,
  repaired: 'Changed so that it can stand:',
  facts: {
    plan: 'Build', body: 'Cousin of', mass: 'Weight', length: 'Length', pace: 'Walking pace', flight: 'Cruise', legs: 'Pairs of legs', generation: 'Generation',
  },
  beasts: { avian: 'bird', bovine: 'ox', canine: 'dog', ceratops: 'horned dinosaur', feline: 'cat', hopper: 'grasshopper', puffer: 'puffer fish', angler: 'angler fish' },
  kin: bodies => (bodies.length > 1 ? `Part ${bodies[0]}, part ${bodies[1]}` : `All ${bodies[0]}`),
  neighbours: 'Neighbours',
  call: name => `Call ${name}`,
  come: 'Come here',
  wander: 'Wander',
  stay: 'Stay',
  sound: 'Sound',
  hint: 'Touch it to pet it, flick it to push it. Double-click the ground to send it there. Click a neighbour to call it.',
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
  noAddress: (letters, most) => `An address has room for ${number(most)} letters, and this creature takes ${number(letters)}. Its picture, GLB and blueprint hold it.`,
  takeFile: 'It has no address. Its picture, GLB and blueprint hold it.',
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
  looked: n => `Looked at ${number(Number(n))} seeds…`,
  notGrown: reason => `Could not be grown: ${reason}`,
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

/** What a base body is called by people: `feline` is a cat. */
export const beast = name => texts.beasts[name] ?? words(name);

export function weight(kg) {
  return kg < 0.1 ? `${(kg * 1000).toPrecision(2)} g` : kg < 10 ? `${kg.toPrecision(2)} kg` : `${number(Number(kg.toPrecision(3)))} kg`;
}

export function length(metres) {
  return metres < 1 ? `${Number((metres * 100).toPrecision(2))} cm` : `${metres.toFixed(2)} m`;
}

export const plural = (count, one, many) => (count === 1 ? `1 ${one}` : `${count} ${many}`);
