// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainCheck_h
#define BitingDomainCheck_h

#include "Domain/Domain.h"
#include "Domain/SegmentTree.h"
#include "Domain/VertexStars.h"
#include "Predicates/Predicates.h"

#include <algorithm> // for sort
#include <cmath>     // for isfinite
#include <cstddef>   // for size_t
#include <string>    // for the report

namespace biting
{

/// Checks one domain; each question returns the first violation as text, or nothing.
class DomainChecker
{
public:
  explicit DomainChecker(const Domain& domain);

  std::string Sizes() const;
  std::string Vertices() const;
  std::string Segments() const;
  std::string Meetings() const;
  std::string LoneVertices() const;
  std::string Fans() const;
  std::string Sides() const;

private:
  static std::string Violation(const char* text, Id id)
  {
    return text + (" " + std::to_string(id));
  }
  std::string Turn(Id vertex, Id here, Id next) const;
  bool MeetsAnother(Id segment, const SegmentTree& tree) const;
  const Point2& At(Id vertex) const { return this->Input.Vertices[vertex]; }
  bool IsLeftSeenFrom(Id vertex, Id segment, bool isLeft) const;

  const Domain& Input;
  std::vector<SegmentEnds> Ends;
};

inline DomainChecker::DomainChecker(const Domain& domain)
  : Input(domain)
{
  for (std::size_t s = 0; s < domain.Starts.size() && s < domain.Ends.size(); ++s)
  {
    this->Ends.push_back({ domain.Starts[s], domain.Ends[s] });
  }
}

inline std::string DomainChecker::Sizes() const
{
  const std::size_t vertices = this->Input.Vertices.size();
  const std::size_t segments = this->Input.Starts.size();
  const bool isEqual = this->Input.VertexPoints.size() == vertices &&
    this->Input.IsEmbedded.size() == vertices && this->Input.HasPoint.size() == vertices &&
    this->Input.Ends.size() == segments && this->Input.Cells.size() == segments &&
    this->Input.IsBoundary.size() == segments && this->Input.LeftInside.size() == segments &&
    this->Input.RightInside.size() == segments;
  return isEqual ? "" : "arrays differ in size";
}

inline std::string DomainChecker::Vertices() const
{
  std::vector<Point2> places = this->Input.Vertices;
  for (const Point2& p : places)
  {
    if (!std::isfinite(p.X) || !std::isfinite(p.Y))
    {
      return "a vertex is not finite";
    }
    if (!this->Input.Bounds.Contains(p))
    {
      return "a vertex lies out of bounds";
    }
  }
  std::sort(places.begin(), places.end());
  const bool isDistinct = std::adjacent_find(places.begin(), places.end()) == places.end();
  return isDistinct ? "" : "two vertices coincide";
}

inline std::string DomainChecker::Segments() const
{
  const Id vertices = this->Input.NumberOfVertices();
  for (std::size_t s = 0; s < this->Ends.size(); ++s)
  {
    const SegmentEnds& ends = this->Ends[s];
    const bool isValid = ends.Start >= 0 && ends.Start < vertices && ends.End >= 0 &&
      ends.End < vertices && ends.Start != ends.End;
    if (!isValid)
    {
      return Violation("ends of segment", static_cast<Id>(s));
    }
  }
  return "";
}

/// Segments without a common end; the others are seen in the fans.
inline std::string DomainChecker::Meetings() const
{
  Pulse unheard(NoMonitor());
  const SegmentTree tree(this->Input.Vertices, this->Ends, 0.0, unheard);
  for (Id segment = 0; segment < this->Input.NumberOfSegments(); ++segment)
  {
    if (this->MeetsAnother(segment, tree))
    {
      return Violation("another segment meets segment", segment);
    }
  }
  return "";
}

inline bool DomainChecker::MeetsAnother(Id segment, const SegmentTree& tree) const
{
  const SegmentEnds& a = this->Ends[segment];
  Box2 box;
  box.Add(this->At(a.Start));
  box.Add(this->At(a.End));
  bool isMet = false;
  const auto test = [this, &a, &isMet](Id other)
  {
    const SegmentEnds& b = this->Ends[other];
    isMet = isMet ||
      Meet(this->At(a.Start), this->At(a.End), this->At(b.Start), this->At(b.End)) != Meeting::None;
  };
  tree.Visit(box, a, test);
  return isMet;
}

inline std::string DomainChecker::LoneVertices() const
{
  Pulse unheard(NoMonitor());
  const SegmentTree tree(this->Input.Vertices, this->Ends, 0.0, unheard);
  const VertexStars stars(this->Input.Vertices, this->Ends, unheard);
  for (Id vertex = 0; vertex < this->Input.NumberOfVertices(); ++vertex)
  {
    const bool isEmbedded = this->Input.IsEmbedded[vertex] != 0;
    if (isEmbedded != (stars.Degree(vertex) == 0) || (isEmbedded && !this->Input.HasPoint[vertex]))
    {
      return Violation("embedded mark of vertex", vertex);
    }
    Box2 place;
    place.Add(this->At(vertex));
    bool isMet = false;
    tree.Visit(place, { vertex, NoId },
      [this, vertex, &isMet](Id segment)
      {
        const SegmentEnds& ends = this->Ends[segment];
        isMet = isMet || IsOnSegment(this->At(vertex), this->At(ends.Start), this->At(ends.End));
      });
    if (isMet)
    {
      return Violation("a segment passes through vertex", vertex);
    }
  }
  return "";
}

inline std::string DomainChecker::Fans() const
{
  Pulse unheard(NoMonitor());
  const VertexStars stars(this->Input.Vertices, this->Ends, unheard);
  std::string violation;
  for (Id vertex = 0; vertex < stars.NumberOfVertices(); ++vertex)
  {
    const Id* star = stars.Begin(vertex);
    for (Id i = 0; i < stars.Degree(vertex) && violation.empty(); ++i)
    {
      violation = this->Turn(vertex, star[i], star[(i + 1) % stars.Degree(vertex)]);
    }
  }
  return violation;
}

/// Two neighbours around a vertex: different directions, and one face between them.
inline std::string DomainChecker::Turn(Id vertex, Id here, Id next) const
{
  const Point2& apex = this->At(vertex);
  const Point2& a = this->At(OtherEnd(this->Ends[here], vertex));
  const Point2& b = this->At(OtherEnd(this->Ends[next], vertex));
  if (here != next && Orient2D(apex, a, b) == 0 && (apex < a) == (apex < b))
  {
    return Violation("two segments overlap at vertex", vertex);
  }
  const bool isSameFace =
    this->IsLeftSeenFrom(vertex, here, true) == this->IsLeftSeenFrom(vertex, next, false);
  return isSameFace ? "" : Violation("inside flags disagree at vertex", vertex);
}

/// The flag of the side that is left (or right) when looking from `vertex` along `segment`.
inline bool DomainChecker::IsLeftSeenFrom(Id vertex, Id segment, bool isLeft) const
{
  const bool isForward = this->Ends[segment].Start == vertex;
  return (isForward == isLeft ? this->Input.LeftInside : this->Input.RightInside)[segment] != 0;
}

inline std::string DomainChecker::Sides() const
{
  for (std::size_t s = 0; s < this->Ends.size(); ++s)
  {
    const bool isLeft = this->Input.LeftInside[s] != 0;
    const bool isRight = this->Input.RightInside[s] != 0;
    if (!isLeft && !isRight)
    {
      return Violation("outside on both sides of segment", static_cast<Id>(s));
    }
    if ((isLeft != isRight) != (this->Input.IsBoundary[s] != 0))
    {
      return Violation("boundary mark of segment", static_cast<Id>(s));
    }
  }
  return "";
}

/// Checks the invariant of `domain`, exactly: finite distinct vertices; segments with distinct ends
/// that meet at common vertices only; inside flags consistent with parity around each vertex.
/// Returns the first violation as text, empty where there is none.
inline std::string CheckDomain(const Domain& domain)
{
  const DomainChecker checker(domain);
  std::string violation = checker.Sizes();
  using Question = std::string (DomainChecker::*)() const;
  for (const Question question :
    { &DomainChecker::Vertices, &DomainChecker::Segments, &DomainChecker::Meetings,
      &DomainChecker::LoneVertices, &DomainChecker::Fans, &DomainChecker::Sides })
  {
    violation = violation.empty() ? (checker.*question)() : violation;
  }
  return violation;
}

} // namespace biting

#endif
