#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# Takes the README's picture of ParaView with the plugin: sh Data/window.sh PLUGIN_FOLDER PICTURE
# where PLUGIN_FOLDER has BitingMesh.so (build/demo/build/lib/BitingMesh after sh Data/demo.sh).

set -eu
BITING_DATA=$(cd "$(dirname "$0")" && pwd)
plugin_folder=$(cd "$1" && pwd)
picture=$(realpath "$2")
home=$(mktemp -d)
BITING_WINDOW="$home/drawn"
export BITING_DATA BITING_WINDOW
trap 'rm -rf "$home"' EXIT

# The file "drawn" says that the window is complete; after two minutes nobody waits any more.
HOME="$home" xvfb-run -a -s '-screen 0 1400x900x24' sh -c '
  paraview --disable-registry --plugins=BitingMesh --plugin-search-paths="$1" \
    --script="$BITING_DATA/window.py" > "$HOME/paraview.log" 2>&1 &
  for second in $(seq 120); do
    [ ! -e "$BITING_WINDOW" ] || break
    sleep 1
  done
  sleep 4
  import -window root -trim "$2"
  kill $!
' window "$plugin_folder" "$picture"
[ -e "$BITING_WINDOW" ] || { cat "$home/paraview.log"; exit 1; }
