// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileReading_h
#define BitingMeshFileReading_h

#include "MeshFile.h"

#include <istream> // for files
#include <string>  // for reasons
#include <vector>  // for remarks

/**
 * Meshes of triangles from the text formats of solvers, made by any program. Vertices keep the
 * order that they have in the file, whatever their numbers there. Quads become two triangles each
 * (Quality/QuadDiagonal.h). Of cells of order 2 the corners are read, and vertices that are no
 * corner of another cell are left out. A cell that is listed once for each of its groups is read
 * once, in the first of them.
 */
namespace biting
{

/// What came of reading a file.
struct ReadingResult
{
  std::string Reason;               // why there is no mesh, with the line; empty where there is one
  std::vector<std::string> Remarks; // sentences: what of the file the mesh does not have
};

/// Gmsh 2.2 and 4.1, ASCII. Groups are the physical groups; where the file has none, the curves
/// and surfaces themselves, without names.
ReadingResult ReadGmsh(std::istream& file, MeshFile& mesh);

/// SU2 of two dimensions: markers as tags. Markers keep the numbers that they are called by if all
/// are whole numbers from 1 to 2147483647, else they are numbered from 1 on.
ReadingResult ReadSU2(std::istream& file, MeshFile& mesh);

/// ADCIRC grid (fort.14): depths; tag 1 for open boundaries, 2 and the type added for land: 2
/// mainland, 3 island and so on. Both sides of weirs with pairs of nodes have the tag of their
/// type.
ReadingResult ReadADCIRC(std::istream& file, MeshFile& mesh);

} // namespace biting

#endif
