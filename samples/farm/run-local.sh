#!/usr/bin/env bash
# A farm on one machine, by GNU parallel: run-local.sh SEEDS FOLDER [SHARDS [OPTIONS OF generate...]]
# Ended at any time and begun again, it makes what is left.
set -euo pipefail
seeds=${1:?such as 1-10000}; folder=${2:?a folder}; shards=${3:-$(nproc)}
shift $(($# < 3 ? $# : 3))
program=${CREATUREGEN:-creaturegen}

seq 0 $((shards - 1)) | parallel --will-cite --jobs "$(nproc)" --halt soon,fail=20% --termseq TERM,5000,KILL \
    "$program" generate --seeds "$seeds" --out "$folder" --shard "{}/$shards" --resume --threads 1 --quiet "$@"
if [ "$shards" -gt 1 ]; then "$program" merge "$folder"; fi
