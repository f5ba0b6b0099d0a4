# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# To be included before find_package(ParaView).
#
# Debian 13's paraview-dev names Python modules vtkX.so, where its python3-paraview installs
# vtkX.cpython-313-*.so; find_package(ParaView) takes them for missing and fails. Nothing is linked
# with these modules: their files need not be looked for. The files of exported targets leave that
# out for targets that are frameworks, and know them by the variables that are set here.
function(biting_find_modules_without_their_files)
  file(GLOB_RECURSE modules
    "/usr/lib/python3/dist-packages/vtkmodules/*.cpython-*.so"
    "/usr/lib/python3/dist-packages/paraview/*.cpython-*.so")
  foreach (module IN LISTS modules)
    get_filename_component(folder "${module}" DIRECTORY)
    get_filename_component(name "${module}" NAME_WE)
    if (NOT EXISTS "${folder}/${name}.so")
      set("_cmake_import_check_xcframework_for_VTK::${name}Python" "/" PARENT_SCOPE)
      set("_cmake_import_check_xcframework_for_ParaView::${name}Python" "/" PARENT_SCOPE)
    endif ()
  endforeach ()
endfunction()

biting_find_modules_without_their_files()
