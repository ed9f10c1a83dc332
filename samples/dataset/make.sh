#!/usr/bin/env bash
# Makes the example anew: make.sh CREATUREGEN
set -euo pipefail
program=$(realpath "$1"); cd "$(dirname "$0")"
rm -f creature-* index.jsonl manifest.jsonl times.jsonl
"$program" generate --seeds 1-12 --no-picture --textures none --triangles 6000 --dataset 2 --picture-size 48x48 --out . --quiet
