// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingMeshWriter
 * @brief   writes a mesh of triangles or tetrahedra with its tags and regions for a solver
 *
 * The end of the file name chooses the format:
 * - `.msh`, Gmsh 4.1 ASCII: tags and regions as physical groups of sides and cells; triangles may
 *   lie in space;
 * - `.su2`, SU2: the tags of the boundary as markers; interfaces and regions are left out;
 * - `.14`, ADCIRC (fort.14), and `.gr3`, SCHISM (hgrid): open and land boundaries; islands are
 *   land around holes;
 * - `.2dm`, SMS: regions as materials, tags as node strings by their numbers, without names;
 * - `.nc`, UGRID 1.0 (NetCDF): tags and regions as flags of edges and faces, depths of nodes.
 *
 * Port 0 is the mesh: a vtkDataSet of triangles or, for `.msh` and `.su2`, of tetrahedra, whose
 * sides are triangles, not edges. Regions are the values of a cell array: RegionArray, else
 * `RegionId`, of which the physical number is the value plus 1. Those of another array have numbers
 * and names as tags do; cells whose text is empty are a group without a name. Port 1, optional, is
 * output 1 of vtkBitingMesher, vtkBitingRemesher, vtkBitingSurfaceMesher or
 * vtkBitingTetrahedralizer: lines, or the boundary's triangles, with the point array `MeshPointId`.
 * Where nothing is connected there, it is taken from the last of these filters through which the
 * mesh came. What is no side of the mesh, at the same points, gives a warning and no tags.
 *
 * Tags are the values of one cell array of port 1: TagArray, else `Tag`, else the first array that
 * the meshers have not made, else `Kind`, else the text "boundary". The physical number of a whole
 * number above 0 is that number; other values and strings are numbered on from the largest of
 * those. Names are the values; a side whose string is empty has no tag. A side of the boundary
 * without a tag is in the marker "boundary" of SU2, and not in a file of Gmsh.
 *
 * Points and lines of the mesh are no part of the file; triangles among tetrahedra and any other
 * cell are an error. Tetrahedra of negative volume are turned; some of no volume, and such as
 * overlap, are an error. Hidden and ghost cells, and cells with a hidden point, are left out, and
 * points that pieces share (the same global id at the same place) are then written once: what
 * several ranks have saved together (`.pvtp`) becomes the mesh of one. With GatherPieces several
 * ranks write one file.
 *
 * All but Gmsh have two coordinates of triangles: a mesh that is not in a plane of constant z is an
 * error for them, and so are triangles that overlap; clockwise triangles are turned. In SU2 names
 * of markers have '_' in place of blanks and other signs that end names there, with a warning. In
 * ADCIRC and SCHISM an island that is open in part is open boundary and mainland; a loop that is
 * all open is two open boundaries. In SMS z is the depth with the other sign. In UGRID all sides of
 * triangles are edges, with 0 where they have no tag, the edges of one triangle are the boundary,
 * and names have '_' in place of blanks. Numbers are written so that reading gives them back bit
 * for bit.
 *
 * Where there is an error no file is written, and one that was there stays as it was.
 */

#ifndef vtkBitingMeshWriter_h
#define vtkBitingMeshWriter_h

#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#include <string> // for reasons
#include <vector> // for names

namespace biting
{
class Ranks;
class WrittenParts;
struct MeshFile;
struct MeshGroup;
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
   * The file to write; its end chooses the format: `.msh`, `.su2`, `.14`, `.gr3`,
   * `.2dm` or `.nc`.
   */
  vtkSetStringMacro(FileName);
  vtkGetStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Cell array of the boundary that holds the tags. Empty (default): see above.
   */
  vtkSetStringMacro(TagArray);
  vtkGetStringMacro(TagArray);
  ///@}

  ///@{
  /**
   * For Gmsh, SMS and UGRID: cell array of the mesh whose values, numbers or texts, are the groups
   * of cells. Empty (default), or "None": `RegionId`.
   */
  vtkSetStringMacro(RegionArray);
  vtkGetStringMacro(RegionArray);
  ///@}

  ///@{
  /**
   * For ADCIRC and SCHISM: the tags of open boundaries, with blanks or commas between; tags may
   * have some, too. A word that is no tag of the boundary is an error. Empty (default): none, all
   * is land.
   */
  vtkSetStringMacro(OpenTags);
  vtkGetStringMacro(OpenTags);
  ///@}

  ///@{
  /**
   * For ADCIRC, SCHISM, SMS and UGRID: the point array of depths, positive downwards. Default
   * `Depth`: where it does not exist depths are 0, and UGRID has none. Any other array that does
   * not exist, and depths that are not finite, are errors.
   */
  vtkSetStringMacro(DepthArray);
  vtkGetStringMacro(DepthArray);
  ///@}

  enum CoordinatesType
  {
    PLANE = 0,
    LONGITUDE_LATITUDE = 1
  };

  ///@{
  /**
   * For UGRID: what x and y are, lengths in a plane, in metres there, or degrees of longitude and
   * latitude, as for vtkBitingMesher. Default PLANE.
   */
  vtkSetClampMacro(Coordinates, int, PLANE, LONGITUDE_LATITUDE);
  vtkGetMacro(Coordinates, int);
  ///@}

  ///@{
  /**
   * Whether all processes of the global controller call Write together: then each gives its piece,
   * and the first one writes the file. Off (default): each process writes what it has.
   */
  vtkSetMacro(GatherPieces, bool);
  vtkGetMacro(GatherPieces, bool);
  vtkBooleanMacro(GatherPieces, bool);
  ///@}

  /**
   * Port 1: the boundary's edges, or its triangles.
   */
  void SetBoundaryEdgesConnection(vtkAlgorithmOutput* edges);

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkBitingMeshWriter();
  ~vtkBitingMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkBitingMeshWriter(const vtkBitingMeshWriter&) = delete;
  void operator=(const vtkBitingMeshWriter&) = delete;

  biting::Ranks WritingRanks() const;
  void Refuse(const std::string& reason);
  vtkPolyData* FindEdges();
  void WarnOfEdges(vtkPolyData* edges);
  std::string WriteMesh(vtkDataSet* mesh, vtkPolyData* edges);
  std::string ReadTags(vtkDataSet* mesh, vtkPolyData* edges, const biting::WrittenParts& parts,
    biting::MeshFile& file);
  void TakeNames(const std::vector<biting::MeshGroup>& names, biting::MeshFile& file);
  std::string WriteFile(const biting::MeshFile& file);

  char* FileName = nullptr;
  char* TagArray = nullptr;
  char* RegionArray = nullptr;
  char* OpenTags = nullptr;
  char* DepthArray = nullptr;
  int Coordinates = PLANE;
  bool GatherPieces = false;
};
VTK_ABI_NAMESPACE_END

#endif
