#!/bin/bash
# Study {{name}} for OpenPBS (cases: {{case_count}}, tasks: {{task_count}}). Torque has -t for -J,
# nodes=1:ppn= for select=1:ncpus=, and depend=afteranyarray: for depend=afterany:. Sent by
#
#   job=$(qsub -J {{array}} job.sh)
#   qsub -W depend=afterany:"$job" job.sh
#
# A task that its time has stopped leaves checkpoints: what is missing is sent again.
#
#PBS -S /bin/bash
#PBS -N {{name}}
#PBS -j oe
#PBS -r y
#PBS -l select=1:ncpus={{processors}}
#PBS -l walltime={{time}}
#PBS -q {{partition}}
#PBS {{directive}}
# Memory is asked for by '--directive=-l mem=4gb'.

cd {{folder}} || exit
export {{environment}}

task=${PBS_ARRAY_INDEX:-$PBS_ARRAYID}
if [ -z "$task" ]; then
  exec {{gather}}
fi

# The cases of each task, a line a task. An array has two tasks at least, of which one may be empty.
cases=$(sed -n "${task}p" <<'TASKS'
{{task}}
TASKS
)
if [ -z "$cases" ]; then exit 0; fi

# PBS leaves seconds between TERM and KILL; checkpoints have longer.
before_the_end=()
before_the_end=(timeout {{working_s}})
retry=()
retry=({{retry}})
exec "${before_the_end[@]}" {{run}} --cases "$cases" "${retry[@]}"
