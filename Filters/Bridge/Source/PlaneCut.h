// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPlaneCut_h
#define BitingPlaneCut_h

#include "../../Kernel/Base/Pulse.h"

#include "vtkType.h" // for vtkIdType

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

} // namespace biting

#endif
