// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remains.h"

#include <algorithm> // for all_of
#include <cmath>     // for cos, sin
#include <limits>    // for infinity
#include <utility>   // for swap

namespace biting
{

namespace
{

constexpr int SidesOfCircle = 64;
constexpr double TurnOfCircle = 6.283185307179586 / SidesOfCircle;

int NumberOfSides(const Bites& bites, Id bite)
{
  return bites.IsCircle(bite) ? SidesOfCircle : 4;
}

std::array<Point2, SidesOfCircle> MakeNormalsOfCircle()
{
  std::array<Point2, SidesOfCircle> normals;
  for (int side = 0; side < SidesOfCircle; ++side)
  {
    normals[side] = { std::cos(side * TurnOfCircle), std::sin(side * TurnOfCircle) };
  }
  return normals;
}

// The outward normal of a side.
Point2 NormalOf(const Bites& bites, Id bite, int side)
{
  if (bites.IsCircle(bite))
  {
    static const std::array<Point2, SidesOfCircle> Normals = MakeNormalsOfCircle();
    return Normals[side];
  }
  const Point2& axis = bites.Axes[bite];
  const Point2 normal = side % 2 == 0 ? axis : Perpendicular(axis);
  return side < 2 ? normal : -1.0 * normal;
}

// From the centre to the sides.
double ReachOf(const Bites& bites, Id bite)
{
  return bites.HalfWidths[bite] * (bites.IsCircle(bite) ? std::cos(0.5 * TurnOfCircle) : 1.0);
}

// Whether a piece lies within all sides of a circle: then these need not be looked at one by one.
template <typename Corners>
bool IsInnerOfCircle(const Bites& bites, Id bite, Corners begin, Corners end)
{
  const Point2& center = bites.Centers[bite];
  const double reach = ReachOf(bites, bite);
  return bites.IsCircle(bite) &&
    std::all_of(begin, end,
      [&center, reach](const Point2& corner)
      { return Dot(corner - center, corner - center) < reach * reach; });
}

} // namespace

void Remains::Polygons::Clear()
{
  this->Corners.clear();
  this->Ends.clear();
}

void Remains::Polygons::DropLast()
{
  this->Shrink(this->Ends.size() - 1);
}

void Remains::Polygons::Shrink(std::size_t count)
{
  this->Corners.resize(this->Begin(count));
  this->Ends.resize(count);
}

void Remains::Begin(const std::array<Point2, 3>& triangle)
{
  this->Left.Corners.assign(triangle.begin(), triangle.end());
  this->Left.Ends.assign(1, triangle.size());
}

Point2 Remains::MiddleOfLast() const
{
  const std::size_t begin = this->Left.Begin(this->Left.Ends.size() - 1);
  const std::size_t end = this->Left.Ends.back();
  const Point2& first = this->Left.Corners[begin];
  Point2 sum;
  for (std::size_t corner = begin; corner < end; ++corner)
  {
    sum = sum + (this->Left.Corners[corner] - first);
  }
  return first + 1.0 / static_cast<double>(end - begin) * sum;
}

bool Remains::TakeAway(const Bites& bites, Id bite, double slack)
{
  this->Next.Clear();
  bool isCut = false;
  for (std::size_t piece = 0; piece < this->Left.Ends.size(); ++piece)
  {
    isCut = this->CutPiece(piece, bites, bite, slack) || isCut;
  }
  std::swap(this->Left, this->Next);
  return isCut;
}

// Side by side: what lies beyond a side is left, the rest goes on to the next side. A piece that
// the bite does not meet, or not by more than the slack, stays whole: false.
bool Remains::CutPiece(std::size_t piece, const Bites& bites, Id bite, double slack)
{
  const auto begin =
    this->Left.Corners.begin() + static_cast<std::ptrdiff_t>(this->Left.Begin(piece));
  const auto end = this->Left.Corners.begin() + static_cast<std::ptrdiff_t>(this->Left.Ends[piece]);
  if (IsInnerOfCircle(bites, bite, begin, end))
  {
    return true;
  }
  this->Inside.assign(begin, end);
  const std::size_t numberBefore = this->Next.Ends.size();
  const double reach = ReachOf(bites, bite) + slack;
  const int numberOfSides = NumberOfSides(bites, bite);
  for (int side = 0; side < numberOfSides; ++side)
  {
    const auto [least, most] =
      this->MeasureBeyond(NormalOf(bites, bite, side), bites.Centers[bite], reach);
    if (least >= -slack)
    {
      this->Next.Shrink(numberBefore);
      this->Next.Corners.insert(this->Next.Corners.end(), begin, end);
      this->Next.Ends.push_back(this->Next.Corners.size());
      return false;
    }
    if (most > 0.0)
    {
      this->CutInside();
    }
  }
  return true;
}

// Sets Beyond for the side that is `reach` from the centre; its least and its largest value.
std::pair<double, double> Remains::MeasureBeyond(
  const Point2& normal, const Point2& center, double reach)
{
  const std::size_t count = this->Inside.size();
  this->Beyond.resize(count);
  const Point2* corners = this->Inside.data();
  double* distances = this->Beyond.data();
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t corner = 0; corner < count; ++corner)
  {
    const double beyond = Dot(normal, corners[corner] - center) - reach;
    distances[corner] = beyond;
    least = beyond < least ? beyond : least;
    most = beyond > most ? beyond : most;
  }
  return { least, most };
}

// Moves what lies beyond the side from Inside to Next.
void Remains::CutInside()
{
  this->Cut.clear();
  const std::size_t count = this->Inside.size();
  for (std::size_t corner = 0; corner < count; ++corner)
  {
    const std::size_t next = corner + 1 == count ? 0 : corner + 1;
    const double here = this->Beyond[corner];
    const double there = this->Beyond[next];
    (here > 0.0 ? this->Next.Corners : this->Cut).push_back(this->Inside[corner]);
    if ((here > 0.0) != (there > 0.0))
    {
      const Point2 crossing =
        this->Inside[corner] + here / (here - there) * (this->Inside[next] - this->Inside[corner]);
      this->Next.Corners.push_back(crossing);
      this->Cut.push_back(crossing);
    }
  }
  this->Next.Ends.push_back(this->Next.Corners.size());
  std::swap(this->Inside, this->Cut);
}

} // namespace biting
