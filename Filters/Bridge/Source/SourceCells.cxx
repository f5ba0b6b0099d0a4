// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceCells.h"

#include "../../Kernel/Base/SortInSteps.h"
#include "../Data/Cells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>  // for unique, lower_bound
#include <array>      // for nodes of a polygon
#include <functional> // for less
#include <limits>     // for the size check
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

  void Add(vtkIdType point) { this->Points[this->Size++] = point; }
  vtkIdType operator[](int k) const { return this->Points[k]; }
};

// As GridEnd.
constexpr double DistancesEnd = 0.2;
constexpr double LocatingEnd = 0.8;
constexpr double PointsEnd = 0.85;

constexpr std::size_t CheapStepsPerCell = 32; // a polygon takes a microsecond to triangulate

// Advice where there are no cells.
constexpr const char* PointsAdvice = " Delaunay 2D makes triangles of points.";

// The entries of a ghost array for the cells from `first` on.
void CopyGhosts(vtkPolyData* source, vtkIdType first, vtkPolyData* copy)
{
  vtkUnsignedCharArray* ghosts = GhostsOf(source, vtkDataObject::CELL);
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

// Triangles for a polygon that VTK cannot triangulate, as its outline touches or crosses itself:
// they may overlap, and cover holes of it.
void FanOut(vtkIdList* outline, vtkIdList* corners)
{
  corners->Reset();
  for (vtkIdType k = 2; k < outline->GetNumberOfIds(); ++k)
  {
    corners->InsertNextId(outline->GetId(0));
    corners->InsertNextId(outline->GetId(k - 1));
    corners->InsertNextId(outline->GetId(k));
  }
}

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
    const double distance = this->Distances[points[corner]];
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
      nodes[size++] = this->EdgeNode(below[b], above[turned]);
    }
  }
  for (int k = 0; k < on.Size; ++k)
  {
    nodes[size++] = on[k];
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
        const Edge& edge = given[node - numberOfPoints];
        const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge);
        node = numberOfPoints + static_cast<vtkIdType>(found - this->Edges.begin());
      }
    });
}

double PlaneCut::Fraction(const Edge& edge) const
{
  const double low = this->Distances[edge.Low];
  const double high = this->Distances[edge.High];
  return low / (low - high);
}

SourceCells::SourceCells(vtkDataSet* source, const PlaneFrame& frame, Pulse& pulse)
  : Source(ShallowCopyOf(source))
  , Frame(frame)
  , Beats(pulse)
  , Ghosts(this->Source)
  , Distances(static_cast<std::size_t>(source->GetNumberOfPoints()))
  , Cut(this->Distances)
  , HasCells(source->GetNumberOfCells() > 0)
{
  this->Dimensions.fill(-1);
}

std::string SourceCells::Collect()
{
  if (!this->HasCells)
  {
    return std::string("The spacing source has no cells to interpolate in.") + PointsAdvice;
  }
  this->MeasureDistances();
  this->CollectCells();
  if (!this->Malformed.empty())
  {
    return this->Malformed;
  }
  this->Cut.MergeEdges(this->Beats);
  if (!this->Cut.GetTriangles().empty())
  {
    constexpr std::size_t Limit = std::numeric_limits<Id>::max();
    const bool isTooLarge =
      this->NumberOfNodes() > Limit || this->Cut.GetTriangles().size() > Limit;
    return isTooLarge ? "The spacing source has more cells than 32-bit ids can number." : "";
  }
  return this->HasVolumes
    ? "The spacing source does not meet the plane of the input."
    : std::string("The spacing source has no visible cells with an area or a volume.") +
      PointsAdvice;
}

void SourceCells::MeasureDistances()
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

void SourceCells::CollectCells()
{
  const PulsePart part(this->Beats, DistancesEnd, LocatingEnd);
  const vtkIdType numberOfCells = this->Source->GetNumberOfCells();
  for (vtkIdType cell = 0;
       cell < numberOfCells && this->Malformed.empty() && this->Beats.Beat(CheapStepsPerCell);
       ++cell)
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

int SourceCells::Dimension(int cellType)
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

// Leaves the points of the cell in Corners.
bool SourceCells::IsSource(vtkIdType cell)
{
  this->Source->GetCellPoints(cell, this->Corners);
  this->Malformed = MissingPointText("the spacing source", cell, this->Corners->GetNumberOfIds(),
    this->Corners->GetPointer(0), this->Source->GetNumberOfPoints());
  return this->Malformed.empty() &&
    !this->Ghosts.LeaveOut(cell, this->Corners->GetNumberOfIds(), this->Corners->GetPointer(0));
}

bool SourceCells::MeetsPlane() const
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (vtkIdType k = 0; k < this->Corners->GetNumberOfIds(); ++k)
  {
    const double distance = this->Distances[this->Corners->GetId(k)];
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  return low <= 0.0 && high >= 0.0;
}

// Expects the points of the cell in Corners.
void SourceCells::AddCell(vtkIdType cell, int dimension)
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
  if (!this->Cell->Triangulate(static_cast<int>(cell % 2), this->Corners, this->Places) &&
    this->Cell->GetCellType() == VTK_POLYGON)
  {
    FanOut(this->Cell->GetPointIds(), this->Corners);
  }
  const vtkIdType size = dimension + 1;
  for (vtkIdType k = 0; k + size <= this->Corners->GetNumberOfIds(); k += size)
  {
    const vtkIdType* points = this->Corners->GetPointer(k);
    // VTK returns anything for a cell of high order with a number of points that is of no order.
    const bool areIds = std::all_of(points, points + size,
      [this](vtkIdType id)
      { return id >= 0 && static_cast<std::size_t>(id) < this->Distances.size(); });
    if (areIds && dimension == 3)
    {
      this->Cut.AddTetrahedron(points);
    }
    else if (areIds)
    {
      this->Cut.AddTriangle(points);
    }
  }
}

std::vector<vtkIdType> SourceCells::UsedPoints() const
{
  const PulsePart part(this->Beats, LocatingEnd, PointsEnd);
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
      isUsed[edges[k].Low] = 1;
      isUsed[edges[k].High] = 1;
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

std::shared_ptr<TriangulatedSource> SourceCells::Triangulation(const double* values) const
{
  auto triangulation = std::make_shared<TriangulatedSource>();
  std::vector<Id> newIds(this->NumberOfNodes(), NoId);
  const std::vector<vtkIdType>& nodes = this->Cut.GetTriangles();
  const PulsePart part(this->Beats, PointsEnd, TrianglesEnd);
  this->Beats.ForEach(nodes.size(),
    [this, values, &triangulation, &newIds, &nodes](std::size_t k)
    {
      Id& newId = newIds[nodes[k]];
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

std::vector<TupleMix> SourceCells::Origins() const
{
  std::vector<TupleMix> origins;
  std::vector<std::uint8_t> isKnown(this->NumberOfNodes(), 0);
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  const std::vector<vtkIdType>& nodes = this->Cut.GetTriangles();
  this->Beats.ForEach(nodes.size(),
    [this, numberOfPoints, &origins, &isKnown, &nodes](std::size_t k)
    {
      std::uint8_t& known = isKnown[nodes[k]];
      if (known == 0)
      {
        TupleMix origin;
        const bool isPoint = nodes[k] < numberOfPoints;
        const PlaneCut::Edge edge = isPoint ? PlaneCut::Edge{ nodes[k], nodes[k] }
                                            : this->Cut.GetEdges()[nodes[k] - numberOfPoints];
        const double fraction = isPoint ? 0.0 : this->Cut.Fraction(edge);
        origin.Add(edge.Low, 1.0 - fraction);
        origin.Add(edge.High, fraction);
        origins.push_back(origin);
      }
      known = 1;
    });
  return origins;
}

Point2 SourceCells::PlaceOf(vtkIdType node) const
{
  double place[3];
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  if (node < numberOfPoints)
  {
    this->Source->GetPoint(node, place);
    return this->Frame.ToPlane(place);
  }
  const PlaneCut::Edge& edge = this->Cut.GetEdges()[node - numberOfPoints];
  this->Source->GetPoint(edge.Low, place);
  const Point2 low = this->Frame.ToPlane(place);
  this->Source->GetPoint(edge.High, place);
  const Point2 high = this->Frame.ToPlane(place);
  return low + this->Cut.Fraction(edge) * (high - low);
}

double SourceCells::ValueOf(vtkIdType node, const double* values) const
{
  const auto numberOfPoints = static_cast<vtkIdType>(this->Distances.size());
  if (node < numberOfPoints)
  {
    return values[node];
  }
  const PlaneCut::Edge& edge = this->Cut.GetEdges()[node - numberOfPoints];
  return values[edge.Low] + this->Cut.Fraction(edge) * (values[edge.High] - values[edge.Low]);
}

} // namespace biting
