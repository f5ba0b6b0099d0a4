// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureLines.h"

#include "../../Base/Numbers.h"
#include "../Surface/SurfaceLinks.h"

#include <algorithm> // for sort, unique, binary_search
#include <cmath>     // for cos
#include <map>       // for chains at corners
#include <utility>   // for pairs, move

namespace biting
{

namespace
{

constexpr double StraightestCorner = 0.6427876096865394; // cos 50 degrees

constexpr EdgeFlag FlagOf(SurfaceEdgeKind kind)
{
  return static_cast<EdgeFlag>(1 + static_cast<int>(kind));
}

/// A feature edge as seen from one of its ends.
struct FeatureArm
{
  Id Tail;
  Id Head;
  EdgeFlag Flag;

  bool operator<(const FeatureArm& other) const
  {
    return this->Tail != other.Tail ? this->Tail < other.Tail : this->Head < other.Head;
  }
  bool operator==(const FeatureArm& other) const
  {
    return this->Tail == other.Tail && this->Head == other.Head;
  }
};

/// The feature edges as a graph, and its chains.
class ChainWalk
{
public:
  explicit ChainWalk(SurfaceGround& ground)
    : Ground(ground)
  {
    const std::vector<Id>& corners = ground.Mesh.Corners;
    for (std::size_t slot = 0; slot < corners.size(); ++slot)
    {
      if (ground.Flags[slot] != 0)
      {
        const Id a = corners[NextSlotOf(slot)];
        const Id b = corners[PreviousSlotOf(slot)];
        this->Arms.push_back({ a, b, ground.Flags[slot] });
        this->Arms.push_back({ b, a, ground.Flags[slot] });
      }
    }
    std::sort(this->Arms.begin(), this->Arms.end());
    this->Arms.erase(std::unique(this->Arms.begin(), this->Arms.end()), this->Arms.end());
    this->IsUsed.assign(this->Arms.size(), 0);
  }

  void Run()
  {
    this->Ground.Chains = {};
    this->Ground.Vanished.clear();
    this->FindPlaces();
    // From corners first; what is left are closed chains without one.
    for (const bool isFromCorners : { true, false })
    {
      for (std::size_t arm = 0; arm < this->Arms.size(); ++arm)
      {
        if (this->IsUsed[arm] == 0 &&
          (!isFromCorners || this->Ground.IsCorner(this->Arms[arm].Tail)))
        {
          this->Follow(arm);
        }
      }
    }
  }

private:
  const Point3& PointAt(Id vertex) const { return this->Ground.Mesh.Points[At(vertex)]; }

  /// From the vertex to the head; without one the first arm of the vertex.
  std::size_t ArmAt(Id vertex, Id head = NoId) const
  {
    const FeatureArm arm{ vertex, head, 0 };
    const auto first = std::lower_bound(this->Arms.begin(), this->Arms.end(), arm);
    return static_cast<std::size_t>(first - this->Arms.begin());
  }

  void FindPlaces()
  {
    this->Ground.Places.assign(this->Ground.Mesh.Points.size(), FeaturePlace::None);
    for (const Id vertex : this->Ground.Pinches)
    {
      this->Ground.Places[At(vertex)] = FeaturePlace::Corner;
    }
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < this->Arms.size(); begin = end)
    {
      const FeatureArm& arm = this->Arms[begin];
      while (end < this->Arms.size() && this->Arms[end].Tail == arm.Tail)
      {
        ++end;
      }
      bool isCorner = this->Ground.IsCorner(arm.Tail) || end - begin != 2 ||
        arm.Flag != this->Arms[begin + 1].Flag;
      if (!isCorner)
      {
        const Point3 in = this->PointAt(arm.Tail) - this->PointAt(arm.Head);
        const Point3 out = this->PointAt(this->Arms[begin + 1].Head) - this->PointAt(arm.Tail);
        isCorner = Dot(in, out) < StraightestCorner * Length(in) * Length(out);
      }
      this->Ground.Places[At(arm.Tail)] = isCorner ? FeaturePlace::Corner : FeaturePlace::Line;
    }
  }

  void Follow(std::size_t arm)
  {
    FeatureChains& chains = this->Ground.Chains;
    const Id start = this->Arms[arm].Tail;
    chains.Vertices.push_back(start);
    chains.Kinds.push_back(static_cast<SurfaceEdgeKind>(this->Arms[arm].Flag - 1));
    Id head = start;
    do
    {
      const Id tail = this->Arms[arm].Tail;
      head = this->Arms[arm].Head;
      const std::size_t first = this->ArmAt(head);
      const std::size_t back = this->ArmAt(head, tail);
      this->IsUsed[arm] = 1;
      this->IsUsed[back] = 1;
      chains.Vertices.push_back(head);
      arm = back == first ? first + 1 : first;
    } while (head != start && !this->Ground.IsCorner(head));
    chains.Offsets.push_back(static_cast<Id>(chains.Vertices.size()));
  }

  SurfaceGround& Ground;
  std::vector<FeatureArm> Arms;
  std::vector<std::uint8_t> IsUsed;
};

/// Makes corners one at short chains between them.
class CornerMerger
{
public:
  explicit CornerMerger(SurfaceGround& ground)
    : Ground(ground)
  {
    const FeatureChains& chains = ground.Chains;
    for (Id chain = 0; chain < chains.Size(); ++chain)
    {
      const Id* first = chains.Vertices.data() + chains.Begin(chain);
      this->Paths.emplace_back(first, chains.Vertices.data() + chains.End(chain));
      this->ChainsAt[this->Paths.back().front()].push_back(At(chain));
      this->ChainsAt[this->Paths.back().back()].push_back(At(chain));
    }
  }

  void Run()
  {
    std::vector<std::pair<double, std::size_t>> chains;
    for (std::size_t chain = 0; chain < this->Paths.size(); ++chain)
    {
      if (this->IsShort(chain, 1.0))
      {
        chains.push_back({ this->Ground.LengthOf(this->Paths[chain]), chain });
      }
    }
    std::sort(chains.begin(), chains.end());
    for (const std::pair<double, std::size_t>& entry : chains)
    {
      const std::vector<Id>& path = this->Paths[entry.second];
      if (path.front() != path.back() && this->IsShort(entry.second, 1.0))
      {
        this->Contract(entry.second);
      }
      // A loop around a face that is no larger than that.
      if (!path.empty() && path.front() == path.back() && this->Ground.IsCorner(path.front()) &&
        this->IsShort(entry.second, 3.0))
      {
        if (this->Ground.Chains.Kinds[entry.second] != SurfaceEdgeKind::Feature)
        {
          this->Ground.Vanished.push_back(path.front());
        }
        this->Paths[entry.second].clear();
      }
    }
    this->TakeBack();
  }

private:
  bool IsShort(std::size_t chain, double times) const
  {
    const std::vector<Id>& path = this->Paths[chain];
    return this->Ground.LengthOf(path) < times * MergedShare * this->Ground.Given[At(path.front())];
  }

  /// The end with more chains stays; those at the other one go on along the chain.
  void Contract(std::size_t chain)
  {
    std::vector<Id> way = std::move(this->Paths[chain]);
    this->Paths[chain].clear();
    if (this->ChainsAt[way.front()].size() > this->ChainsAt[way.back()].size())
    {
      std::reverse(way.begin(), way.end());
    }
    const Id gone = way.front();
    this->Ground.Places[At(gone)] = FeaturePlace::Line;
    std::vector<std::size_t>& kept = this->ChainsAt[way.back()];
    for (const std::size_t other : this->ChainsAt[gone])
    {
      std::vector<Id>& path = this->Paths[other];
      if (!path.empty() && path.back() == gone)
      {
        path.insert(path.end(), way.begin() + 1, way.end());
        kept.push_back(other);
      }
      if (!path.empty() && path.front() == gone)
      {
        path.insert(path.begin(), way.rbegin(), way.rend() - 1);
        kept.push_back(other);
      }
    }
  }

  void TakeBack()
  {
    FeatureChains chains;
    for (std::size_t chain = 0; chain < this->Paths.size(); ++chain)
    {
      const std::vector<Id>& path = this->Paths[chain];
      if (!path.empty())
      {
        chains.Vertices.insert(chains.Vertices.end(), path.begin(), path.end());
        chains.Offsets.push_back(static_cast<Id>(chains.Vertices.size()));
        chains.Kinds.push_back(this->Ground.Chains.Kinds[chain]);
      }
    }
    this->Ground.Chains = std::move(chains);
  }

  static constexpr double MergedShare = 0.1;

  SurfaceGround& Ground;
  std::vector<std::vector<Id>> Paths; ///< of chains; those that are gone are empty
  std::map<Id, std::vector<std::size_t>> ChainsAt;
};

std::vector<Id> NoisyChains(const SurfaceGround& ground)
{
  const FeatureChains& chains = ground.Chains;
  std::vector<Id> degrees(ground.Mesh.Points.size(), 0);
  for (Id chain = 0; chain < chains.Size(); ++chain)
  {
    ++degrees[At(chains.At(chains.Begin(chain)))];
    ++degrees[At(chains.At(chains.End(chain) - 1))];
  }
  std::vector<Id> noisy;
  for (Id chain = 0; chain < chains.Size(); ++chain)
  {
    const auto first = At(chains.At(chains.Begin(chain)));
    const auto last = At(chains.At(chains.End(chain) - 1));
    const bool isOpen = first != last && (degrees[first] == 1 || degrees[last] == 1);
    if (isOpen && chains.Kinds[At(chain)] == SurfaceEdgeKind::Feature &&
      ground.LengthOf(chain) < 0.5 * (ground.Sizes[first] + ground.Sizes[last]))
    {
      noisy.push_back(chain);
    }
  }
  return noisy;
}

/// Of the edges of chains; finds the others anew.
void ClearFlags(SurfaceGround& ground, const std::vector<Id>& chains)
{
  std::vector<std::pair<Id, Id>> edges;
  for (const Id chain : chains)
  {
    for (Id k = ground.Chains.Begin(chain) + 1; k < ground.Chains.End(chain); ++k)
    {
      edges.push_back(std::minmax({ ground.Chains.At(k - 1), ground.Chains.At(k) }));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t slot = 0; slot < ground.Flags.size(); ++slot)
  {
    const std::pair<Id, Id> pair =
      std::minmax(ground.Mesh.Corners[NextSlotOf(slot)], ground.Mesh.Corners[PreviousSlotOf(slot)]);
    if (ground.Flags[slot] != 0 && std::binary_search(edges.begin(), edges.end(), pair))
    {
      ground.Flags[slot] = 0;
    }
  }
  FindChains(ground);
}

} // namespace

void FlagFeatures(SurfaceGround& ground, const std::vector<Id>& regions, double angle, Pulse& pulse)
{
  const double turned = std::cos(angle / DegreesPerRadian);
  const SurfaceLinks links = LinkSurface(ground.Mesh, pulse);
  const auto regionOf = [&regions](std::size_t slot)
  { return regions.empty() ? 0 : regions[slot / 3]; };
  ground.Pinches = PinchedVertices(ground.Mesh, links, pulse);
  ground.Flags.assign(ground.Mesh.Corners.size(), 0);
  for (std::size_t slot = 0; slot < ground.Flags.size(); ++slot)
  {
    const Id across = links.Across[slot];
    if (across == OpenEdge || across == CrowdedEdge)
    {
      ground.Flags[slot] =
        FlagOf(across == OpenEdge ? SurfaceEdgeKind::Border : SurfaceEdgeKind::NonManifold);
      continue;
    }
    const auto other = At(across);
    if (regionOf(slot) != regionOf(other) ||
      Dot(ground.NormalOf(slot / 3), ground.NormalOf(other / 3)) < turned)
    {
      ground.Flags[slot] = FlagOf(SurfaceEdgeKind::Feature);
    }
  }
}

void FindChains(SurfaceGround& ground)
{
  ChainWalk(ground).Run();
}

void MergeCorners(SurfaceGround& ground)
{
  CornerMerger(ground).Run();
}

void DropNoise(SurfaceGround& ground)
{
  constexpr int MostRounds = 5;
  std::vector<Id> chains = NoisyChains(ground);
  for (int round = 0; round < MostRounds && !chains.empty(); ++round)
  {
    ClearFlags(ground, chains);
    chains = NoisyChains(ground);
  }
}

void DropChains(SurfaceGround& ground, const std::vector<Id>& chains, Pulse& pulse)
{
  ClearFlags(ground, chains);
  LinkGround(ground, pulse);
}

} // namespace biting
