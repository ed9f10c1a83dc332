#!/usr/bin/env bash
# Makes anew what the documents and examples show of the program: its manual, all pictures, the example of a data set. To be run when creatures' bytes have changed: docs/renew.sh [CREATUREGEN]
# The page of the lab takes its own pictures: docs/renew-lab.sh.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -eq 0 ]; then
    dotnet build -c Release -v q --nologo "$root/samples/CreatureGen.Console"
    set -- "$root/samples/CreatureGen.Console/bin/Release/net10.0/creaturegen"
fi
"$1" manual > "$root/docs/console.md"
"$root/samples/dataset/make.sh" "$1"
"$root/docs/pictures.sh" "$1"
