// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainChains.h"

#include <array>   // for pairs
#include <cstddef> // for size_t

namespace biting
{

namespace
{

using AreAlike = std::function<bool(Id, Id)>;

class ChainMaker
{
public:
  ChainMaker(const Domain& domain, const AreAlike& areAlike, Pulse& pulse)
    : Drawing(domain)
    , Pairs(domain.Vertices.size(), { NoId, NoId })
    , Degrees(domain.Vertices.size(), 0)
    , Inner(domain.Vertices.size(), 0)
    , IsDone(domain.Starts.size(), 0)
  {
    for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
    {
      for (const Id vertex : { domain.Starts[segment], domain.Ends[segment] })
      {
        const Id degree = this->Degrees[vertex]++;
        if (degree < 2)
        {
          this->Pairs[vertex][degree] = segment;
        }
      }
    }
    pulse.ForEach(domain.Vertices.size(),
      [this, &areAlike](std::size_t vertex)
      { this->Inner[vertex] = this->IsInner(static_cast<Id>(vertex), areAlike); });
  }

  DomainChains Make(Pulse& pulse)
  {
    for (const bool isClosed : { false, true })
    {
      pulse.ForEach(this->IsDone.size(),
        [this, isClosed](std::size_t place)
        {
          const Id segment = static_cast<Id>(place);
          for (const Id vertex : { this->Drawing.Starts[segment], this->Drawing.Ends[segment] })
          {
            if (!this->IsDone[place] && (isClosed || !this->Inner[vertex]))
            {
              this->Walk(segment, vertex, isClosed);
            }
          }
        });
    }
    this->Result.Firsts.push_back(this->Result.NumberOfSlots());
    this->Result.Goes.assign(this->Result.Vertices.size(), 0);
    return std::move(this->Result);
  }

private:
  bool IsInner(Id vertex, const AreAlike& areAlike) const
  {
    if (this->Degrees[vertex] != 2 || this->Drawing.HasPoint[vertex])
    {
      return false;
    }
    const auto [first, second] = this->Pairs[vertex];
    const Id firstCell = this->Drawing.Cells[first];
    const Id secondCell = this->Drawing.Cells[second];
    return this->Drawing.IsBoundary[first] == this->Drawing.IsBoundary[second] &&
      (firstCell == secondCell || !areAlike || areAlike(firstCell, secondCell));
  }

  void Walk(Id segment, Id start, bool isClosed)
  {
    this->Result.Firsts.push_back(this->Result.NumberOfSlots());
    Id vertex = start;
    bool isOver = false;
    while (!isOver)
    {
      this->IsDone[segment] = 1;
      this->AddSlot(vertex, segment);
      vertex = this->OtherEnd(segment, vertex);
      isOver = vertex == start || !this->Inner[vertex];
      const auto [first, second] = this->Pairs[vertex];
      segment = first == segment ? second : first;
    }
    if (!isClosed)
    {
      this->AddSlot(vertex, NoId);
    }
    this->Link(isClosed);
  }

  void AddSlot(Id vertex, Id segment)
  {
    this->Result.Vertices.push_back(vertex);
    this->Result.Segments.push_back(segment);
    this->Result.Chains.push_back(this->Result.NumberOfChains());
  }

  void Link(bool isClosed)
  {
    const Id first = this->Result.Firsts.back();
    const Id last = this->Result.NumberOfSlots() - 1;
    for (Id slot = first; slot <= last; ++slot)
    {
      this->Result.Nexts.push_back(slot + 1);
      this->Result.Previous.push_back(slot - 1);
    }
    this->Result.Nexts[last] = isClosed ? first : NoId;
    this->Result.Previous[first] = isClosed ? last : NoId;
    this->Result.IsClosed.push_back(isClosed ? 1 : 0);
    this->Result.Left.push_back(last - first + 1);
  }

  Id OtherEnd(Id segment, Id vertex) const
  {
    const Id start = this->Drawing.Starts[segment];
    return start == vertex ? this->Drawing.Ends[segment] : start;
  }

  const Domain& Drawing;
  std::vector<std::array<Id, 2>> Pairs; ///< the first two segments at each vertex
  std::vector<Id> Degrees;
  std::vector<std::uint8_t> Inner;  ///< of each vertex: chains go on there
  std::vector<std::uint8_t> IsDone; ///< of each segment
  DomainChains Result;
};

} // namespace

DomainChains MakeChains(const Domain& domain, const AreAlike& areAlike, Pulse& pulse)
{
  return ChainMaker(domain, areAlike, pulse).Make(pulse);
}

} // namespace biting
