#!/bin/bash
# Study {{name}} for Slurm (cases: {{case_count}}, tasks: {{task_count}}). Sent by
#
#   {{submit}}
#
#SBATCH --job-name={{name}}
#SBATCH --cpus-per-task={{processors}}
#SBATCH --time={{time}}
#SBATCH --partition={{partition}}
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --signal=B:USR1@{{warning_s}}
#SBATCH {{directive}}

cd {{folder}} || exit
export {{environment}}

if [ "$1" = gather ]; then
  trap '' USR1 # it comes before the end of this job, too
  exec {{gather}}
fi

# The cases of each task, a line a task; $1 is how many are in arrays before this one.
cases=$(sed -n "$((${SLURM_ARRAY_TASK_ID:?is missing: this is for sbatch --array} + ${1:-0}))p" <<'TASKS'
{{task}}
TASKS
)
if [ -z "$cases" ]; then exit 0; fi

# USR1 comes when the task's time is nearly over: its cases then write checkpoints, and it goes back
# into the queue. TERM is that of scancel, after which it does not.
trap 'told=yes requeue=yes; kill -TERM "$run"' USR1
trap 'told=yes requeue=; kill -TERM "$run"' TERM
{{run}} --cases "$cases" &
run=$!
told=yes
while [ -n "$told" ]; do # a signal ends wait before the run has ended
  told=
  wait "$run"
  code=$?
done
if [ -n "$requeue" ] && [ "$code" -eq 143 ]; then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
