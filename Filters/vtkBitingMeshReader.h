// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingMeshReader
 * @brief   reads a triangle mesh with its tags and regions from the file of a solver
 *
 * The end of the file name chooses the format:
 * - `.msh`, Gmsh 2.2 or 4.1, ASCII: physical groups; where there are none, curves and surfaces,
 *   without names;
 * - `.su2`, SU2 of two dimensions: markers;
 * - `.14`, ADCIRC (fort.14), and `.gr3`, SCHISM (hgrid): depths, open and land boundaries;
 * - `.2dm`, SMS: materials as regions, node strings as tags, z as depth with the other sign.
 *
 * Output 0 is the mesh: triangles with the cell array `RegionId`, the number of their group less
 * 1, as vtkBitingMeshWriter adds 1, and 0 where the file has no groups; points in the order of the
 * file, with `Depth` from ADCIRC, SCHISM and SMS.
 * Output 1 are the edges that the file names: lines with the cell array `Tag`, the number of their
 * group, and the point array `MeshPointId`, the number of the point in output 0. So they can be the
 * tagged lines of vtkBitingRemesher. Where the file has names they are in the cell arrays
 * `RegionName` and `TagName`. Markers of SU2 that are not all called by numbers are numbered from 1
 * on. In files of ADCIRC and SCHISM the tag of open boundaries is 1, that of land 2 plus its type:
 * 2 mainland, 3 islands; of weirs both sides have it. In SMS it is the number of the node string.
 *
 * What the mesh does not have of the file is said in warnings. Quads become two triangles each, by
 * the diagonal with the larger smallest angle. Of triangles, quads and edges of order 2 the corners
 * are read. A cell that is in several groups is read once, in the first of them. Other cells, pairs
 * of nodes and heights of weirs are left out. Edges that are no side of a triangle are counted.
 *
 * A file that cannot be read is one error, with the line; outputs are empty then. That is one that
 * is cut, has a word where there should be a number, numbers of things that are not those that are
 * there, vertices that do not exist, or quads whose sides cross.
 */

#ifndef vtkBitingMeshReader_h
#define vtkBitingMeshReader_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKBITINGFILTERS_EXPORT vtkBitingMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkBitingMeshReader* New();
  vtkTypeMacro(vtkBitingMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputPorts
  {
    MESH = 0,
    BOUNDARY_EDGES = 1
  };

  ///@{
  /**
   * The file to read; its end chooses the format: `.msh`, `.su2`, `.14`, `.gr3` or `.2dm`.
   */
  vtkSetStringMacro(FileName);
  vtkGetStringMacro(FileName);
  ///@}

protected:
  vtkBitingMeshReader();
  ~vtkBitingMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingMeshReader(const vtkBitingMeshReader&) = delete;
  void operator=(const vtkBitingMeshReader&) = delete;

  char* FileName = nullptr;
};
VTK_ABI_NAMESPACE_END

#endif
