// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomInput.h"

#include "Base/Box.h"
#include "Base/Numbers.h"
#include "RandomDrawing.h"

#include <algorithm> // for min, max
#include <cmath>     // for isfinite
#include <limits>    // for values that are none
#include <memory>    // for sources
#include <ostream>   // for the file
#include <sstream>   // for the description

namespace biting
{

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

/// The box of the finite points.
Box2 BoundsOf(const Polylines& input)
{
  Box2 bounds;
  for (const Point2& point : input.Points)
  {
    if (std::isfinite(point.X + point.Y))
    {
      bounds.Add(point);
    }
  }
  if (bounds.IsEmpty())
  {
    bounds.Add({});
  }
  return bounds;
}

/// Makes up the spacing for a drawing in `bounds`.
class SpacingMaker
{
public:
  SpacingMaker(FuzzNumbers& numbers, const Polylines& input)
    : Numbers(numbers)
    , Input(input)
    , Bounds(BoundsOf(input))
    , Size(std::max(this->Bounds.Width(), this->Bounds.Height()))
  {
    this->Size = this->Size > 0.0 ? this->Size : 1.0;
  }

  SpacingOptions Make();

private:
  double Length();
  double Value();
  double Poison();
  double Gradation();
  std::vector<double> Nodes(double low, double high, int count);
  std::vector<double> Values(std::size_t count);
  std::shared_ptr<const GridSource> Grid();
  std::shared_ptr<const TriangulatedSource> Triangulation();
  std::shared_ptr<const SegmentSource> Segments();
  Point2 Place();

  FuzzNumbers& Numbers;
  const Polylines& Input;
  Box2 Bounds;
  double Size;
};

SpacingOptions SpacingMaker::Make()
{
  SpacingOptions options;
  const int sources = this->Numbers.Below(16);
  options.Uniform = sources < 14 ? this->Length() : 0.0;
  options.Gradation = this->Gradation();
  if (sources == 12 || sources == 15)
  {
    options.Sources.emplace_back(this->Grid());
  }
  if (sources == 13 || sources == 15)
  {
    options.Sources.emplace_back(this->Triangulation());
  }
  if (sources == 11 || sources == 15)
  {
    options.Sources.emplace_back(this->Segments());
  }
  if (this->Numbers.OneIn(8))
  {
    options.Scale = this->Numbers.Power(-2, 2);
    options.Minimum = this->Numbers.OneIn(2) ? this->Length() : 0.0;
    options.Maximum = this->Numbers.OneIn(2) ? 8.0 * this->Length() : 0.0;
  }
  if (this->Numbers.OneIn(100))
  {
    double* const parameters[] = { &options.Uniform, &options.Scale, &options.Minimum,
      &options.Maximum, &options.Gradation };
    *parameters[this->Numbers.Below(5)] = this->Poison();
  }
  return options;
}

double SpacingMaker::Length()
{
  const int kind = this->Numbers.Below(64);
  return this->Size *
    (kind == 63      ? this->Numbers.Power(-200, -12)
        : kind == 62 ? this->Numbers.Power(4, 80)
        : kind > 58  ? this->Numbers.Power(-6, -4)
                     : this->Numbers.Power(-3, 2));
}

double SpacingMaker::Value()
{
  return this->Size * this->Numbers.Power(-4, 2);
}

double SpacingMaker::Poison()
{
  const double poisons[] = { 0.0, Nan, -this->Size, Infinity, -Infinity, 1e-320, 1e100, 1e-200 };
  return poisons[this->Numbers.Below(8)];
}

double SpacingMaker::Gradation()
{
  const double gradations[] = { 0.3, 0.0, 0.1, 1.0, 1e-6, 20.0 };
  return gradations[this->Numbers.Below(6)];
}

/// Ascending, not always strictly.
std::vector<double> SpacingMaker::Nodes(double low, double high, int count)
{
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k)
  {
    nodes.push_back(low + this->Numbers.Below(9) / 8.0 * (high - low));
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// One value, some that differ little, or some that jump; seldom one that is none.
std::vector<double> SpacingMaker::Values(std::size_t count)
{
  std::vector<double> values(count, this->Value());
  const int style = this->Numbers.Below(4);
  for (std::size_t k = 0; style > 0 && k < count; ++k)
  {
    values[k] = style == 1 ? values[0] * (1.0 + this->Numbers.Unit()) : this->Value();
  }
  const bool mayPoison = this->Numbers.OneIn(8);
  for (double& value : values)
  {
    value = mayPoison && this->Numbers.OneIn(8) ? Nan : value;
    value = mayPoison && this->Numbers.OneIn(50) ? this->Poison() : value;
  }
  return values;
}

std::shared_ptr<const GridSource> SpacingMaker::Grid()
{
  auto grid = std::make_shared<GridSource>();
  const double margin = (this->Numbers.Unit() - 0.5) * this->Size;
  const Box2& box = this->Bounds;
  grid->XNodes = this->Nodes(box.Low.X - margin, box.High.X + margin, this->Numbers.Between(1, 5));
  grid->YNodes = this->Nodes(box.Low.Y - margin, box.High.Y + margin, this->Numbers.Between(1, 5));
  grid->Values = this->Values(grid->XNodes.size() * grid->YNodes.size());
  return grid;
}

std::shared_ptr<const TriangulatedSource> SpacingMaker::Triangulation()
{
  auto source = std::make_shared<TriangulatedSource>();
  const int points = this->Numbers.Between(3, 10);
  for (int k = 0; k < points; ++k)
  {
    source->Points.push_back(this->Place());
  }
  for (int corners = 3 * this->Numbers.Between(0, 8); corners > 0; --corners)
  {
    source->Triangles.push_back(this->Numbers.Below(points));
  }
  source->Values = this->Values(source->Points.size());
  return source;
}

/// Boundary values along the chains of the input, or some points and segments of its own.
std::shared_ptr<const SegmentSource> SpacingMaker::Segments()
{
  auto source = std::make_shared<SegmentSource>();
  const bool isBoundary = this->Numbers.Below(3) > 0 && this->Input.Points.size() < 200;
  if (isBoundary)
  {
    source->Points = this->Input.Points;
    for (std::size_t k = 1; k < this->Input.Connectivity.size(); ++k)
    {
      source->Segments.push_back(this->Input.Connectivity[k - 1]);
      source->Segments.push_back(this->Input.Connectivity[k]);
    }
  }
  const int ownPoints = isBoundary ? 0 : this->Numbers.Between(1, 6);
  for (int k = 0; k < ownPoints; ++k)
  {
    source->Points.push_back(this->Place());
    source->Segments.push_back(this->Numbers.Below(k + 1));
    source->Segments.push_back(this->Numbers.Below(k + 1));
  }
  source->Values = this->Values(source->Points.size());
  return source;
}

/// In the box grown by a half, on a coarse grid.
Point2 SpacingMaker::Place()
{
  const auto along = [this](double low, double width)
  { return low + (this->Numbers.Below(17) - 4) / 8.0 * width; };
  const double x = along(this->Bounds.Low.X, this->Bounds.Width());
  return { x, along(this->Bounds.Low.Y, this->Bounds.Height()) };
}

void MakeSimplification(FuzzNumbers& numbers, SimplificationOptions& options)
{
  const double tolerances[] = { 0.2, 0.05, 0.5, 1.0, 10.0, 0.0 };
  options.Tolerance = tolerances[numbers.Below(6)];
  const double angles[] = { 45.0, 0.0, 10.0, 90.0, 180.0 };
  options.CornerAngle = angles[numbers.Below(5)];
  options.MinimumLoopSize = numbers.OneIn(2) ? numbers.Power(-3, 3) : 0.0;
}

void MakeMeshOptions(FuzzNumbers& numbers, BitingMeshOptions& options)
{
  options.Domain.EndTolerance = 0.0; // the oracle looks for ends where they are drawn
  options.Domain.Repair = !numbers.OneIn(8);
  options.Domain.KeepCellEdges = numbers.OneIn(8);
  options.BitingConstant = numbers.OneIn(4) ? 0.1 + 0.9 * numbers.Unit() : 0.0;
  options.BiteShape = numbers.OneIn(3) ? BiteShape::Circle : BiteShape::Square;
  options.Placement = numbers.OneIn(2) ? Placement::Bisectors : Placement::Corners;
  const FrontOrder orders[] = { FrontOrder::Layers, FrontOrder::LargestY, FrontOrder::BestFirst };
  options.Order = orders[numbers.Below(3)];
  options.Phi = numbers.OneIn(4) ? 0.05 + 0.95 * numbers.Unit() : 1.0;
  options.Relaxation = numbers.OneIn(3);
  numbers.OneIn(4); // a choice that is gone: seeds keep their meaning
  options.KeepBites = numbers.OneIn(4);
  options.MaximumNumberOfBites = numbers.OneIn(8) ? numbers.Below(200) : -1;
  options.PreserveBoundary = numbers.OneIn(8);
  options.LimitByFeatureSize = numbers.OneIn(2);
  if (numbers.OneIn(4))
  {
    MakeSimplification(numbers, options.Simplification);
  }
  options.MaximumNumberOfVertices = numbers.OneIn(32) ? numbers.Below(100)
    : options.PreserveBoundary                        ? 500
                                                      : 1500;
}

/// Half of the cases: with the options that keep one block there would be nothing to try, and
/// meshes are finer, as cuts need room.
void MakeBlocks(FuzzNumbers& numbers, BitingMeshOptions& options)
{
  if (numbers.OneIn(2))
  {
    return;
  }
  options.VerticesPerBlock = numbers.Between(30, 300);
  options.MaximumNumberOfVertices = 4000;
  options.Spacing.Scale *= numbers.Power(-6, -1);
  options.Order = options.Order == FrontOrder::LargestY ? FrontOrder::Layers : options.Order;
  options.Relaxation = true;
  options.KeepBites = false;
  options.MaximumNumberOfBites = -1;
  options.PreserveBoundary = false;
}

const char* KindName(ChainKind kind)
{
  return kind == ChainKind::Automatic ? "-1"
    : kind == ChainKind::Boundary     ? "0"
    : kind == ChainKind::Interface    ? "1"
    : kind == ChainKind::Face         ? "3"
                                      : "2";
}

void WriteCells(std::ostream& file, const Polylines& input, bool areVertices)
{
  std::ostringstream cells;
  std::size_t count = 0;
  std::size_t numbers = 0;
  for (std::size_t chain = 0; chain < input.Kinds.size(); ++chain)
  {
    if ((input.Kinds[chain] == ChainKind::EmbeddedPoint) == areVertices)
    {
      cells << input.Offsets[chain + 1] - input.Offsets[chain];
      for (Id k = input.Offsets[chain]; k < input.Offsets[chain + 1]; ++k)
      {
        cells << ' ' << input.Connectivity[static_cast<std::size_t>(k)];
        ++numbers;
      }
      cells << '\n';
      ++count;
    }
  }
  file << (areVertices ? "VERTICES " : "LINES ") << count << ' ' << count + numbers << '\n'
       << cells.str();
}

void WriteKinds(std::ostream& file, const Polylines& input, bool areVertices)
{
  for (const ChainKind kind : input.Kinds)
  {
    if ((kind == ChainKind::EmbeddedPoint) == areVertices)
    {
      file << KindName(kind) << '\n';
    }
  }
}

/// Sometimes, as the filter does for every drawing.
void MakeSeams(FuzzNumbers& numbers, Polylines& input)
{
  if (!numbers.OneIn(8))
  {
    return;
  }
  Box2 box;
  for (const Point2& place : input.Points)
  {
    box.Add(place);
  }
  const double size = box.Diagonal();
  input.SeamNoise =
    std::isfinite(size) ? SeamInUlp * std::numeric_limits<double>::epsilon() * size : 0.0;
}

} // namespace

FuzzCase MakeFuzzCase(FuzzNumbers& numbers, FuzzBlocks blocks)
{
  FuzzCase fuzzCase;
  fuzzCase.Input = MakeRandomDrawing(numbers);
  fuzzCase.Options.Spacing = SpacingMaker(numbers, fuzzCase.Input).Make();
  MakeMeshOptions(numbers, fuzzCase.Options);
  fuzzCase.StopAtCall = numbers.OneIn(24) ? numbers.Below(24) : -1;
  // Last, so that seeds from before there were blocks and seams keep their meaning.
  if (blocks == FuzzBlocks::Small)
  {
    MakeBlocks(numbers, fuzzCase.Options);
    MakeSeams(numbers, fuzzCase.Input);
  }
  return fuzzCase;
}

void WriteLegacyVtk(std::ostream& file, const Polylines& input, const std::string& title)
{
  file << "# vtk DataFile Version 3.0\n" << title << "\nASCII\nDATASET POLYDATA\n";
  file.precision(17);
  file << "POINTS " << input.Points.size() << " double\n";
  for (const Point2& point : input.Points)
  {
    file << point.X << ' ' << point.Y << " 0\n";
  }
  WriteCells(file, input, true);
  WriteCells(file, input, false);
  file << "CELL_DATA " << input.Kinds.size() << "\nSCALARS Kind int 1\nLOOKUP_TABLE default\n";
  WriteKinds(file, input, true);
  WriteKinds(file, input, false);
}

std::string Describe(const FuzzCase& fuzzCase)
{
  const BitingMeshOptions& options = fuzzCase.Options;
  const SpacingOptions& spacing = options.Spacing;
  std::ostringstream text;
  text.precision(17);
  text << "points=" << fuzzCase.Input.Points.size() << " chains=" << fuzzCase.Input.Kinds.size()
       << " uniform=" << spacing.Uniform << " scale=" << spacing.Scale
       << " minimum=" << spacing.Minimum << " maximum=" << spacing.Maximum
       << " gradation=" << spacing.Gradation << " sources=" << spacing.Sources.size()
       << " repair=" << options.Domain.Repair << " edges=" << options.Domain.KeepCellEdges
       << " constant=" << options.BitingConstant
       << " circles=" << (options.BiteShape == BiteShape::Circle)
       << " bisectors=" << (options.Placement == Placement::Bisectors)
       << " order=" << static_cast<int>(options.Order) << " limit=" << options.LimitByFeatureSize
       << " phi=" << options.Phi << " relaxation=" << options.Relaxation
       << " seams=" << fuzzCase.Input.SeamNoise << " block=" << options.VerticesPerBlock
       << " tolerance=" << options.Simplification.Tolerance
       << " corner=" << options.Simplification.CornerAngle
       << " loops=" << options.Simplification.MinimumLoopSize
       << " preserve=" << options.PreserveBoundary << " keep=" << options.KeepBites
       << " bites=" << options.MaximumNumberOfBites
       << " vertices=" << options.MaximumNumberOfVertices << " stop=" << fuzzCase.StopAtCall;
  return text.str();
}

} // namespace biting
