// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCases.h"

#include "PaperSpacing.h"

#include <algorithm>  // for max
#include <cmath>      // for fields
#include <cstdint>    // for noise
#include <cstdlib>    // for the folder
#include <fstream>    // for drawings
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

double AroundHoles(const Point2& x)
{
  const Point2 offset{ 7.0 * x.X - std::floor(7.0 * x.X) - 0.5,
    7.0 * x.Y - std::floor(7.0 * x.Y) - 0.5 };
  return 0.002 + 0.3 * std::max(Length(offset) / 7.0 - 0.02, 0.0);
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

/// Reads legacy VTK files, ASCII, as those of Data: points, lines, vertices, the first point array.
class DrawingReader
{
public:
  explicit DrawingReader(const std::string& path)
    : File(path)
  {
    std::string line;
    for (int k = 0; k < 3; ++k)
    {
      std::getline(this->File, line);
    }
  }

  void Read();

  Polylines Lines;
  std::vector<double> Values; ///< one a point, or none

private:
  void ReadCells(ChainKind kind);
  void ReadArrays(bool areOfPoints);

  std::ifstream File;
};

void DrawingReader::Read()
{
  std::string word;
  bool isAtPoints = false;
  while (this->File >> word)
  {
    if (word == "POINTS")
    {
      std::size_t count = 0;
      this->File >> count >> word;
      this->Lines.Points.resize(count);
      double z = 0.0;
      for (Point2& p : this->Lines.Points)
      {
        this->File >> p.X >> p.Y >> z;
      }
    }
    else if (word == "LINES" || word == "VERTICES")
    {
      this->ReadCells(word == "LINES" ? ChainKind::Automatic : ChainKind::EmbeddedPoint);
    }
    else if (word == "CELL_DATA" || word == "POINT_DATA")
    {
      isAtPoints = word == "POINT_DATA";
    }
    else if (word == "FIELD")
    {
      this->ReadArrays(isAtPoints);
    }
  }
}

void DrawingReader::ReadCells(ChainKind kind)
{
  Id count = 0;
  Id size = 0;
  this->File >> count >> size;
  for (Id cell = 0; cell < count; ++cell)
  {
    this->File >> size;
    for (Id k = 0; k < size; ++k)
    {
      Id point = 0;
      this->File >> point;
      this->Lines.Connectivity.push_back(point);
    }
    this->Lines.Offsets.push_back(static_cast<Id>(this->Lines.Connectivity.size()));
    this->Lines.Cells.push_back(this->Lines.NumberOfChains());
    this->Lines.Kinds.push_back(kind);
  }
}

void DrawingReader::ReadArrays(bool areOfPoints)
{
  std::string word;
  int count = 0;
  this->File >> word >> count;
  for (int array = 0; array < count; ++array)
  {
    std::size_t components = 0;
    std::size_t tuples = 0;
    this->File >> word >> components >> tuples >> word;
    std::vector<double> values(components * tuples);
    for (double& value : values)
    {
      this->File >> value;
    }
    if (areOfPoints && this->Values.empty() && components == 1)
    {
      this->Values = std::move(values);
    }
  }
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

std::string PathOf(const std::string& name)
{
  const std::string inData = std::string(BITING_SOURCE_DIR) + "/Data/" + name;
  const char* shared = std::getenv("BITING_SHARED_INPUTS");
  const bool isInData = std::ifstream(inData).good();
  return isInData || shared == nullptr ? inData : std::string(shared) + "/" + name;
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
  made.Options.Spacing.Grid = Image(129, field);
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
  made.Options.Spacing.Grid = PaperImage(vertices);
  made.Options.Spacing.Gradation = 0.0;
  return made;
}

MeshCase SquareWithHoles()
{
  MeshCase made;
  made.Name = "T3, image 513";
  made.Drawing = HoledSquare();
  made.Options.Spacing.Grid = Image(513, AroundHoles);
  made.Options.Spacing.Gradation = 0.31;
  return made;
}

MeshCase OfFile(const std::string& name, double gradation, double share)
{
  DrawingReader reader(PathOf(name));
  reader.Read();
  MeshCase made;
  made.Name = name.substr(0, name.find('.')) + " g " + std::to_string(gradation).substr(0, 4) +
    " x " + std::to_string(share).substr(0, 4);
  made.Options.Spacing.Gradation = gradation;
  if (!reader.Values.empty())
  {
    made.Options.Spacing.Segments = AlongSegments(reader.Lines, reader.Values);
    made.Options.Spacing.Scale = share;
  }
  else
  {
    made.Options.Spacing.Uniform = 0.02 * share * Diagonal(reader.Lines);
  }
  made.Drawing = std::move(reader.Lines);
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
  level.Options.Spacing.Grid = nullptr;
  level.Options.Spacing.Uniform = 0.01;
  cases.push_back(level);
  cases.push_back(OfField("waves",
    [](const Point2& x) { return 0.02 + 0.01 * std::sin(9.0 * x.X) * std::cos(7.0 * x.Y); }));
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
