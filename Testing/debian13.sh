#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# Both commands of the README on a bare Debian 13, wherever this runs: sh Testing/debian13.sh [folder]
#
# Makes a Debian 13 in a folder (default: one that is removed at the end), copies this tree into it, and
# runs Data/demo.sh and Testing/run.sh there. Needs root, debootstrap and some 6 GB. What it prints is
# what the two commands print; the status is 0 if and only if both succeeded.
#
#   BITING_WARNINGS_AS_ERRORS=ON   as for Testing/run.sh

set -u
root=$(cd "$(dirname "$0")/.." && pwd)
system="${1:-}"
keeps=$system
tree=/root/biting

main()
{
  [ -n "$system" ] || system=$(mktemp -d)
  trap clean_up EXIT
  trap 'exit 1' INT TERM
  [ -e "$system/etc/debian_version" ] ||
    debootstrap --variant=minbase trixie "$system" > "$system.log" 2>&1 || fail
  prepare || exit
  in_system "sh $tree/Data/demo.sh" && in_system "sh $tree/Testing/run.sh"
}

fail()
{
  tail -n 20 "$system.log" >&2
  exit 1
}

# The tree as it would be cloned, with what is not committed, and without build folders; those of an
# earlier run stay, its sources do not.
prepare()
{
  for folder in proc sys dev dev/pts; do
    mountpoint -q "$system/$folder" || mount --bind "/$folder" "$system/$folder" || return
  done
  cp /etc/resolv.conf "$system/etc/" || return
  mkdir -p "$system$tree" || return
  find "$system$tree" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} + || return
  (cd "$root" && git ls-files -co --exclude-standard -z | tar -cf - --null -T -) |
    tar -xmf - -C "$system$tree"
}

in_system()
{
  chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    BITING_WARNINGS_AS_ERRORS="${BITING_WARNINGS_AS_ERRORS:-OFF}" sh -c "$1"
}

clean_up()
{
  for folder in dev/pts dev sys proc; do
    ! mountpoint -q "$system/$folder" || umount "$system/$folder"
  done
  [ -n "$keeps" ] || rm -rf --one-file-system "$system"
}

main
