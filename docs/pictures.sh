#!/usr/bin/env bash
# Draws all pictures of the documents anew, each by the command that stands above it: docs/pictures.sh CREATUREGEN [DOCUMENT...]
set -euo pipefail
program=$(realpath "$1"); docs=$(cd "$(dirname "$0")" && pwd); place=$(mktemp -d)
shift; [ $# -gt 0 ] || set -- "$docs"/*.md
documents=$(realpath "$@")
trap 'rm -rf "$place"' EXIT
cd "$place"

# A line such as: `creaturegen animate --seed 20 --out walk.png`, its strip `walk-strip.png`; the next picture is the last file that it names.
awk 'FNR == 1 { command = "" } /^`creaturegen .*--out / { command = $0; sub(/^`creaturegen /, "", command); sub(/`.*$/, "", command); made = $0; sub(/`[^`]*$/, "", made); sub(/^.*[ `]/, "", made) }
     match($0, /!\[[^]]*\]\([a-z\/-]+\.png\)/) && command { picture = substr($0, RSTART, RLENGTH); sub(/^.*\(/, "", picture); sub(/\)$/, "", picture); print picture "\t" command "\t" made; command = "" }' $documents |
while IFS=$'\t' read -r picture command made; do
    echo "$picture: creaturegen $command"
    eval "'$program' $command" < /dev/null > /dev/null
    cp "$made" "$docs/$picture"
done

# The blocks on other skeletons, and the icon of the packages.
dotnet run -c Release --project "$docs/../samples/CreatureGen.Blocks" blocks > /dev/null
for picture in "$docs"/blocks-*.png; do cp "blocks/$(basename "${picture#*blocks-}")" "$picture"; done
"$program" generate --seed 3 --kind walking --picture-size 128x128 --transparent --out icon --quiet && cp icon/creature-3.png "$docs/../src/icon.png"
