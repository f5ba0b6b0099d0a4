// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedVertices.h"

#include "../Quality/Quality.h"

#include <array>   // for corners
#include <utility> // for move

namespace biting
{

namespace
{

// New numbers of the vertices: those of the domain that stay, the released ones, the others.
std::vector<Id> NumberVertices(
  const std::vector<std::uint8_t>& isReleased, std::size_t numberOfVertices)
{
  std::vector<Id> numbers(numberOfVertices);
  Id next = 0;
  for (const bool releases : { false, true })
  {
    for (std::size_t vertex = 0; vertex < isReleased.size(); ++vertex)
    {
      if ((isReleased[vertex] != 0) == releases)
      {
        numbers[vertex] = next++;
      }
    }
  }
  for (std::size_t vertex = isReleased.size(); vertex < numberOfVertices; ++vertex)
  {
    numbers[vertex] = next++;
  }
  return numbers;
}

template <typename Value>
void Permute(const std::vector<Id>& numbers, std::vector<Value>& values)
{
  std::vector<Value> permuted(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    permuted[numbers[k]] = values[k];
  }
  values = std::move(permuted);
}

void Renumber(const std::vector<Id>& numbers, std::vector<Id>& ids)
{
  for (Id& id : ids)
  {
    id = numbers[id];
  }
}

/// Finds what is poor, and which vertices may go for it.
class Judge
{
public:
  Judge(const OldMesh& old, const Domain& domain, const BitingResult& bites, const KeepRules& rules)
    : Bites(bites)
    , Rules(rules)
    , MayGo(FindVerticesThatMayGo(old, domain))
    , Complaints(domain.Vertices.size(), 0)
  {
  }

  /// At a poor triangle it may be any corner, at a poor edge either end.
  void LookAt(const Id* corners)
  {
    const auto place = [this, corners](int k) { return this->Bites.Points[corners[k % 3]]; };
    const auto spacing = [this, corners](int k) { return this->Bites.Spacings[corners[k % 3]]; };
    if (MinimumAngle(place(0), place(1), place(2)) < this->Rules.LeastAngle)
    {
      this->Add({ corners[0], corners[1], corners[2] });
    }
    for (int k = 0; k < 3; ++k)
    {
      const double length = 2.0 * Distance(place(k), place(k + 1)) / (spacing(k) + spacing(k + 1));
      if (length < this->Rules.ShortestEdge || length > this->Rules.LongestEdge)
      {
        this->Add({ corners[k], corners[(k + 1) % 3], NoId });
      }
    }
  }

  /// For each that is poor, one vertex: that at which most is.
  std::vector<std::uint8_t> Choose() const
  {
    std::vector<std::uint8_t> isChosen(this->MayGo.size(), 0);
    for (const std::array<Id, 3>& poor : this->Poor)
    {
      Id chosen = NoId;
      for (const Id vertex : poor)
      {
        const bool isMore =
          vertex != NoId && (chosen == NoId || this->Complaints[vertex] > this->Complaints[chosen]);
        chosen = isMore ? vertex : chosen;
      }
      if (chosen != NoId)
      {
        isChosen[chosen] = 1;
      }
    }
    return isChosen;
  }

private:
  void Add(std::array<Id, 3> vertices)
  {
    bool hasSome = false;
    for (Id& vertex : vertices)
    {
      const bool mayGo = vertex != NoId && static_cast<std::size_t>(vertex) < this->MayGo.size() &&
        this->MayGo[vertex] != 0;
      vertex = mayGo ? vertex : NoId;
      hasSome = hasSome || mayGo;
      if (mayGo)
      {
        ++this->Complaints[vertex];
      }
    }
    if (hasSome)
    {
      this->Poor.push_back(vertices);
    }
  }

  const BitingResult& Bites;
  const KeepRules& Rules;
  std::vector<std::uint8_t> MayGo;
  std::vector<Id> Complaints;
  std::vector<std::array<Id, 3>> Poor;
};

} // namespace

std::vector<std::uint8_t> FindVerticesThatMayGo(const OldMesh& old, const Domain& domain)
{
  std::vector<std::uint8_t> mayGo = domain.IsEmbedded;
  for (std::size_t vertex = 0; vertex < mayGo.size(); ++vertex)
  {
    mayGo[vertex] &= old.IsFixed[domain.VertexPoints[vertex]] == 0;
  }
  return mayGo;
}

std::vector<std::uint8_t> FindVerticesInTheWay(const OldMesh& old, const Domain& domain,
  const BitingResult& bites, const Triangulation& mesh, const KeepRules& rules)
{
  Judge judge(old, domain, bites, rules);
  for (std::size_t corner = 0; corner < mesh.Corners.size(); corner += 3)
  {
    judge.LookAt(mesh.Corners.data() + corner);
  }
  return judge.Choose();
}

void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh)
{
  const std::vector<Id> numbers = NumberVertices(isReleased, bites.Points.size());
  Permute(numbers, bites.Points);
  Permute(numbers, bites.Spacings);
  Permute(numbers, bites.BiteOrders);
  Permute(numbers, bites.Segments);
  Renumber(numbers, bites.EdgeStarts);
  Renumber(numbers, bites.EdgeEnds);
  Renumber(numbers, mesh.Corners);
  Renumber(numbers, domain.Starts);
  Renumber(numbers, domain.Ends);
  Permute(numbers, domain.Vertices);
  Permute(numbers, domain.VertexPoints);
  Permute(numbers, domain.IsEmbedded);
  std::size_t left = 0;
  for (const std::uint8_t is : isReleased)
  {
    left += is == 0;
  }
  domain.Vertices.resize(left);
  domain.VertexPoints.resize(left);
  domain.IsEmbedded.resize(left);
}

} // namespace biting
