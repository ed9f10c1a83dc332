// The GLB files of the folder named on the command line, in order of their names.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Name and bytes of each file. Ends the process with code 2 when there is no folder or no GLB in it: nothing checked is not a pass. */
export function glbFiles() {
  const folder = process.argv[2];
  let names;
  try {
    names = readdirSync(folder).filter((name) => name.endsWith('.glb')).sort();
  } catch (error) {
    fail(`cannot list the folder ${folder}: ${error.message}`);
  }
  if (names.length === 0) fail(`no .glb file in ${folder}`);
  return names.map((name) => ({ name, bytes: new Uint8Array(readFileSync(join(folder, name))) }));
}

function fail(message) {
  console.error(message);
  process.exit(2);
}
