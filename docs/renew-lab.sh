#!/usr/bin/env bash
# Draws the pictures of the lab's page anew: docs/lab.png and docs/lab-phone.png; with "loop" also the ten seconds of docs/lab-loop.webp, which take software drawing some minutes. Look at them before they are committed.
set -euo pipefail
docs=$(cd "$(dirname "$0")" && pwd)
lab="$docs/../samples/CreatureGen.Lab"
dotnet build -c Release -v q --nologo "$lab"
node "$lab/page/tests/check.mjs" renew
if [ "${1:-}" = loop ]; then
    node "$lab/page/tests/film.mjs" "$docs/lab-loop.webp"
fi
