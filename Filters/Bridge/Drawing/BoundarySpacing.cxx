// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySpacing.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Pulse.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Source/SpacingValues.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm> // for max, min, sort, upper_bound
#include <cmath>     // for ceil, isfinite, isnan

namespace biting
{

namespace
{

void AddSegments(const Polylines& chains, Id chain, const std::vector<Id>& newIds,
  std::vector<Id>& segments, Pulse& pulse)
{
  const auto first = static_cast<std::size_t>(chains.Offsets[chain]);
  const auto end = static_cast<std::size_t>(chains.Offsets[static_cast<std::size_t>(chain) + 1]);
  const bool isPoints = chains.Kinds[chain] == ChainKind::EmbeddedPoint || end - first == 1;
  const std::size_t step = isPoints ? 0 : 1;
  for (std::size_t k = first; k + step < end && pulse.Beat(); ++k)
  {
    const Id start = newIds[chains.Connectivity[k]];
    if (start != NoId)
    {
      segments.push_back(start);
      segments.push_back(newIds[chains.Connectivity[k + step]]);
    }
  }
}

// The points that chains use, of blocks with the array; ascending.
std::vector<vtkIdType> PointsWith(
  vtkDataArray* values, const Drawing& drawing, const PlanarInput& input)
{
  const std::vector<unsigned char> isGiven =
    values->GetName() ? drawing.FindGiven(values->GetName()) : std::vector<unsigned char>();
  std::vector<vtkIdType> points;
  for (const Id point : input.UsedPoints)
  {
    if (isGiven.empty() || isGiven[point])
    {
      points.push_back(point);
    }
  }
  return points;
}

// Values at points that divide lines: linear along these, if both ends have one.
void AddDivisions(const PlanarInput& input, std::vector<Id>& newIds, SegmentSource& source)
{
  auto point = input.Chains.Points.size() - input.Divisions.size();
  for (const PlanarInput::Division& division : input.Divisions)
  {
    const Id start = newIds[division.Start];
    const Id end = newIds[division.End];
    if (start != NoId && end != NoId)
    {
      const double low = source.Values[start];
      const double high = source.Values[end];
      newIds[point] = static_cast<Id>(source.Points.size());
      source.Points.push_back(input.Chains.Points[point]);
      source.Values.push_back(low + division.Share * (high - low));
    }
    ++point;
  }
}

// Values are lengths of the plane from here on.
void Stretch(const PlaneFrame& frame, SegmentSource& source)
{
  for (std::size_t k = 0; k < source.Points.size(); ++k)
  {
    source.Values[k] *= frame.StretchAt(source.Points[k]);
  }
}

std::string AddPointSpacing(const Drawing& drawing, const PlanarInput& input, vtkDataArray* values,
  SpacingOptions& options, ProblemPlaces& places, Pulse& pulse)
{
  const std::vector<vtkIdType> used = PointsWith(values, drawing, input);
  std::vector<double> read;
  const std::string refusal =
    ReadOwnValues(drawing.Points, values, used, LeastValue(options), read, places, pulse);
  if (!refusal.empty())
  {
    return refusal;
  }
  auto source = std::make_shared<SegmentSource>();
  std::vector<Id> newIds(input.IsUsed.size(), NoId);
  for (std::size_t k = 0; k < used.size() && pulse.Beat(); ++k)
  {
    const auto point = static_cast<std::size_t>(used[k]);
    newIds[point] = static_cast<Id>(k);
    source->Points.push_back(input.Chains.Points[point]);
    source->Values.push_back(read[point]);
  }
  AddDivisions(input, newIds, *source);
  Stretch(input.Frame, *source);
  for (Id chain = 0; chain < input.Chains.NumberOfChains() && pulse.Beat(); ++chain)
  {
    AddSegments(input.Chains, chain, newIds, source->Segments, pulse);
  }
  SortSource(*source, pulse);
  options.Sources.emplace_back(source);
  return {};
}

void AddSegment(const Point2& start, const Point2& end, double value, SegmentSource& source)
{
  const auto first = static_cast<Id>(source.Points.size());
  source.Points.insert(source.Points.end(), { start, end });
  source.Values.insert(source.Values.end(), 2, value);
  source.Segments.insert(source.Segments.end(), { first, first + 1 });
}

// A square face with k lines has (k / 3)^2 vertices: k / 9 a line, seven where k is 64. So faces of
// more than 64 lines with more than 2^22 lines together are a mesh of some 30 million vertices.
constexpr double LinesOfFineFace = 64.0;
constexpr double MostLinesOfFineFaces = 1 << 22;

// Lines across a face, along the longer side of its box, at distances of at most `step`; none where
// fine faces have too many lines together.
void AddHatching(const std::vector<Point2>& outline, double value, double step, double& fineLines,
  SegmentSource& source, Pulse& pulse)
{
  const Box2 box = Box2::Around(outline);
  const bool isAlongX = box.Width() >= box.Height();
  const auto turned = [isAlongX](const Point2& p) { return isAlongX ? p : Point2{ p.Y, p.X }; };
  const double low = turned(box.Low).Y;
  const double gaps = std::ceil((turned(box.High).Y - low) / step);
  fineLines += gaps > LinesOfFineFace ? gaps : 0.0;
  std::vector<double> crossings;
  const bool isRefused = fineLines > MostLinesOfFineFaces;
  for (double line = 1.0; line < gaps && !isRefused && pulse.Beat(); line += 1.0)
  {
    const double level = low + line / gaps * (turned(box.High).Y - low);
    crossings.clear();
    for (std::size_t k = 1; k < outline.size(); ++k)
    {
      const Point2 a = turned(outline[k - 1]);
      const Point2 b = turned(outline[k]);
      if ((a.Y <= level) != (b.Y <= level))
      {
        crossings.push_back(a.X + (level - a.Y) / (b.Y - a.Y) * (b.X - a.X));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 1; k < crossings.size(); k += 2)
    {
      AddSegment(
        turned({ crossings[k - 1], level }), turned({ crossings[k], level }), value, source);
    }
  }
}

// In a face f = v + g d, where d <= step / 2 is the distance from the nearest line: at most 5 %
// above v where step = 0.1 v / g.
double StepOf(double value, const SpacingOptions& options)
{
  constexpr double Excess = 0.05;
  constexpr double UsualGradation = 0.3; // where none is given
  const double slope = options.Gradation > 0.0 ? options.Gradation : UsualGradation;
  return 2.0 * Excess * std::max(value * options.Scale, options.Minimum) / std::max(slope, 0.1);
}

// Whether the cell has an area, also where its outline is an interface only.
bool HasArea(const Drawing& drawing, Id cell)
{
  const auto after = std::upper_bound(drawing.Blocks.begin(), drawing.Blocks.end(), cell,
    [](Id wanted, const DrawingBlock& block) { return wanted < block.FirstCell; });
  const DrawingBlock& block = *(after - 1);
  const vtkIdType own = cell - block.FirstCell;
  if (auto* lines = vtkPolyData::SafeDownCast(block.Data)) // whose types are not known as yet
  {
    return own >= lines->GetNumberOfVerts() + lines->GetNumberOfLines();
  }
  const CellShape shape = ShapeOf(block.Data->GetCellType(own));
  return shape == CellShape::Face || shape == CellShape::Strip;
}

void AddChain(const Polylines& chains, std::size_t chain, bool hasArea, double value,
  const SpacingOptions& options, double& fineLines, SegmentSource& source, Pulse& pulse)
{
  std::vector<Point2> places;
  for (Id k = chains.Offsets[chain]; k < chains.Offsets[chain + 1]; ++k)
  {
    places.push_back(chains.Points[chains.Connectivity[k]]);
  }
  const bool arePoints = chains.Kinds[chain] == ChainKind::EmbeddedPoint || places.size() == 1;
  for (std::size_t k = arePoints ? 0 : 1; k < places.size() && pulse.Beat(); ++k)
  {
    AddSegment(places[arePoints ? k : k - 1], places[k], value, source);
  }
  if (hasArea && !arePoints)
  {
    AddHatching(places, value, StepOf(value, options), fineLines, source, pulse);
  }
}

std::string AddCellSpacing(const Drawing& drawing, const PlanarInput& input, vtkDataArray* values,
  SpacingOptions& options, Pulse& pulse)
{
  const Polylines& chains = input.Chains;
  const std::string subject =
    std::string("The spacing array ") + (values->GetName() ? values->GetName() : "");
  if (values->GetNumberOfComponents() != 1 || values->GetNumberOfTuples() < drawing.NumberOfCells)
  {
    return subject + " must have one value for each of the " +
      std::to_string(drawing.NumberOfCells) + " cells.";
  }
  std::vector<std::string> bad;
  std::int64_t count = 0;
  double fineLines = 0.0;
  auto source = std::make_shared<SegmentSource>();
  for (std::size_t chain = 0; chain < chains.Cells.size() && pulse.Beat(); ++chain)
  {
    const double value = values->GetComponent(chains.Cells[chain], 0);
    const bool isSpacing = value > 0.0 && std::isfinite(value);
    if (isSpacing)
    {
      const bool hasArea = HasArea(drawing, chains.Cells[chain]);
      AddChain(chains, chain, hasArea, value, options, fineLines, *source, pulse);
    }
    else if (value != 0.0 && !std::isnan(value) && ++count <= static_cast<std::int64_t>(ShownIds))
    {
      bad.push_back("cell " + std::to_string(chains.Cells[chain]) + " with " + ShortText(value));
    }
  }
  if (fineLines > MostLinesOfFineFaces)
  {
    return subject +
      " has sizes far below those of cells: the mesh would be too large. Choose "
      "larger sizes.";
  }
  Stretch(input.Frame, *source);
  SortSource(*source, pulse);
  if (!source->IsEmpty())
  {
    options.Sources.emplace_back(source);
  }
  return count == 0 ? ""
                    : subject + " has values of cells that are negative or infinite (" +
      std::to_string(count) + "): " + ListText(bad, count) + ". Spacing is an edge length.";
}

} // namespace

ChosenArray ChooseBoundaryArray(vtkInformation* choice, const Drawing& drawing)
{
  constexpr ArrayRole Role{ "spacing array", "input" };
  const bool isNamed = choice->Has(vtkDataObject::FIELD_NAME()) != 0;
  const bool isOther = !isNamed && choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  const char* name = isNamed ? choice->Get(vtkDataObject::FIELD_NAME()) : SpacingArrayName;
  const bool areCells = choice->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  ChosenArray chosen;
  chosen.Array = vtkDataArray::SafeDownCast(drawing.CellArrays->GetAbstractArray(name));
  chosen.IsOfCells =
    !isOther && chosen.Array && (areCells || !drawing.Points->GetPointData()->HasArray(name));
  if (chosen.IsOfCells)
  {
    return chosen;
  }
  return isNamed && areCells ? ArrayNamed(name, drawing.Points, Role)
                             : ChooseArray(choice, drawing.Points, Role);
}

std::string AddBoundarySpacing(const Drawing& drawing, const PlanarInput& input,
  const ChosenArray& chosen, SpacingOptions& options, ProblemPlaces& places, Monitor& monitor)
{
  Pulse pulse(monitor);
  return chosen.IsOfCells ? AddCellSpacing(drawing, input, chosen.Array, options, pulse)
                          : AddPointSpacing(drawing, input, chosen.Array, options, places, pulse);
}

} // namespace biting
