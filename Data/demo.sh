#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# From a bare Debian 12 to the mesh of a real coast: sh Data/demo.sh (as root, if packages miss).
#
# Installs what is missing, builds the plugin for ParaView, and meshes the seas around Britain and
# Ireland with it: see demo.py. All results are in build/demo. Says nothing but the summary of the
# mesh and where the files are; what the stages said is in demo.log, and is shown when one fails.

set -u
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/Testing/setup.sh"
folder="$build_root/demo"
paraview_build="$folder/build"
plugin="$paraview_build/lib/BitingMesh/BitingMesh.so"
log="$folder/demo.log"

main()
{
  mkdir -p "$folder" || exit
  : > "$log"
  stage 'Installing packages' install_packages $paraview_packages
  stage 'Building the plugin' build_paraview -DBITING_BUILD_TESTING=OFF
  stage 'Meshing the coast' mesh_coast
  cat "$folder/summary.txt"
  echo
  echo "Mesh:    $folder/coast_mesh.vtk"
  echo "Shores:  $folder/coast_shores.vtk"
  echo "Picture: $folder/coast_mesh.png"
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
  rm -f "$folder"/coast_* "$folder/summary.txt"
  xvfb-run -a pvpython "$root/Data/demo.py" "$plugin" "$folder" > "$folder/summary.txt" &&
    [ -s "$folder/coast_mesh.png" ]
}

main
