// Holds every document of a manifest against the schema of its kind: node validate.mjs job.yaml
import { readFileSync } from 'node:fs';
import { parseAllDocuments } from 'yaml';

let wrong = 0;
for (const document of parseAllDocuments(readFileSync(process.argv[2], 'utf8'))) {
  const object = document.toJS();
  const models = await import(`kubernetes-models/${object.apiVersion}`);
  const Model = models[object.kind];
  try {
    new Model(object).validate();
    console.log(`${object.kind} ${object.metadata.name}: valid`);
  } catch (problem) {
    wrong++;
    console.error(`${object.kind} ${object.metadata.name}: ${problem.message}`);
  }
}
process.exit(wrong === 0 ? 0 : 1);
