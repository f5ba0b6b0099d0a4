#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# From a bare Debian 12 or 13 to the mesh of a real coast: sh Data/demo.sh (as root, if packages miss).
#
# Installs what is missing, builds the plugin for ParaView, and meshes the seas around Britain and
# Ireland with it: see demo.py. All results are in build/demo. Says nothing but the summary of the
# mesh and where the files are; what the stages said is in demo.log, and is shown when one fails.

set -u
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/Testing/setup.sh"
output="$build_root/demo"
paraview_build="$output/build"
plugin="$paraview_build/lib/BitingMesh/BitingMesh.so"
log="$output/demo.log"

main()
{
  mkdir -p "$output" || exit
  : > "$log"
  stage 'Installing packages' install_packages $paraview_packages
  stage 'Building the plugin' build_paraview -DBITING_BUILD_TESTING=OFF
  stage 'Meshing the coast' mesh_coast
  cat "$output/summary.txt"
  echo
  echo "Mesh:    $output/coast_mesh.vtk"
  echo "Shores:  $output/coast_shores.vtk"
  echo "Picture: $output/coast_mesh.png"
  echo "Plugin:  $plugin"
}

# Says what it does only to a person who waits.
stage()
{
  [ ! -t 2 ] || echo "$1 ..." >&2
  shift
  "$@" >> "$log" 2>&1 && return
  tail -n 40 "$log" >&2
  echo "The demo failed; all of the above is in $log" >&2
  exit 1
}

mesh_coast()
{
  rm -f "$output"/coast_* "$output/summary.txt"
  with_display pvpython "$root/Data/demo.py" "$plugin" "$output" > "$output/summary.txt" &&
    [ -s "$output/coast_mesh.png" ]
}

# A screen in memory; the server itself chooses a number that nobody else uses.
with_display()
{
  : > "$output/display"
  Xvfb -displayfd 3 -screen 0 1600x1000x24 3> "$output/display" &
  server=$!
  while [ ! -s "$output/display" ] && kill -0 $server; do
    sleep 0.2
  done
  DISPLAY=":$(cat "$output/display")" "$@"
  status=$?
  kill $server
  return $status
}

main
