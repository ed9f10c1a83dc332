#!/usr/bin/env node
// validate.mjs DIR: runs the Khronos validator over all GLB files of a folder and prints totals as JSON:
//   { files, errors, warnings, infos, hints, issues: [{ code, severity, count, file, pointer, message }] }
// Each code is listed once for each kind of place (its pointer, whatever the numbers in it), with its first occurrence. Exit code 1 on any error or warning.
import validator from 'gltf-validator';
import { glbFiles } from './files.mjs';

const totals = { files: 0, errors: 0, warnings: 0, infos: 0, hints: 0 };
const issues = new Map();
for (const { name, bytes } of glbFiles()) {
  const report = await validator.validateBytes(bytes, { uri: name, format: 'glb', maxIssues: 0, writeTimestamp: false });
  totals.files++;
  totals.errors += report.issues.numErrors;
  totals.warnings += report.issues.numWarnings;
  totals.infos += report.issues.numInfos;
  totals.hints += report.issues.numHints;
  for (const { code, severity, pointer, message } of report.issues.messages) {
    const key = `${severity} ${code} ${pointer?.replaceAll(/\d+/g, '')}`;
    const issue = issues.get(key) ?? { code, severity, count: 0, file: name, pointer, message };
    issue.count++;
    issues.set(key, issue);
  }
}
console.log(JSON.stringify({ ...totals, issues: [...issues.values()] }));
process.exitCode = totals.errors + totals.warnings > 0 ? 1 : 0;
