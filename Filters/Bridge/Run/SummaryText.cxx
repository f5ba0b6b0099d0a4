// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SummaryText.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>   // for isnan
#include <iomanip> // for setprecision
#include <sstream> // for numbers

namespace biting
{

namespace
{

// Below this a triangle is thin.
constexpr double ThinAngle = 30.0;
constexpr double InputVertex = 0.0; // the value of `VertexKind`

// With a space before each three digits.
std::string Grouped(std::int64_t count)
{
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;)
  {
    place -= 3;
    text.insert(place, " ");
  }
  return text;
}

std::string Fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string Percent(double share)
{
  return Fixed(100.0 * share, 1) + " %";
}

double Figure(vtkDataSet* mesh, const char* name)
{
  return mesh->GetFieldData()->GetArray(name)->GetTuple1(0);
}

std::string Count(vtkDataSet* mesh, const char* name)
{
  return Grouped(static_cast<std::int64_t>(Figure(mesh, name)));
}

// Short times are not told apart: they say nothing of the mesh.
std::string SizeLines(vtkDataSet* mesh, double seconds)
{
  return Count(mesh, "NumberOfVertices") + " vertices, " + Count(mesh, "NumberOfTriangles") +
    " triangles\nMade in " +
    (seconds < 1.0 ? "less than a second" : Fixed(seconds, 0) + " s, without its display") + "\n";
}

double Share(double part, double whole)
{
  return whole > 0.0 ? part / whole : 0.0;
}

std::string AngleLines(vtkDataSet* mesh, const SummaryCounts& counts)
{
  return "Smallest angle " + Fixed(Figure(mesh, "SmallestAngle"), 1) +
    " degrees\nMean of smallest angles " + Fixed(Share(counts.SumOfAngles, counts.Triangles), 1) +
    " degrees\n";
}

std::string ConformityLines(vtkDataSet* mesh)
{
  return "Mean conformity " + Fixed(Figure(mesh, "MeanConformity"), 3) +
    " (best: 1)\nEdges of 0.7 to 1.4 spacings: " + Percent(Figure(mesh, "ShareOfEdgesInBand")) +
    "\n";
}

// The effect of Boundary Tolerance and Minimum Loop Size, and a hint where the drawing is fine.
std::string DrawingLines(vtkDataSet* mesh)
{
  constexpr double LargeShare = 0.5;
  const double share = Figure(mesh, "ShareOfDrawing");
  std::string text;
  if (share > LargeShare)
  {
    text += "The drawing is much finer than the spacing: " + Percent(share) +
      " of the vertices are there for it alone. With a Boundary Tolerance, such as 0.2, the mesh "
      "follows the spacing.\n";
  }
  const bool isRemeshed = mesh->GetFieldData()->HasArray("KeptVertices"); // those of the old mesh
  if (!isRemeshed && Figure(mesh, "RemovedVertices") > 0.0)
  {
    text += Count(mesh, "RemovedVertices") + " points of the drawing not needed\n";
  }
  if (Figure(mesh, "LeftOutLoops") > 0.0)
  {
    text += Count(mesh, "LeftOutLoops") + " small loops left out\n";
  }
  return text;
}

bool TouchesInput(vtkIdList* corners, vtkDataArray* kinds)
{
  for (const vtkIdType corner : *corners)
  {
    if (kinds->GetTuple1(corner) == InputVertex)
    {
      return true;
    }
  }
  return false;
}

// The number of thin triangles, and, where kinds are known, of those with a vertex of the input.
std::string ThinLines(const SummaryCounts& counts, bool areKindsKnown)
{
  const auto grouped = [](double count) { return Grouped(static_cast<std::int64_t>(count)); };
  return "Triangles below 30 degrees: " + grouped(counts.Thin) +
    (counts.Thin > 0.0 && areKindsKnown
        ? ", of these at input vertices: " + grouped(counts.ThinAtInput)
        : "") +
    "\n";
}

bool IsGhost(vtkDataArray* marks, vtkIdType k)
{
  return marks && marks->GetTuple1(k) != 0.0;
}

void CountTriangles(
  vtkDataSet* mesh, vtkDataArray* marks, vtkDataArray* kinds, SummaryCounts& counts)
{
  vtkDataArray* angles = mesh->GetCellData()->GetArray("MinimumAngle");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; angles && cell < angles->GetNumberOfTuples(); ++cell)
  {
    const double angle = angles->GetTuple1(cell);
    if (std::isnan(angle) || IsGhost(marks, cell)) // not known, or another's
    {
      continue;
    }
    counts.Triangles += 1.0;
    counts.SumOfAngles += angle;
    if (angle < ThinAngle)
    {
      counts.Thin += 1.0;
      mesh->GetCellPoints(cell, corners);
      counts.ThinAtInput += kinds && TouchesInput(corners, kinds) ? 1.0 : 0.0;
    }
  }
}

// `areGhostsLeftOut`: where arrays of marks come from the input they say nothing of the mesh.
SummaryCounts CountAll(vtkDataSet* mesh, bool areGhostsLeftOut)
{
  const auto marks = [areGhostsLeftOut](vtkDataSetAttributes* data)
  { return areGhostsLeftOut ? data->GetArray(vtkDataSetAttributes::GhostArrayName()) : nullptr; };
  SummaryCounts counts;
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  CountTriangles(mesh, marks(mesh->GetCellData()), kinds, counts);
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  counts.LargestSpacing =
    spacing && spacing->GetNumberOfTuples() > 0 ? spacing->GetRange(0)[1] : 0.0;
  return counts;
}

} // namespace

SummaryCounts CountForSummary(vtkDataSet* mesh)
{
  return CountAll(mesh, true);
}

std::string SummaryOf(vtkDataSet* mesh, double seconds)
{
  return SummaryOf(mesh, CountAll(mesh, false), seconds);
}

std::string SummaryOf(vtkDataSet* mesh, const SummaryCounts& counts, double seconds)
{
  vtkFieldData* figures = mesh->GetFieldData();
  if (!figures->HasArray("NumberOfVertices") || Figure(mesh, "NumberOfTriangles") == 0.0)
  {
    return {};
  }
  std::string text = SizeLines(mesh, seconds) + AngleLines(mesh, counts);
  if (figures->HasArray("MeanConformity"))
  {
    text += ConformityLines(mesh);
  }
  if (figures->HasArray("ShareOfDrawing"))
  {
    text += DrawingLines(mesh);
  }
  return text + ThinLines(counts, mesh->GetPointData()->HasArray("VertexKind") != 0);
}

std::string UnreachedLine(const SummaryCounts& counts, double uniformSpacing)
{
  constexpr double RoomForTolerance = 0.98; // within 2 % is the contract for f
  const bool isUnreached =
    counts.LargestSpacing > 0.0 && counts.LargestSpacing < RoomForTolerance * uniformSpacing;
  return isUnreached
    ? "Uniform Spacing has no effect: other spacings, or the size of features, are "
      "smaller everywhere.\n"
    : "";
}

std::string CountsOf(vtkDataSet* mesh)
{
  vtkFieldData* data = mesh->GetFieldData();
  if (!data->HasArray("KeptTriangles"))
  {
    return {};
  }
  const auto count = [data](const char* name)
  { return std::to_string(static_cast<vtkIdType>(data->GetArray(name)->GetComponent(0, 0))); };
  return count("KeptVertices") + " vertices kept, " + count("RemovedVertices") + " removed, " +
    count("NewVertices") + " new\n" + count("KeptTriangles") + " triangles unchanged\n";
}

} // namespace biting
