// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpaceSpacing.h"

#include "../../Kernel/Base/BoxTree.h"
#include "../../Kernel/Spacing/ConeTree.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "SpacingValues.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm> // for clamp, fill_n, max, min, sort
#include <cmath>     // for floor, isnan, nan
#include <limits>    // for the least distance
#include <memory>    // for sharing
#include <utility>   // for pairs

namespace biting
{

namespace
{

// Ghosts of other pieces have values.
constexpr int CellsWithoutValues =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

// A value as Uniform, SpacingScale and the bounds make it.
double Clamped(double value, const SpacingOptions& options)
{
  value = options.Uniform > 0.0 ? std::min(value, options.Uniform) : value;
  value = std::max(value * options.Scale, options.Minimum);
  return options.Maximum > 0.0 ? std::min(value, options.Maximum) : value;
}

// A cell of the source as an item of a tree.
struct SourceItem
{
  Box3 Bounds;
  vtkIdType Cell;

  const Box3& Box() const { return this->Bounds; }
  double Least() const { return 0.0; }
};

// What is given at a place.
class SourceOfSpace
{
public:
  SourceOfSpace(vtkDataSet* data, std::vector<double> values, const SpacingOptions& options)
    : Data(data)
    , Options(options)
    , Values(std::move(values))
    , Ghosts(data, CellsWithoutValues)
  {
    for (double& value : this->Values)
    {
      value = std::isnan(value) ? value : Clamped(value, options);
    }
  }
  virtual ~SourceOfSpace() = default;
  SourceOfSpace(const SourceOfSpace&) = delete;
  SourceOfSpace& operator=(const SourceOfSpace&) = delete;

  virtual double At(const Point3& x) const = 0;

  void Grade(const Box3& bounds, Monitor& monitor, Pulse& pulse);

  double operator()(const Point3& x) const
  {
    const double given = this->At(x);
    return this->IsGraded ? std::min(given, this->Cones(x)) : given;
  }

protected:
  /// Whether something is given in a cell: it is not hidden, and there is a value at each corner.
  bool IsKnown(vtkIdType id, vtkCell* cell) const;

  vtkSmartPointer<vtkDataSet> Data;
  SpacingOptions Options;
  std::vector<double> Values; ///< of points, clamped; NaN: nothing is given

private:
  void AddConesOf(vtkCell* cell, std::vector<std::pair<vtkIdType, vtkIdType>>& edges) const;

  GhostArrays Ghosts;
  ConeTree<3> Cones;
  bool IsGraded = false;
};

bool SourceOfSpace::IsKnown(vtkIdType id, vtkCell* cell) const
{
  const vtkIdType size = cell->GetNumberOfPoints();
  const vtkIdType* points = cell->GetPointIds()->GetPointer(0);
  return size > 0 && !this->Ghosts.LeaveOut(id, size, points) &&
    std::none_of(points, points + size,
      [this](vtkIdType point)
      { return std::isnan(this->Values[static_cast<std::size_t>(point)]); });
}

// The edges, or one end of each, from which f grows by less than what is given.
void SourceOfSpace::AddConesOf(
  vtkCell* cell, std::vector<std::pair<vtkIdType, vtkIdType>>& edges) const
{
  std::vector<std::pair<vtkIdType, vtkIdType>> flat;
  bool isSteep = false;
  const vtkIdType size = cell->GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i)
  {
    for (vtkIdType j = i + 1; j < size; ++j)
    {
      Point3 a;
      Point3 b;
      cell->GetPoints()->GetPoint(i, a.Data());
      cell->GetPoints()->GetPoint(j, b.Data());
      const vtkIdType first = cell->GetPointId(static_cast<int>(i));
      const vtkIdType second = cell->GetPointId(static_cast<int>(j));
      const double change = this->Values[second] - this->Values[first];
      if (std::abs(change) > this->Options.Gradation * Distance(a, b))
      {
        isSteep = true;
        edges.emplace_back(change > 0.0 ? first : second, change > 0.0 ? first : second);
      }
      else
      {
        flat.emplace_back(std::min(first, second), std::max(first, second));
      }
    }
  }
  if (isSteep)
  {
    edges.insert(edges.end(), flat.begin(), flat.end());
  }
}

void SourceOfSpace::Grade(const Box3& bounds, Monitor& monitor, Pulse& pulse)
{
  double most = 0.0;
  for (const double value : this->Values)
  {
    most = std::max(most, std::isnan(value) ? 0.0 : value);
  }
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkGenericCell> cell;
  pulse.ForEach(static_cast<std::size_t>(this->Data->GetNumberOfCells()),
    [this, &edges, &cell](std::size_t k)
    {
      this->Data->GetCell(static_cast<vtkIdType>(k), cell);
      if (this->IsKnown(static_cast<vtkIdType>(k), cell))
      {
        this->AddConesOf(cell, edges);
      }
    });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Cone<3>> cones;
  const double slope = this->Options.Gradation;
  pulse.ForEach(edges.size(),
    [this, &edges, &cones, &bounds, slope, most](std::size_t k)
    {
      Point3 a;
      Point3 b;
      this->Data->GetPoint(edges[k].first, a.Data());
      this->Data->GetPoint(edges[k].second, b.Data());
      const double atA = this->Values[edges[k].first];
      const double atB = this->Values[edges[k].second];
      const double away = std::max(bounds.DistanceTo(a) - Distance(a, b), 0.0);
      if (std::min(atA, atB) + slope * away < most)
      {
        cones.emplace_back(a, b, atA, atB, slope);
      }
    });
  this->IsGraded = !cones.empty() && !pulse.HasStopped();
  if (this->IsGraded)
  {
    this->Cones = ConeTree<3>(cones, slope, bounds, most, monitor);
  }
}

// An image: trilinear; outside the nearest place of it.
class ImageOfSpace : public SourceOfSpace
{
public:
  ImageOfSpace(vtkImageData* image, std::vector<double> values, const SpacingOptions& options)
    : SourceOfSpace(image, std::move(values), options)
  {
    image->GetPoint(0, this->Origin.Data());
    vtkNew<vtkMatrix3x3> toImage;
    vtkMatrix3x3::Invert(image->GetDirectionMatrix(), toImage);
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double* axis = toImage->GetData() + 3 * d;
      this->Size[d] = image->GetDimensions()[d];
      this->Axes[d] = (1.0 / image->GetSpacing()[d]) * Point3{ axis[0], axis[1], axis[2] };
    }
  }

  double At(const Point3& x) const override
  {
    std::size_t low[3];
    double share[3];
    std::size_t next[3];
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double most = this->Size[d] - 1.0;
      // Not clamp: of a step of zero, as single slices may have, the place may be NaN.
      const double place = std::max(0.0, std::min(Dot(x - this->Origin, this->Axes[d]), most));
      const double floor = std::min(std::floor(place), std::max(most - 1.0, 0.0));
      low[d] = static_cast<std::size_t>(floor);
      share[d] = place - floor;
      next[d] = most > 0.0 ? 1 : 0;
    }
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      std::size_t node = 0;
      for (std::size_t d = 3; d-- > 0;)
      {
        const bool isHigh = ((corner >> d) & 1u) != 0;
        weight *= isHigh ? share[d] : 1.0 - share[d];
        node = node * static_cast<std::size_t>(this->Size[d]) + low[d] + (isHigh ? next[d] : 0);
      }
      sum += weight > 0.0 ? weight * this->Values[node] : 0.0;
    }
    return sum;
  }

private:
  Point3 Origin;
  Point3 Axes[3]; ///< by how many points of the image a step in space leads on along each
  int Size[3] = { 1, 1, 1 };
};

// Voxels of a turned image as hexahedra: vtkVoxel takes its edges for parallel to the axes.
vtkGenericCell* WithoutVoxel(vtkGenericCell* cell)
{
  constexpr int Order[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  static thread_local vtkNew<vtkGenericCell> hexahedron;
  if (cell->GetCellType() != VTK_VOXEL)
  {
    return cell;
  }
  hexahedron->SetCellType(VTK_HEXAHEDRON);
  for (vtkIdType k = 0; k < 8; ++k)
  {
    hexahedron->GetPointIds()->SetId(k, cell->GetPointId(Order[k]));
    hexahedron->GetPoints()->SetPoint(k, cell->GetPoints()->GetPoint(Order[k]));
  }
  return hexahedron;
}

// Cells of any kind.
class CellsOfSpace : public SourceOfSpace
{
public:
  CellsOfSpace(
    vtkDataSet* data, std::vector<double> values, const SpacingOptions& options, Pulse& pulse)
    : SourceOfSpace(data, std::move(values), options)
  {
    std::vector<SourceItem> items;
    vtkNew<vtkGenericCell> cell;
    pulse.ForEach(static_cast<std::size_t>(data->GetNumberOfCells()),
      [this, data, &items, &cell](std::size_t k)
      {
        data->GetCell(static_cast<vtkIdType>(k), cell);
        SourceItem item;
        item.Cell = static_cast<vtkIdType>(k);
        bool isKnown = this->IsKnown(item.Cell, cell);
        for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
        {
          Point3 place;
          cell->GetPoints()->GetPoint(i, place.Data());
          item.Bounds.Add(place);
          isKnown = isKnown && AreFinite(place.Data());
        }
        if (isKnown)
        {
          items.push_back(item);
        }
      });
    this->Tree = BoxTree<SourceItem, 3>(items, pulse);
  }

  bool IsEmpty() const { return this->Tree.Items().empty(); }

  double At(const Point3& x) const override
  {
    static thread_local vtkNew<vtkGenericCell> cell; // one a thread: to make one costs more than At
    double nearest = Infinity;
    double least = Infinity;
    this->Tree.Search(x, 1.0, Infinity,
      [this, &x, &nearest, &least](const SourceItem& item, double)
      {
        double distance = 0.0;
        const double value = this->ValueIn(item.Cell, x, cell, distance);
        least = distance < nearest ? value : distance == nearest ? std::min(value, least) : least;
        nearest = std::min(nearest, distance);
        return nearest > 0.0 ? nearest : std::numeric_limits<double>::min();
      });
    return least;
  }

private:
  // The value at the nearest place of the cell, and how far it is.
  double ValueIn(vtkIdType id, const Point3& x, vtkGenericCell* own, double& distance) const
  {
    this->Data->GetCell(id, own);
    vtkGenericCell* cell = WithoutVoxel(own);
    static thread_local std::vector<double> all;
    all.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    double* weights = all.data();
    Point3 closest = x;
    Point3 place = x;
    double parametric[3];
    double squared = 0.0;
    int part = 0;
    int state =
      cell->EvaluatePosition(place.Data(), closest.Data(), part, parametric, squared, weights);
    distance = state == 1 ? std::sqrt(squared) : Distance(x, closest);
    if (state == 0)
    {
      place = closest;
      state =
        cell->EvaluatePosition(place.Data(), closest.Data(), part, parametric, squared, weights);
    }
    if (state == -1) // of a cell without volume, or far away: its nearest corner
    {
      distance = Infinity;
      for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
      {
        cell->GetPoints()->GetPoint(i, closest.Data());
        const bool isNearest = Distance(x, closest) < distance;
        distance = isNearest ? Distance(x, closest) : distance;
        std::fill_n(weights, isNearest ? i : 0, 0.0);
        weights[i] = isNearest ? 1.0 : 0.0;
      }
    }
    double sum = 0.0;
    double low = Infinity;
    double high = 0.0;
    for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      const double value = this->Values[cell->GetPointId(i)];
      sum += weights[i] * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return std::clamp(sum, low, high);
  }

  BoxTree<SourceItem, 3> Tree;
};

// Whether ImageOfSpace can hold it.
bool IsPlainImage(vtkDataSet* data, const std::vector<double>& values)
{
  return vtkImageData::SafeDownCast(data) && data->GetNumberOfPoints() > 0 &&
    !HasGhosts(data, vtkDataObject::CELL, CellsWithoutValues) &&
    std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

} // namespace

std::string MakeSpaceSpacing(const SourceData& source, const SpacingOptions& options,
  const Box3& bounds, SpaceSpacing& spacing, ProblemPlaces& places, Monitor& monitor)
{
  vtkDataSet* data = source.Data;
  if (!data || !source.Chosen.Array)
  {
    const double value = Clamped(options.Uniform, options);
    spacing = options.Uniform > 0.0 ? [value](const Point3&) { return value; } : SpaceSpacing();
    return source.Chosen.Refusal;
  }
  Pulse pulse(monitor);
  std::string refusal = CheckShape(data, source.Chosen.Array);
  if (!refusal.empty())
  {
    return refusal;
  }
  std::vector<double> values = ReadDoubles(source.Chosen.Array, data->GetNumberOfPoints());
  const double least = LeastValue(options);
  const GhostArrays ghosts(data);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    values[k] = values[k] <= 0.0 && least > 0.0 ? least : values[k];
    values[k] = ghosts.IsHidden(static_cast<vtkIdType>(k)) ? std::nan("") : values[k];
  }
  refusal = CheckReadValues(
    data, source.Chosen.Array, values, nullptr, SpacingOwner::Source, places, pulse);
  if (!refusal.empty())
  {
    return refusal;
  }
  std::shared_ptr<SourceOfSpace> field;
  if (IsPlainImage(data, values))
  {
    field =
      std::make_shared<ImageOfSpace>(vtkImageData::SafeDownCast(data), std::move(values), options);
  }
  else
  {
    auto cells = std::make_shared<CellsOfSpace>(data, std::move(values), options, pulse);
    if (cells->IsEmpty() && !pulse.HasStopped())
    {
      return "The spacing source has no cell with values at all of its points.";
    }
    field = cells;
  }
  if (options.Gradation > 0.0)
  {
    field->Grade(bounds, monitor, pulse);
  }
  spacing = [field](const Point3& x) { return (*field)(x); };
  return {};
}

} // namespace biting
