// Starts the library and answers calls, nothing else. The page passes the runtime's folder as the worker's name.

// Without this the runtime takes any worker for a thread of its own and never starts.
globalThis.dotnetSidecar = true;

// Loops are compiled when they were run this often, four times the usual: compiling what runs only while the first creature grows costs more than it saves.
const runtimeOptions = ['--jiterpreter-minimum-trace-hit-count=20000'];

const base = self.name;
let library;
let heap;

const started = start();

async function start() {
  const [{ dotnet }, names] = await Promise.all([
    import(/* @vite-ignore */ base + 'dotnet.js'),
    fetch(base + 'assemblies.json').then(answer => answer.json()),
  ]);
  const asset = name => ({ name, virtualPath: name });
  const isCore = name => /CoreLib|InteropServices\.JavaScript/.test(name);
  const api = await dotnet
    .withConfig({
      mainAssemblyName: 'CreatureGen.Lab.Runtime.dll',
      globalizationMode: 'invariant',
      debugLevel: 0,
      disableIntegrityCheck: true,
      disableNoCacheFetch: true,
      resources: {
        jsModuleNative: [{ name: 'dotnet.native.js' }],
        jsModuleRuntime: [{ name: 'dotnet.runtime.js' }],
        wasmNative: [{ name: 'dotnet.native.wasm' }],
        coreAssembly: names.filter(isCore).map(asset),
        assembly: names.filter(name => !isCore(name)).map(asset),
      },
    })
    .withRuntimeOptions(runtimeOptions)
    .create();
  library = (await api.getAssemblyExports('CreatureGen.Lab.Runtime.dll')).CreatureGen.Lab.Runtime.Exports;
  heap = () => api.localHeapViewU8().buffer;
}

// One frame is under way at most; its buffer goes back and forth.
function frame({ seconds, eye, buffer }) {
  const begin = performance.now();
  const length = library.Frame(seconds, eye);
  const cost = performance.now() - begin;
  let numbers = new Float32Array(buffer);
  if (numbers.length < length) {
    numbers = new Float32Array(2 * length);
  }
  // The memory may have grown: its view is made anew.
  numbers.set(new Float32Array(heap(), library.FrameAddress(), length));
  return { buffer: numbers.buffer, cost };
}

self.onmessage = async ({ data: { id, name, values } }) => {
  try {
    await started;
    const value = name === 'frame' ? frame(values) : name === 'heapSize' ? heap().byteLength : library[name](...values);
    const moved = value?.buffer instanceof ArrayBuffer ? [value.buffer] : [];
    self.postMessage({ id, value }, moved);
  } catch (problem) {
    self.postMessage({ id, problem: String(problem?.message ?? problem).replace(/^Error: /, '') });
  }
};

started.then(
  () => self.postMessage({ id: 0, value: true }),
  problem => self.postMessage({ id: 0, problem: String(problem?.message ?? problem) }),
);
