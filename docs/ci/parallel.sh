#!/usr/bin/env bash
# Replays all recordings of a folder on all cores, by GNU parallel.
#
#   docs/ci/parallel.sh FOLDER RESULTS [SHARDS]
#
# RESULTS gets, for each shard, its JSON, its JUnit XML and what it has reported. With many shards no
# core waits at the end; each holds about 20 recordings if none are asked for. Exits with 1 if a
# recording differs or cannot be replayed.
set -euo pipefail

folder=$1 results=$2
recordings=$(find "$folder" -name '*.rec' | wc -l)
shards=${3:-$((recordings / 20 + 1))}
mkdir -p "$results"

status=0
seq "$shards" | parallel --joblog "$results/jobs.tsv" \
  softcnc replay "$folder" --shard "{}/$shards" --format json --junit "$results/{}.xml" \
  '>' "$results/{}.json" '2>' "$results/{}.log" || status=1

count() { grep -hc "\"result\": \"$1\"" "$results"/*.json | awk '{ sum += $1 } END { print sum }'; }
echo "$(count agrees) of $recordings recordings agree; $(count differs) differ;" \
  "$(count error) could not be replayed"
grep -h ': error: ' "$results"/*.log || true
exit "$status"
