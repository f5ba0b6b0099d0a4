// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDrawingFile_h
#define BitingDrawingFile_h

#include "BitingMesh.h"

#include <string> // for names
#include <vector> // for values

/// What a legacy VTK file has, ASCII, as those of Data: points, lines, vertices, triangles, the
/// first point array of numbers. Without points: it is not there.
struct DrawingFile
{
  /// Of the folder Data, or of the folder that BITING_SHARED_INPUTS names.
  explicit DrawingFile(const std::string& name);

  biting::Polylines Lines;
  std::vector<biting::Id> Triangles; ///< three points each
  std::vector<double> Values;        ///< one a point, or none
};

#endif
