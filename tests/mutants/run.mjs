// Applies all mutants of mutants.txt to a copy of the repository, builds it once, and runs for each mutant the tests that should notice it.
//   node tests/mutants/run.mjs [FIRST-LAST | NUMBER,NUMBER…]
// Each expression becomes a choice by the environment variable MUTANT. Before the mutants the same tests must pass without one. A run ends at the first
// test that fails; one that takes over five minutes counts as neither killed nor survived. Exit code 1 when a mutant survives or runs out of time.
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..', '..');
const mutants = readFileSync(join(here, 'mutants.txt'), 'utf8').split('\n').filter(l => l.trim() && !l.startsWith('#'))
  .map((l, i) => [i + 1, ...l.split(' ## ').map(w => w.trim())]);
let chosen = (process.argv[2] ?? `1-${mutants.length}`).split(',').flatMap(part => {
  const [first, last = first] = part.split('-').map(Number);
  return mutants.slice(first - 1, last);
});

const copy = join(mkdtempSync(join(tmpdir(), 'mutants-')), 'copy');
execFileSync('git', ['worktree', 'add', '--detach', copy, 'HEAD'], { cwd: root, stdio: 'ignore' });
try {
  const stale = new Set();
  for (const [number, file, expression, replacement] of mutants) {
    const path = join(copy, 'src/CreatureGen', file);
    const text = existsSync(path) ? readFileSync(path, 'utf8') : '';
    const at = text.indexOf(expression);
    if (at < 0 || text.indexOf(expression, at + 1) >= 0) {
      stale.add(number);
      console.log(`STALE       ${number}: ${file} does not have "${expression}" once`);
      continue;
    }
    writeFileSync(path, text.slice(0, at) + `(global::CreatureGen.Mutant.Active == ${number} ? (${replacement}) : (${expression}))` + text.slice(at + expression.length));
  }
  chosen = chosen.filter(([number]) => !stale.has(number));
  writeFileSync(join(copy, 'src/CreatureGen/Mutant.cs'),
    'namespace CreatureGen { internal static class Mutant { public static readonly int Active = int.TryParse(System.Environment.GetEnvironmentVariable("MUTANT"), out int number) ? number : 0; } }\n');
  execFileSync('dotnet', ['build', '-c', 'Release', 'tests/CreatureGen.Tests', '-p:RunAnalyzers=false', '-p:TreatWarningsAsErrors=false', '-v', 'q', '--nologo'], { cwd: copy, stdio: ['ignore', 'inherit', 'inherit'] });
  const folder = join(copy, 'tests/CreatureGen.Tests');
  const run = (number, classes) => {
    const started = Date.now();
    const { status, stdout } = spawnSync('./bin/Release/net10.0/CreatureGen.Tests', ['-nologo', '-noColor', '-stopOnFail', ...classes.split(',').flatMap(c => ['-class', c.trim()])],
      { cwd: folder, env: { ...process.env, MUTANT: String(number) }, timeout: 300000, maxBuffer: 1 << 28, encoding: 'utf8' });
    return { outcome: status === null ? 'OUT OF TIME' : status === 0 ? 'SURVIVES' : 'killed', seconds: Math.round((Date.now() - started) / 1000), by: /^\s+(CreatureGen\S+).*\[FAIL\]/m.exec(stdout)?.[1] ?? '', stdout };
  };
  for (const classes of new Set(chosen.map(m => m[4]))) {
    const { outcome, seconds, stdout } = run(0, classes);
    if (outcome !== 'SURVIVES' || / Total: 0,/.test(stdout)) {
      for (const mutant of chosen.filter(m => m[4] === classes)) stale.add(mutant[0]);
      console.log(`STALE       ${[...stale].pop()}: without a mutant ${classes} do not pass in ${seconds} s\n${stdout}`);
    }
  }
  chosen = chosen.filter(([number]) => !stale.has(number));
  let killed = 0;
  for (const [number, file, expression, replacement, classes] of chosen) {
    const { outcome, seconds, by } = run(number, classes);
    killed += outcome === 'killed';
    console.log(`${outcome.padEnd(11)} ${number}: ${file}: ${expression} -> ${replacement} (${seconds} s) ${by}`);
  }
  console.log(`${killed} of ${chosen.length} killed`);
  process.exitCode = killed < chosen.length || stale.size ? 1 : 0;
} finally {
  execFileSync('git', ['worktree', 'remove', '--force', copy], { cwd: root });
  rmSync(dirname(copy), { recursive: true, force: true });
}
