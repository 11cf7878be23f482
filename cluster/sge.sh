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
#$ -pe smp {{slots}}
#$ -l h_rt={{time_s}}
#$ -q {{partition}}
#$ {{directive}}

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
if [ -z "$cases" ]; then exit 0; fi

# A task whose time is nearly over writes checkpoints, and exit code 99 puts it back into the queue.
# (The signal of s_rt comes only the first time that a task runs.)
before_the_end=()
before_the_end=(timeout {{working_s}})
"${before_the_end[@]}" {{run}} --cases "$cases"
code=$?
if [ "$code" -eq 124 ]; then exit 99; fi
exit "$code"
