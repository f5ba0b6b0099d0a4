// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "HessianRecovery.h"

#include "../Base/IdLists.h"
#include "../Base/Pulse.h"

#include <algorithm> // for min, max
#include <array>     // for the columns
#include <cmath>     // for sqrt
#include <limits>    // for NaN

namespace biting
{

namespace
{

constexpr int MostRings = 4;
constexpr std::size_t MostPatchPoints = 64;
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

// The least sine between a column of the fit and those before it. A fit with less would multiply
// errors of the values by more than its reciprocal.
constexpr double LeastSine = 0.02;

// The cells at each point, ascending.
IdLists Distribute(const CellsView& view)
{
  return IdLists(view.Points.size(),
    [&view](const auto& add)
    {
      for (std::size_t cell = 0; cell + 1 < view.Offsets.size(); ++cell)
      {
        for (Id k = view.Offsets[cell]; k < view.Offsets[cell + 1]; ++k)
        {
          add(view.Corners[k], static_cast<Id>(cell));
        }
      }
    });
}

// The points around a point, ring by ring. Only those with a finite value.
class PatchWalk
{
public:
  PatchWalk(const CellsView& view, const std::vector<double>& values);

  void Start(Id point);
  bool Grow(); // false where nothing was added
  const std::vector<Id>& Points() const { return this->Patch; }

private:
  void AddCell(Id cell);

  const CellsView& View;
  const std::vector<double>& Values;
  IdLists AtPoint;
  std::vector<Id> Patch;
  std::size_t RingBegin = 0;
  std::vector<Id> LastStart; // the point whose patch this one was last in
};

PatchWalk::PatchWalk(const CellsView& view, const std::vector<double>& values)
  : View(view)
  , Values(values)
  , AtPoint(Distribute(view))
  , LastStart(view.Points.size(), NoId)
{
  this->Patch.reserve(MostPatchPoints);
}

void PatchWalk::Start(Id point)
{
  this->Patch.assign(1, point);
  this->RingBegin = 0;
  this->LastStart[point] = point;
}

bool PatchWalk::Grow()
{
  const std::size_t ringEnd = this->Patch.size();
  for (std::size_t k = this->RingBegin; k < ringEnd; ++k)
  {
    for (const Id cell : this->AtPoint[this->Patch[k]])
    {
      this->AddCell(cell);
    }
  }
  this->RingBegin = ringEnd;
  return this->Patch.size() > ringEnd;
}

void PatchWalk::AddCell(Id cell)
{
  const Id start = this->Patch.front();
  const Id end = this->View.Offsets[static_cast<std::size_t>(cell) + 1];
  for (Id k = this->View.Offsets[cell]; k < end; ++k)
  {
    const Id corner = this->View.Corners[k];
    if (this->LastStart[corner] != start && this->Patch.size() < MostPatchPoints &&
      std::isfinite(this->Values[corner]))
    {
      this->LastStart[corner] = start;
      this->Patch.push_back(corner);
    }
  }
}

// Fits 1, u, v, u^2 / 2, u v, v^2 / 2 to the values of a patch. (u, v) are coordinates in which the
// patch is as wide in every direction, so that stretched meshes are fitted as well as others.
class QuadraticFit
{
public:
  // Returns whether the patch determines the polynomial well.
  bool Fit(const CellsView& view, const std::vector<double>& values, const std::vector<Id>& patch);
  Hessian2 Hessian() const;

private:
  static constexpr std::size_t Terms = 6;
  using Column = std::array<double, MostPatchPoints>;

  bool ReadPlaces(const std::vector<Point2>& points, const std::vector<Id>& patch);
  void FillColumns();
  bool Orthogonalize();
  void Solve();
  double Product(const Column& a, const Column& b) const;
  void Subtract(double factor, const Column& a, Column& b) const;

  std::size_t Count = 0;
  // The factor of Cholesky of the offsets' second moments: dx = ScaleX u, dy = Shear u + ScaleY v.
  double ScaleX = 0.0;
  double Shear = 0.0;
  double ScaleY = 0.0;
  std::array<Column, Terms> Columns;
  Column Residual;
  std::array<std::array<double, Terms>, Terms> Upper;
  std::array<double, Terms> Projections;
  std::array<double, Terms> Coefficients;
};

bool QuadraticFit::Fit(
  const CellsView& view, const std::vector<double>& values, const std::vector<Id>& patch)
{
  this->Count = patch.size();
  if (this->Count < Terms || !this->ReadPlaces(view.Points, patch))
  {
    return false;
  }
  // Differences to the value of the point itself: what they have in common is not rounded.
  const double own = values[patch.front()];
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    this->Residual[k] = values[patch[k]] - own;
  }
  this->FillColumns();
  if (!this->Orthogonalize())
  {
    return false;
  }
  this->Solve();
  return true;
}

// Leaves u and v in columns 1 and 2; false where the points are on a line.
bool QuadraticFit::ReadPlaces(const std::vector<Point2>& points, const std::vector<Id>& patch)
{
  const Point2& own = points[patch.front()];
  Column& u = this->Columns[1];
  Column& v = this->Columns[2];
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    const Point2 offset = points[patch[k]] - own;
    u[k] = offset.X;
    v[k] = offset.Y;
  }
  const double share = 1.0 / static_cast<double>(this->Count);
  this->ScaleX = std::sqrt(share * this->Product(u, u));
  if (!(this->ScaleX > 0.0))
  {
    return false;
  }
  this->Shear = share * this->Product(u, v) / this->ScaleX;
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    u[k] /= this->ScaleX;
    v[k] -= this->Shear * u[k];
  }
  this->ScaleY = std::sqrt(share * this->Product(v, v));
  // Offsets are rounded by epsilon: what is left of them must be far more than that.
  constexpr double LeastWidth = 1e-10;
  if (!(this->ScaleY > LeastWidth * std::max(this->ScaleX, std::abs(this->Shear))))
  {
    return false;
  }
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    v[k] /= this->ScaleY;
  }
  return true;
}

void QuadraticFit::FillColumns()
{
  const Column& u = this->Columns[1];
  const Column& v = this->Columns[2];
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    this->Columns[0][k] = 1.0;
    this->Columns[3][k] = 0.5 * u[k] * u[k];
    this->Columns[4][k] = u[k] * v[k];
    this->Columns[5][k] = 0.5 * v[k] * v[k];
  }
}

// Gram-Schmidt, one column after the other taken out of all that follow and of the values.
bool QuadraticFit::Orthogonalize()
{
  std::array<double, Terms> squares;
  for (std::size_t term = 0; term < Terms; ++term)
  {
    squares[term] = this->Product(this->Columns[term], this->Columns[term]);
  }
  for (std::size_t term = 0; term < Terms; ++term)
  {
    const Column& column = this->Columns[term];
    const double square = this->Product(column, column);
    if (!(square > LeastSine * LeastSine * squares[term]))
    {
      return false;
    }
    for (std::size_t later = term + 1; later < Terms; ++later)
    {
      this->Upper[term][later] = this->Product(column, this->Columns[later]) / square;
      this->Subtract(this->Upper[term][later], column, this->Columns[later]);
    }
    this->Projections[term] = this->Product(column, this->Residual) / square;
    this->Subtract(this->Projections[term], column, this->Residual);
  }
  return true;
}

void QuadraticFit::Solve()
{
  for (std::size_t term = Terms; term-- > 0;)
  {
    this->Coefficients[term] = this->Projections[term];
    for (std::size_t later = term + 1; later < Terms; ++later)
    {
      this->Coefficients[term] -= this->Upper[term][later] * this->Coefficients[later];
    }
  }
}

// u = x / ScaleX, v = (y - Shear / ScaleX x) / ScaleY.
Hessian2 QuadraticFit::Hessian() const
{
  const double ux = 1.0 / this->ScaleX;
  const double vx = -this->Shear / (this->ScaleX * this->ScaleY);
  const double vy = 1.0 / this->ScaleY;
  const double uu = this->Coefficients[3];
  const double uv = this->Coefficients[4];
  const double vv = this->Coefficients[5];
  return { uu * ux * ux + 2.0 * uv * ux * vx + vv * vx * vx, uv * ux * vy + vv * vx * vy,
    vv * vy * vy };
}

double QuadraticFit::Product(const Column& a, const Column& b) const
{
  double sum = 0.0;
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    sum += a[k] * b[k];
  }
  return sum;
}

void QuadraticFit::Subtract(double factor, const Column& a, Column& b) const
{
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    b[k] -= factor * a[k];
  }
}

Hessian2 RecoverAt(Id point, const CellsView& cells, const std::vector<double>& values,
  PatchWalk& walk, QuadraticFit& fit)
{
  walk.Start(point);
  bool isFitted = false;
  const bool isKnown = std::isfinite(values[point]);
  for (int ring = 0; ring < MostRings && isKnown && !isFitted && walk.Grow(); ++ring)
  {
    isFitted = fit.Fit(cells, values, walk.Points());
  }
  return isFitted ? fit.Hessian() : Hessian2{ Unknown, Unknown, Unknown };
}

} // namespace

std::vector<Hessian2> RecoverHessians(
  const CellsView& cells, const std::vector<double>& values, Monitor& monitor)
{
  PatchWalk walk(cells, values);
  QuadraticFit fit;
  std::vector<Hessian2> hessians(cells.Points.size());
  Pulse pulse(monitor);
  pulse.ForEach(hessians.size(),
    [&cells, &values, &walk, &fit, &hessians](std::size_t point)
    { hessians[point] = RecoverAt(static_cast<Id>(point), cells, values, walk, fit); });
  return pulse.HasStopped() ? std::vector<Hessian2>() : hessians;
}

std::vector<double> WithThoseAround(
  const CellsView& cells, const std::vector<double>& values, std::vector<double> norms)
{
  const IdLists atPoint = Distribute(cells);
  std::vector<double> found(norms.size(), Unknown); // in this ring
  std::vector<Id> ring;
  for (std::size_t point = 0; point < norms.size(); ++point)
  {
    if (!std::isnan(norms[point]))
    {
      ring.push_back(static_cast<Id>(point));
    }
  }
  const auto forEachCorner = [&cells, &atPoint](Id point, auto visit)
  {
    for (const Id cell : atPoint[point])
    {
      for (Id k = cells.Offsets[cell]; k < cells.Offsets[cell + 1]; ++k)
      {
        visit(static_cast<std::size_t>(cells.Corners[k]));
      }
    }
  };
  while (!ring.empty())
  {
    std::vector<Id> next;
    for (const Id point : ring)
    {
      const double norm = norms[point];
      forEachCorner(point,
        [&values, &norms, &found, &next, norm](std::size_t corner)
        {
          if (!std::isnan(norms[corner]) || !std::isfinite(values[corner]))
          {
            return;
          }
          if (std::isnan(found[corner]))
          {
            next.push_back(static_cast<Id>(corner));
          }
          found[corner] = std::isnan(found[corner]) ? norm : std::max(found[corner], norm);
        });
    }
    for (const Id point : next)
    {
      norms[point] = found[point];
    }
    ring.swap(next);
  }
  return norms;
}

double SpectralNorm(const Hessian2& hessian)
{
  const double half = 0.5 * (hessian.XX - hessian.YY);
  const double mean = 0.5 * (hessian.XX + hessian.YY);
  // Squares of very small or large derivatives would be 0 or infinite: those of shares are not.
  const double largest = std::max(std::abs(half), std::abs(hessian.XY));
  const bool hasShare = largest > 0.0 && std::isfinite(largest);
  const double share = hasShare ? std::min(std::abs(half), std::abs(hessian.XY)) / largest : 0.0;
  return std::abs(mean) + largest * std::sqrt(1.0 + share * share);
}

double NumericalSpacing(double norm, double errorTolerance, double minimum, double maximum)
{
  if (std::isnan(norm))
  {
    return Unknown;
  }
  constexpr double Least = std::numeric_limits<double>::min();
  const bool isBounded = norm > 0.0 && errorTolerance > 0.0;
  const double spacing = isBounded ? std::sqrt(errorTolerance / norm) : maximum;
  return std::max({ Least, minimum, std::min(spacing, maximum) });
}

} // namespace biting
