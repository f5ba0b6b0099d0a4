// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceSpacing.h"

#include "../Kernel/Base/Pulse.h"
#include "DoubleArray.h"
#include "MessagesFromProblems.h"
#include "PlaneCut.h"
#include "SourceBorder.h"
#include "SourceOrder.h"
#include "SpacingValues.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for all_of, is_sorted, minmax
#include <array>     // for axes
#include <cmath>     // for NaN
#include <limits>    // for the size check, NaN

namespace biting
{

namespace
{

// Where steps end, as shares of the time: the grid, or what reads cells instead.
constexpr double GridEnd = 0.1;
constexpr double DistancesEnd = 0.2;
constexpr double CellsEnd = 0.8;
constexpr double PointsEnd = 0.85;
constexpr double TrianglesEnd = 0.9;

constexpr std::size_t CheapStepsPerCell = 32; // a polygon takes a microsecond to triangulate

using AxisNodes = std::array<std::vector<double>, 3>;

bool HasGhosts(vtkDataSet* source)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  return source->GetAttributes(vtkDataObject::POINT)->HasArray(name) ||
    source->GetAttributes(vtkDataObject::CELL)->HasArray(name);
}

// The coordinates of the grid lines of an image whose axes are those of space; empty for others.
AxisNodes NodesOfImage(vtkImageData* image)
{
  AxisNodes nodes;
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    return nodes;
  }
  const int* extent = image->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int k = extent[2 * axis]; k <= extent[2 * axis + 1]; ++k)
    {
      nodes[axis].push_back(image->GetOrigin()[axis] + k * image->GetSpacing()[axis]);
    }
  }
  return nodes;
}

AxisNodes NodesOfRectilinearGrid(vtkRectilinearGrid* grid)
{
  AxisNodes nodes;
  vtkDataArray* arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto doubles = AsDoubles(arrays[axis]);
    const double* first = doubles->GetPointer(0);
    nodes[axis].assign(first, first + doubles->GetNumberOfValues());
  }
  return nodes;
}

AxisNodes NodesOfGrid(vtkDataSet* source)
{
  if (auto* image = vtkImageData::SafeDownCast(source))
  {
    return NodesOfImage(image);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(source))
  {
    return NodesOfRectilinearGrid(grid);
  }
  return {};
}

// Why an image lies nowhere; empty where it does not, or the source is no image.
std::string CheckImage(vtkDataSet* source)
{
  auto* image = vtkImageData::SafeDownCast(source);
  if (!image || (AreFinite(image->GetOrigin()) && AreFinite(image->GetSpacing())))
  {
    return {};
  }
  const double* origin = image->GetOrigin();
  const double* steps = image->GetSpacing();
  return "The spacing source lies nowhere: the origin of the image is " +
    PlaceText({ origin[0], origin[1], origin[2] }) + " and its spacing of points " +
    PlaceText({ steps[0], steps[1], steps[2] }) + ". Both must be finite.";
}

// Which of `points` of the source lie nowhere.
std::string CheckPoints(vtkDataSet* source, const std::vector<vtkIdType>& points, Pulse& pulse)
{
  std::vector<std::string> first;
  std::int64_t count = 0;
  for (const vtkIdType point : points)
  {
    Point3 place;
    source->GetPoint(point, place.data());
    if (pulse.Beat(1) && !AreFinite(place.data()) && ++count <= static_cast<std::int64_t>(ShownIds))
    {
      first.push_back("point " + std::to_string(point) + " at " + PlaceText(place));
    }
  }
  return count == 0 ? ""
                    : "The spacing source has coordinates that are not finite (" +
      std::to_string(count) + "): " + ListText(first, count) + ". Correct or remove these points.";
}

bool IsAscending(const std::vector<double>& nodes)
{
  const bool isFinite =
    std::all_of(nodes.begin(), nodes.end(), [](double node) { return std::isfinite(node); });
  const auto repeated = std::adjacent_find(
    nodes.begin(), nodes.end(), [](double node, double next) { return !(node < next); });
  return isFinite && !nodes.empty() && repeated == nodes.end();
}

// The source as a grid of the plane; null where it is none.
std::shared_ptr<GridSource> GridFrom(
  vtkDataSet* source, const double* values, const PlaneFrame& frame, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, GridEnd);
  const AxisNodes nodes = NodesOfGrid(source);
  const auto first = static_cast<std::size_t>(frame.Axis(0));
  const auto second = static_cast<std::size_t>(frame.Axis(1));
  const auto normal = static_cast<std::size_t>(frame.Axis(2));
  if (!frame.IsAxisAligned() || HasGhosts(source) || nodes[normal].size() != 1 ||
    !IsAscending(nodes[first]) || !IsAscending(nodes[second]))
  {
    return nullptr;
  }
  const std::array<std::size_t, 3> strides{ 1, nodes[0].size(), nodes[0].size() * nodes[1].size() };
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = nodes[first];
  grid->YNodes = nodes[second];
  const std::size_t width = nodes[first].size();
  GrowInSteps(grid->Values, width * nodes[second].size(), 0.0, pulse);
  pulse.ForEach(grid->Values.size(),
    [values, &grid, width, along = strides[first], across = strides[second]](std::size_t k)
    { grid->Values[k] = values[k % width * along + k / width * across]; });
  return grid;
}

// Turns the cells of any data into triangles of the plane.
class CellCollector
{
public:
  CellCollector(vtkDataSet* source, const PlaneFrame& frame, Pulse& pulse);

  std::string Collect();
  std::vector<vtkIdType> UsedPoints() const;
  std::shared_ptr<TriangulatedSource> Triangulation(const double* values) const;

private:
  void MeasureDistances();
  void CollectCells();
  int Dimension(int cellType);
  bool IsSource(vtkIdType cell);
  bool MeetsPlane() const;
  void AddCell(vtkIdType cell, int dimension);
  std::size_t NumberOfNodes() const { return this->Distances.size() + this->Cut.GetEdges().size(); }
  Point2 PlaceOf(vtkIdType node) const;
  double ValueOf(vtkIdType node, const double* values) const;

  vtkSmartPointer<vtkDataSet> Source; // a shallow copy: asking it for cells changes nothing shared
  const PlaneFrame& Frame;
  Pulse& Beats;
  vtkUnsignedCharArray* PointGhosts;
  vtkUnsignedCharArray* CellGhosts;
  std::vector<double> Distances;
  PlaneCut Cut;
  bool HasCells;
  bool HasVolumes = false;
  std::array<int, VTK_NUMBER_OF_CELL_TYPES> Dimensions;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkPoints> Places;
};

// The entries of a ghost array for the cells from `first` on.
void CopyGhosts(vtkPolyData* source, vtkIdType first, vtkPolyData* copy)
{
  vtkUnsignedCharArray* ghosts = source->GetCellGhostArray();
  if (!ghosts)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> kept;
  kept->SetName(vtkDataSetAttributes::GhostArrayName());
  kept->InsertTuples(0, ghosts->GetNumberOfTuples() - first, first, ghosts);
  copy->GetCellData()->AddArray(kept);
}

// Without vertices and lines: they are no source, and where a line has one point, VTK 9.1 cannot
// build the list of cells.
vtkSmartPointer<vtkDataSet> FacesOf(vtkPolyData* source)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(source->GetPoints());
  copy->GetPointData()->ShallowCopy(source->GetPointData());
  copy->SetPolys(source->GetPolys());
  copy->SetStrips(source->GetStrips());
  CopyGhosts(source, source->GetNumberOfVerts() + source->GetNumberOfLines(), copy);
  return copy;
}

vtkSmartPointer<vtkDataSet> ShallowCopyOf(vtkDataSet* source)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(source))
  {
    return FacesOf(polyData);
  }
  auto copy = vtk::TakeSmartPointer(source->NewInstance());
  copy->ShallowCopy(source);
  return copy;
}

CellCollector::CellCollector(vtkDataSet* source, const PlaneFrame& frame, Pulse& pulse)
  : Source(ShallowCopyOf(source))
  , Frame(frame)
  , Beats(pulse)
  , PointGhosts(this->Source->GetPointGhostArray())
  , CellGhosts(this->Source->GetCellGhostArray())
  , Distances(static_cast<std::size_t>(source->GetNumberOfPoints()))
  , Cut(this->Distances)
  , HasCells(source->GetNumberOfCells() > 0)
{
  this->Dimensions.fill(-1);
}

std::string CellCollector::Collect()
{
  if (!this->HasCells)
  {
    return "The spacing source has no cells to interpolate in.";
  }
  this->MeasureDistances();
  this->CollectCells();
  this->Cut.MergeEdges(this->Beats);
  if (!this->Cut.GetTriangles().empty())
  {
    constexpr std::size_t Limit = std::numeric_limits<Id>::max();
    const bool isTooLarge =
      this->NumberOfNodes() > Limit || this->Cut.GetTriangles().size() > Limit;
    return isTooLarge ? "The spacing source has more cells than 32-bit ids can number." : "";
  }
  return this->HasVolumes ? "The spacing source does not meet the plane of the input."
                          : "The spacing source has no visible cells with an area or a volume.";
}

void CellCollector::MeasureDistances()
{
  const PulsePart part(this->Beats, GridEnd, DistancesEnd);
  this->Beats.ForEach(this->Distances.size(),
    [this](std::size_t point)
    {
      double place[3];
      this->Source->GetPoint(static_cast<vtkIdType>(point), place);
      this->Distances[point] = this->Frame.Distance(place);
    });
}

void CellCollector::CollectCells()
{
  const PulsePart part(this->Beats, DistancesEnd, CellsEnd);
  const vtkIdType numberOfCells = this->Source->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < numberOfCells && this->Beats.Beat(CheapStepsPerCell); ++cell)
  {
    this->Beats.SetFraction(static_cast<double>(cell) / static_cast<double>(numberOfCells));
    const int dimension = this->Dimension(this->Source->GetCellType(cell));
    this->HasVolumes = this->HasVolumes || dimension == 3;
    if (dimension >= 2 && this->IsSource(cell))
    {
      this->AddCell(cell, dimension);
    }
  }
}

int CellCollector::Dimension(int cellType)
{
  const auto type = static_cast<std::size_t>(cellType);
  if (type >= this->Dimensions.size())
  {
    return 0;
  }
  if (this->Dimensions[type] < 0)
  {
    this->Cell->SetCellType(cellType);
    this->Dimensions[type] = this->Cell->GetCellDimension();
  }
  return this->Dimensions[type];
}

bool CellCollector::IsSource(vtkIdType cell)
{
  constexpr unsigned char NotHere =
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
  if (this->CellGhosts && (this->CellGhosts->GetValue(cell) & NotHere) != 0)
  {
    return false;
  }
  this->Source->GetCellPoints(cell, this->Corners);
  for (vtkIdType k = 0; this->PointGhosts && k < this->Corners->GetNumberOfIds(); ++k)
  {
    const unsigned char ghost = this->PointGhosts->GetValue(this->Corners->GetId(k));
    if ((ghost & vtkDataSetAttributes::HIDDENPOINT) != 0)
    {
      return false;
    }
  }
  return true;
}

bool CellCollector::MeetsPlane() const
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (vtkIdType k = 0; k < this->Corners->GetNumberOfIds(); ++k)
  {
    const double distance = this->Distances[static_cast<std::size_t>(this->Corners->GetId(k))];
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  return low <= 0.0 && high >= 0.0;
}

// Expects the points of the cell in Corners.
void CellCollector::AddCell(vtkIdType cell, int dimension)
{
  if (dimension == 3 && !this->MeetsPlane())
  {
    return;
  }
  if (dimension == 2 && this->Corners->GetNumberOfIds() == 3)
  {
    this->Cut.AddTriangle(this->Corners->GetPointer(0));
    return;
  }
  this->Source->GetCell(cell, this->Cell);
  this->Cell->Triangulate(static_cast<int>(cell % 2), this->Corners, this->Places);
  const vtkIdType size = dimension + 1;
  for (vtkIdType k = 0; k + size <= this->Corners->GetNumberOfIds(); k += size)
  {
    const vtkIdType* points = this->Corners->GetPointer(k);
    if (dimension == 3)
    {
      this->Cut.AddTetrahedron(points);
    }
    else
    {
      this->Cut.AddTriangle(points);
    }
  }
}

std::vector<vtkIdType> CellCollector::UsedPoints() const
{
  const PulsePart part(this->Beats, CellsEnd, PointsEnd);
  std::vector<std::uint8_t> isUsed(this->Distances.size(), 0);
  const std::vector<vtkIdType>& nodes = this->Cut.GetTriangles();
  this->Beats.ForEach(nodes.size(),
    [&nodes, &isUsed](std::size_t k)
    {
      const auto node = static_cast<std::size_t>(nodes[k]);
      if (node < isUsed.size())
      {
        isUsed[node] = 1;
      }
    });
  const std::vector<PlaneCut::Edge>& edges = this->Cut.GetEdges();
  this->Beats.ForEach(edges.size(),
    [&edges, &isUsed](std::size_t k)
    {
      isUsed[static_cast<std::size_t>(edges[k].Low)] = 1;
      isUsed[static_cast<std::size_t>(edges[k].High)] = 1;
    });
  std::vector<vtkIdType> used;
  this->Beats.ForEach(isUsed.size(),
    [&isUsed, &used](std::size_t point)
    {
      if (isUsed[point])
      {
        used.push_back(static_cast<vtkIdType>(point));
      }
    });
  return used;
}

std::shared_ptr<TriangulatedSource> CellCollector::Triangulation(const double* values) const
{
  auto triangulation = std::make_shared<TriangulatedSource>();
  std::vector<Id> newIds(this->NumberOfNodes(), NoId);
  const std::vector<vtkIdType>& nodes = this->Cut.GetTriangles();
  const PulsePart part(this->Beats, PointsEnd, TrianglesEnd);
  this->Beats.ForEach(nodes.size(),
    [this, values, &triangulation, &newIds, &nodes](std::size_t k)
    {
      Id& newId = newIds[static_cast<std::size_t>(nodes[k])];
      if (newId == NoId)
      {
        newId = static_cast<Id>(triangulation->Points.size());
        triangulation->Points.push_back(this->PlaceOf(nodes[k]));
        triangulation->Values.push_back(this->ValueOf(nodes[k], values));
      }
      triangulation->Triangles.push_back(newId);
    });
  return triangulation;
}

Point2 CellCollector::PlaceOf(vtkIdType node) const
{
  double place[3];
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  if (node < numberOfPoints)
  {
    this->Source->GetPoint(node, place);
    return this->Frame.ToPlane(place);
  }
  const PlaneCut::Edge& edge =
    this->Cut.GetEdges()[static_cast<std::size_t>(node - numberOfPoints)];
  this->Source->GetPoint(edge.Low, place);
  const Point2 low = this->Frame.ToPlane(place);
  this->Source->GetPoint(edge.High, place);
  const Point2 high = this->Frame.ToPlane(place);
  return low + this->Cut.Fraction(edge) * (high - low);
}

double CellCollector::ValueOf(vtkIdType node, const double* values) const
{
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  if (node < numberOfPoints)
  {
    return values[node];
  }
  const PlaneCut::Edge& edge =
    this->Cut.GetEdges()[static_cast<std::size_t>(node - numberOfPoints)];
  return values[edge.Low] + this->Cut.Fraction(edge) * (values[edge.High] - values[edge.Low]);
}

bool HasArea(const TriangulatedSource& source, Pulse& pulse)
{
  for (std::size_t k = 0; k < source.Triangles.size() && pulse.Beat(); k += 3)
  {
    const Point2& a = source.Points[static_cast<std::size_t>(source.Triangles[k])];
    const Point2& b = source.Points[static_cast<std::size_t>(source.Triangles[k + 1])];
    const Point2& c = source.Points[static_cast<std::size_t>(source.Triangles[k + 2])];
    if (Cross(b - a, c - a) != 0.0)
    {
      return true;
    }
  }
  return false;
}

std::string AddGrid(vtkDataSet* source, vtkDataArray* values, std::shared_ptr<GridSource> grid,
  SpacingOptions& options, ProblemPlaces& places, Pulse& pulse)
{
  std::vector<vtkIdType> points(static_cast<std::size_t>(source->GetNumberOfPoints()));
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    points[point] = static_cast<vtkIdType>(point);
  }
  options.Grid = std::move(grid);
  return CheckSpacingValues(source, values, points, SpacingOwner::Source, places, pulse);
}

std::string AddCells(vtkDataSet* source, vtkDataArray* values, const PlaneFrame& frame,
  bool mayOverlap, SpacingOptions& options, ProblemPlaces& places, Pulse& pulse)
{
  CellCollector collector(source, frame, pulse);
  std::string refusal = collector.Collect();
  const std::vector<vtkIdType> points = collector.UsedPoints();
  if (refusal.empty())
  {
    refusal = CheckPoints(source, points, pulse);
  }
  if (refusal.empty())
  {
    refusal = CheckSpacingValues(source, values, points, SpacingOwner::Source, places, pulse);
  }
  if (!refusal.empty())
  {
    return refusal;
  }
  const auto triangulation = collector.Triangulation(AsDoubles(values)->GetPointer(0));
  const PulsePart part(pulse, TrianglesEnd, 1.0);
  SortSource(*triangulation, pulse);
  triangulation->MayOverlap = mayOverlap;
  if (mayOverlap)
  {
    AddBorderOf(*triangulation, options, pulse);
  }
  options.Triangulation = triangulation;
  return HasArea(*triangulation, pulse)
    ? ""
    : "The cells of the spacing source have no area in the plane of the input.";
}

bool IsFillValue(double value)
{
  return !std::isnan(value) && !(value > 0.0 && std::isfinite(value));
}

// The values as doubles, NaN for those that are no spacing where none is wanted.
vtkSmartPointer<vtkDoubleArray> KnownValues(vtkDataSet* source, vtkDataArray* given,
  const PlaneFrame& frame, const std::function<bool(const Point2&)>& isWanted, Pulse& pulse)
{
  vtkSmartPointer<vtkDoubleArray> values = AsDoubles(given);
  bool isOwn = false;
  bool isAnyKnown = false;
  pulse.ForEach(static_cast<std::size_t>(source->GetNumberOfPoints()),
    [source, given, &frame, &isWanted, &values, &isOwn, &isAnyKnown](std::size_t k)
    {
      const auto point = static_cast<vtkIdType>(k);
      double place[3];
      if (!IsFillValue(values->GetValue(point)))
      {
        isAnyKnown = isAnyKnown || values->GetValue(point) > 0.0;
        return;
      }
      source->GetPoint(point, place);
      if (isWanted(frame.ToPlane(place)))
      {
        return;
      }
      if (!isOwn)
      {
        const auto own = vtkSmartPointer<vtkDoubleArray>::New();
        own->DeepCopy(values);
        own->SetName(given->GetName());
        values = own;
        isOwn = true;
      }
      values->SetValue(point, std::numeric_limits<double>::quiet_NaN());
    });
  // Where nothing else is known, what is given is refused by its values.
  return isAnyKnown ? values : vtkSmartPointer<vtkDoubleArray>(AsDoubles(given));
}

} // namespace

std::string AddSourceSpacing(const SourceData& chosen, const PlaneFrame& frame,
  const std::function<bool(const Point2&)>& isWanted, SpacingOptions& options,
  ProblemPlaces& places, Monitor& monitor)
{
  Pulse pulse(monitor);
  vtkDataSet* source = chosen.Data;
  vtkDataArray* given = chosen.Chosen.Array;
  if (given->GetNumberOfComponents() != 1 ||
    given->GetNumberOfTuples() < source->GetNumberOfPoints())
  {
    return CheckSpacingValues(source, given, {}, SpacingOwner::Source, places, pulse);
  }
  const std::string misplaced = CheckImage(source);
  if (!misplaced.empty())
  {
    return misplaced;
  }
  const auto values = KnownValues(source, given, frame, isWanted, pulse);
  auto grid = GridFrom(source, values->GetPointer(0), frame, pulse);
  const std::string refusal = grid
    ? AddGrid(source, values, std::move(grid), options, places, pulse)
    : AddCells(source, values, frame, chosen.MayOverlap, options, places, pulse);
  return pulse.HasStopped() ? "" : refusal;
}

} // namespace biting
