# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

# The one list of sources of this folder, relative to it; the module and the tests read it.
set(biting_file_sources
  ADCIRCReading.cxx
  GmshReading.cxx
  GmshWriting.cxx
  MeshFile.cxx
  MeshFileBuilder.cxx
  MeshFormat.cxx
  SMSFiles.cxx
  SU2Reading.cxx)
