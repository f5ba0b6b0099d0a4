// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCases.h"

#include "DrawingFile.h"
#include "PaperSpacing.h"

#include <algorithm>  // for max
#include <cmath>      // for fields
#include <cstdint>    // for noise
#include <functional> // for fields
#include <memory>     // for sources
#include <utility>    // for move

using namespace biting;

namespace
{

using Field = std::function<double(const Point2&)>;

constexpr double Turn = 6.283185307179586;

void AddLoop(const std::vector<Point2>& points, Polylines& lines)
{
  const Id first = static_cast<Id>(lines.Points.size());
  lines.Points.insert(lines.Points.end(), points.begin(), points.end());
  for (std::size_t k = 0; k <= points.size(); ++k)
  {
    lines.Connectivity.push_back(first + static_cast<Id>(k % points.size()));
  }
  lines.Offsets.push_back(static_cast<Id>(lines.Connectivity.size()));
  lines.Cells.push_back(lines.NumberOfChains());
  lines.Kinds.push_back(ChainKind::Automatic);
}

Polylines Square(double side)
{
  Polylines square;
  AddLoop({ { 0, 0 }, { side, 0 }, { side, side }, { 0, side } }, square);
  return square;
}

std::shared_ptr<const GridSource> Image(int size, const Field& field)
{
  auto grid = std::make_shared<GridSource>();
  for (int node = 0; node < size; ++node)
  {
    grid->XNodes.push_back(node / (size - 1.0));
  }
  grid->YNodes = grid->XNodes;
  for (const double y : grid->YNodes)
  {
    for (const double x : grid->XNodes)
    {
      grid->Values.push_back(field({ x, y }));
    }
  }
  return grid;
}

std::shared_ptr<const GridSource> PaperImage(double vertices)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0, PaperSide };
  const double scale = std::sqrt(3000.0 / vertices); // the integral of 1.25 / f^2
  for (int node = 0; node <= PaperIntervals; ++node)
  {
    const double y = PaperSide * node / PaperIntervals;
    grid->YNodes.push_back(y);
    grid->Values.insert(grid->Values.end(), 2, scale * PaperSpacing(y));
  }
  return grid;
}

double Waves(const Point2& x)
{
  return 0.02 + 0.01 * std::sin(9.0 * x.X) * std::cos(7.0 * x.Y);
}

double AroundHoles(const Point2& x, double slope)
{
  const Point2 offset{ 7.0 * x.X - std::floor(7.0 * x.X) - 0.5,
    7.0 * x.Y - std::floor(7.0 * x.Y) - 0.5 };
  return 0.002 + slope * std::max(Length(offset) / 7.0 - 0.02, 0.0);
}

Polylines HoledSquare()
{
  constexpr int Sides = 63;
  Polylines lines = Square(1.0);
  for (int hole = 0; hole < 49; ++hole)
  {
    std::vector<Point2> points;
    for (int k = 0; k < Sides; ++k)
    {
      const double angle = Turn * k / Sides;
      points.push_back({ (hole % 7 + 0.5) / 7.0 + 0.02 * std::cos(angle),
        (hole / 7 + 0.5) / 7.0 + 0.02 * std::sin(angle) });
    }
    AddLoop(points, lines);
  }
  return lines;
}

Polylines Circle(int sides)
{
  std::vector<Point2> points;
  for (int k = 0; k < sides; ++k)
  {
    points.push_back({ std::cos(Turn * k / sides), std::sin(Turn * k / sides) });
  }
  Polylines lines;
  AddLoop(points, lines);
  return lines;
}

/// Three rings about each other, whose points are off their circles by up to a step along these.
Polylines RaggedRings(int sides)
{
  Polylines lines;
  std::uint32_t noise = 1;
  for (const double radius : { 1.0, 0.7, 0.4 })
  {
    std::vector<Point2> points;
    for (int k = 0; k < sides; ++k)
    {
      noise = 1664525u * noise + 1013904223u;
      const double angle = Turn * k / sides;
      const double place = radius * (1.0 + Turn / sides * (noise / 2147483648.0 - 1.0));
      points.push_back({ place * std::cos(angle), place * std::sin(angle) });
    }
    AddLoop(points, lines);
  }
  return lines;
}

std::shared_ptr<const SegmentSource> AlongSegments(
  const Polylines& lines, const std::vector<double>& values)
{
  auto source = std::make_shared<SegmentSource>();
  source->Points = lines.Points;
  source->Values = values;
  for (Id chain = 0; chain < lines.NumberOfChains(); ++chain)
  {
    for (Id k = lines.Offsets[chain]; k + 1 < lines.Offsets[chain + 1]; ++k)
    {
      source->Segments.push_back(lines.Connectivity[k]);
      source->Segments.push_back(lines.Connectivity[k + 1]);
    }
  }
  return source;
}

double Diagonal(const Polylines& lines)
{
  Box2 box;
  for (const Point2& p : lines.Points)
  {
    box.Add(p);
  }
  return Distance(box.Low, box.High);
}

/// Segments much shorter than the spacing, which the feature size may not see.
MeshCase FineCircle(int sides)
{
  MeshCase made;
  made.Name = "circle, " + std::to_string(sides) + " segments";
  made.Drawing = Circle(sides);
  made.Options.Spacing.Uniform = 0.05;
  made.Options.LimitByFeatureSize = false;
  return made;
}

MeshCase OfRaggedRings(int sides)
{
  MeshCase made;
  made.Name = "ragged rings, " + std::to_string(3 * sides);
  made.Drawing = RaggedRings(sides);
  made.Options.Spacing.Uniform = 0.05;
  made.Options.Spacing.Gradation = 0.3;
  return made;
}

MeshCase Raw(MeshCase made)
{
  made.Name += ", raw";
  made.Options.Relaxation = false;
  return made;
}

MeshCase OfField(const std::string& name, const Field& field)
{
  MeshCase made;
  made.Name = name;
  made.Drawing = Square(1.0);
  made.Options.Spacing.Sources.emplace_back(Image(129, field));
  return made;
}

MeshCase Preserved(MeshCase made)
{
  made.Name += ", preserved";
  made.Options.PreserveBoundary = true;
  return made;
}

} // namespace

MeshCase UniformSquare(double vertices)
{
  MeshCase made;
  made.Name = "T2, " + std::to_string(static_cast<int>(vertices));
  made.Drawing = Square(1.0);
  made.Options.Spacing.Uniform = std::sqrt(1.25 / vertices);
  return made;
}

MeshCase SectionSix(double vertices)
{
  MeshCase made;
  made.Name = "T1, " + std::to_string(static_cast<int>(vertices));
  made.Drawing = Square(PaperSide);
  made.Options.Spacing.Sources.emplace_back(PaperImage(vertices));
  made.Options.Spacing.Gradation = 0.0;
  return made;
}

MeshCase SquareWithHoles()
{
  MeshCase made;
  made.Name = "T3, image 513";
  made.Drawing = HoledSquare();
  made.Options.Spacing.Sources.emplace_back(
    Image(513, [](const Point2& x) { return AroundHoles(x, 0.3); }));
  made.Options.Spacing.Gradation = 0.31;
  return made;
}

MeshCase OfFile(const std::string& name, double gradation, double share)
{
  DrawingFile file(name);
  MeshCase made;
  made.Name = name.substr(0, name.find('.')) + " g " + std::to_string(gradation).substr(0, 4) +
    " x " + std::to_string(share).substr(0, 4);
  made.Options.Spacing.Gradation = gradation;
  if (!file.Values.empty())
  {
    made.Options.Spacing.Sources.emplace_back(AlongSegments(file.Lines, file.Values));
    made.Options.Spacing.Scale = share;
  }
  else
  {
    made.Options.Spacing.Uniform = 0.02 * share * Diagonal(file.Lines);
  }
  made.Drawing = std::move(file.Lines);
  return made;
}

std::vector<MeshCase> CostCases(double mostVertices)
{
  std::vector<MeshCase> cases{ OfFile("coast.vtk", 0.15), OfFile("adcirc_shinnecock.vtk", 0.3),
    OfFile("plate.vtk", 0.3), OfFile("naca_airfoil.vtk", 0.3), SquareWithHoles(),
    UniformSquare(1000.0), Preserved(OfFile("shetland.vtk", 0.3)),
    Preserved(OfFile("pixels.vtk", 0.3)), Preserved(OfRaggedRings(1000)), FineCircle(100000) };
  for (const double vertices : { 1e4, 1e5, 1e6, 4e6 })
  {
    if (vertices > mostVertices)
    {
      break;
    }
    for (const MeshCase& one : { UniformSquare(vertices), SectionSix(vertices) })
    {
      cases.push_back(Raw(one));
      cases.push_back(one);
    }
  }
  return cases;
}

std::vector<MeshCase> QualityCases()
{
  std::vector<MeshCase> cases{ SectionSix(7000.0), SectionSix(43000.0), UniformSquare(1000.0),
    UniformSquare(20000.0), SquareWithHoles() };
  MeshCase level = SquareWithHoles();
  level.Name = "T3, uniform";
  level.Options.Spacing.Sources.clear();
  level.Options.Spacing.Uniform = 0.01;
  cases.push_back(level);
  cases.push_back(OfField("waves", Waves));
  cases.push_back(OfField("jump",
    [](const Point2& x) {
      return Length(x - Point2{ 0.4, 0.45 }) < 0.3 ? 0.004 : 0.1;
    }));
  cases.push_back(OfField("point", [](const Point2& x) { return 0.0002 + 0.2 * Length(x); }));
  for (const char* name : { "coast.vtk", "shetland.vtk", "plate.vtk", "naca_airfoil.vtk" })
  {
    cases.push_back(OfFile(name, 0.15));
    cases.push_back(OfFile(name, 0.3));
    cases.push_back(OfFile(name, 0.3, 0.5));
    cases.push_back(OfFile(name, 0.15, 2.0));
  }
  cases.push_back(OfFile("pixels.vtk", 0.3));
  cases.push_back(OfFile("pixels.vtk", 0.3, 0.5));
  cases.push_back(OfFile("plate.vtk", 0.3, 0.25));
  return cases;
}

namespace
{

/// Waves, as triangles of a grid of the unit square.
std::shared_ptr<const TriangulatedSource> TriangulatedWaves(int size)
{
  auto source = std::make_shared<TriangulatedSource>();
  for (Id node = 0; node < size * size; ++node)
  {
    const Point2 x{ node % size / (size - 1.0), node / size / (size - 1.0) };
    source->Points.push_back(x);
    source->Values.push_back(Waves(x));
    if (node % size > 0 && node >= size)
    {
      const Id low = node - size;
      source->Triangles.insert(
        source->Triangles.end(), { low - 1, low, node, low - 1, node, node - 1 });
    }
  }
  return source;
}

MeshCase OfHoles(double slope)
{
  MeshCase made = SquareWithHoles();
  made.Name = "holes " + std::to_string(slope).substr(0, 3);
  made.Options.Spacing.Sources = { Image(
    513, [slope](const Point2& x) { return AroundHoles(x, slope); }) };
  made.Options.Spacing.Gradation = 1.03 * slope;
  return made;
}

/// A ring whose points ask for a tenth of what others do in turns.
MeshCase BoundaryOnly()
{
  MeshCase made;
  made.Name = "boundary only";
  made.Drawing = Circle(60);
  std::vector<double> values;
  for (int k = 0; k < 60; ++k)
  {
    values.push_back(0.055 + 0.045 * std::cos(5.0 * Turn * k / 60));
  }
  made.Options.Spacing.Sources.emplace_back(AlongSegments(made.Drawing, values));
  return made;
}

/// The element size of a production mesh.
MeshCase AdcircField()
{
  MeshCase made = OfFile("adcirc_shinnecock.vtk", 0.3);
  made.Name = "ADCIRC field";
  const DrawingFile file("field_adcirc_shinnecock.vtk");
  auto source = std::make_shared<TriangulatedSource>();
  source->Points = file.Lines.Points;
  source->Values = file.Values;
  source->Triangles = file.Triangles;
  made.Options.Spacing.Sources = { source };
  made.Drawing.Points.resize(file.Triangles.empty() ? 0 : made.Drawing.Points.size());
  return made;
}

MeshCase Named(const std::string& name, MeshCase made)
{
  made.Name = name;
  return made;
}

} // namespace

std::vector<MeshCase> FieldCases()
{
  constexpr double Vertices = 2000.0; // of section 6 as in the paper
  std::vector<MeshCase> cases{ Named("uniform", UniformSquare(10000.0)) };
  for (const double share : { 1.0, 0.5, 0.35, 0.25 })
  {
    cases.push_back(Named(
      "section 6 x " + std::to_string(share).substr(0, 4), SectionSix(Vertices / (share * share))));
  }
  for (const double slope : { 0.1, 0.3, 1.0 })
  {
    cases.push_back(OfHoles(slope));
  }
  cases.push_back(
    Named("jump by 50", OfField("", [](const Point2& x) { return x.X < 0.5 ? 0.002 : 0.1; })));
  cases.push_back(Named("image", OfField("", Waves)));
  cases.push_back(Named("triangulated", OfField("", Waves)));
  cases.back().Options.Spacing.Sources = { TriangulatedWaves(129) };
  cases.push_back(BoundaryOnly());
  cases.push_back(Named("ADCIRC boundary", OfFile("adcirc_shinnecock.vtk", 0.3)));
  cases.push_back(AdcircField());
  return cases;
}
