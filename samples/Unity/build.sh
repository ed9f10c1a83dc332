#!/usr/bin/env bash
# Puts the library into the Unity package: build.sh
set -euo pipefail
cd "$(dirname "$0")"
dotnet build -c Release --nologo -v q -f netstandard2.1 ../../src/CreatureGen
cp ../../src/CreatureGen/bin/Release/netstandard2.1/CreatureGen.{dll,xml} com.creaturegen/Plugins/
