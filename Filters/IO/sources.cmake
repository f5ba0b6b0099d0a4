# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The lists of sources of this folder, relative to it; the module and the tests read the first one,
# the module alone that of the sources which need VTK's NetCDF.
set(biting_file_sources
  ADCIRCReading.cxx
  GmshReading.cxx
  GmshWriting.cxx
  MeshFile.cxx
  MeshFileBuilder.cxx
  SMSFiles.cxx
  SU2Reading.cxx)
set(biting_netcdf_sources
  MeshFormat.cxx
  UGRIDWriting.cxx)
