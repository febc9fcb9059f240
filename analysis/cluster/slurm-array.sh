#!/usr/bin/env bash
#SBATCH --job-name=impetus
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
# A chunk of `impetus power`, `recover` or `trade`, as a task of a Slurm array. Its arguments are the command without --chunk:
#
#   sbatch --array=1-50 analysis/cluster/slurm-array.sh impetus power protocols/causality.json \
#     --observer causality --n 20,30 --out power --chunks 50
#
# A task that was killed or requeued begins its chunk again; one whose chunk is there ends at once.
# SPDX-License-Identifier: MIT
set -euo pipefail
[ "$2" = trade ] || set -- "$@" --jobs "${SLURM_CPUS_PER_TASK:-1}"  # a trade has one thread
exec "$@" --chunk "$SLURM_ARRAY_TASK_ID"
