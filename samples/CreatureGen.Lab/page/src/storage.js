const key = 'creaturegen.collection';
const most = 500;

/** The collection, in this browser's own storage; nothing leaves the machine. */
export function readCollection() {
  try {
    const entries = JSON.parse(localStorage.getItem(key) ?? '[]');
    return Array.isArray(entries) ? entries.filter(entry => typeof entry?.name === 'string' && typeof entry?.design === 'object').slice(0, most) : [];
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
