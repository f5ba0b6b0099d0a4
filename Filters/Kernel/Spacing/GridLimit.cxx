// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

#include "../Base/Pulse.h"

#include <array>   // for corners
#include <utility> // for move

namespace biting
{
namespace
{

/// Cells in which f may grow by more than this share of itself are too wide for interpolation
/// between limited nodes: at a node that bounds its neighbors it is wrong by up to a quarter of that.
constexpr double WidestGrowth = 0.02;

/// A cell is steep where its mean gradient or one of its sides is above the gradation by more than
/// this share of it, or where its twist adds more than this share of f to what is linear. Otherwise
/// a field that somebody has limited already would be limited again, cell by cell: the gradient at
/// a corner of a cell of a distance function exceeds that of the function itself.
constexpr double SteepnessMargin = 0.005;

/// How far a chord may be from the arc it stands for, in f; at most so many chords a side of a cell.
constexpr double ChordError = 0.002;
constexpr double ChordsPerSide = 32.0;

constexpr double FullTurn = 6.283185307179586;

/// f = Value + Slope . x + Twist x y over a cell, x from its low corner.
struct Patch
{
  Point2 Low;
  Point2 Size;
  double Value;
  Point2 Slope;
  double Twist;

  double At(const Point2& x) const
  {
    return this->Value + Dot(this->Slope, x) + this->Twist * x.X * x.Y;
  }
  bool Contains(const Point2& x) const
  {
    return x.X >= 0.0 && x.Y >= 0.0 && x.X <= this->Size.X && x.Y <= this->Size.Y;
  }
};

class GridLimiter
{
public:
  GridLimiter(const GridSource& source, double gradation, ConeCollector& cones, Monitor& monitor)
    : Source(source)
    , Gradation(gradation)
    , Cones(cones)
    , Beats(monitor)
    , Columns(static_cast<Id>(source.XNodes.size()))
    , Rows(static_cast<Id>(source.YNodes.size()))
  {
  }

  bool Run()
  {
    if (!this->FindSteep())
    {
      return false;
    }
    return this->SteepCount == 0 ||
      (this->Sweep() && this->FindWide() && this->AddCones() && this->WriteLimits());
  }

  /// Null where nothing is steep.
  std::shared_ptr<const GridSource> Result() const { return this->Limited; }

private:
  /// A row is done; `fraction` of all the work.
  bool EndRow(double fraction)
  {
    this->Beats.SetFraction(fraction);
    return this->Beats.Beat(8 * static_cast<std::size_t>(this->Columns));
  }

  double Share(Id row) const { return static_cast<double>(row) / this->Rows; }
  double X(Id column) const { return this->Source.XNodes[static_cast<std::size_t>(column)]; }
  double Y(Id row) const { return this->Source.YNodes[static_cast<std::size_t>(row)]; }
  Id Node(Id column, Id row) const { return column + this->Columns * row; }

  Point2 Place(Id node) const
  {
    return { this->X(node % this->Columns), this->Y(node / this->Columns) };
  }

  double Raw(Id node) const { return this->Source.Values[static_cast<std::size_t>(node)]; }
  double Given(Id node) const { return this->Cones.Values()(this->Raw(node)); }
  double& Limit(Id node) { return this->Limits[static_cast<std::size_t>(node)]; }
  Id& Apex(Id node) { return this->Apexes[static_cast<std::size_t>(node)]; }

  // Finding steep cells.

  bool FindSteep()
  {
    for (Id row = 0; row < this->Rows; ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        this->SteepCount += this->IsSteep(column, row) ? 1 : 0;
      }
      if (!this->EndRow(0.1 * this->Share(row)))
      {
        return false;
      }
    }
    return true;
  }

  /// The cell whose low corner is a node; it may have no width or height at the last nodes.
  bool IsSteep(Id column, Id row) const
  {
    if (column < 0 || row < 0)
    {
      return false;
    }
    const Id right = std::min(column + 1, this->Columns - 1);
    const Id above = std::min(row + 1, this->Rows - 1);
    const double a = this->Given(this->Node(column, row));
    const double b = this->Given(this->Node(right, row));
    const double c = this->Given(this->Node(column, above));
    const double d = this->Given(this->Node(right, above));
    const double width = this->X(right) - this->X(column);
    const double height = this->Y(above) - this->Y(row);
    const double most = (1.0 + SteepnessMargin) * this->Gradation;
    if (!(width > 0.0 && height > 0.0))
    {
      return std::max({ a, b, c, d }) - std::min({ a, b, c, d }) > most * std::max(width, height);
    }
    const auto isAbove = [most, width, height](double alongX, double alongY) {
      return Length({ alongX * height, alongY * width }) > most * width * height;
    };
    const double alongX = std::max(std::abs(b - a), std::abs(d - c));
    const double alongY = std::max(std::abs(c - a), std::abs(d - b));
    const double added = 0.25 * std::abs(a - b - c + d);
    return isAbove(alongX, alongY) &&
      (isAbove(0.5 * (b - a + d - c), 0.5 * (c - a + d - b)) || isAbove(alongX, 0.0) ||
        isAbove(0.0, alongY) || added > SteepnessMargin * std::min({ a, b, c, d }));
  }

  // Lowering nodes.

  bool Sweep()
  {
    const std::size_t count = this->Source.Values.size();
    this->Limits.reserve(count);
    this->Apexes.reserve(count);
    for (Id row = 0; row < this->Rows; ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        this->Apexes.push_back(this->Node(column, row));
        this->Limits.push_back(this->Given(this->Node(column, row)));
      }
      this->SweepRow(row, row - 1);
      if (!this->EndRow(0.1 + 0.4 * this->Share(row)))
      {
        return false;
      }
    }
    for (Id row = this->Rows - 1; row >= 0; --row)
    {
      this->SweepRow(row, row + 1);
      if (!this->EndRow(0.9 - 0.4 * this->Share(row)))
      {
        return false;
      }
    }
    return true;
  }

  void SweepRow(Id row, Id from)
  {
    const bool hasFrom = from >= 0 && from < this->Rows;
    for (Id column = 0; column < this->Columns; ++column)
    {
      for (Id side = -1; hasFrom && side <= 1; ++side)
      {
        this->Lower(column, row, column + side, from);
      }
      this->Lower(column, row, column - 1, row);
    }
    for (Id column = this->Columns - 2; column >= 0; --column)
    {
      this->Lower(column, row, column + 1, row);
    }
  }

  void Lower(Id column, Id row, Id fromColumn, Id fromRow)
  {
    if (fromColumn < 0 || fromColumn >= this->Columns)
    {
      return;
    }
    const Id node = this->Node(column, row);
    const Id apex = this->Apex(this->Node(fromColumn, fromRow));
    const double base = this->Given(apex);
    if (base < this->Limit(node) && apex != this->Apex(node))
    {
      const double value =
        base + this->Gradation * Distance(this->Place(apex), { this->X(column), this->Y(row) });
      if (value < this->Limit(node))
      {
        this->Limit(node) = value;
        this->Apex(node) = apex;
      }
    }
  }

  // Cones where cells are wide.

  bool FindWide()
  {
    this->WideCells.reserve(this->Source.Values.size());
    for (Id row = 0; row < this->Rows; ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        this->WideCells.push_back(this->IsWide(column, row));
        this->HasWideCells = this->HasWideCells || this->WideCells.back();
      }
      if (!this->EndRow(0.9 + 0.02 * this->Share(row)))
      {
        return false;
      }
    }
    return true;
  }

  bool AddCones()
  {
    this->IsAdded.assign(this->Source.Values.size(), false);
    for (Id row = 0; row < this->Rows && this->HasWideCells; ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        this->AddConesAt(column, row);
      }
      if (!this->EndRow(0.92 + 0.03 * this->Share(row)))
      {
        return false;
      }
    }
    return true;
  }

  void AddConesAt(Id column, Id row)
  {
    if (this->TouchesConeNode(column, row))
    {
      this->AddApexes(column, row);
    }
    const bool isSource = this->IsWideAndSteep(column, row);
    if (column + 1 < this->Columns && (isSource || this->IsWideAndSteep(column, row - 1)))
    {
      this->AddSide(this->Node(column, row), this->Node(column + 1, row));
    }
    if (row + 1 < this->Rows && (isSource || this->IsWideAndSteep(column - 1, row)))
    {
      this->AddSide(this->Node(column, row), this->Node(column, row + 1));
    }
    if (isSource && column + 1 < this->Columns && row + 1 < this->Rows)
    {
      this->AddInside(this->MakePatch(column, row));
    }
  }

  bool IsWideCell(Id column, Id row) const
  {
    return column >= 0 && row >= 0 &&
      this->WideCells[static_cast<std::size_t>(this->Node(column, row))];
  }

  /// Whether cones limit f around a node: beside wide cells, lowered nodes would say too little of
  /// where between them it is how low.
  bool IsConeNode(Id column, Id row) const
  {
    return this->IsWideCell(column, row) || this->IsWideCell(column - 1, row) ||
      this->IsWideCell(column, row - 1) || this->IsWideCell(column - 1, row - 1);
  }

  bool TouchesConeNode(Id column, Id row) const
  {
    const Id right = std::min(column + 1, this->Columns - 1);
    const Id above = std::min(row + 1, this->Rows - 1);
    return this->IsConeNode(column, row) || this->IsConeNode(right, row) ||
      this->IsConeNode(column, above) || this->IsConeNode(right, above);
  }

  bool IsWide(Id column, Id row)
  {
    const Id right = std::min(column + 1, this->Columns - 1);
    const Id above = std::min(row + 1, this->Rows - 1);
    const double least =
      std::min(std::min(this->Limit(this->Node(column, row)), this->Limit(this->Node(right, row))),
        std::min(this->Limit(this->Node(column, above)), this->Limit(this->Node(right, above))));
    const double side = std::max(this->X(right) - this->X(column), this->Y(above) - this->Y(row));
    return this->Gradation * side > WidestGrowth * least;
  }

  bool IsWideAndSteep(Id column, Id row)
  {
    return this->IsWideCell(column, row) && this->IsSteep(column, row);
  }

  void AddSide(Id start, Id end)
  {
    if (!this->IsBounded(start, end) && !this->IsBounded(end, start))
    {
      this->Cones.AddGiven(this->Place(start), this->Place(end), this->Raw(start), this->Raw(end));
    }
  }

  /// Whether all of the side a-b is above what another node brings to a, and from there along it.
  bool IsBounded(Id a, Id b)
  {
    return this->Limit(a) < this->Given(a) &&
      this->Limit(a) + this->Gradation * Distance(this->Place(a), this->Place(b)) <= this->Given(b);
  }

  /// The nodes that bound the corners of a cell, from wherever they are.
  void AddApexes(Id column, Id row)
  {
    for (Id above = row; above <= std::min(row + 1, this->Rows - 1); ++above)
    {
      for (Id right = column; right <= std::min(column + 1, this->Columns - 1); ++right)
      {
        const Id node = this->Node(right, above);
        const Id apex = this->Apex(node);
        if (apex != node && !this->IsAdded[static_cast<std::size_t>(apex)])
        {
          this->IsAdded[static_cast<std::size_t>(apex)] = true;
          this->Cones.AddPoint(this->Place(apex), this->Given(apex));
        }
      }
    }
  }

  bool WriteLimits()
  {
    auto limited = std::make_shared<GridSource>();
    limited->XNodes = this->Source.XNodes;
    limited->YNodes = this->Source.YNodes;
    limited->Values.reserve(this->Source.Values.size());
    for (Id row = 0; row < this->Rows; ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        const Id node = this->Node(column, row);
        const bool isLimited =
          this->Limit(node) < this->Given(node) && !this->IsConeNode(column, row);
        limited->Values.push_back(
          isLimited ? this->Limit(node) / this->Cones.Values().Scale : this->Raw(node));
      }
      if (!this->EndRow(0.95 + 0.05 * this->Share(row)))
      {
        return false;
      }
    }
    this->Limited = limited;
    return true;
  }

  Patch MakePatch(Id column, Id row) const
  {
    const double scale = this->Cones.Values().Scale;
    const double a = scale * this->Raw(this->Node(column, row));
    const double b = scale * this->Raw(this->Node(column + 1, row));
    const double c = scale * this->Raw(this->Node(column, row + 1));
    const double d = scale * this->Raw(this->Node(column + 1, row + 1));
    Patch patch;
    patch.Low = { this->X(column), this->Y(row) };
    patch.Size = { this->X(column + 1) - patch.Low.X, this->Y(row + 1) - patch.Low.Y };
    patch.Value = a;
    patch.Slope = { (b - a) / patch.Size.X, (c - a) / patch.Size.Y };
    patch.Twist = (d - c - b + a) / (patch.Size.X * patch.Size.Y);
    return patch;
  }

  /// The gradient is (Slope.X + Twist y, Slope.Y + Twist x): as long as the gradation on a circle.
  void AddInside(const Patch& patch)
  {
    const double side = std::max(patch.Size.X, patch.Size.Y);
    const double least = std::max(this->Cones.Values().Least, this->LeastOf(patch));
    const double twist = std::abs(patch.Twist);
    if (!(twist * patch.Size.X * patch.Size.Y > ChordError * least) || !std::isfinite(twist))
    {
      return;
    }
    const double radius = this->Gradation / twist;
    const Point2 center{ -patch.Slope.Y / patch.Twist, -patch.Slope.X / patch.Twist };
    const double chord =
      std::max(std::sqrt(4.0 * ChordError * least / twist), side / ChordsPerSide);
    double start = 0.0;
    double turn = FullTurn;
    if (!patch.Contains(center))
    {
      AnglesAround(patch, center, start, turn);
    }
    const double chords = std::ceil(radius * turn / chord);
    for (double step = 0.0; step < chords; step += 1.0)
    {
      this->AddChord(patch, PointOnCircle(center, radius, start + turn * step / chords),
        PointOnCircle(center, radius, start + turn * (step + 1.0) / chords));
    }
  }

  void AddChord(const Patch& patch, const Point2& from, const Point2& to)
  {
    double start = 0.0;
    double end = 1.0;
    const Point2 step = to - from;
    if (Clip(from.X, step.X, patch.Size.X, start, end) &&
      Clip(from.Y, step.Y, patch.Size.Y, start, end))
    {
      const Point2 a = from + start * step;
      const Point2 b = from + end * step;
      const double scale = this->Cones.Values().Scale;
      this->Cones.AddGiven(patch.Low + a, patch.Low + b, patch.At(a) / scale, patch.At(b) / scale);
    }
  }

  /// Leaves the part of [start, end] for which low + t rise is in [0, size]; false if there is none.
  static bool Clip(double low, double rise, double size, double& start, double& end)
  {
    if (rise == 0.0)
    {
      return low >= 0.0 && low <= size;
    }
    const double first = -low / rise;
    const double second = (size - low) / rise;
    start = std::max(start, std::min(first, second));
    end = std::min(end, std::max(first, second));
    return start < end;
  }

  static double LeastOf(const Patch& patch)
  {
    return std::min(std::min(patch.At({ 0.0, 0.0 }), patch.At({ patch.Size.X, 0.0 })),
      std::min(patch.At({ 0.0, patch.Size.Y }), patch.At(patch.Size)));
  }

  static Point2 PointOnCircle(const Point2& center, double radius, double angle)
  {
    return { center.X + radius * std::cos(angle), center.Y + radius * std::sin(angle) };
  }

  /// The angles under which a point outside sees a cell: less than half a turn.
  static void AnglesAround(const Patch& patch, const Point2& center, double& start, double& turn)
  {
    const Point2 toMiddle = 0.5 * patch.Size - center;
    const double middle = std::atan2(toMiddle.Y, toMiddle.X);
    double half = 0.0;
    for (const Point2& corner :
      { Point2{ 0.0, 0.0 }, Point2{ patch.Size.X, 0.0 }, Point2{ 0.0, patch.Size.Y }, patch.Size })
    {
      const Point2 toCorner = corner - center;
      half =
        std::max(half, std::abs(std::atan2(Cross(toMiddle, toCorner), Dot(toMiddle, toCorner))));
    }
    start = middle - half;
    turn = 2.0 * half;
  }

  const GridSource& Source;
  const double Gradation;
  ConeCollector& Cones;
  Pulse Beats;
  const Id Columns;
  const Id Rows;
  std::int64_t SteepCount = 0;
  std::shared_ptr<const GridSource> Limited;
  std::vector<double> Limits; ///< of f at each node
  std::vector<Id> Apexes;     ///< the node that bounds each node
  bool HasWideCells = false;
  std::vector<bool> WideCells;
  std::vector<bool> IsAdded; ///< as a cone
};

} // namespace

std::shared_ptr<const GridSource> LimitGrid(const std::shared_ptr<const GridSource>& source,
  double gradation, ConeCollector& cones, Monitor& monitor)
{
  GridLimiter limiter(*source, gradation, cones, monitor);
  if (!limiter.Run())
  {
    return nullptr;
  }
  return limiter.Result() ? limiter.Result() : source;
}

} // namespace biting
