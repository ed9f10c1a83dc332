#!/usr/bin/env bash
# Writes the .meta file of each asset of the package. Ids follow from the paths, so that they stay when files change.
set -euo pipefail
cd "$(dirname "$0")/com.creaturegen"
find . -mindepth 1 \( -type d -o -type f \) ! -name '*.meta' ! -name '.gitignore' ! -name '*~' | sort | { cat; echo ./Plugins/CreatureGen.dll; echo ./Plugins/CreatureGen.xml; } | sort -u | while read -r path; do
    id=$(printf 'com.creaturegen/%s' "${path#./}" | md5sum | cut -c1-32)
    case $path in
        *.dll) importer=$'PluginImporter:\n  serializedVersion: 2\n  isExplicitlyReferenced: 1\n  validateReferences: 1\n  platformData:\n  - first:\n      Any:\n    second:\n      enabled: 1\n      settings: {}' ;;
        *.cs) importer=$'MonoImporter:\n  serializedVersion: 2\n  executionOrder: 0' ;;
        *.asmdef) importer=$'AssemblyDefinitionImporter:\n  externalObjects: {}' ;;
        *) if [ -d "$path" ]; then importer=$'folderAsset: yes\nDefaultImporter:\n  externalObjects: {}'; else importer=$'TextScriptImporter:\n  externalObjects: {}'; fi ;;
    esac
    printf 'fileFormatVersion: 2\nguid: %s\n%s\n' "$id" "$importer" > "$path.meta"
done
