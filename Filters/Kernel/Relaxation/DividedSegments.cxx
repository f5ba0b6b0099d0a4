// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DividedSegments.h"

#include "../Base/DistanceToSegment.h"
#include "../Domain/SegmentTree.h"
#include "../Domain/VertexStars.h"

#include <algorithm> // for min
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double NearInResolutions = 4.0; // two rounded vertices, each off by less than one
constexpr double LeastInResolutions = 1024.0;
constexpr double LeastPart = 0.25; // of the spacing

class ClearanceSearch
{
public:
  ClearanceSearch(const Domain& domain, const std::vector<double>& spacings, Pulse& pulse)
    : Geometry(domain)
    , Spacings(spacings)
    , Progress(pulse)
    , Near(NearInResolutions * domain.Resolution)
  {
    for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
    {
      this->Segments.push_back({ domain.Starts[segment], domain.Ends[segment] });
      const double length = Distance(this->Start(segment), this->End(segment));
      this->IsDivided.push_back(IsFarAboveRounding(length, domain));
    }
  }

  std::vector<std::uint8_t> Run()
  {
    if (!this->Segments.empty())
    {
      this->CompareApart();
      this->CompareAtVertices();
    }
    return this->IsDivided;
  }

  // For SegmentTree::VisitPairs.
  bool GoesOn() { return this->Progress.Beat(); }
  void SetFraction(double fraction) { this->Progress.SetFraction(fraction); }

  void operator()(Id first, Id second)
  {
    if (this->AreNear(first, second))
    {
      this->IsDivided[first] = 0;
      this->IsDivided[second] = 0;
    }
  }

private:
  void CompareApart()
  {
    const SegmentTree tree(this->Geometry.Vertices, this->Segments, this->Near, this->Progress);
    const std::vector<std::uint8_t> all(this->Segments.size(), 1);
    tree.VisitPairs(all, *this);
  }

  void CompareAtVertices()
  {
    const VertexStars stars(this->Geometry.Vertices, this->Segments, this->Progress);
    for (Id vertex = 0; vertex < stars.NumberOfVertices() && this->Progress.Beat(); ++vertex)
    {
      for (const Id* segment = stars.Begin(vertex); segment != stars.End(vertex); ++segment)
      {
        const Id next = stars.Next(vertex, *segment);
        if (next != *segment && this->AreNearAt(vertex, *segment, next))
        {
          this->IsDivided[*segment] = 0;
          this->IsDivided[next] = 0;
        }
      }
    }
  }

  // Segments do not cross, so an end of one is nearest.
  bool AreNear(Id segment, Id other) const
  {
    const Point2& a = this->Start(segment);
    const Point2& b = this->End(segment);
    const Point2& c = this->Start(other);
    const Point2& d = this->End(other);
    const double distance =
      std::min(std::min(DistanceToSegment(a, c, d), DistanceToSegment(b, c, d)),
        std::min(DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)));
    return !(distance > this->Near);
  }

  bool AreNearAt(Id vertex, Id segment, Id other) const
  {
    const Point2& center = this->Geometry.Vertices[vertex];
    const Point2 p = this->Geometry.Vertices[OtherEnd(this->Segments[segment], vertex)] - center;
    const Point2 q = this->Geometry.Vertices[OtherEnd(this->Segments[other], vertex)] - center;
    const double lengths = Length(p) * Length(q);
    if (!(Dot(p, q) > 0.0))
    {
      return false;
    }
    const double reach =
      std::min(std::min(Length(p), Length(q)), LeastPart * this->Spacings[vertex]);
    return !(std::abs(Cross(p, q)) * reach > this->Near * lengths);
  }

  const Point2& Start(Id segment) const
  {
    return this->Geometry.Vertices[this->Geometry.Starts[segment]];
  }
  const Point2& End(Id segment) const
  {
    return this->Geometry.Vertices[this->Geometry.Ends[segment]];
  }

  const Domain& Geometry;
  const std::vector<double>& Spacings;
  Pulse& Progress;
  double Near;
  std::vector<SegmentEnds> Segments;
  std::vector<std::uint8_t> IsDivided;
};

} // namespace

double LeastSlidingLength(const Domain& domain)
{
  return LeastInResolutions * domain.Resolution;
}

std::vector<std::uint8_t> FindDividedSegments(
  const Domain& domain, const std::vector<double>& spacings, Pulse& pulse)
{
  return ClearanceSearch(domain, spacings, pulse).Run();
}

} // namespace biting
