// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SummaryText.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
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

// Without those that are not known.
double Mean(vtkDataArray* values)
{
  double sum = 0.0;
  vtkIdType count = 0;
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    const double value = values->GetTuple1(k);
    if (!std::isnan(value))
    {
      sum += value;
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

std::string Count(vtkDataSet* mesh, const char* name)
{
  return Grouped(static_cast<std::int64_t>(Figure(mesh, name)));
}

std::string SizeLines(vtkDataSet* mesh, double seconds)
{
  return Count(mesh, "NumberOfVertices") + " vertices, " + Count(mesh, "NumberOfTriangles") +
    " triangles\nMade in " + Fixed(seconds, 2) + " s\n";
}

std::string AngleLines(vtkDataSet* mesh)
{
  return "Smallest angle " + Fixed(Figure(mesh, "SmallestAngle"), 1) +
    " degrees\nMean of smallest angles " +
    Fixed(Mean(mesh->GetCellData()->GetArray("MinimumAngle")), 1) + "\n";
}

std::string ConformityLines(vtkDataSet* mesh)
{
  return "Mean conformity " + Fixed(Figure(mesh, "MeanConformity"), 3) + "\nEdges in band " +
    Percent(Figure(mesh, "ShareOfEdgesInBand")) + "\n";
}

std::string InputVerticesLines(vtkDataArray* kinds)
{
  vtkIdType count = 0;
  for (vtkIdType point = 0; point < kinds->GetNumberOfTuples(); ++point)
  {
    count += kinds->GetTuple1(point) == InputVertex ? 1 : 0;
  }
  return Percent(static_cast<double>(count) / static_cast<double>(kinds->GetNumberOfTuples())) +
    " of the vertices stand\n  because input vertices stay\n";
}

// What Boundary Tolerance and Minimum Loop Size did, or could do.
std::string DrawingLines(vtkDataSet* mesh)
{
  constexpr double LargeShare = 0.5;
  const double share = Figure(mesh, "ShareOfDrawing");
  std::string text;
  if (share > LargeShare)
  {
    text += "The drawing is much finer than the spacing:\n  " + Percent(share) +
      " of the vertices are there for it alone\n  (see Boundary Tolerance)\n";
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

// How many triangles are thin, and, where `kinds` are known, at how many of them the input has a
// say.
std::string ThinLines(vtkDataSet* mesh, vtkDataArray* kinds)
{
  vtkDataArray* angles = mesh->GetCellData()->GetArray("MinimumAngle");
  vtkNew<vtkIdList> corners;
  std::int64_t thin = 0;
  std::int64_t atInput = 0;
  for (vtkIdType cell = 0; cell < angles->GetNumberOfTuples(); ++cell)
  {
    if (angles->GetTuple1(cell) < ThinAngle)
    {
      ++thin;
      mesh->GetCellPoints(cell, corners);
      atInput += kinds && TouchesInput(corners, kinds) ? 1 : 0;
    }
  }
  const std::string text = "Triangles below 30 degrees: " + Grouped(thin);
  return thin > 0 && kinds ? text + "\n  at input vertices: " + Grouped(atInput) : text;
}

} // namespace

std::string SummaryOf(vtkDataSet* mesh, double seconds)
{
  vtkFieldData* figures = mesh->GetFieldData();
  if (!figures->HasArray("NumberOfVertices") || Figure(mesh, "NumberOfTriangles") == 0.0)
  {
    return {};
  }
  std::string text = SizeLines(mesh, seconds) + AngleLines(mesh);
  if (figures->HasArray("MeanConformity"))
  {
    text += ConformityLines(mesh);
  }
  vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind");
  if (kinds)
  {
    text += InputVerticesLines(kinds);
  }
  if (figures->HasArray("ShareOfDrawing"))
  {
    text += DrawingLines(mesh);
  }
  return text + ThinLines(mesh, kinds);
}

std::string UnreachedLine(vtkDataSet* mesh, double uniformSpacing)
{
  constexpr double RoomForTolerance = 0.98; // within 2 % is the contract for f
  vtkDataArray* spacing = mesh->GetPointData()->GetArray("Spacing");
  const bool isUnreached = spacing && spacing->GetNumberOfTuples() > 0 &&
    spacing->GetRange(0)[1] < RoomForTolerance * uniformSpacing;
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

std::string RefusalLines(const std::string& reason)
{
  constexpr std::size_t Width = 34; // of the panel, as ParaView opens it
  const std::string indent = "\n  ";
  std::istringstream words(reason);
  std::string text = "Error:";
  std::size_t column = text.size();
  for (std::string word; words >> word;)
  {
    const bool fits = column + 1 + word.size() <= Width;
    text += (fits ? " " : indent) + word;
    column = (fits ? column : indent.size() - 2) + 1 + word.size();
  }
  return text + "\n";
}

} // namespace biting
