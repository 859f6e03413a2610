#!/usr/bin/env bash
# h NAME COMMAND...: runs a command in a mount namespace where /work/main is the clone NAME
n=$1; shift
exec unshare -m bash -c 'mount --make-rprivate / && mount --bind /work/helpers/'"$n"' /work/main && cd /work/main && exec bash -c "$1"' _ "$*"
