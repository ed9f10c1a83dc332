#!/usr/bin/env bash
# Makes the documents and the API as a static site: build.sh FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd); root=$(cd "$here/../.." && pwd)
out=$(mkdir -p "$1" && cd "$1" && pwd)
cd "$root"
dotnet build -c Release --nologo -v q tools/CreatureGen.Reference
dotnet build -c Release --nologo -v q src/CreatureGen.Preview
dotnet tools/CreatureGen.Reference/bin/Release/net10.0/CreatureGen.Reference.dll pages "$out/docs/api" src/CreatureGen.Preview/bin/Release/net10.0/CreatureGen.dll src/CreatureGen.Preview/bin/Release/net10.0/CreatureGen.Preview.dll
[ -d tools/site/node_modules ] || npm ci --prefix tools/site --prefer-offline
node tools/site/build.mjs "$out" "$root"
find "$out/docs/api" -name '*.md' -delete
