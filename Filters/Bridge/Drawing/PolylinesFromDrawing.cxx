// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PolylinesFromDrawing.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Base/SortInSteps.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "CellTags.h"
#include "CoordinateRounding.h"
#include "Globe.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <algorithm> // for max, max_element
#include <cmath>     // for abs
#include <limits>    // for epsilon
#include <utility>   // for pair

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
  const auto visit = [this](const SeenCell& cell)
  {
    this->Cell = cell.Id;
    return this->ReadCell(cell.Type, cell.Size, cell.Points);
  };
  return refusal.empty() ? VisitCells(this->Block.Data, visit, this->Beats) : refusal;
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
    this->IsUsed[this->Block.FirstPoint + point] = 1;
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
    this->Chains.Regions.push_back(this->Regions[this->CellId()]);
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

// `regions` has a number for each cell, or is empty.
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

// Where steps end, as shares of the time: of all, and of what follows the cells.
constexpr double PolylinesEnd = 0.4;
constexpr double FrameEnd = 0.5;
constexpr double MapEnd = 0.7;

std::string ReadCells(
  const Drawing& drawing, const std::string& regionArray, PlanarInput& result, Pulse& pulse)
{
  std::vector<Id> regions;
  const std::string refusal = FindRegionNumbers(drawing, regionArray, regions, pulse);
  const PulsePart part(pulse, 0.0, PolylinesEnd);
  return refusal.empty() ? ReadChains(drawing, regions, result.Chains, result.IsUsed, pulse)
                         : refusal;
}

void ListUsedPoints(PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  pulse.ForEach(input.IsUsed.size(),
    [&input](std::size_t point)
    {
      if (input.IsUsed[point])
      {
        input.UsedPoints.push_back(static_cast<Id>(point));
      }
    });
}

void RefuseNotFinite(const PlanarInput& input, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  pulse.ForEach(input.UsedPoints.size(),
    [&input, &problems](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      const double* place = input.Place(point);
      if (!AreFinite(place))
      {
        problems.Add({ ProblemCode::NotFinite, { point }, {}, {} });
      }
    });
}

void MapToPlane(PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, FrameEnd, MapEnd);
  input.Chains.Points.resize(input.IsUsed.size());
  pulse.ForEach(input.UsedPoints.size(),
    [&input](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      input.Chains.Points[point] = input.Frame.ToPlane(input.Place(point));
    });
}

// The ends of all lines.
std::vector<Id> LinesOf(const Polylines& chains)
{
  std::vector<Id> ends;
  ends.reserve(2 * chains.Connectivity.size());
  for (std::size_t chain = 0; chain < chains.Kinds.size(); ++chain)
  {
    const bool arePoints = chains.Kinds[chain] == ChainKind::EmbeddedPoint;
    for (Id k = chains.Offsets[chain] + 1; k < chains.Offsets[chain + 1] && !arePoints; ++k)
    {
      ends.insert(ends.end(), { chains.Connectivity[k - 1], chains.Connectivity[k] });
    }
  }
  return ends;
}

// The largest stretch of the points counts for all.
double RoundingOnGlobe(const CoordinateRounding& rounding, const PlanarInput& input)
{
  double stretch = 1.0;
  for (const Id point : input.UsedPoints)
  {
    const Point2& place = input.Chains.Points[point];
    stretch = std::max(stretch, input.Frame.StretchAt(place));
  }
  return stretch * MetresPerDegree * std::max(rounding.Axes[0], rounding.Axes[1]);
}

// Along the axes of the plane; in a slanted plane they mix those of space.
Point2 InPlane(const CoordinateRounding& rounding, const PlaneFrame& frame)
{
  const auto along = [&rounding, &frame](int axis) { return rounding.Axes[frame.Axis(axis)]; };
  const double most = *std::max_element(rounding.Axes.begin(), rounding.Axes.end());
  return frame.IsAxisAligned() ? Point2{ along(0), along(1) } : Point2{ most, most };
}

double Diagonal(const PlanarInput& input, Pulse& pulse)
{
  const PulsePart part(pulse, MapEnd, MapEnd);
  Box2 box;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, &box](std::size_t k) { box.Add(input.Chains.Points[input.UsedPoints[k]]); });
  return box.Diagonal();
}

// A point and its distance from the plane, worst first.
using Distances = std::vector<std::pair<double, Id>>;

Distances FindNotPlanar(const PlanarInput& input, double farthest, Pulse& pulse)
{
  Distances off;
  pulse.ForEach(input.UsedPoints.size(),
    [&input, farthest, &off](std::size_t k)
    {
      const Id point = input.UsedPoints[k];
      const double distance = std::abs(input.Frame.Distance(input.Place(point)));
      if (distance > farthest)
      {
        off.emplace_back(distance, point);
      }
    });
  SortInSteps(
    off,
    [](const auto& a, const auto& b)
    { return a.first != b.first ? a.first > b.first : a.second < b.second; },
    pulse);
  return off;
}

void RefuseNotPlanar(const PlanarInput& input, double farthest, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, MapEnd, 1.0);
  for (const auto& [distance, point] : FindNotPlanar(input, farthest, pulse))
  {
    if (!pulse.Beat())
    {
      return;
    }
    problems.Add({ ProblemCode::NotPlanar, { point }, input.Chains.Points[point],
      "it lies " + vtkVariant(distance).ToString() + " from the plane" });
  }
}

} // namespace

std::string PolylinesFromDrawing(const Drawing& drawing, const std::string& regionArray,
  PlanarInput& result, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::string refusal = ReadCells(drawing, regionArray, result, pulse);
  if (!refusal.empty() || result.Chains.NumberOfChains() == 0)
  {
    return refusal;
  }
  const PulsePart part(pulse, PolylinesEnd, 1.0);
  result.Coordinates = CoordinatesOf(drawing.Points);
  ListUsedPoints(result, pulse);
  RefuseNotFinite(result, problems, pulse);
  if (problems.HasErrors() || pulse.HasStopped())
  {
    return {};
  }
  const double* places = result.Coordinates->GetPointer(0);
  const CoordinateRounding rounding =
    RoundingOfCoordinates(drawing.CoordinateType(), places, result.UsedPoints, pulse);
  if (result.IsOnGlobe)
  {
    const std::string beyond =
      FitGlobe(places, result.UsedPoints, LinesOf(result.Chains), result.Frame);
    if (!beyond.empty())
    {
      return beyond;
    }
  }
  else
  {
    result.Frame = PlaneFrame::FitTo(places, result.UsedPoints, rounding.Most, pulse);
    result.Chains.Rounding = InPlane(rounding, result.Frame);
  }
  MapToPlane(result, pulse);
  const double diagonal = Diagonal(result, pulse);
  result.Chains.SeamNoise = SeamInUlp * std::numeric_limits<double>::epsilon() * diagonal;
  RefuseNotPlanar(result, std::max(PlanarTolerance * diagonal, rounding.Most), problems, pulse);
  if (result.IsOnGlobe)
  {
    const double noise = RoundingOnGlobe(rounding, result);
    result.Chains.Rounding = { noise, noise };
  }
  if (result.IsOnGlobe && !problems.HasErrors())
  {
    // A copy, to which points are added: the coordinates may be those of the drawing.
    const auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->DeepCopy(result.Coordinates);
    result.Coordinates = copy;
    DivideLines(nullptr, result, monitor);
  }
  return {};
}

} // namespace biting
