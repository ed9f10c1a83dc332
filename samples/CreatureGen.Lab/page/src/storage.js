const key = 'creaturegen.collection';
const most = 500;
const longestText = 400_000;
const longestPicture = 40_000;
const kinds = ['walking', 'flying', 'swimming', 'any'];
const digits = /^[0-9]{1,20}$/;

/** An entry of a collection with what belongs to one and nothing else; null for anything that is none. Blueprints are read strictly by the library when somebody visits. */
function checked(entry) {
  const { seed, kind, strangeness, individual = '', traits = {}, text = null, name } = entry?.design ?? {};
  const sound = typeof entry?.name === 'string' && digits.test(seed) && kinds.includes(kind) && strangeness >= 0 && strangeness <= 1 && (individual === '' || digits.test(individual))
    && (text === null || (typeof text === 'string' && text.length <= longestText))
    && typeof traits === 'object' && traits !== null && Object.entries(traits).length <= 20 && Object.entries(traits).every(([key, value]) => /^[a-z]{2,12}$/.test(key) && Number.isFinite(value));
  if (!sound) {
    return null;
  }
  const thumb = typeof entry.thumb === 'string' && entry.thumb.startsWith('data:image/') && entry.thumb.length <= longestPicture ? entry.thumb : null;
  return { name: entry.name.slice(0, 40), thumb, design: { seed, kind, strangeness, individual, traits: { ...traits }, text, name: typeof name === 'string' ? name.slice(0, 40) : undefined } };
}

/** The entries of an exported collection. Throws with a message for people. */
export function parseCollection(text) {
  let entries;
  try {
    entries = JSON.parse(text);
  } catch {
    throw new Error('it is no JSON');
  }
  const sound = Array.isArray(entries) ? entries.map(checked).filter(Boolean) : [];
  if (sound.length === 0) {
    throw new Error('it holds no creatures; expected a collection that this page exported');
  }
  return sound.slice(0, most);
}

/** The collection, in this browser's own storage; nothing leaves the machine. */
export function readCollection() {
  try {
    const entries = JSON.parse(localStorage.getItem(key) ?? '[]');
    return Array.isArray(entries) ? entries.map(checked).filter(Boolean).slice(0, most) : [];
  } catch {
    return [];
  }
}

export function writeCollection(entries) {
  try {
    localStorage.setItem(key, JSON.stringify(entries.slice(0, most)));
  } catch {
    // A browser may forbid storage; then the collection lives as long as the page.
  }
}

/** Offers bytes as a file. */
export function download(name, bytes, type) {
  const address = URL.createObjectURL(new Blob([bytes], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
