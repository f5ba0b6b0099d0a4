// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileReading_h
#define BitingMeshFileReading_h

#include "MeshFile.h"

#include <cstddef> // for counts
#include <istream> // for files
#include <string>  // for reasons

/**
 * Meshes of triangles from the text formats of solvers, made by any program. Vertices keep the
 * order that they have in the file, whatever their numbers there.
 */
namespace biting
{

/// What came of reading a file.
struct ReadingResult
{
  std::string Reason;              // why there is no mesh, with the line; empty where there is one
  std::size_t PassedOverCells = 0; // cells that are neither triangles nor edges nor points
};

/// Gmsh 2.2 and 4.1, ASCII. Groups are the physical groups; where the file has none, the curves
/// and surfaces themselves.
ReadingResult ReadGmsh(std::istream& file, MeshFile& mesh);

/// SU2 of two dimensions: markers as tags, numbered from 1 on where their names are no numbers.
ReadingResult ReadSU2(std::istream& file, MeshFile& mesh);

/// ADCIRC grid (fort.14): depths; tag 1 for open boundaries, 2 and the type added for land: 2
/// mainland, 3 island and so on.
ReadingResult ReadADCIRC(std::istream& file, MeshFile& mesh);

} // namespace biting

#endif
