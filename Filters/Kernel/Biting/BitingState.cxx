// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingState.h"

#include "Bisectors.h"

#include <algorithm> // for all_of, max, min

namespace biting
{

namespace
{

constexpr std::size_t CheapStepsPerBite = 32; // where bites are crowded: thousands
constexpr double TieTolerance = 1e-12;        // of a half-width
constexpr double GreatestSlack = 0.5;         // of a half-width

// Where the first is full all get room for a few more: twice as many would be more than are needed.
template <typename First, typename... Rest>
void MakeRoom(std::vector<First>& first, std::vector<Rest>&... rest)
{
  constexpr std::size_t SizePerRoom = 16;
  const std::size_t size = first.size();
  if (size == first.capacity())
  {
    const std::size_t wanted = size + std::max(size / SizePerRoom, SizePerRoom);
    first.reserve(wanted);
    (rest.reserve(wanted), ...);
  }
}

} // namespace

double NeighborRange(const BitingOptions& options)
{
  return options.Placement == Placement::Corners
    ? 0.0
    : Bisectors::GreatestBond * options.PartLength / options.BitingConstant;
}

BitingState::BitingState(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
  : Geometry(domain)
  , Locator(locator)
  , F(spacing)
  , Options(options)
  , Progress(monitor)
  , ExpectedVertices(expectedVertices)
  , Placed(Result.Bites)
  , Grid(Result.Bites, domain.Bounds, expectedVertices - domain.NumberOfVertices(),
      NeighborRange(options), domain.Resolution)
{
}

void BitingState::Reserve()
{
  const std::size_t expected = static_cast<std::size_t>(this->ExpectedVertices) + 16;
  const auto reserve = [expected](auto&... arrays) { (arrays.reserve(expected), ...); };
  reserve(this->Result.Points, this->Result.Spacings, this->Result.BiteOrders, this->Placed.Centers,
    this->Placed.Axes, this->Placed.HalfWidths, this->Placed.Orders, this->Placed.Phases);
  if (this->Options.FollowSlope)
  {
    reserve(this->PlacedSpacings);
  }
}

Id BitingState::AddVertex(const Point2& place, double spacing, Id segment)
{
  MakeRoom(this->Result.Points, this->Result.Spacings, this->Result.BiteOrders);
  if (segment != NoId)
  {
    this->Result.Segments.resize(this->Result.Points.size(), NoId);
    this->Result.Segments.push_back(segment);
  }
  this->Result.Points.push_back(place);
  this->Result.Spacings.push_back(spacing);
  this->Result.BiteOrders.push_back(NoId);
  return static_cast<Id>(this->Result.Points.size()) - 1;
}

void BitingState::AddEdge(Id start, Id end, Id segment)
{
  this->Result.EdgeStarts.push_back(start);
  this->Result.EdgeEnds.push_back(end);
  this->Result.EdgeSegments.push_back(segment);
}

void BitingState::Bite(Id vertex, const Point2& axis, double share, BitePhase phase)
{
  const double spacing = this->Result.Spacings[vertex];
  this->AddBite(this->Result.Points[vertex],
    this->Options.Shape == BiteShape::Circle ? Point2{} : axis,
    share * this->Options.BitingConstant * spacing, spacing, phase);
  this->Result.BiteOrders[vertex] = this->NumberOfBites;
}

void BitingState::AddBite(
  const Point2& center, const Point2& axis, double halfWidth, double spacing, BitePhase phase)
{
  const Id bite = this->Placed.Size();
  MakeRoom(this->Placed.HalfWidths, this->Placed.Centers, this->Placed.Axes, this->Placed.Orders,
    this->Placed.Phases);
  this->Placed.Centers.push_back(center);
  this->Placed.Axes.push_back(axis);
  this->Placed.HalfWidths.push_back(halfWidth);
  this->Placed.Orders.push_back(this->NumberOfBites);
  this->Placed.Phases.push_back(phase);
  if (this->Options.FollowSlope)
  {
    MakeRoom(this->PlacedSpacings);
    this->PlacedSpacings.push_back(spacing);
  }
  this->Grid.File(bite);
}

bool BitingState::MayBite() const
{
  const std::int64_t most = this->Options.MaximumNumberOfBites;
  return this->Result.End == BitingEnd::Complete && (most < 0 || this->NumberOfBites < most);
}

void BitingState::FinishBite()
{
  ++this->NumberOfBites;
  if (static_cast<std::int64_t>(this->Result.Points.size()) > this->Options.MaximumNumberOfVertices)
  {
    this->Result.End = BitingEnd::TooManyVertices;
  }
  this->Step();
}

void BitingState::Step()
{
  this->Progress.SetFraction(std::min(this->NumberOfBites / this->ExpectedVertices, 1.0));
  if (!this->Progress.Beat(CheapStepsPerBite))
  {
    this->Result.End = BitingEnd::Aborted;
  }
}

double BitingState::Slack(Id bite) const
{
  const double halfWidth = this->Placed.HalfWidths[bite];
  return TieTolerance * halfWidth + std::min(this->Geometry.Resolution, GreatestSlack * halfWidth);
}

bool BitingState::DividesSegments() const
{
  const std::vector<std::uint8_t>& isPreserved = this->Geometry.IsPreserved;
  const bool areAllPreserved = !isPreserved.empty() &&
    std::all_of(isPreserved.begin(), isPreserved.end(), [](std::uint8_t is) { return is != 0; });
  return !this->Options.PreserveBoundary && !areAllPreserved;
}

BitingEnd BitingState::ReasonNotToDivide() const
{
  return this->Progress.HasStopped() ? BitingEnd::Aborted : BitingEnd::TooManyVertices;
}

} // namespace biting
