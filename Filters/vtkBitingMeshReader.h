// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingMeshReader
 * @brief   reads a mesh of triangles or tetrahedra with its tags and regions from a solver's file
 *
 * The end of the file name chooses the format:
 * - `.msh`, Gmsh 2.2 or 4.1, ASCII: physical groups; where there are none, curves, surfaces and
 *   volumes, without names;
 * - `.su2`, SU2: markers;
 * - `.14`, ADCIRC (fort.14), and `.gr3`, SCHISM (hgrid): depths, open and land boundaries;
 * - `.2dm`, SMS: materials as regions, node strings as tags, z as depth with the other sign.
 *
 * Output 0 is the mesh: a vtkUnstructuredGrid of tetrahedra where the file has some, else a
 * vtkPolyData of triangles. The cell array `RegionId` is the number of their group less 1, as
 * vtkBitingMeshWriter adds 1, and 0 where the file has no groups; points in the order of the file,
 * with `Depth` from ADCIRC, SCHISM and SMS. Output 1 are the sides that the file names: triangles
 * beside tetrahedra, else lines, with the cell array `Tag`, the number of their group, and the
 * point array `MeshPointId`, the number of the point in output 0. So they can be the tagged lines
 * of vtkBitingRemesher. Where the file has names they are in the cell arrays `RegionName` and
 * `TagName`. Markers of SU2 that are not all called by numbers are numbered from 1 on. In files of
 * ADCIRC and SCHISM the tag of open boundaries is 1, that of land 2 plus its type: 2 mainland, 3
 * islands; of weirs both sides have it. In SMS it is the number of the node string.
 *
 * What the mesh does not have of the file is said in warnings. Quads become two triangles each, by
 * the diagonal with the larger smallest angle. Of triangles, quads and edges of order 2 the corners
 * are read. A cell that is in several groups is read once, in the first of them. Other cells, edges
 * beside tetrahedra, pairs of nodes and heights of weirs are left out. Sides of no cell are
 * counted.
 *
 * A file that cannot be read is one error, with the line; outputs are empty then. That is one that
 * is cut, has a word where there should be a number, numbers of things that are not those that are
 * there, vertices that do not exist, or quads whose sides cross.
 */

#ifndef vtkBitingMeshReader_h
#define vtkBitingMeshReader_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkPointSetAlgorithm.h"

#include <memory>  // for the file
#include <utility> // for pair

namespace biting
{
struct MeshFile;
struct ReadingResult;
} // namespace biting

VTK_ABI_NAMESPACE_BEGIN

class VTKBITINGFILTERS_EXPORT vtkBitingMeshReader : public vtkPointSetAlgorithm
{
public:
  static vtkBitingMeshReader* New();
  vtkTypeMacro(vtkBitingMeshReader, vtkPointSetAlgorithm);
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

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /**
   * Reads the file, of whose cells the type of output 0 is.
   */
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBitingMeshReader(const vtkBitingMeshReader&) = delete;
  void operator=(const vtkBitingMeshReader&) = delete;

  void ReadFile();

  char* FileName = nullptr;
  std::unique_ptr<std::pair<biting::MeshFile, biting::ReadingResult>>
    File; // of what is not yet in the outputs
};
VTK_ABI_NAMESPACE_END

#endif
