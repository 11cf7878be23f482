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
# Memory is asked for by --directive=--mem=4G.

# USR1 comes when the task's time is nearly over, or another job is to have its place: its cases then
# write checkpoints, and it goes back into the queue. TERM comes at the end of that time, too, and by
# scancel, after which the task does not go back.
run='' told='' requeue=''
stop() {
  told=yes
  if [ -n "$run" ]; then kill -TERM "$run"; fi
}
ask_why() {
  case $(squeue --noheader --format=%r --jobs="${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID") in
    TimeLimit) requeue=yes ;;
    ?*) requeue='' ;;
  esac
}
trap 'requeue=yes; stop' USR1
trap 'stop; ask_why' TERM

cd {{folder}} || exit
export {{environment}}

if [ "$1" = gather ]; then
  trap '' USR1 # it comes before the end of this job, too
  exec {{gather}}
fi

# The cases of each task, a line a task; $1 is how many are in arrays before this one.
: "${SLURM_ARRAY_TASK_ID:?is missing: this is for sbatch --array}"
cases=$(sed -n "$((SLURM_ARRAY_TASK_ID + ${1:-0}))p" <<'TASKS'
{{task}}
TASKS
)
if [ -z "$cases" ]; then
  echo "task $SLURM_ARRAY_TASK_ID after ${1:-0}: this script has no such task" >&2
  exit 2
fi

# Those that could not be run are tried again, but not each time that the task starts.
retry=()
retry=({{retry}})
if [ "${SLURM_RESTART_COUNT:-0}" -gt 0 ]; then retry=(); fi

{{run}} --cases "$cases" "${retry[@]}" &
run=$!
if [ -n "$told" ]; then # before there was a run, which needs a moment until it can be told
  sleep 1
  kill -TERM "$run"
fi
told=yes
while [ -n "$told" ]; do # a signal ends wait before the run has ended
  told=
  wait "$run"
  code=$?
done
if [ "$code" -eq 75 ]; then
  echo "task $SLURM_ARRAY_TASK_ID: no progress within --time: give more" >&2
elif [ -n "$requeue" ] && [ "$code" -eq 143 ]; then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
