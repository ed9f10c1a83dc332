#!/usr/bin/env bash
# Draws all pictures of the documents anew, each by the command that stands above it: docs/pictures.sh CREATUREGEN [DOCUMENT...]
# Two programs of the same version draw the same bytes: run twice, it changes nothing. One picture that fails is told and the others go on; then it ends with 1.
set -euo pipefail
program=$(realpath "$1"); docs=$(cd "$(dirname "$0")" && pwd); place=$(mktemp -d)
shift
blocks=$([ $# -eq 0 ] && echo yes || echo no)
[ $# -gt 0 ] || set -- "$docs"/*.md
documents=$(realpath "$@")
trap 'rm -rf "$place"' EXIT
cd "$place"
failed=""

# renew PICTURE COMMAND MADE: runs the command in a folder of its own and puts what it made in the picture's place.
renew() {
    local began=$SECONDS folder
    folder=$(mktemp -d "$place/picture.XXXX")
    if (cd "$folder" && eval "'$program' $2" < /dev/null > /dev/null) && mv -f "$folder/$3" "$docs/$1"; then
        echo "$1: $((SECONDS - began)) s: creaturegen $2"
    else
        failed="$failed $1"
        echo "$1: FAILED: creaturegen $2" >&2
    fi
    rm -rf "$folder"
}

# A line such as: `creaturegen animate --seed 20 --out walk.png`, its strip `walk-strip.png`; the next picture is the last file that it names.
awk 'FNR == 1 { command = "" } /^`creaturegen .*--out / { command = $0; sub(/^`creaturegen /, "", command); sub(/`.*$/, "", command); made = $0; sub(/`[^`]*$/, "", made); sub(/^.*[ `]/, "", made) }
     match($0, /!\[[^]]*\]\([a-z\/-]+\.png\)/) && command { picture = substr($0, RSTART, RLENGTH); sub(/^.*\(/, "", picture); sub(/\)$/, "", picture); print picture "\t" command "\t" made; command = "" }' $documents > list
while IFS=$'\t' read -r picture command made; do
    renew "$picture" "$command" "$made"
done < list

if [ $blocks = yes ]; then
    # The blocks on other skeletons, and the icon of the packages.
    renew ../src/icon.png "generate --seed 3 --kind walking --picture-size 128x128 --transparent --out . --quiet" creature-3.png
    if dotnet run -c Release --project "$docs/../samples/CreatureGen.Blocks" "$place/blocks" > /dev/null; then
        for picture in "$place"/blocks/*.png; do cp "$picture" "$docs/blocks-$(basename "$picture")"; done
    else
        failed="$failed blocks"
    fi
fi
[ -z "$failed" ] || { echo "not drawn:$failed" >&2; exit 1; }
