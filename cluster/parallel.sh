#!/bin/bash
# Study {{name}} for GNU parallel (cases: {{case_count}}, tasks: {{task_count}}). Started by
#
#   bash job.sh
#
# parallel's --sshlogin takes other machines that share its files.

cd {{folder}} || exit
export {{environment}}

# The cases of each task, a line a task.
parallel --quote \
  --jobs {{limit}} \
  {{run}} --cases {} <<'TASKS'
{{task}}
TASKS

{{gather}}
