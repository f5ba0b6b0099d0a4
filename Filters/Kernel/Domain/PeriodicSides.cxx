// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PeriodicSides.h"

#include "../Base/BoxTree.h"
#include "../Base/PointOnSegment.h"

#include <algorithm> // for sort, min, max
#include <cmath>     // for abs
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

// What is mapped beside a side, not onto it: within these shares of the translation's length, of
// the shorter segment, and of a turn (the sine of 10 degrees).
constexpr double NearShare = 0.01;
constexpr double LeastOverlap = 0.5;
constexpr double NearSine = 0.17;

// Vertices of one side divide the other, and with two translations the next one, once each.
constexpr int MostRounds = 8;

struct SideItem
{
  Id Segment;
  Point2 Start;
  Point2 End;

  Box2 Box() const { return Box2::Around(this->Start, this->End); }
  double Least() const { return 0.0; }
};

// How an image and a segment lie along each other.
struct Overlap
{
  double From = 0.0; // parameters of the image
  double To = 0.0;
  double Apart = 0.0; // at the farther of both
  double Sine = 0.0;
  bool AreOpposite = false; // the domain lies on different sides
};

class SideMatcher
{
public:
  SideMatcher(Domain& domain, double tolerance, Pulse& pulse)
    : Geometry(domain)
    , Tolerance(tolerance)
    , Beats(pulse)
  {
    this->Origins.resize(domain.Starts.size());
    for (std::size_t segment = 0; segment < this->Origins.size(); ++segment)
    {
      this->Origins[segment] = static_cast<Id>(segment);
    }
  }

  PeriodicSides Match(const std::vector<Point2>& translations, ProblemList& problems);

private:
  void FindPairs(const std::vector<Point2>& translations);
  void FindImages(const BoxTree<SideItem>& tree, const Point2& translation);
  void Meet(const SideItem& image, const SideItem& other);
  void CutAt(const SideItem& segment, const Point2& place);
  bool Divide();
  void Check(const Point2& translation, std::size_t number, ProblemList& problems) const;
  void Refuse(
    Id segment, const Point2& place, const std::string& detail, ProblemList& problems) const;
  std::vector<SideItem> Sides() const;
  Point2 At(const SideItem& item, double t) const
  {
    return item.Start + t * (item.End - item.Start);
  }
  Overlap Compare(const SideItem& image, const SideItem& other) const;

  // A segment whose image is beside another, and how far.
  struct NearMiss
  {
    Id First;
    Id Second;
    double Distance;
    std::size_t Translation;
  };

  Domain& Geometry;
  double Tolerance;
  Pulse& Beats;
  std::vector<Id> Origins; // the segment that each is a part of
  std::size_t Translation = 0;
  double Near = 0.0;
  PeriodicSides Result;
  std::vector<NearMiss> Misses;
  std::vector<std::vector<double>> Cuts; // of each segment
};

std::vector<SideItem> SideMatcher::Sides() const
{
  std::vector<SideItem> sides;
  for (Id segment = 0; segment < this->Geometry.NumberOfSegments(); ++segment)
  {
    if (this->Geometry.IsBoundary[segment])
    {
      sides.push_back({ segment, this->Geometry.Vertices[this->Geometry.Starts[segment]],
        this->Geometry.Vertices[this->Geometry.Ends[segment]] });
    }
  }
  return sides;
}

Overlap SideMatcher::Compare(const SideItem& image, const SideItem& other) const
{
  const Point2 way = image.End - image.Start;
  const Point2 across = other.End - other.Start;
  const double length = Length(way);
  const double otherLength = Length(across);
  const double start = Dot(other.Start - image.Start, way) / (length * length);
  const double end = Dot(other.End - image.Start, way) / (length * length);
  Overlap overlap;
  overlap.From = std::max(0.0, std::min(start, end));
  overlap.To = std::min(1.0, std::max(start, end));
  const auto apart = [this, &image, &other, &across, otherLength](double t)
  { return std::abs(Cross(across, this->At(image, t) - other.Start)) / otherLength; };
  overlap.Apart = std::max(apart(overlap.From), apart(overlap.To));
  overlap.Sine = std::abs(Cross(way, across)) / (length * otherLength);
  const bool isLeft = this->Geometry.LeftInside[image.Segment] != 0;
  const bool isOtherLeft = this->Geometry.LeftInside[other.Segment] != 0;
  overlap.AreOpposite = (Dot(way, across) > 0.0) == (isLeft != isOtherLeft);
  return overlap;
}

// Unless the place is an end.
void SideMatcher::CutAt(const SideItem& segment, const Point2& place)
{
  const Point2 way = segment.End - segment.Start;
  const double length = Length(way);
  const double t = Dot(place - segment.Start, way) / (length * length);
  if (t * length > this->Tolerance && (1.0 - t) * length > this->Tolerance)
  {
    this->Cuts[segment.Segment].push_back(t);
  }
}

void SideMatcher::Meet(const SideItem& image, const SideItem& other)
{
  const Overlap overlap = this->Compare(image, other);
  const double shared = (overlap.To - overlap.From) * Distance(image.Start, image.End);
  const double shorter =
    std::min(Distance(image.Start, image.End), Distance(other.Start, other.End));
  if (!overlap.AreOpposite || !(shared > 2.0 * this->Tolerance))
  {
    return;
  }
  if (overlap.Apart <= this->Tolerance)
  {
    this->Result.Pairs.push_back({ image.Segment, other.Segment, this->Translation });
    this->CutAt(image, other.Start);
    this->CutAt(image, other.End);
    this->CutAt(other, image.Start);
    this->CutAt(other, image.End);
  }
  else if (overlap.Apart <= this->Near && overlap.Sine <= NearSine &&
    shared > LeastOverlap * shorter)
  {
    this->Misses.push_back({ image.Segment, other.Segment, overlap.Apart, this->Translation });
  }
}

void SideMatcher::FindImages(const BoxTree<SideItem>& tree, const Point2& translation)
{
  this->Near = std::max(this->Tolerance, NearShare * Length(translation));
  for (const SideItem& item : this->Sides())
  {
    const SideItem image{ item.Segment, item.Start + translation, item.End + translation };
    Box2 box = image.Box();
    box.Grow(this->Near);
    tree.AllOf(box,
      [this, &image](const SideItem& other)
      {
        if (other.Segment != image.Segment)
        {
          this->Meet(image, other);
        }
        return true;
      });
    if (!this->Beats.Beat(16))
    {
      return;
    }
  }
}

void SideMatcher::FindPairs(const std::vector<Point2>& translations)
{
  this->Result.Pairs.clear();
  this->Misses.clear();
  this->Cuts.assign(this->Geometry.Starts.size(), {});
  const BoxTree<SideItem> tree(this->Sides(), this->Beats);
  for (this->Translation = 0; this->Translation < translations.size(); ++this->Translation)
  {
    this->FindImages(tree, translations[this->Translation]);
  }
  std::sort(this->Result.Pairs.begin(), this->Result.Pairs.end(),
    [](const PeriodicSides::Pair& a, const PeriodicSides::Pair& b)
    {
      return a.Translation != b.Translation ? a.Translation < b.Translation
        : a.First != b.First                ? a.First < b.First
                                            : a.Second < b.Second;
    });
}

// Whether anything was cut.
bool SideMatcher::Divide()
{
  bool isCut = false;
  for (std::size_t segment = 0; segment < this->Cuts.size(); ++segment)
  {
    std::vector<double>& cuts = this->Cuts[segment];
    const double length = Distance(this->Geometry.Vertices[this->Geometry.Starts[segment]],
      this->Geometry.Vertices[this->Geometry.Ends[segment]]);
    std::sort(cuts.begin(), cuts.end());
    const auto isSame = [this, length](double a, double b)
    { return (b - a) * length <= this->Tolerance; };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), isSame), cuts.end());
    isCut = isCut || !cuts.empty();
  }
  if (isCut)
  {
    std::vector<Id> origins;
    for (const Id old : DivideSegments(this->Cuts, this->Geometry))
    {
      origins.push_back(this->Origins[old]);
    }
    this->Origins = std::move(origins);
  }
  return isCut;
}

void SideMatcher::Refuse(
  Id segment, const Point2& place, const std::string& detail, ProblemList& problems) const
{
  problems.Add({ ProblemCode::UnmatchedSides, { this->Geometry.Cells[segment] }, place, detail });
}

void SideMatcher::Check(const Point2& translation, std::size_t number, ProblemList& problems) const
{
  const std::size_t count = this->Geometry.Starts.size();
  std::vector<std::uint8_t> isPaired(count, 0);
  for (const PeriodicSides::Pair& pair : this->Result.Pairs)
  {
    if (pair.Translation == number)
    {
      isPaired[pair.First] = 1;
      isPaired[pair.Second] = 1;
    }
  }
  const auto middle = [this](std::size_t segment)
  {
    return Midpoint(this->Geometry.Vertices[this->Geometry.Starts[segment]],
      this->Geometry.Vertices[this->Geometry.Ends[segment]]);
  };
  std::vector<std::uint8_t> hasPart(count, 0); // of the segments at first
  for (std::size_t segment = 0; segment < count; ++segment)
  {
    hasPart[this->Origins[segment]] |= isPaired[segment];
  }
  for (std::size_t segment = 0; segment < count; ++segment)
  {
    if (!isPaired[segment] && hasPart[this->Origins[segment]])
    {
      this->Refuse(static_cast<Id>(segment), middle(segment),
        "only a part of it has an image: where a side ends, the other needs a vertex", problems);
    }
  }
  for (const NearMiss& miss : this->Misses)
  {
    if (miss.Translation == number && !isPaired[miss.First] && !isPaired[miss.Second])
    {
      this->Refuse(miss.First, middle(static_cast<std::size_t>(miss.First)),
        "its image is " + Figure(miss.Distance) + " beside cell " +
          std::to_string(this->Geometry.Cells[miss.Second]),
        problems);
    }
  }
  if (!problems.HasErrors() && std::count(isPaired.begin(), isPaired.end(), 1) == 0)
  {
    problems.Add({ ProblemCode::UnmatchedSides, {}, {},
      "none is mapped onto another by the translation (" + Figure(translation.X, 6) + ", " +
        Figure(translation.Y, 6) + ") in the plane" });
  }
}

PeriodicSides SideMatcher::Match(const std::vector<Point2>& translations, ProblemList& problems)
{
  this->FindPairs(translations);
  for (int round = 0; round < MostRounds && !this->Beats.HasStopped() && this->Divide(); ++round)
  {
    this->FindPairs(translations);
  }
  for (std::size_t number = 0; number < translations.size() && !this->Beats.HasStopped(); ++number)
  {
    this->Check(translations[number], number, problems);
  }
  return problems.HasErrors() || this->Beats.HasStopped() ? PeriodicSides()
                                                          : std::move(this->Result);
}

} // namespace

bool AreParallel(const Domain& domain, const PeriodicSides::Pair& pair)
{
  const auto way = [&domain](Id segment)
  { return domain.Vertices[domain.Ends[segment]] - domain.Vertices[domain.Starts[segment]]; };
  return Dot(way(pair.First), way(pair.Second)) > 0.0;
}

PeriodicSides MatchSides(Domain& domain, const std::vector<Point2>& translations, double tolerance,
  ProblemList& problems, Pulse& pulse)
{
  return translations.empty() ? PeriodicSides()
                              : SideMatcher(domain, tolerance, pulse).Match(translations, problems);
}

std::vector<Id> DivideSegments(const std::vector<std::vector<double>>& parameters, Domain& domain)
{
  Domain divided = domain;
  divided.Starts.clear();
  divided.Ends.clear();
  std::vector<Id> old;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& a = domain.Vertices[domain.Starts[segment]];
    const Point2& b = domain.Vertices[domain.Ends[segment]];
    const std::vector<double>& cuts = parameters[segment];
    Id last = domain.Starts[segment];
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      const double before = k == 0 ? 0.0 : cuts[k - 1];
      const double after = k + 1 == cuts.size() ? 1.0 : cuts[k + 1];
      const double room = std::min(cuts[k] - before, after - cuts[k]) * Distance(a, b);
      const Id vertex = divided.NumberOfVertices();
      divided.Vertices.push_back(PointOnSegment(a, b, cuts[k], room));
      divided.Starts.push_back(last);
      divided.Ends.push_back(vertex);
      old.push_back(segment);
      last = vertex;
    }
    divided.Starts.push_back(last);
    divided.Ends.push_back(domain.Ends[segment]);
    old.push_back(segment);
  }
  divided.VertexPoints.resize(divided.Vertices.size(), NoId);
  divided.IsEmbedded.resize(divided.Vertices.size(), 0);
  divided.HasPoint.resize(divided.Vertices.size(), 0);
  const auto take = [&old](auto& values)
  {
    const auto before = values;
    values.clear();
    for (const Id segment : old)
    {
      values.push_back(before[segment]);
    }
  };
  take(divided.Cells);
  take(divided.IsBoundary);
  take(divided.LeftInside);
  take(divided.RightInside);
  if (!divided.IsPreserved.empty())
  {
    take(divided.IsPreserved);
  }
  domain = std::move(divided);
  return old;
}

} // namespace biting
