// Applies all mutants of mutants.txt to a copy of the repository, builds it once, and runs for each mutant the tests that should notice it.
//   node tests/mutants/run.mjs [FIRST-LAST]
// Each expression becomes a choice by the environment variable MUTANT. Exit code 1 when a mutant survives.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..', '..');
const mutants = readFileSync(join(here, 'mutants.txt'), 'utf8').split('\n').filter(l => l.trim() && !l.startsWith('#'))
  .map((l, i) => [i + 1, ...l.split(' ## ').map(w => w.trim())]);
const [first, last] = (process.argv[2] ?? `1-${mutants.length}`).split('-').map(Number);

const copy = join(mkdtempSync(join(tmpdir(), 'mutants-')), 'copy');
execFileSync('git', ['worktree', 'add', '--detach', copy, 'HEAD'], { cwd: root, stdio: 'ignore' });
try {
  const broken = [];
  for (const [number, file, expression, replacement] of mutants) {
    const path = join(copy, 'src/CreatureGen', file);
    const text = readFileSync(path, 'utf8');
    const at = text.indexOf(expression);
    if (at < 0 || text.indexOf(expression, at + 1) >= 0) {
      broken.push(`${number}: ${file} does not have "${expression}" once`);
      continue;
    }
    writeFileSync(path, text.slice(0, at) + `(global::CreatureGen.Mutant.Is(${number}) ? (${replacement}) : (${expression}))` + text.slice(at + expression.length));
  }
  if (broken.length) throw new Error(broken.join('\n'));
  writeFileSync(join(copy, 'src/CreatureGen/Mutant.cs'),
    'namespace CreatureGen { internal static class Mutant { private static readonly string active = System.Environment.GetEnvironmentVariable("MUTANT") ?? "";\n' +
    'public static bool Is(int number) => active == number.ToString(System.Globalization.CultureInfo.InvariantCulture); } }\n');
  execFileSync('dotnet', ['build', '-c', 'Release', 'tests/CreatureGen.Tests', '-p:RunAnalyzers=false', '-p:TreatWarningsAsErrors=false', '-v', 'q', '--nologo'], { cwd: copy, stdio: ['ignore', 'inherit', 'inherit'] });
  const folder = join(copy, 'tests/CreatureGen.Tests');
  const run = (number, classes) => spawnSync('./bin/Release/net10.0/CreatureGen.Tests', ['-nologo', '-noColor', ...classes.split(',').flatMap(c => ['-class', c.trim()])],
    { cwd: folder, env: { ...process.env, MUTANT: String(number) }, timeout: 120000 }).status === 0;
  let survivors = 0;
  for (const [number, file, expression, replacement, classes] of mutants.slice(first - 1, last)) {
    const survives = run(number, classes);
    survivors += survives;
    console.log(`${survives ? 'SURVIVES' : 'killed  '} ${number}: ${file}: ${expression} -> ${replacement}`);
  }
  console.log(`${last - first + 1 - survivors} of ${last - first + 1} killed`);
  process.exitCode = survivors ? 1 : 0;
} finally {
  execFileSync('git', ['worktree', 'remove', '--force', copy], { cwd: root });
  rmSync(dirname(copy), { recursive: true, force: true });
}
