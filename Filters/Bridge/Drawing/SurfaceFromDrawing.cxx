// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceFromDrawing.h"

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Predicates/Predicates3.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Run/ProblemReport.h"

#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <algorithm> // for all_of, copy_if, min
#include <cmath>     // for abs
#include <iterator>  // for back_inserter
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
  std::string AddCell(const SeenCell& cell);
  bool IsConvex() const;
  void CutCorners(int type);
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
  vtkIdType Cell = 0;             ///< in the block
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
  return VisitCells(
    block.Data, [this](const SeenCell& cell) { return this->AddCell(cell); }, this->Beats);
}

std::string SurfaceReader::AddCell(const SeenCell& cell)
{
  this->Cell = cell.Id;
  const std::string missing =
    MissingPointText("the input", cell.Id, cell.Size, cell.Points, this->NumberOfPoints);
  const CellShape shape = ShapeOf(cell.Type);
  if (!missing.empty() || this->Ghosts->LeaveOut(cell.Id, cell.Size, cell.Points))
  {
    return missing;
  }
  if (shape == CellShape::Volume || shape == CellShape::Curved)
  {
    return "Cell " + std::to_string(this->FirstCell + cell.Id) + " is a " +
      vtkCellTypes::GetClassNameFromTypeId(cell.Type) + "; the input must be a surface (apply " +
      (shape == CellShape::Volume ? "Extract Surface" : "Tessellate") + " before it).";
  }
  if (shape == CellShape::Face || shape == CellShape::Strip)
  {
    PointsAlong(cell.Type, cell.Size, cell.Points, this->Outline);
    this->CutCorners(cell.Type);
    shape == CellShape::Face ? this->AddFace() : this->AddStrip();
  }
  constexpr std::size_t Limit = std::numeric_limits<Id>::max();
  return this->Mesh.Corners.size() > Limit
    ? "The input has more corners than 32-bit ids can number."
    : "";
}

// Whether the outline turns to one side at all corners of a quadratic cell.
bool SurfaceReader::IsConvex() const
{
  const std::size_t size = this->Outline.size();
  const auto turn = [this, size](std::size_t corner)
  {
    const Point3& middle = this->At(corner);
    return Cross(middle - this->At((corner + size - 1) % size), this->At(corner + 1) - middle);
  };
  Point3 normal;
  for (std::size_t k = 0; k + 1 < size; ++k)
  {
    normal = normal + Cross(this->At(k) - this->At(0), this->At(k + 1) - this->At(0));
  }
  bool isConvex = true;
  for (std::size_t corner = 0; corner < size; corner += 2)
  {
    isConvex = isConvex && Dot(turn(corner), normal) >= 0.0;
  }
  return isConvex;
}

// Of a quadratic cell: between them are the points of its sides. No triangle lies along a side,
// where the neighbor could have the same one. A cell with a reflex corner stays whole.
void SurfaceReader::CutCorners(int type)
{
  const std::size_t size = this->Outline.size();
  const bool isQuadratic = type == VTK_QUADRATIC_TRIANGLE || type == VTK_BIQUADRATIC_TRIANGLE ||
    type == VTK_QUADRATIC_QUAD || type == VTK_BIQUADRATIC_QUAD || type == VTK_QUADRATIC_POLYGON;
  if (isQuadratic && size >= 6 && size % 2 == 0 && this->IsConvex())
  {
    std::vector<vtkIdType> sides;
    for (std::size_t corner = 0; corner < size; corner += 2)
    {
      this->Add((corner + size - 1) % size, corner, corner + 1);
      sides.push_back(this->Outline[corner + 1]);
    }
    this->Outline = sides;
  }
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
  std::copy_if(surface.Mesh.PointIds.begin(), surface.Mesh.PointIds.end(), std::back_inserter(used),
    [&isUsed](Id point) { return isUsed[static_cast<std::size_t>(point)] != 0; });
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
