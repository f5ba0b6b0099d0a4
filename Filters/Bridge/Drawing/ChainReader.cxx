// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainReader.h"

#include "../Data/CellShapes.h"
#include "../Data/GhostArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <limits> // for the size check

namespace biting
{

namespace
{

constexpr std::size_t MostIds = std::numeric_limits<Id>::max();
constexpr const char* TooManyText =
  "The input has more points or cells than 32-bit ids can number.";

// Reads one block.
class BlockReader
{
public:
  BlockReader(const DrawingBlock& block, vtkIdType numberOfCells, const std::vector<Id>& regions,
    Polylines& chains, std::vector<std::uint8_t>& isUsed, Pulse& pulse)
    : Block(block)
    , NumberOfCells(numberOfCells)
    , Regions(regions)
    , Chains(chains)
    , IsUsed(isUsed)
    , Beats(pulse)
    , Ghosts(block.Data)
  {
  }

  std::string Read();

private:
  std::string FindKinds();
  std::string ReadPolyData(vtkPolyData* data);
  std::string ReadList(vtkCellArray* cells, int type);
  std::string ReadAll();
  std::string ReadCell(int type, vtkIdType size, const vtkIdType* points);
  std::string AddShape(CellShape shape, int type, vtkIdType size, const vtkIdType* points);
  std::string AddStrip(vtkIdType size, const vtkIdType* points, ChainKind kind);
  std::string AddChain(const std::vector<vtkIdType>& points, ChainKind kind, bool isClosed);
  std::string KindOf(CellShape shape, ChainKind& kind) const;
  std::string Refusal(CellShape shape, int type) const;

  vtkIdType CellId() const { return this->Block.FirstCell + this->Cell; }
  std::string CellText() const { return "Cell " + std::to_string(this->CellId()); }

  const DrawingBlock& Block;
  const vtkIdType NumberOfCells; // of the drawing
  const std::vector<Id>& Regions;
  Polylines& Chains;
  std::vector<std::uint8_t>& IsUsed;
  Pulse& Beats;
  const GhostArrays Ghosts;
  vtkDataArray* Kinds = nullptr;
  vtkIdType Cell = 0;
  std::vector<vtkIdType> Along;
};

std::string BlockReader::Read()
{
  const std::string refusal = this->FindKinds();
  if (!refusal.empty())
  {
    return refusal;
  }
  auto* polyData = vtkPolyData::SafeDownCast(this->Block.Data);
  return polyData ? this->ReadPolyData(polyData) : this->ReadAll();
}

std::string BlockReader::FindKinds()
{
  vtkCellData* cellData = this->Block.Data->GetCellData();
  this->Kinds = cellData->GetArray("Kind");
  if (cellData->GetAbstractArray("Kind") && !this->Kinds)
  {
    return "The cell array Kind is not numeric; it takes 0 (boundary), 1 (interface) and 2 "
           "(embedded points).";
  }
  const vtkIdType kinds = this->Kinds ? this->Kinds->GetNumberOfTuples() : 0;
  const vtkIdType cells = this->Block.Data->GetNumberOfCells();
  if (this->Kinds && kinds < cells)
  {
    return "The cell array Kind has " + std::to_string(kinds) + " values for " +
      std::to_string(cells) + " cells.";
  }
  return {};
}

// By its lists: asking poly data for a cell by its id would build something in it.
std::string BlockReader::ReadPolyData(vtkPolyData* data)
{
  std::string refusal = this->ReadList(data->GetVerts(), VTK_POLY_VERTEX);
  refusal = refusal.empty() ? this->ReadList(data->GetLines(), VTK_POLY_LINE) : refusal;
  refusal = refusal.empty() ? this->ReadList(data->GetPolys(), VTK_POLYGON) : refusal;
  return refusal.empty() ? this->ReadList(data->GetStrips(), VTK_TRIANGLE_STRIP) : refusal;
}

std::string BlockReader::ReadList(vtkCellArray* cells, int type)
{
  std::string refusal;
  vtkNew<vtkIdList> points;
  const vtkIdType count = cells->GetNumberOfCells();
  for (vtkIdType k = 0; k < count && refusal.empty() && this->Beats.Beat(); ++k, ++this->Cell)
  {
    cells->GetCellAtId(k, points);
    refusal = this->ReadCell(type, points->GetNumberOfIds(), points->GetPointer(0));
  }
  return refusal;
}

std::string BlockReader::ReadAll()
{
  std::string refusal;
  vtkNew<vtkIdList> points;
  vtkDataSet* data = this->Block.Data;
  const vtkIdType count = data->GetNumberOfCells();
  for (; this->Cell < count && refusal.empty() && this->Beats.Beat(); ++this->Cell)
  {
    data->GetCellPoints(this->Cell, points);
    refusal = this->ReadCell(
      data->GetCellType(this->Cell), points->GetNumberOfIds(), points->GetPointer(0));
  }
  return refusal;
}

std::string BlockReader::ReadCell(int type, vtkIdType size, const vtkIdType* points)
{
  this->Beats.SetFraction(
    static_cast<double>(this->CellId()) / static_cast<double>(this->NumberOfCells));
  const CellShape shape = ShapeOf(type);
  const std::string refusal = MissingPointText(
    "the input", this->CellId(), size, points, this->Block.Data->GetNumberOfPoints());
  if (!refusal.empty())
  {
    return refusal;
  }
  const bool isFlat = (shape == CellShape::Face || shape == CellShape::Strip) && size < 3;
  if (size == 0 || isFlat || shape == CellShape::Nothing ||
    this->Ghosts.LeaveOut(this->Cell, size, points))
  {
    return {};
  }
  return this->AddShape(shape, type, size, points);
}

std::string BlockReader::AddShape(
  CellShape shape, int type, vtkIdType size, const vtkIdType* points)
{
  ChainKind kind = ChainKind::EmbeddedPoint;
  const std::string refusal = this->KindOf(shape, kind);
  if (!refusal.empty())
  {
    return refusal;
  }
  switch (shape)
  {
    case CellShape::Points:
    case CellShape::Line:
    case CellShape::Face:
      PointsAlong(type, size, points, this->Along);
      return this->AddChain(this->Along, kind, shape == CellShape::Face);
    case CellShape::Strip:
      return this->AddStrip(size, points, kind);
    default:
      return this->Refusal(shape, type);
  }
}

// A vertex cell has no segments: it is embedded, whatever the array says.
std::string BlockReader::KindOf(CellShape shape, ChainKind& kind) const
{
  if (shape == CellShape::Points)
  {
    return {};
  }
  const bool isLine = shape == CellShape::Line;
  const double value = this->Kinds ? this->Kinds->GetComponent(this->Cell, 0) : -1.0;
  if (this->Kinds && value != 0.0 && value != 1.0 && value != 2.0)
  {
    return this->CellText() + " has an unknown Kind, " + vtkVariant(value).ToString() +
      "; it takes 0 (boundary), 1 (interface) and 2 (embedded points).";
  }
  kind = static_cast<ChainKind>(static_cast<int>(value));
  const bool mayBeFace = kind == ChainKind::Automatic || kind == ChainKind::Boundary;
  kind = !isLine && mayBeFace ? ChainKind::Face : kind;
  return {};
}

// The orientation of its triangles plays no part.
std::string BlockReader::AddStrip(vtkIdType size, const vtkIdType* points, ChainKind kind)
{
  std::string refusal;
  for (vtkIdType k = 0; k + 2 < size && refusal.empty(); ++k)
  {
    this->Along.assign(points + k, points + k + 3);
    refusal = this->AddChain(this->Along, kind, true);
  }
  return refusal;
}

std::string BlockReader::AddChain(
  const std::vector<vtkIdType>& points, ChainKind kind, bool isClosed)
{
  if (this->Chains.Connectivity.size() + points.size() >= MostIds)
  {
    return TooManyText;
  }
  const auto add = [this](vtkIdType point)
  { this->Chains.Connectivity.push_back(static_cast<Id>(this->Block.FirstPoint + point)); };
  for (const vtkIdType point : points)
  {
    add(point);
    this->IsUsed[static_cast<std::size_t>(this->Block.FirstPoint + point)] = 1;
  }
  if (isClosed && kind != ChainKind::EmbeddedPoint && points.front() != points.back())
  {
    add(points.front());
  }
  this->Chains.Offsets.push_back(static_cast<Id>(this->Chains.Connectivity.size()));
  this->Chains.Kinds.push_back(kind);
  this->Chains.Cells.push_back(static_cast<Id>(this->CellId()));
  if (!this->Regions.empty())
  {
    this->Chains.Regions.push_back(this->Regions[static_cast<std::size_t>(this->CellId())]);
  }
  return {};
}

std::string BlockReader::Refusal(CellShape shape, int type) const
{
  const std::string name = vtkCellTypes::GetClassNameFromTypeId(type);
  return this->CellText() + " is a " + name +
    (shape == CellShape::Volume
        ? ": cells with a volume are not meshed; apply Extract Surface, Slice or Feature Edges "
          "first."
        : ": apply Tessellate first, which makes straight cells of curved ones.");
}

} // namespace

std::string ReadChains(const Drawing& drawing, const std::vector<Id>& regions, Polylines& chains,
  std::vector<std::uint8_t>& isUsed, Pulse& pulse)
{
  const auto isTooMuch = [](vtkIdType count) { return count > static_cast<vtkIdType>(MostIds); };
  if (isTooMuch(drawing.NumberOfPoints) || isTooMuch(drawing.NumberOfCells))
  {
    return TooManyText;
  }
  isUsed.assign(static_cast<std::size_t>(drawing.NumberOfPoints), 0);
  std::string refusal;
  for (const DrawingBlock& block : drawing.Blocks)
  {
    refusal = refusal.empty()
      ? BlockReader(block, drawing.NumberOfCells, regions, chains, isUsed, pulse).Read()
      : refusal;
  }
  return refusal;
}

} // namespace biting
