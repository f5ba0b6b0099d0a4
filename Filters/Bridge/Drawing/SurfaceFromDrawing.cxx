// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceFromDrawing.h"

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Predicates/Predicates3.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Run/ProblemReport.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm> // for min, sort, unique
#include <cmath>     // for abs
#include <limits>    // for the size check

namespace biting
{

namespace
{

// Adds the cells of one block after the other to a surface.
class SurfaceReader
{
public:
  SurfaceReader(SurfaceMesh& mesh, Pulse& pulse)
    : Mesh(mesh)
    , Beats(pulse)
  {
  }

  std::string Read(const DrawingBlock& block);

private:
  std::string ReadCells(vtkCellArray* cells, int type);
  std::string AddCell(int type);
  void AddStrip();
  void AddFace();
  void AddQuad();
  void AddPolygon();
  void Add(std::size_t a, std::size_t b, std::size_t c);
  const Point3& At(std::size_t k) const
  {
    return this->Mesh.Points[this->FirstPoint + this->Outline[k]];
  }

  SurfaceMesh& Mesh;
  Pulse& Beats;
  const GhostArrays* Ghosts = nullptr;
  vtkIdType NumberOfPoints = 0;
  vtkIdType FirstPoint = 0;
  vtkIdType FirstCell = 0;
  vtkIdType Cell = 0; ///< in the block
  vtkNew<vtkIdList> Points;
  std::vector<vtkIdType> Outline; ///< of the cell at hand
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ears;
};

std::string SurfaceReader::Read(const DrawingBlock& block)
{
  const GhostArrays ghosts(block.Data);
  this->Ghosts = &ghosts;
  this->NumberOfPoints = block.Data->GetNumberOfPoints();
  this->FirstPoint = block.FirstPoint;
  this->FirstCell = block.FirstCell;
  this->Cell = 0;
  if (auto* polyData = vtkPolyData::SafeDownCast(block.Data))
  {
    // By its lists: asking poly data for a cell by its id would build something in it.
    this->Cell = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
    const std::string refusal = this->ReadCells(polyData->GetPolys(), VTK_POLYGON);
    return refusal.empty() ? this->ReadCells(polyData->GetStrips(), VTK_TRIANGLE_STRIP) : refusal;
  }
  std::string refusal;
  const vtkIdType count = block.Data->GetNumberOfCells();
  for (; this->Cell < count && refusal.empty() && this->Beats.Beat(); ++this->Cell)
  {
    block.Data->GetCellPoints(this->Cell, this->Points);
    refusal = this->AddCell(block.Data->GetCellType(this->Cell));
  }
  return refusal;
}

std::string SurfaceReader::ReadCells(vtkCellArray* cells, int type)
{
  std::string refusal;
  const vtkIdType count = cells->GetNumberOfCells();
  for (vtkIdType k = 0; k < count && refusal.empty() && this->Beats.Beat(); ++k, ++this->Cell)
  {
    cells->GetCellAtId(k, this->Points);
    refusal = this->AddCell(type);
  }
  return refusal;
}

// Expects the points of the cell in Points.
std::string SurfaceReader::AddCell(int type)
{
  const vtkIdType size = this->Points->GetNumberOfIds();
  const vtkIdType* points = this->Points->GetPointer(0);
  const std::string missing =
    MissingPointText("the input", this->Cell, size, points, this->NumberOfPoints);
  const CellShape shape = ShapeOf(type);
  if (!missing.empty() || this->Ghosts->LeaveOut(this->Cell, size, points))
  {
    return missing;
  }
  if (shape == CellShape::Volume || shape == CellShape::Curved)
  {
    return "Cell " + std::to_string(this->FirstCell + this->Cell) + " is a " +
      vtkCellTypes::GetClassNameFromTypeId(type) + "; the input must be a surface (apply " +
      (shape == CellShape::Volume ? "Extract Surface" : "Tessellate") + " before it).";
  }
  if (shape == CellShape::Face || shape == CellShape::Strip)
  {
    PointsAlong(type, size, points, this->Outline);
    shape == CellShape::Face ? this->AddFace() : this->AddStrip();
  }
  constexpr std::size_t Limit = std::numeric_limits<Id>::max();
  return this->Mesh.Corners.size() > Limit
    ? "The input has more corners than 32-bit ids can number."
    : "";
}

void SurfaceReader::Add(std::size_t a, std::size_t b, std::size_t c)
{
  for (const std::size_t k : { a, b, c })
  {
    this->Mesh.Corners.push_back(static_cast<Id>(this->FirstPoint + this->Outline[k]));
  }
  this->Mesh.Cells.push_back(static_cast<Id>(this->FirstCell + this->Cell));
}

void SurfaceReader::AddStrip()
{
  for (std::size_t k = 0; k + 2 < this->Outline.size(); ++k)
  {
    this->Add(k, k + 1 + k % 2, k + 2 - k % 2);
  }
}

void SurfaceReader::AddFace()
{
  if (this->Outline.size() == 3)
  {
    this->Add(0, 1, 2);
  }
  else if (this->Outline.size() == 4)
  {
    this->AddQuad();
  }
  else if (this->Outline.size() > 4)
  {
    this->AddPolygon();
  }
}

// Of equal diagonals that from the lowest corner: what the places of the corners decide alone.
void SurfaceReader::AddQuad()
{
  const auto normal = [this](std::size_t a, std::size_t b, std::size_t c)
  { return Cross(this->At(b) - this->At(a), this->At(c) - this->At(a)); };
  const bool isFirstGood = Dot(normal(0, 1, 2), normal(0, 2, 3)) >= 0.0;
  const bool isSecondGood = Dot(normal(0, 1, 3), normal(1, 2, 3)) >= 0.0;
  const double first = Distance(this->At(0), this->At(2));
  const double second = Distance(this->At(1), this->At(3));
  const bool isLowest = std::min(this->At(0), this->At(2)) < std::min(this->At(1), this->At(3));
  const bool isShorter = first < second || (first == second && isLowest);
  if (isFirstGood != isSecondGood ? isFirstGood : isShorter)
  {
    this->Add(0, 1, 2);
    this->Add(0, 2, 3);
  }
  else
  {
    this->Add(0, 1, 3);
    this->Add(1, 2, 3);
  }
}

// VTK cuts ears within a tolerance; where it does not use all corners the fan is taken.
void SurfaceReader::AddPolygon()
{
  const auto size = static_cast<vtkIdType>(this->Outline.size());
  this->Polygon->Points->SetDataTypeToDouble();
  this->Polygon->Points->SetNumberOfPoints(size);
  this->Polygon->PointIds->SetNumberOfIds(size);
  for (vtkIdType k = 0; k < size; ++k)
  {
    this->Polygon->Points->SetPoint(k, this->At(static_cast<std::size_t>(k)).Data());
    this->Polygon->PointIds->SetId(k, k);
  }
  const bool isDone =
    this->Polygon->Triangulate(this->Ears) != 0 && this->Ears->GetNumberOfIds() == 3 * (size - 2);
  for (vtkIdType k = 0; k < size - 2; ++k)
  {
    const auto ear = [this, k](vtkIdType corner)
    { return static_cast<std::size_t>(this->Ears->GetId(3 * k + corner)); };
    const auto next = static_cast<std::size_t>(k);
    isDone ? this->Add(ear(0), ear(1), ear(2)) : this->Add(0, next + 1, next + 2);
  }
}

// Coordinates too small for exact predicates are zero.
void ReadPoints(const Drawing& drawing, SurfaceMesh& mesh, Pulse& pulse)
{
  const auto doubles = CoordinatesOf(drawing.Points);
  const double* coordinates = doubles->GetPointer(0);
  mesh.Points.resize(static_cast<std::size_t>(drawing.NumberOfPoints));
  mesh.PointIds.resize(mesh.Points.size());
  pulse.ForEach(mesh.Points.size(),
    [coordinates, &mesh](std::size_t point)
    {
      mesh.PointIds[point] = static_cast<Id>(point);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double value = coordinates[3 * point + axis];
        mesh.Points[point][axis] = std::abs(value) < LeastCoordinate3 ? 0.0 : value;
      }
    });
}

} // namespace

std::string SurfaceFromDrawing(const Drawing& drawing, GivenSurface& surface, Monitor& monitor)
{
  constexpr vtkIdType Limit = std::numeric_limits<Id>::max();
  if (drawing.NumberOfPoints > Limit || drawing.NumberOfCells > Limit)
  {
    return "The input has more points or cells than 32-bit ids can number.";
  }
  Pulse pulse(monitor);
  if (drawing.NumberOfPoints > 0)
  {
    ReadPoints(drawing, surface.Mesh, pulse);
  }
  SurfaceReader reader(surface.Mesh, pulse);
  for (const DrawingBlock& block : drawing.Blocks)
  {
    const std::string refusal = reader.Read(block);
    if (!refusal.empty())
    {
      return refusal;
    }
  }
  std::vector<Id> used;
  std::vector<std::uint8_t> isUsed(surface.Mesh.Points.size(), 0);
  for (const Id corner : surface.Mesh.Corners)
  {
    isUsed[corner] = 1;
  }
  for (std::size_t point = 0; point < isUsed.size(); ++point)
  {
    if (isUsed[point])
    {
      used.push_back(static_cast<Id>(point));
    }
  }
  if (used.empty())
  {
    return {};
  }
  const double* coordinates = surface.Mesh.Points.front().Data();
  const std::string refusal = RefuseWhereNot(
    [](const double* place)
    {
      return std::all_of(
        place, place + 3, [](double value) { return std::abs(value) <= GreatestCoordinate3; });
    },
    used, coordinates, "Coordinates that are not finite, or too large to compute with",
    "Correct or remove these points.");
  if (refusal.empty())
  {
    surface.Rounding = RoundingOfCoordinates(drawing.CoordinateType(), coordinates, used, pulse);
  }
  return refusal;
}

} // namespace biting
