#!/bin/bash
# Study {{name}} for Grid Engine (cases: {{case_count}}, tasks: {{task_count}}). Sent by
#
#   job=$(qsub -terse -t {{array}} job.sh)
#   qsub -hold_jid "${job%%.*}" job.sh
#
#$ -S /bin/bash
#$ -N {{name}}
#$ -cwd
#$ -j y
#$ -r y
# A site has its own names of parallel environments: qconf -spl lists them.
#$ -pe smp {{slots}}
#$ -l h_rt={{time_s}}
#$ -q {{partition}}
#$ {{directive}}
# Memory is asked for by '--directive=-l h_vmem=4G', for each slot.

cd {{folder}} || exit
export {{environment}}

if [ "${SGE_TASK_ID:-undefined}" = undefined ]; then
  exec {{gather}}
fi

# The cases of each task, a line a task.
cases=$(sed -n "${SGE_TASK_ID}p" <<'TASKS'
{{task}}
TASKS
)
if [ -z "$cases" ]; then
  echo "task $SGE_TASK_ID: this script has no such task" >&2
  exit 2
fi

# Those that could not be run are tried again, but not each time that the task starts.
retry=()
retry=({{retry}})
if [ "${RESTARTED:-0}" != 0 ]; then retry=(); fi

# A task whose time is nearly over writes checkpoints, and exit code 99 puts it back into the queue.
# (The signal of s_rt comes only the first time that a task runs.)
before_the_end=()
before_the_end=(timeout --preserve-status {{working_s}})
"${before_the_end[@]}" {{run}} --cases "$cases" "${retry[@]}"
code=$?
if [ "$code" -eq 75 ]; then echo "task $SGE_TASK_ID: no progress within --time: give more" >&2; fi
if [ "$code" -eq 143 ]; then exit 99; fi
exit "$code"
