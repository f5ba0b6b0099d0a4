// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FineDrawing.h"

#include <algorithm> // for max

namespace biting
{

namespace
{

constexpr double ShortLength = 0.5;

// Where most segments are longer than this many f, or next to no vertex is of the drawing, there is
// nothing to tell, and the given spacing need not be asked for.
constexpr double LongLength = 2.0;
constexpr double LeastShareOfVertices = 0.02;

constexpr double LargeShare = 0.5;
constexpr double ManyVertices = 500.0;

constexpr double VerticesPerDensity = 1.1547005383792515; // 2 / sqrt(3): equilateral triangles

// The mean length of the segments at each vertex; 0 where there is none.
std::vector<double> MeanLengths(const Domain& drawing)
{
  std::vector<double> lengths(drawing.Vertices.size(), 0.0);
  std::vector<Id> counts(drawing.Vertices.size(), 0);
  for (Id segment = 0; segment < drawing.NumberOfSegments(); ++segment)
  {
    const Id start = drawing.Starts[segment];
    const Id end = drawing.Ends[segment];
    const double length = Distance(drawing.Vertices[start], drawing.Vertices[end]);
    for (const Id vertex : { start, end })
    {
      lengths[vertex] += length;
      ++counts[vertex];
    }
  }
  for (std::size_t vertex = 0; vertex < lengths.size(); ++vertex)
  {
    lengths[vertex] /= std::max<Id>(1, counts[vertex]);
  }
  return lengths;
}

// Whether most of the lengths are below a share of the values.
template <typename Values>
bool AreMostBelow(const std::vector<double>& lengths, double share, const Values& valueAt)
{
  std::size_t count = 0;
  for (std::size_t vertex = 0; vertex < lengths.size(); ++vertex)
  {
    count += lengths[vertex] > 0.0 && lengths[vertex] < share * valueAt(vertex) ? 1 : 0;
  }
  return 2 * count > lengths.size();
}

} // namespace

bool IsFineDrawing(const Domain& drawing, const std::vector<double>& spacings,
  double numberOfVertices, const Spacing& spacing)
{
  const std::vector<double> lengths = MeanLengths(drawing);
  // The vertices of the drawing are the first of the mesh, and few are missing there.
  const std::size_t known = spacings.size();
  return static_cast<double>(lengths.size()) > LeastShareOfVertices * numberOfVertices &&
    AreMostBelow(lengths, LongLength,
      [&spacings, known](std::size_t vertex) { return vertex < known ? spacings[vertex] : 0.0; }) &&
    AreMostBelow(lengths, ShortLength,
      [&drawing, &spacing](std::size_t vertex)
      { return spacing.BeforeFeatures(drawing.Vertices[vertex]); });
}

ExactSum CountAsked(const BitingMesh& mesh, const Spacing& spacing, Pulse& pulse)
{
  ExactSum density;
  for (std::size_t corner = 0; corner < mesh.Corners.size() && pulse.Beat(16); corner += 3)
  {
    if (mesh.Piece.IsPart && mesh.Piece.Levels[corner / 3] != 0)
    {
      continue;
    }
    const Point2& a = mesh.Points[mesh.Corners[corner]];
    const Point2& b = mesh.Points[mesh.Corners[corner + 1]];
    const Point2& c = mesh.Points[mesh.Corners[corner + 2]];
    const double value = spacing.BeforeFeatures(a + (1.0 / 3.0) * ((b - a) + (c - a)));
    density.Add(0.5 * Cross(b - a, c - a) / (value * value));
  }
  return density;
}

double ShareOfFineDrawing(const ExactSum& asked, double numberOfVertices)
{
  return std::max(0.0, 1.0 - VerticesPerDensity * asked.Value() / numberOfVertices);
}

bool IsWorthTelling(double shareOfDrawing, double numberOfVertices)
{
  return shareOfDrawing > LargeShare && shareOfDrawing * numberOfVertices >= ManyVertices;
}

} // namespace biting
