// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneCut.h"

#include "../../Kernel/Base/SortInSteps.h"

#include <algorithm>  // for unique, lower_bound
#include <array>      // for nodes of a polygon
#include <functional> // for less
#include <tuple>      // for tie

namespace biting
{

namespace
{

// Points on one side of the plane, at most all four of a tetrahedron.
struct Side
{
  std::array<vtkIdType, 4> Points{};
  int Size = 0;

  void Add(vtkIdType point) { this->Points[static_cast<std::size_t>(this->Size++)] = point; }
  vtkIdType operator[](int k) const { return this->Points[static_cast<std::size_t>(k)]; }
};

} // namespace

bool PlaneCut::Edge::operator<(const Edge& other) const
{
  return std::tie(this->Low, this->High) < std::tie(other.Low, other.High);
}

bool PlaneCut::Edge::operator==(const Edge& other) const
{
  return this->Low == other.Low && this->High == other.High;
}

PlaneCut::PlaneCut(const std::vector<double>& distances)
  : Distances(distances)
{
}

void PlaneCut::AddTetrahedron(const vtkIdType* points)
{
  Side below;
  Side on;
  Side above;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double distance = this->Distances[static_cast<std::size_t>(points[corner])];
    Side& side = distance < 0.0 ? below : (distance > 0.0 ? above : on);
    side.Add(points[corner]);
  }
  const int crossings = below.Size * above.Size;
  if (crossings + on.Size < 3 || on.Size == 4)
  {
    return;
  }
  std::array<vtkIdType, 4> nodes{};
  int size = 0;
  for (int b = 0; b < below.Size; ++b)
  {
    for (int a = 0; a < above.Size; ++a)
    {
      // Every second row backwards, so that the four nodes go around their quadrilateral.
      const int turned = b % 2 == 0 ? a : above.Size - 1 - a;
      nodes[static_cast<std::size_t>(size++)] = this->EdgeNode(below[b], above[turned]);
    }
  }
  for (int k = 0; k < on.Size; ++k)
  {
    nodes[static_cast<std::size_t>(size++)] = on[k];
  }
  this->AddPolygon(nodes.data(), size);
}

void PlaneCut::AddTriangle(const vtkIdType* points)
{
  this->AddPolygon(points, 3);
}

void PlaneCut::AddPolygon(const vtkIdType* nodes, int size)
{
  for (int k = 1; k + 1 < size; ++k)
  {
    this->Triangles.insert(this->Triangles.end(), { nodes[0], nodes[k], nodes[k + 1] });
  }
}

vtkIdType PlaneCut::EdgeNode(vtkIdType below, vtkIdType above)
{
  this->Edges.push_back({ below, above });
  return static_cast<vtkIdType>(this->Distances.size() + this->Edges.size()) - 1;
}

void PlaneCut::MergeEdges(Pulse& pulse)
{
  const std::vector<Edge> given = this->Edges;
  if (!SortInSteps(this->Edges, std::less<Edge>(), pulse))
  {
    return;
  }
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  pulse.ForEach(this->Triangles.size(),
    [this, &given, numberOfPoints](std::size_t k)
    {
      vtkIdType& node = this->Triangles[k];
      if (node >= numberOfPoints)
      {
        const Edge& edge = given[static_cast<std::size_t>(node - numberOfPoints)];
        const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge);
        node = numberOfPoints + static_cast<vtkIdType>(found - this->Edges.begin());
      }
    });
}

double PlaneCut::Fraction(const Edge& edge) const
{
  const double low = this->Distances[static_cast<std::size_t>(edge.Low)];
  const double high = this->Distances[static_cast<std::size_t>(edge.High)];
  return low / (low - high);
}

} // namespace biting
