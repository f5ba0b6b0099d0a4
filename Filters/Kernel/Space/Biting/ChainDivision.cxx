// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainDivision.h"

#include "../../Base/Numbers.h"

#include <algorithm> // for min, sort
#include <cmath>     // for round
#include <utility>   // for pairs

namespace biting
{

namespace
{

class ChainDivider
{
public:
  ChainDivider(const SurfaceGround& ground, SurfaceBites& bites)
    : Ground(ground)
    , Bites(bites)
    , BiteAt(ground.Mesh.Points.size(), NoId)
  {
  }

  void Run()
  {
    this->AddCorners();
    const Id chains = this->Ground.Chains.Size();
    std::vector<Id> pieces(static_cast<std::size_t>(chains));
    std::vector<std::pair<std::pair<Id, Id>, Id>> single;
    for (Id chain = 0; chain < chains; ++chain)
    {
      const double count = std::round(this->Integral(chain));
      const Id first = this->Ground.Chains.At(this->Ground.Chains.Begin(chain));
      const Id last = this->Ground.Chains.At(this->Ground.Chains.End(chain) - 1);
      pieces[Index(chain)] = std::max(static_cast<Id>(count), first == last ? 3 : 1);
      if (pieces[Index(chain)] == 1)
      {
        single.push_back({ { std::min(first, last), std::max(first, last) }, chain });
      }
    }
    std::sort(single.begin(), single.end());
    for (std::size_t k = 1; k < single.size(); ++k)
    {
      if (single[k].first == single[k - 1].first)
      {
        pieces[Index(single[k].second)] = 2;
      }
    }
    for (Id chain = 0; chain < chains; ++chain)
    {
      this->Divide(chain, pieces[Index(chain)]);
    }
    this->SetSizes();
  }

private:
  static std::size_t Index(Id id) { return static_cast<std::size_t>(id); }

  void AddCorners()
  {
    for (std::size_t v = 0; v < this->Ground.Places.size(); ++v)
    {
      if (this->Ground.Places[v] == FeaturePlace::Corner)
      {
        const auto vertex = static_cast<Id>(v);
        this->BiteAt[v] = this->Add(this->Ground.Mesh.Points[v], vertex, vertex);
      }
    }
    this->Bites.NumberOfCorners = this->Bites.Size();
  }

  /// `near`: a vertex of the ground whose triangles have the centre.
  Id Add(const Point3& center, Id near, Id groundVertex)
  {
    this->Bites.Centers.push_back(center);
    this->Bites.Sizes.push_back(Infinity);
    this->Bites.Triangles.push_back(*this->Ground.TrianglesAt.Begin(near));
    this->Bites.GroundVertices.push_back(groundVertex);
    return this->Bites.Size() - 1;
  }

  double SizeAt(Id place) const { return this->Ground.Sizes[Index(this->Ground.Chains.At(place))]; }
  const Point3& PointAt(Id place) const
  {
    return this->Ground.Mesh.Points[Index(this->Ground.Chains.At(place))];
  }

  /// Of 1/f from the place before to the place: f is linear between, and the logarithmic mean of
  /// the ends is near their mean.
  double Step(Id place) const
  {
    return 2.0 * Distance(this->PointAt(place - 1), this->PointAt(place)) /
      (this->SizeAt(place - 1) + this->SizeAt(place));
  }

  double Integral(Id chain) const
  {
    double sum = 0.0;
    for (Id k = this->Ground.Chains.Begin(chain) + 1; k < this->Ground.Chains.End(chain); ++k)
    {
      sum += this->Step(k);
    }
    return sum;
  }

  void Divide(Id chain, Id pieces)
  {
    const FeatureChains& chains = this->Ground.Chains;
    const Id begin = chains.Begin(chain);
    const Id end = chains.End(chain);
    const double step = this->Integral(chain) / pieces;
    Id& first = this->BiteAt[Index(chains.At(begin))];
    if (first == NoId)
    {
      first = this->Add(this->PointAt(begin), chains.At(begin), NoId);
    }
    Id last = first;
    double sum = 0.0;
    Id made = 1;
    for (Id k = begin + 1; k < end; ++k)
    {
      const double here = this->Step(k);
      while (made < pieces && sum + here >= made * step)
      {
        const double part = std::min(1.0, (made * step - sum) / here);
        const Point3 place =
          this->PointAt(k - 1) + part * (this->PointAt(k) - this->PointAt(k - 1));
        const Id bite = this->Add(place, chains.At(k), NoId);
        this->Bites.Triangles.back() = this->TriangleOf(chains.At(k - 1), chains.At(k));
        this->AddPiece(last, bite, chain);
        last = bite;
        ++made;
      }
      sum += here;
    }
    this->AddPiece(last, this->BiteAt[Index(chains.At(end - 1))], chain);
  }

  Id TriangleOf(Id a, Id b) const
  {
    for (const Id* t = this->Ground.TrianglesAt.Begin(a); t < this->Ground.TrianglesAt.End(a); ++t)
    {
      const Id* corners = &this->Ground.Mesh.Corners[3 * Index(*t)];
      if (std::find(corners, corners + 3, b) != corners + 3)
      {
        return *t;
      }
    }
    return NoId;
  }

  void AddPiece(Id from, Id to, Id chain)
  {
    this->Bites.PieceEnds.push_back(from);
    this->Bites.PieceEnds.push_back(to);
    this->Bites.PieceChains.push_back(chain);
    const double length =
      Distance(this->Bites.Centers[Index(from)], this->Bites.Centers[Index(to)]);
    for (const Id bite : { from, to })
    {
      double& size = this->Bites.Sizes[Index(bite)];
      size = std::min(size, length);
    }
  }

  void SetSizes()
  {
    this->Bites.NumberOnLines = this->Bites.Size();
    constexpr double Beyond = 1e-7; // guards are just larger than balls, radii than guards
    for (const double size : this->Bites.Sizes)
    {
      this->Bites.Guards.push_back((1.0 + Beyond) * SurfaceBites::WeightShare * size);
      this->Bites.Radii.push_back((1.0 + 2.0 * Beyond) * SurfaceBites::WeightShare * size);
    }
  }

  const SurfaceGround& Ground;
  SurfaceBites& Bites;
  std::vector<Id> BiteAt;
};

} // namespace

void DivideChains(const SurfaceGround& ground, SurfaceBites& bites)
{
  ChainDivider(ground, bites).Run();
}

} // namespace biting
