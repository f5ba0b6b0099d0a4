// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceCells_h
#define BitingSourceCells_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../Data/CarriedArrays.h"
#include "../Data/Cells.h"
#include "../Drawing/PlaneFrame.h"

#include "vtkCellType.h"     // for the number of types
#include "vtkDataSet.h"      // for the source
#include "vtkGenericCell.h"  // for the cell at work
#include "vtkIdList.h"       // for its points
#include "vtkNew.h"          // for what is used again
#include "vtkPoints.h"       // for their places
#include "vtkSmartPointer.h" // for the source
#include "vtkType.h"         // for vtkIdType

#include <array>  // for dimensions
#include <memory> // for the triangulation
#include <string> // for the refusal
#include <vector> // for the arrays

namespace biting
{

/// The cut of tetrahedra by a plane, as triangles over nodes. Nodes below the number of points are
/// points of the data; node numberOfPoints + k lies on edge k, between its ends.
/// Tetrahedra are given one by one; a face that lies in the plane is part of the cut.
class PlaneCut
{
public:
  /// An edge from below the plane to above it.
  struct Edge
  {
    vtkIdType Low;
    vtkIdType High;
    bool operator<(const Edge& other) const;
    bool operator==(const Edge& other) const;
  };

  /// `distances`: signed distance of every point from the plane; must outlive this.
  explicit PlaneCut(const std::vector<double>& distances);

  /// Adds what the plane cuts from the tetrahedron with these four points.
  void AddTetrahedron(const vtkIdType* points);

  /// Adds a triangle that lies in the plane.
  void AddTriangle(const vtkIdType* points);

  /// Makes equal edges one node. Call once, after the last cell.
  void MergeEdges(Pulse& pulse);

  const std::vector<vtkIdType>& GetTriangles() const { return this->Triangles; }
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /// How far along the edge, from Low to High, the plane lies: in (0, 1).
  double Fraction(const Edge& edge) const;

private:
  vtkIdType EdgeNode(vtkIdType below, vtkIdType above);
  void AddPolygon(const vtkIdType* nodes, int size);

  const std::vector<double>& Distances;
  std::vector<vtkIdType> Triangles;
  std::vector<Edge> Edges;
};

/// Where steps of reading a source end, as shares of the time: looking for a grid, reading cells.
/// Sorting their triangles follows.
constexpr double GridEnd = 0.1;
constexpr double TrianglesEnd = 0.9;

/// Turns the cells of any data into triangles of the plane: those with an area are triangulated and
/// projected, those with a volume split into tetrahedra and cut. Hidden and ghost cells, and cells
/// with a hidden point, are left out.
class SourceCells
{
public:
  SourceCells(vtkDataSet* source, const PlaneFrame& frame, Pulse& pulse);

  /// Why there are no triangles, empty where there are. To be called first.
  std::string Collect();

  /// Of the source, ascending.
  std::vector<vtkIdType> UsedPoints() const;

  /// What the points of Triangulation are of those of the source.
  std::vector<TupleMix> Origins() const;

  /// `values` are those at the points of the source.
  std::shared_ptr<TriangulatedSource> Triangulation(const double* values) const;

private:
  void MeasureDistances();
  void CollectCells();
  int Dimension(int cellType);
  bool IsSource(vtkIdType cell);
  bool MeetsPlane() const;
  void AddCell(vtkIdType cell, int dimension);
  std::size_t NumberOfNodes() const { return this->Distances.size() + this->Cut.GetEdges().size(); }
  Point2 PlaceOf(vtkIdType node) const;
  double ValueOf(vtkIdType node, const double* values) const;

  vtkSmartPointer<vtkDataSet> Source; // a shallow copy: asking it for cells changes nothing shared
  const PlaneFrame& Frame;
  Pulse& Beats;
  const GhostArrays Ghosts;
  std::vector<double> Distances;
  PlaneCut Cut;
  bool HasCells;
  bool HasVolumes = false;
  std::string Malformed; ///< what is said of the cell that has a point which does not exist
  std::array<int, VTK_NUMBER_OF_CELL_TYPES> Dimensions;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkPoints> Places;
};

} // namespace biting

#endif
