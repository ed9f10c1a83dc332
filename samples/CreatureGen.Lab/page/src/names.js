// Names for creatures that nobody has named: always the same one for the same seed and kind.

const heads = ['Bo', 'Fen', 'Mo', 'Tal', 'Ru', 'Ka', 'Lu', 'Pim', 'Zo', 'Har', 'Nib', 'Ves', 'Ol', 'Su', 'Wim', 'Gru', 'Il', 'Jo', 'Dra', 'Quo', 'Ty', 'Eb', 'Sor', 'Mir'];
const middles = ['ba', 'li', 'ro', 'mu', 'ne', 'vi', 'do', 'sha', 'ki', 'lo', 'ra', 'bi', 'wu', 'ta', '', '', ''];
const tails = ['n', 'bo', 'wick', 'la', 'x', 'moth', 'ling', 'ra', 'fin', 'tuk', 'dle', 'paw', 'rius', 'ndo', 'sk', 'loo', 'via', 'p'];

export function nameOf(seed, kind) {
  let h = 2166136261;
  for (const letter of `${seed}.${kind}`) {
    h = Math.imul(h ^ letter.charCodeAt(0), 16777619) >>> 0;
  }
  const pick = list => {
    h = Math.imul(h ^ (h >>> 15), 2246822519) >>> 0;
    return list[(h >>> 8) % list.length];
  };
  return pick(heads) + pick(middles) + pick(tails);
}
