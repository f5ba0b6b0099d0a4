#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# A long fuzz run with sanitizers, of the kernel alone:
#
#   sh Testing/fuzz.sh [CASES [SEED [PROCESSES [PROGRAM]]]]
#
# By default 200,000 cases from seed 1 in one process of BitingFuzz, the mesher; BitingRemeshFuzz is
# the remesher. Several processes share the cases. Ends with
# status 1 where one of them found a violation; what each said is in build/fuzz/run-SEED.log.
set -eu
cd "$(dirname "$0")/.."

cases=${1:-200000}
seed=${2:-1}
processes=${3:-1}
program=${4:-BitingFuzz}

cmake -G Ninja -S . -B build/fuzz -DBITING_SDK=Kernel -DCMAKE_BUILD_TYPE=Debug \
  -DBITING_UNITY_BUILD=ON -DCMAKE_CXX_FLAGS_DEBUG="-O2 -g1" \
  -DBITING_SANITIZE=address,undefined,float-cast-overflow
cmake --build build/fuzz --target "$program"

each=$(((cases + processes - 1) / processes))
status=0
pids=
k=0
while [ "$k" -lt "$processes" ]; do
  first=$((seed + k * each))
  "build/fuzz/bin/$program" --cases "$each" --seed "$first" >"build/fuzz/run-$first.log" 2>&1 &
  pids="$pids $!"
  k=$((k + 1))
done
for pid in $pids; do
  wait "$pid" || status=1
done
tail -n 1 build/fuzz/run-*.log
exit $status
