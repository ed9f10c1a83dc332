#!/usr/bin/env bash
# Draws all pictures of the documents anew, each by the command that stands beside it: docs/pictures.sh CREATUREGEN
set -euo pipefail
program=$(realpath "$1"); docs=$(cd "$(dirname "$0")" && pwd); place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"

# The gallery: a command, and below it its picture. Films are shown by their strips.
awk '/^`creaturegen / { command = $0; sub(/^`creaturegen /, "", command); sub(/`.*$/, "", command) } match($0, /\]\([a-z\/-]+\.png\)/) { print substr($0, RSTART + 2, RLENGTH - 3) "\t" command }' "$docs/gallery.md" |
while IFS=$'\t' read -r picture command; do
    eval "'$program' $command" < /dev/null
    made=$(sed 's/.*--out \([^ ]*\).*/\1/' <<< "$command")
    case $command in animate*) made=${made%.png}-strip.png ;; esac
    cp "$made" "$docs/$picture"
done

# Litters: the page on breeding names folders.
"$program" breed 3 16 --litter 9 --mutation 0.2 --out litter && cp litter/litter.png "$docs/breeding.png"
"$program" breed 3 16 --age 0 --out babies && cp babies/litter.png "$docs/babies.png"

# The blocks on other skeletons.
dotnet run -c Release --project "$docs/../samples/CreatureGen.Blocks" blocks > /dev/null
for name in gecko chains ponytail; do cp "blocks/$name.png" "$docs/blocks-$name.png"; done

# The icon of the packages.
"$program" generate --seed 3 --kind walking --picture-size 128x128 --transparent --out icon --quiet && cp icon/creature-3.png "$docs/../src/icon.png"
