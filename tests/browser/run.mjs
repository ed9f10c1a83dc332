// Runs a .NET program in the runtime for the browser, on Node: run.mjs RUNTIME-PACK PROGRAM.dll FOLDER ARGUMENT…
// The files of the folder are in /files of the program; what it prints is printed, and the exit code is its own.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [pack, program, folder, ...args] = process.argv.slice(2);
const places = [[join(pack, 'lib/net10.0'), /\.dll$/], [join(pack, 'native'), /\.(dll|js|wasm)$/], [dirname(program), /^CreatureGen.*\.dll$/]];
const found = new Map(places.flatMap(([place, wanted]) => readdirSync(place).filter(name => wanted.test(name)).map(name => [name, join(place, name)])));
const files = readdirSync(folder).map(name => ({ name: 'file:' + name, virtualPath: '/files/' + name, path: join(folder, name) }));
for (const file of files) found.set(file.name, file.path);

const assemblies = [...found.keys()].filter(name => name.endsWith('.dll')).map(name => ({ name, virtualPath: name }));
const isCore = ({ name }) => /CoreLib|InteropServices\.JavaScript/.test(name);
const { dotnet } = await import(pathToFileURL(found.get('dotnet.js')));
const runtime = await dotnet.withConfig({
  mainAssemblyName: basename(program),
  globalizationMode: 'invariant',
  debugLevel: 0,
  disableIntegrityCheck: true,
  disableNoCacheFetch: true,
  resources: {
    jsModuleNative: [{ name: 'dotnet.native.js' }],
    jsModuleRuntime: [{ name: 'dotnet.runtime.js' }],
    wasmNative: [{ name: 'dotnet.native.wasm' }],
    coreAssembly: assemblies.filter(isCore),
    assembly: assemblies.filter(asset => !isCore(asset)),
    vfs: files.map(({ name, virtualPath }) => ({ name, virtualPath })),
  },
}).withResourceLoader((kind, name) => kind === 'dotnetjs'
  ? pathToFileURL(found.get(name)).href
  : Promise.resolve(new Response(readFileSync(found.get(name)), { headers: { 'Content-Type': name.endsWith('.wasm') ? 'application/wasm' : 'application/octet-stream' } }))).create();
process.exit(await runtime.runMain(basename(program), args));
