// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remains.h"

#include "BiteOutline.h" // for Gauge

#include <algorithm> // for max
#include <cmath>     // for cos, sin, sqrt
#include <limits>    // for infinity
#include <utility>   // for swap

namespace biting
{

namespace
{

constexpr int SidesOfCircle = 64;
constexpr double TurnOfCircle = 6.283185307179586 / SidesOfCircle;

const double CosineOfHalfTurn = std::cos(0.5 * TurnOfCircle);
constexpr double CosineOf45Degrees = 0.7071067811865475;

std::vector<Point2> MakeNormalsOfCircle()
{
  std::vector<Point2> normals;
  normals.reserve(SidesOfCircle);
  for (int side = 0; side < SidesOfCircle; ++side)
  {
    normals.push_back({ std::cos(side * TurnOfCircle), std::sin(side * TurnOfCircle) });
  }
  return normals;
}

// The square of the greatest distance of a corner.
double SquareFrom(const Point2& place, const Point2* begin, const Point2* end)
{
  double square = 0.0;
  for (const Point2* corner = begin; corner != end; ++corner)
  {
    square = std::max(square, Dot(*corner - place, *corner - place));
  }
  return square;
}

bool Contains(const Bites& bites, Id bite, const Point2& p)
{
  return Gauge(bites, bite, p) <= bites.HalfWidths[bite];
}

// Whether two bites, the ends of an edge their centres, cover it.
bool CoverEdge(const Bites& bites, Id first, Id second)
{
  const double there = Gauge(bites, first, bites.Centers[second]);
  const double back = Gauge(bites, second, bites.Centers[first]);
  return bites.HalfWidths[first] * back + bites.HalfWidths[second] * there >= there * back;
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
  this->SetSides(bites, bite, slack);
  this->Next.Clear();
  bool isCut = false;
  const Point2* corners = this->Left.Corners.data();
  for (std::size_t piece = 0; piece < this->Left.Ends.size(); ++piece)
  {
    isCut =
      this->CutPiece(corners + this->Left.Begin(piece), corners + this->Left.Ends[piece]) || isCut;
  }
  std::swap(this->Left, this->Next);
  return isCut;
}

void Remains::SetSides(const Bites& bites, Id bite, double slack)
{
  this->Bite.Center = bites.Centers[bite];
  this->Bite.Reach = bites.HalfWidths[bite] + slack;
  this->Bite.Slack = slack;
  if (bites.IsCircle(bite))
  {
    static const std::vector<Point2> Normals = MakeNormalsOfCircle();
    this->Bite.Reach = bites.HalfWidths[bite] * CosineOfHalfTurn + slack;
    this->Bite.CosineOfHalfTurn = CosineOfHalfTurn;
    this->Bite.Normals = Normals;
    return;
  }
  const Point2& axis = bites.Axes[bite];
  const Point2 across = Perpendicular(axis);
  this->Bite.CosineOfHalfTurn = CosineOf45Degrees;
  this->Bite.Normals.assign({ axis, across, -1.0 * axis, -1.0 * across });
}

// Side by side: what lies beyond a side is left, the rest goes on to the next side. A piece that
// the bite does not meet, or not by more than the slack, stays whole: false.
//
// Few sides need a look at all corners, as a piece lies in a circle about its first one. Where that
// is so far away that it is beyond the side whose normal leads there, but for half a turn, all
// of it is; and it is within most sides of a bite that it meets. Both are asked for with the slack
// to spare, as that is more than rounding.
bool Remains::CutPiece(const Point2* begin, const Point2* end)
{
  const double within = this->Bite.Reach - this->Bite.Slack;
  if (SquareFrom(this->Bite.Center, begin, end) < within * within)
  {
    return true;
  }
  const double radius = std::sqrt(SquareFrom(*begin, begin, end));
  const Point2 offset = *begin - this->Bite.Center;
  if (this->Bite.CosineOfHalfTurn * Length(offset) - radius > this->Bite.Reach)
  {
    this->KeepWhole(begin, end);
    return false;
  }
  this->Inside.assign(begin, end);
  const std::size_t numberBefore = this->Next.Ends.size();
  for (const Point2& normal : this->Bite.Normals)
  {
    if (Dot(normal, offset) + radius < within - this->Bite.Slack)
    {
      continue;
    }
    const auto [least, most] = this->MeasureBeyond(normal);
    if (least >= -this->Bite.Slack)
    {
      this->Next.Shrink(numberBefore);
      this->KeepWhole(begin, end);
      return false;
    }
    if (most > 0.0)
    {
      this->CutInside();
    }
  }
  return true;
}

void Remains::KeepWhole(const Point2* begin, const Point2* end)
{
  this->Next.Corners.insert(this->Next.Corners.end(), begin, end);
  this->Next.Ends.push_back(this->Next.Corners.size());
}

// Sets Beyond for a side; its least and its largest value.
std::pair<double, double> Remains::MeasureBeyond(const Point2& normal)
{
  const std::size_t count = this->Inside.size();
  this->Beyond.resize(count);
  const Point2* corners = this->Inside.data();
  double* distances = this->Beyond.data();
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t corner = 0; corner < count; ++corner)
  {
    const double beyond = Dot(normal, corners[corner] - this->Bite.Center) - this->Bite.Reach;
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

// With sides of lengths u, v, w and A the doubled area, the circumradius is u v w / (2 A).
bool IsWithinOfCorners(const std::array<Point2, 3>& corners, double distance)
{
  const Point2 u = corners[1] - corners[0];
  const Point2 v = corners[2] - corners[0];
  const Point2 w = corners[2] - corners[1];
  const double doubledArea = Cross(u, v);
  const double reach = 2.0 * distance * doubledArea;
  return Dot(u, u) * Dot(v, v) * Dot(w, w) <= reach * reach;
}

// A place that all three share, and one on each edge that two do, cut the triangle into three
// parts: the four places of each lie in one bite, which is convex.
bool CoverTriangle(const Bites& bites, const std::array<Id, 3>& atCorners)
{
  const auto& [a, b, c] = atCorners;
  const double weightA = bites.HalfWidths[b] * bites.HalfWidths[c];
  const double weightB = bites.HalfWidths[c] * bites.HalfWidths[a];
  const double weightC = bites.HalfWidths[a] * bites.HalfWidths[b];
  const double perSum = 1.0 / (weightA + weightB + weightC);
  const Point2& origin = bites.Centers[a];
  const Point2 shared = origin +
    perSum * (weightB * (bites.Centers[b] - origin) + weightC * (bites.Centers[c] - origin));
  return Contains(bites, a, shared) && Contains(bites, b, shared) && Contains(bites, c, shared) &&
    CoverEdge(bites, a, b) && CoverEdge(bites, b, c) && CoverEdge(bites, c, a);
}

} // namespace biting
