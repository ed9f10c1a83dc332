#!/usr/bin/env bash
# Writes a CycloneDX bill of materials of what is shipped, as it is committed: bom.sh FILE. Needs npm.
set -euo pipefail
file=$(realpath -m "$1")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/creaturegen"
git archive HEAD src samples/CreatureGen.Console Directory.Build.props Directory.Packages.props global.json nuget.config | tar x -C "$work/creaturegen"
npm install --prefix "$work/tool" --omit=optional --ignore-scripts --no-audit --no-fund @cyclonedx/cdxgen@12.8.4
node "$work/tool/node_modules/@cyclonedx/cdxgen/bin/cdxgen.js" -t dotnet --no-install-deps --spec-version 1.6 -o "$file" "$work/creaturegen"
