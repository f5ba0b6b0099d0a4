# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# What the entry commands share: packages, SDKs, builds. To be read by a shell (sh), which first sets
# `root` to the root of this tree:
#
#   root=$(cd "$(dirname "$0")/.." && pwd)
#   . "$root/Testing/setup.sh"
#   install_packages $paraview_packages   # nothing happens where all of them are there
#   build_paraview                        # module, Python wrapping, plugin: in $paraview_build
#   paraview_python script.py             # pvpython which finds `biting`; $plugin is the plugin's file
#
# The functions write to their standard output and error what the programs in them say; they return
# the status of the first command that failed. All build folders are under $root/build.

build_root="$root/build"
paraview_build="$build_root/paraview"
vtk_build="$build_root/vtk"
vtk_prefix="$build_root/vtk-prefix"
thread_build="$build_root/thread"
plugin="$paraview_build/lib/BitingMesh/BitingMesh.so"
warnings_as_errors="${BITING_WARNINGS_AS_ERRORS:-OFF}"

# Packages have other names in Debian 12 and 13; systems without a number get the newer ones.
# vtk_packages is what the stand-alone VTK asks for; VTK itself cannot be installed beside ParaView:
# see unpack_vtk.
debian=$(. /etc/os-release 2>/dev/null && echo "${VERSION_ID:-}")
if [ "$debian" = 12 ]; then
  qt_packages="
    qtbase5-dev qttools5-dev qttools5-dev-tools qtxmlpatterns5-dev-tools
    libqt5svg5-dev libqt5x11extras5-dev
    libqt5opengl5-dev libqt5sql5-sqlite libxt-dev"
  vtk_version=9.1
  vtk_packages="libtbb-dev libjsoncpp25 libproj25 libtcl8.6 libtk8.6 libhdf5-103-1"
else
  qt_packages="
    qt6-base-dev qt6-5compat-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools
    qt6-declarative-dev qt6-svg-plugins libqt6sql6-sqlite"
  vtk_version=9.3
  vtk_packages="libtbb-dev libjsoncpp26 libproj25 libtcl8.6 libtk8.6 libhdf5-310"
fi

# ParaView, what its package configuration asks for, a compiler, and a display for pictures.
paraview_packages="
  g++ cmake ninja-build pkg-config
  paraview paraview-dev python3-paraview python3-dev
  $qt_packages
  libutfcpp-dev libhdf5-openmpi-dev libnetcdf-dev libgdal-dev libxml2-dev libtheora-dev
  libgl2ps-dev libglew-dev libfreetype-dev libdouble-conversion-dev liblz4-dev libboost-dev
  libopenmpi-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev libtiff-dev
  libjpeg-dev libpng-dev libeigen3-dev libexpat1-dev
  xvfb xauth libgl1-mesa-dri fonts-dejavu-core"

test_packages="libgtest-dev imagemagick xdotool python3-meshio clang-tidy clang-format ccache"

# Installs those of the given packages that are missing.
install_packages()
{
  missing=
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
      missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    echo "These packages are missing and only root can install them:$missing" >&2
    return 1
  fi
  apt-get update -q || return
  # shellcheck disable=SC2086
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
}

# Puts Debian's VTK into a folder of its own, because its packages exclude those of ParaView.
unpack_vtk()
{
  [ -e "$vtk_prefix/complete" ] || fetch_vtk || return
  set -- "$vtk_prefix"/usr/lib/*/cmake/vtk-$vtk_version
  VTK_DIR="$1"
  vtk_library_path="${VTK_DIR%/cmake/vtk-*}"
  vtk_python_path="$vtk_prefix/usr/lib/python3/dist-packages"
}

fetch_vtk()
{
  rm -rf "$vtk_prefix"
  mkdir -p "$vtk_prefix/packages" || return
  (cd "$vtk_prefix/packages" &&
    fetch_packages "libvtk$vtk_version" libvtk9-dev python3-vtk9 vtk9) || return
  for archive in "$vtk_prefix"/packages/*.deb; do
    dpkg -x "$archive" "$vtk_prefix" || return
  done
  rm -r "$vtk_prefix/packages"
  : > "$vtk_prefix/complete"
}

# Downloads into the current folder; asks for the lists of packages where they are missing or old.
fetch_packages()
{
  apt-get -q -o APT::Sandbox::User=root download "$@" && return
  apt-get update -q && apt-get -q -o APT::Sandbox::User=root download "$@"
}

# What builds have in common, as those for ParaView and VTK the kernel, ccache compiles once.
use_ccache()
{
  if [ -n "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ] || ! command -v ccache > /dev/null; then
    return
  fi
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache
  export CCACHE_DIR="$build_root/ccache" CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=true
}

# Configures and builds: folder, then arguments for CMake.
build()
{
  folder="$1"
  shift
  use_ccache
  cmake -G Ninja -S "$root" -B "$folder" \
    -DBITING_BUILD_TESTING=ON -DBITING_WARNINGS_AS_ERRORS="$warnings_as_errors" \
    -DBITING_UNITY_BUILD=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" || return
  cmake --build "$folder" --parallel "$(nproc)"
}

# Arguments go to CMake, as in build_paraview -DBITING_BUILD_TESTING=OFF.
build_paraview()
{
  build "$paraview_build" -DBITING_SDK=ParaView -DCMAKE_BUILD_TYPE=Release "$@"
}

# The kernel's tests do not depend on the SDK: they are built with ParaView.
build_vtk()
{
  unpack_vtk || return
  build "$vtk_build" -DBITING_SDK=VTK -DVTK_DIR="$VTK_DIR" \
    -DCMAKE_BUILD_TYPE=Release -DBITING_BUILD_KERNEL_TESTING=OFF "$@"
}

# Tests that use several threads only, of the kernel.
build_thread()
{
  build "$thread_build" -DBITING_SDK=Kernel -DCMAKE_BUILD_TYPE=Release \
    -DBITING_SANITIZE=thread "$@"
}

paraview_python()
{
  set -- pvpython "$@"
  PYTHONPATH="$(echo "$paraview_build"/lib/python3*/site-packages)${PYTHONPATH:+:$PYTHONPATH}" "$@"
}
