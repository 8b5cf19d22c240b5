#!/bin/bash
# Campaigns one after the other, each once the one before it is complete:
#   slurm/scan.sh [CAMPAIGN.toml ...]    options of sbatch go into SBATCH_* variables, e.g. SBATCH_TIMELIMIT
# Without arguments the design-basis and then the beyond-design campaign: the second asks how far the first one's verdict
# carries, so it is not worth its hours before that is known.
set -eu
slurm=$(cd "$(dirname "$0")" && pwd)
export OVERTURN_SLURM=$slurm
[ $# -gt 0 ] || set -- "$slurm/../campaigns/design_basis.toml" "$slurm/../campaigns/beyond_design.toml"
after=()
for campaign in "$@"; do
    name=$(basename "$campaign" .toml)
    job=$(sbatch --parsable --job-name="$name" "${after[@]}" "$slurm/campaign.sbatch" "$campaign" -o "$name.h5")
    echo "$name $job"
    after=(--dependency="afterok:$job" --kill-on-invalid-dep=yes)  # a campaign that failed leaves no job waiting forever
done
