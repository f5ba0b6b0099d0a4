// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// How well meshes follow their spacing, on fields of all kinds of sources.
//   BenchmarkFields
// A row a field: vertices; mean length of edges over f, share of edges within [1/sqrt(2), sqrt(2)]
// f in per cent, and mean conformity: of all, of what is inside, and of what lies on segments; the
// mean of the triangles' smallest angles. An edge is on a segment where it covers a part of one.
// ADCIRC's are there where BITING_SHARED_INPUTS names a folder that has them.

#include "MeshCases.h"

#include <algorithm> // for min, max
#include <cmath>     // for the band
#include <cstdio>    // for tables
#include <set>       // for edges on segments
#include <utility>   // for edges

namespace
{

using namespace biting;

using Edge = std::pair<Id, Id>;

Edge EdgeOf(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Sums over edges and vertices.
struct FieldSums
{
  double Edges = 0.0;
  double Lengths = 0.0; ///< over f
  double InBand = 0.0;
  double Vertices = 0.0;
  double Conformities = 0.0;

  void AddEdge(double length)
  {
    this->Edges += 1.0;
    this->Lengths += length;
    this->InBand += length >= std::sqrt(0.5) && length <= std::sqrt(2.0) ? 1.0 : 0.0;
  }

  void AddVertex(double conformity)
  {
    this->Vertices += 1.0;
    this->Conformities += conformity;
  }

  void Print() const
  {
    std::printf(" %.3f %6.2f %.3f |", this->Lengths / this->Edges,
      100.0 * this->InBand / this->Edges, this->Conformities / this->Vertices);
  }
};

/// Inside, and on segments.
struct FieldScores
{
  FieldSums All;
  FieldSums Inner;
  FieldSums OnSegments;
};

void AddEdges(const BitingMesh& mesh, FieldScores& scores)
{
  std::set<Edge> onSegments;
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    onSegments.insert(EdgeOf(mesh.EdgeStarts[edge], mesh.EdgeEnds[edge]));
  }
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const Id next = mesh.Neighbors[slot];
    if (next != NoId && static_cast<std::size_t>(next) < slot / 3)
    {
      continue;
    }
    const std::size_t first = slot - slot % 3;
    const Id a = mesh.Corners[first + (slot + 1) % 3];
    const Id b = mesh.Corners[first + (slot + 2) % 3];
    const double length =
      2.0 * Distance(mesh.Points[a], mesh.Points[b]) / (mesh.Spacing[a] + mesh.Spacing[b]);
    scores.All.AddEdge(length);
    (onSegments.count(EdgeOf(a, b)) > 0 ? scores.OnSegments : scores.Inner).AddEdge(length);
  }
}

void AddVertices(const BitingMesh& mesh, FieldScores& scores)
{
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const double conformity = mesh.Quality.Conformity[vertex];
    scores.All.AddVertex(conformity);
    (mesh.Kinds[vertex] == VertexKind::Interior ? scores.Inner : scores.OnSegments)
      .AddVertex(conformity);
  }
}

double MeanAngle(const BitingMesh& mesh)
{
  double sum = 0.0;
  for (const double angle : mesh.Quality.MinimumAngle)
  {
    sum += angle;
  }
  return sum / static_cast<double>(mesh.Quality.MinimumAngle.size());
}

void PrintField(const MeshCase& field)
{
  if (field.Drawing.Points.empty())
  {
    std::printf("| %-20s | no such file\n", field.Name.c_str());
    return;
  }
  ProblemList problems;
  const BitingMesh mesh = MakeBitingMesh(field.Drawing, field.Options, problems, NoMonitor());
  FieldScores scores;
  AddEdges(mesh, scores);
  AddVertices(mesh, scores);
  std::printf("| %-20s | %6zu |", field.Name.c_str(), mesh.Points.size());
  scores.All.Print();
  scores.Inner.Print();
  scores.OnSegments.Print();
  std::printf(" %.2f |\n", MeanAngle(mesh));
}

} // namespace

int main()
{
  std::printf("Vertices; length over f, share in band (%%), conformity: of all, inside, on "
              "segments; mean angle\n");
  for (const MeshCase& field : FieldCases())
  {
    PrintField(field);
  }
  return 0;
}
