#!/usr/bin/env bash
#SBATCH --job-name=replay
#SBATCH --array=1-64
#SBATCH --cpus-per-task=1
#SBATCH --output=results/%a.log
# Replays the recordings below recordings/, a shard for each task of the array:
#
#   mkdir -p results && sbatch docs/ci/slurm.sh
#
# Another number of tasks, for example sbatch --array=1-500, needs no other change. A task fails if
# one of its recordings differs: sacct -j JOB --state=FAILED lists those tasks.
set -euo pipefail

softcnc replay recordings --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --format json --junit "results/$SLURM_ARRAY_TASK_ID.xml" >"results/$SLURM_ARRAY_TASK_ID.json"
