// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileFromDataSet_h
#define BitingMeshFileFromDataSet_h

#include "../../IO/MeshFile.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkCellData;
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

class ValueGroups;
class WrittenParts;

/// The array of depths that need not be there.
constexpr const char* DefaultDepths = "Depth";

/// What would end the name of a group in a file: of any format, and of SU2 and its configuration.
constexpr const char* EndsOfNames = "\"\n\r";
constexpr const char* EndsOfNamesInSU2 = "\"\n\r \t%=,()";

/// What is said of the first cell that has no place in a file; empty where there is none.
std::string RefusalOfCells(vtkDataSet* mesh);

/// Reads points, and triangles with their regions. Returns why that is no mesh, empty where it is.
std::string ReadTriangles(vtkDataSet* mesh, const WrittenParts& parts, MeshFile& file);

/// Makes the mesh one of two coordinates; returns why it is none, empty where it is.
std::string MakePlanar(MeshFile& file);

/// Reads a point array; returns what is wrong with it, empty where nothing is.
std::string ReadDepths(
  vtkDataSet* mesh, const WrittenParts& parts, const std::string& name, MeshFile& file);

/// The tags of edges: the chosen array, else `Tag`, else the first that the mesher has not made,
/// else `Kind`; null where the chosen one does not exist.
vtkAbstractArray* FindTags(vtkCellData* data, const std::string& chosen);

/// Reads the edges that have a tag.
void ReadEdges(
  vtkPolyData* edges, const WrittenParts& parts, const ValueGroups& groups, MeshFile& file);

} // namespace biting

#endif
