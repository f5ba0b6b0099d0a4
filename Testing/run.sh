#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# All tests in one command, from a bare Debian 12 or 13: sh Testing/run.sh (as root, if
# packages are missing).
#
# Installs what is missing, builds for ParaView and for the stand-alone VTK, and the kernel once more
# with sanitizers; runs every test of each; checks format and clang-tidy. Ends with the sum of all
# of them; the status is 0 if and only if nothing failed. What the stages said is in build/log.
#
#   BITING_WARNINGS_AS_ERRORS=ON   warnings of compiler and clang-tidy are failures
#   BITING_SHARED_INPUTS=folder    more inputs for the tests; default ../shared/inputs, may be absent

set -u
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/Testing/setup.sh"
log_folder="$build_root/log"
format_version=14
tests_with_threads='Kernel\.(Tasks|Threads|Marks)\.|Kernel\..*OnAnyNumberOfThreads|Kernel\..*ForAnyNumberOfThreads|Kernel\.BlockMesher\..*(Threads|Refuses)'
only=
passed=0
failed=0
failures=

main()
{
  mkdir -p "$log_folder"
  begin=$(date +%s)
  stage packages install_packages $paraview_packages $vtk_packages $test_packages
  install_packages gmsh > "$log_folder/gmsh.log" 2>&1 ||
    echo "Gmsh cannot be installed here: what asks it is skipped."
  stage build-paraview build_paraview -DBITING_SANITIZED_TESTS=address,undefined
  stage build-vtk build_vtk
  stage build-thread build_thread
  suite paraview "$paraview_build"
  suite vtk "$vtk_build" LD_LIBRARY_PATH="${vtk_library_path:-}" PYTHONPATH="${vtk_python_path:-}"
  only="$tests_with_threads"
  suite thread "$thread_build"
  only=
  if clang-format --version | grep -q "version $format_version\."; then
    stage format check_format
  else
    echo "Stage format             Skipped: other versions than clang-format $format_version format otherwise"
  fi
  stage clang-tidy check_with_clang_tidy
  summarize
}

# A stage is one test: it passes if its command does. Quiet, unless it fails.
stage()
{
  name="$1"
  shift
  stage_begin=$(date +%s)
  if "$@" > "$log_folder/$name.log" 2>&1; then
    passed=$((passed + 1))
    report "$name" Passed
  else
    tail -n 60 "$log_folder/$name.log"
    failed=$((failed + 1))
    failures="$failures $name"
    report "$name" '***Failed'
  fi
}

report()
{
  printf '%-24s %-10s %5d sec\n' "Stage $1" "$2" $(($(date +%s) - stage_begin))
}

# All tests of one build, or those that match `only`, counted one by one: name, folder, then
# variables for the environment.
suite()
{
  name="$1"
  folder="$2"
  shift 2
  stage_begin=$(date +%s)
  env "$@" ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(nproc)" \
    ${only:+-R "$only"} \
    > "$log_folder/test-$name.log" 2>&1
  status=$?
  count "$log_folder/test-$name.log"
  if [ $status -eq 0 ]; then
    report "test-$name" Passed
  else
    grep -vE '^ +Start |[0-9]+/[0-9]+ Test .*( Passed |Skipped )' "$log_folder/test-$name.log"
    failures="$failures test-$name"
    report "test-$name" '***Failed'
  fi
}

# Adds the numbers of CTest's closing line; a log without one counts as a failure.
count()
{
  line=$(grep -E 'tests passed, [0-9]+ tests failed out of [0-9]+' "$1" | tail -n 1)
  if [ -z "$line" ]; then
    failed=$((failed + 1))
    return
  fi
  suite_failed=$(echo "$line" | sed 's/.*passed, \([0-9]*\) tests failed.*/\1/')
  suite_total=$(echo "$line" | sed 's/.*out of \([0-9]*\).*/\1/')
  failed=$((failed + suite_failed))
  passed=$((passed + suite_total - suite_failed))
}

sources()
{
  find "$root/Filters" "$root/Testing" -name '*.cxx' -o -name '*.h' | LC_ALL=C sort
}

check_format()
{
  sources | xargs clang-format --dry-run -Werror
}

# Only what the library is compiled from, room by room: it includes all of its headers.
check_with_clang_tidy()
{
  errors=
  [ "$warnings_as_errors" = OFF ] || errors='-warnings-as-errors=*'
  units_of_library | xargs -P "$(nproc)" -n 1 clang-tidy --quiet $errors -p "$paraview_build"
}

units_of_library()
{
  sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$paraview_build/compile_commands.json" |
    grep -E "^$root/Filters/.*\.cxx$|^$paraview_build/Filters/.*/Unity/.*\.cxx$" | LC_ALL=C sort -u
}

summarize()
{
  total=$((passed + failed))
  [ $failed -eq 0 ] || printf '\nThe following stages failed:%s (logs in %s)\n' "$failures" "$log_folder"
  [ -n "$(find "${BITING_SHARED_INPUTS:-$root/../shared/inputs}" -name '*.vtk' 2>/dev/null | head -n 1)" ] ||
    printf '\nThe shared inputs were absent: only those of Data were tested.\n'
  printf '\n%d%% tests passed, %d tests failed out of %d\n' \
    $((100 * passed / total)) $failed $total
  printf '\nTotal Test time (real) = %d sec\n' $(($(date +%s) - begin))
  [ $failed -eq 0 ]
}

main
