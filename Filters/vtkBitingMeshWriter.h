// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingMeshWriter
 * @brief   writes a triangle mesh with its tags and regions for a solver
 *
 * The end of the file name chooses the format:
 * - `.msh`, Gmsh 4.1 ASCII: tags and regions as physical groups of edges and triangles;
 * - `.su2`, SU2: the tags of the boundary as markers; interfaces and regions are left out;
 * - `.14`, ADCIRC (fort.14): open and land boundaries; islands are land around holes.
 *
 * Port 0 is the mesh: a vtkDataSet of triangles; other cells are passed over. Regions are the
 * values of its cell array `RegionId`; the physical number is the value plus 1. Port 1, optional,
 * is output 1 of vtkBitingMesher or vtkBitingRemesher: lines with the point array `MeshPointId`.
 * Where nothing is connected there, it is taken from the last of these filters through which the
 * mesh came. Lines that are not edges of the mesh, at the same points, give a warning and no tags.
 *
 * Tags are the values of one cell array of port 1: TagArray, else `Tag`, else the first array that
 * the mesher has not made, else `Kind`. The physical number of a whole number above 0 is that
 * number; other values and strings are numbered on from the largest of those. Names are the values;
 * an edge whose string is empty has no tag.
 *
 * Points and lines of the mesh are no part of the file; any other cell that is no triangle is an
 * error. Hidden and ghost cells, and cells with a hidden point, are left out, and points that
 * pieces share (the same global id at the same place) are then written once: what several ranks
 * have saved together (`.pvtp`) becomes the mesh of one.
 *
 * SU2 and ADCIRC have two coordinates: a mesh that is not in a plane of constant z is an error for
 * them. Numbers are written so that reading gives them back bit for bit.
 */

#ifndef vtkBitingMeshWriter_h
#define vtkBitingMeshWriter_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#include <string> // for reasons

namespace biting
{
class WrittenParts;
struct MeshFile;
} // namespace biting

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;

class VTKBITINGFILTERS_EXPORT vtkBitingMeshWriter : public vtkWriter
{
public:
  static vtkBitingMeshWriter* New();
  vtkTypeMacro(vtkBitingMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write; its end chooses the format: `.msh`, `.su2` or `.14`.
   */
  vtkSetStringMacro(FileName);
  vtkGetStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Cell array of the boundary edges that holds the tags. Empty (default): see above.
   */
  vtkSetStringMacro(TagArray);
  vtkGetStringMacro(TagArray);
  ///@}

  ///@{
  /**
   * For ADCIRC: the tags of open boundaries, with blanks or commas between. Empty (default): none,
   * all is land.
   */
  vtkSetStringMacro(OpenTags);
  vtkGetStringMacro(OpenTags);
  ///@}

  ///@{
  /**
   * For ADCIRC: the point array of depths, positive downwards. Default `Depth`; 0 where it does not
   * exist.
   */
  vtkSetStringMacro(DepthArray);
  vtkGetStringMacro(DepthArray);
  ///@}

  /**
   * Port 1: the boundary edges.
   */
  void SetBoundaryEdgesConnection(vtkAlgorithmOutput* edges);

protected:
  vtkBitingMeshWriter();
  ~vtkBitingMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkBitingMeshWriter(const vtkBitingMeshWriter&) = delete;
  void operator=(const vtkBitingMeshWriter&) = delete;

  void Refuse(const std::string& reason);
  vtkPolyData* FindEdges();
  void WarnOfEdges(vtkPolyData* edges);
  bool ReadTags(vtkDataSet* mesh, const biting::WrittenParts& parts, biting::MeshFile& file);
  void WriteFile(const biting::MeshFile& file);

  char* FileName = nullptr;
  char* TagArray = nullptr;
  char* OpenTags = nullptr;
  char* DepthArray = nullptr;
};
VTK_ABI_NAMESPACE_END

#endif
