#!/usr/bin/env bash
# b NAME [TARGET...]: builds the release preset of clone NAME; at most two builds at once
n=$1; shift
mkdir -p /tmp/locks
for i in 0 1; do exec {fd}>/tmp/locks/build$i; if flock -n $fd; then break; fi; flock -u $fd; exec {fd}>&-; fd=; done
if [[ -z ${fd:-} ]]; then exec {fd}>/tmp/locks/build0; flock $fd; fi
/work/helpers/h "$n" "ci/build release $*" 2>&1 | tail -60
