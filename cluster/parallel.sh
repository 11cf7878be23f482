#!/bin/bash
# Study {{name}} for GNU parallel (cases: {{case_count}}, tasks: {{task_count}}). Started by
#
#   bash job.sh
#
# Other machines that share its files are given in the variable PARALLEL: PARALLEL='-S host1,host2'.

# parallel starts this script once more for each task. No name of a file is in its command, as it
# would put a task where a name has {}.
LSOS_JOB_SCRIPT=$(realpath -e -- "$0") || exit
export LSOS_JOB_SCRIPT
cd {{folder}} || exit
export {{environment}}

retry=()
retry=({{retry}})
if [ $# -gt 0 ]; then
  exec {{run}} --cases "$1" "${retry[@]}"
fi

jobs=$(((n = $(nproc) / {{processors}}) > 0 ? n : 1))
jobs={{limit}}

# The cases of each task, a line a task.
parallel --env LSOS_JOB_SCRIPT --jobs "$jobs" bash '"$LSOS_JOB_SCRIPT"' {} <<'TASKS'
{{task}}
TASKS
code=$?

{{gather}} || exit
exit "$code"
