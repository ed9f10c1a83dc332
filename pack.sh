#!/usr/bin/env bash
# Makes the packages: pack.sh FOLDER [PROJECT-URL]
set -euo pipefail
cd "$(dirname "$0")"
out=$(mkdir -p "$1" && cd "$1" && pwd)
url=${2:+-p:ProjectUrl=$2}

dotnet build -c Release --nologo -v q tools/CreatureGen.Reference
for project in src/CreatureGen src/CreatureGen.Preview samples/CreatureGen.Console; do
    dotnet build -c Release --nologo -v q $project
done

# What is documented is what can be used.
reference=tools/CreatureGen.Reference/bin/Release/net10.0/CreatureGen.Reference.dll
for framework in net10.0 netstandard2.1; do
    dotnet $reference trim src/CreatureGen/bin/Release/net10.0/CreatureGen.dll src/CreatureGen/bin/Release/$framework/CreatureGen.xml
done
dotnet $reference trim src/CreatureGen.Preview/bin/Release/net10.0/CreatureGen.Preview.dll src/CreatureGen.Preview/bin/Release/net10.0/CreatureGen.Preview.xml

for project in src/CreatureGen src/CreatureGen.Preview samples/CreatureGen.Console; do
    dotnet pack -c Release --nologo -v q --no-build -o "$out" $project $url
done
ls "$out"
