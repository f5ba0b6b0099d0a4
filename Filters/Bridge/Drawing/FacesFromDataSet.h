// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFacesFromDataSet_h
#define BitingFacesFromDataSet_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Base/Point.h"
#include "../../Kernel/Domain/Polylines.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "PlaneFrame.h"

#include "vtkType.h" // for vtkIdType

#include <string> // for the refusal
#include <vector> // for the arrays

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Which cells of two dimensions are read; any other is a refusal.
enum class FaceRule
{
  Triangles, ///< linear ones
  Polygons   ///< linear cells of any number of corners
};

/// The faces of a dataset in its plane. Only points that a face uses are vertices.
struct PlanarFaces
{
  PlaneFrame Frame;
  std::vector<vtkIdType> PointIds; ///< of each vertex; ascending, until ordered by place
  std::vector<Point2> Points;      ///< of each vertex
  std::vector<vtkIdType> CellIds;  ///< of each face; likewise
  std::vector<Id> Offsets{ 0 };    ///< face c has Corners[Offsets[c] .. Offsets[c + 1])
  std::vector<Id> Corners;         ///< vertices
  double Rounding = 0.0;           ///< of the coordinates (CoordinateRounding.h)
  bool IsOnGlobe = false;          ///< x and y are degrees (Globe.h); set before it is read
};

/// Reads the faces of `data` and fits their plane, on the globe that of FitGlobe. Cells of less
/// than two dimensions, hidden and ghost cells, and cells with a hidden point, are left out. Reads
/// without changing anything of `data`. Returns a refusal: of the first cell that is no such face,
/// or refers to a point that does not exist; of more points or corners than 32-bit ids can number,
/// coordinates that are not finite or beyond GreatestCoordinate, a mesh smaller than
/// LeastCoordinate, points farther from the plane than PlanarTolerance. Where the monitor asks to
/// stop `faces` have no meaning.
std::string FacesFromDataSet(vtkDataSet* data, FaceRule rule, PlanarFaces& faces, Monitor& monitor);

/// Sorts the vertices by place, rotates each face to begin with its lowest vertex, and sorts the
/// faces: results are then the same to the last bit for any order of points and cells, as after
/// joining pieces of ranks. Vertices at one place, and faces of the same vertices, keep their
/// order.
void OrderByPlace(PlanarFaces& faces);

/// The outlines of the faces, as closed chains: a place in an odd number of them is in the mesh.
Polylines OutlinesOf(const PlanarFaces& faces);

} // namespace biting

#endif
