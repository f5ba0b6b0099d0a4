// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainDivision.h"

#include "../../Base/BoxTree.h"
#include "../../Base/Numbers.h"

#include <algorithm> // for min, sort, lower_bound
#include <cmath>     // for round
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// A place of a chain where it is divided, or a corner.
struct ChainMark
{
  Id Chain;   ///< of a corner NoId
  double Way; ///< integral of 1/f along the chain, from its begin
  Point3 Place;
};

/// A mark as an item of a tree, where it was when the tree was built.
struct MarkItem
{
  Box3 Bounds;
  std::size_t Mark;

  const Box3& Box() const { return this->Bounds; }
  double Least() const { return 0.0; }
};

/// The chains by ways: integrals of 1/f along them.
class ChainWays
{
public:
  explicit ChainWays(const SurfaceGround& ground)
    : Ground(ground)
    , Ways(ground.Chains.Vertices.size(), 0.0)
  {
    for (Id chain = 0; chain < ground.Chains.Size(); ++chain)
    {
      for (Id k = ground.Chains.Begin(chain) + 1; k < ground.Chains.End(chain); ++k)
      {
        // f is linear between, and the logarithmic mean of the ends is near their mean.
        this->Ways[At(k)] = this->Ways[At(k - 1)] +
          2.0 * Distance(this->PointAt(k - 1), this->PointAt(k)) /
            (this->SizeAt(k - 1) + this->SizeAt(k));
      }
    }
  }

  double LengthOf(Id chain) const { return this->Ways[At(this->Ground.Chains.End(chain) - 1)]; }

  /// Closed, and no vertex of it is a corner.
  bool IsRing(Id chain) const
  {
    const Id first = this->Ground.Chains.At(this->Ground.Chains.Begin(chain));
    return first == this->Ground.Chains.At(this->Ground.Chains.End(chain) - 1) &&
      this->Ground.Places[At(first)] != FeaturePlace::Corner;
  }

  /// The end of the first edge of the chain that reaches the way.
  Id EdgeAt(Id chain, double way) const
  {
    const auto begin = this->Ways.begin() + this->Ground.Chains.Begin(chain) + 1;
    const auto end = this->Ways.begin() + this->Ground.Chains.End(chain) - 1;
    return static_cast<Id>(std::lower_bound(begin, end, way) - this->Ways.begin());
  }

  Point3 PlaceAt(Id chain, double way) const
  {
    const Id k = this->EdgeAt(chain, way);
    const double before = this->Ways[At(k - 1)];
    const double part = std::min(1.0, (way - before) / (this->Ways[At(k)] - before));
    return this->PointAt(k - 1) + part * (this->PointAt(k) - this->PointAt(k - 1));
  }

  /// f there.
  double SizeOn(Id chain, double way) const { return this->SizeAt(this->EdgeAt(chain, way)); }

  /// The way of the place of the chain, of those from `from` to `to`, that is nearest to a point;
  /// and its distance.
  std::pair<double, double> Nearest(Id chain, double from, double to, const Point3& point) const
  {
    std::pair<double, double> best{ from, Infinity };
    const Id last = this->EdgeAt(chain, to);
    for (Id k = this->EdgeAt(chain, from); k <= last; ++k)
    {
      const Point3& tail = this->PointAt(k - 1);
      const Point3 side = this->PointAt(k) - tail;
      const double part =
        std::min(1.0, std::max(0.0, Dot(point - tail, side) / std::max(Dot(side, side), 1e-300)));
      const double distance = Distance(point, tail + part * side);
      if (distance < best.second)
      {
        best = { this->Ways[At(k - 1)] + part * (this->Ways[At(k)] - this->Ways[At(k - 1)]),
          distance };
      }
    }
    return best;
  }

private:
  double SizeAt(Id place) const { return this->Ground.Sizes[At(this->Ground.Chains.At(place))]; }
  const Point3& PointAt(Id place) const
  {
    return this->Ground.Mesh.Points[At(this->Ground.Chains.At(place))];
  }

  const SurfaceGround& Ground;
  std::vector<double> Ways; ///< of places of chains
};

/// Moves the marks of chains that run along others nearer than f to the middles between the marks
/// there: triangles of the strip between are as good as isosceles ones then.
class MarkStagger
{
public:
  MarkStagger(const SurfaceGround& ground, const ChainWays& ways,
    std::vector<std::vector<double>>& marks, Pulse& pulse)
    : Ground(ground)
    , Ways(ways)
    , Given(marks)
    , Beats(pulse)
  {
  }

  void Run()
  {
    constexpr int Rounds = 6;
    this->ListMarks();
    for (int phase = 0; phase < 2; ++phase)
    {
      for (int round = 0; round < Rounds; ++round)
      {
        for (std::size_t mark = 0; mark < this->Marks.size() && this->Beats.Beat(64); ++mark)
        {
          this->Stagger(mark);
        }
      }
      if (phase == 0)
      {
        this->FillGaps();
        this->ListMarks();
      }
    }
    this->TakeBack();
  }

private:
  void ListMarks()
  {
    this->Marks.clear();
    this->Firsts.assign(1, 0);
    for (std::size_t chain = 0; chain < this->Given.size(); ++chain)
    {
      for (const double way : this->Given[chain])
      {
        const auto id = static_cast<Id>(chain);
        this->Marks.push_back({ id, way, this->Ways.PlaceAt(id, way) });
      }
      this->Firsts.push_back(this->Marks.size());
    }
    for (std::size_t v = 0; v < this->Ground.Places.size(); ++v)
    {
      if (this->Ground.Places[v] == FeaturePlace::Corner)
      {
        this->Marks.push_back({ NoId, 0.0, this->Ground.Mesh.Points[v] });
      }
    }
    std::vector<MarkItem> items;
    items.reserve(this->Marks.size());
    for (std::size_t mark = 0; mark < this->Marks.size(); ++mark)
    {
      const Point3& place = this->Marks[mark].Place;
      items.push_back({ Box3::Around(place, place), mark });
    }
    this->Tree = BoxTree<MarkItem, 3>(items, this->Beats);
  }

  /// Moves a mark of a chain to max over its ways w of min(w - before, after - w, 2 |w - s|), s the
  /// ways of strangers: there triangles of the strip are nearest to isosceles ones.
  void Stagger(std::size_t mark)
  {
    ChainMark& own = this->Marks[mark];
    if (own.Chain == NoId)
    {
      return;
    }
    const std::size_t first = this->Firsts[At(own.Chain)];
    const std::size_t end = this->Firsts[At(own.Chain) + 1];
    const double before = mark > first ? this->Marks[mark - 1].Way : 0.0;
    const double after =
      mark + 1 < end ? this->Marks[mark + 1].Way : this->Ways.LengthOf(own.Chain);
    if (mark == first && this->Ways.IsRing(own.Chain))
    {
      return; // where the ways of a ring begin
    }
    std::vector<double> strangers;
    if (!this->FindStrangers(own, before, after, strangers))
    {
      return;
    }
    const auto value = [before, after, &strangers](double way)
    {
      double least = std::min(way - before, after - way);
      for (const double other : strangers)
      {
        least = std::min(least, 2.0 * std::abs(way - other));
      }
      return least;
    };
    constexpr double Better = 1e-3;
    std::sort(strangers.begin(), strangers.end());
    double best = value(own.Way) + Better;
    double way = own.Way;
    const auto tryAt = [&value, &best, &way](double place)
    {
      const double here = value(place);
      way = here > best ? place : way;
      best = here > best ? here + 1e-6 : best;
    };
    tryAt(0.5 * (before + after));
    for (std::size_t k = 0; k <= strangers.size(); ++k)
    {
      // Where the distances from the nearest on both sides are equal.
      const double left = k == 0 ? before : strangers[k - 1];
      const double right = k == strangers.size() ? after : strangers[k];
      tryAt(0.5 * (left + right));
      tryAt((before + 2.0 * right) / 3.0);
      tryAt((2.0 * left + after) / 3.0);
    }
    own.Way = way;
    own.Place = this->Ways.PlaceAt(own.Chain, way);
  }

  /// The ways of the places of the chain that are nearest to marks of others, nearer than
  /// MostWidth f. Whether there are any, and none nearer than LeastWidth f: the ball of a mark that
  /// is as near to the middle of a piece takes it.
  bool FindStrangers(const ChainMark& own, double before, double after, std::vector<double>& ways)
  {
    constexpr double MostWidth = 0.8;
    constexpr double LeastWidth = 0.3;
    // Of chains that meet in a corner. Equal ways from it keep balls on borders out of each other.
    const double mostSlope = this->Ground.Sides.empty() ? 0.0 : 0.6;
    const double size = this->Ways.SizeOn(own.Chain, own.Way);
    const double length = this->Ways.LengthOf(own.Chain);
    const double reach = (after - before + 2.0) * size;
    bool isTooNear = false;
    this->Tree.Search(own.Place, 1.0, reach,
      [this, &own, &ways, &isTooNear, before, after, size, length, mostSlope](
        const MarkItem& item, double limit)
      {
        const ChainMark& other = this->Marks[item.Mark];
        if (other.Chain != own.Chain)
        {
          const std::pair<double, double> foot =
            this->Ways.Nearest(own.Chain, before, after, other.Place);
          const double width = foot.second / size;
          if (foot.first > before && foot.first < after && width < MostWidth &&
            (this->Ways.IsRing(own.Chain) ||
              width < mostSlope * std::min(foot.first, length - foot.first)))
          {
            ways.push_back(foot.first);
            isTooNear = isTooNear || width < LeastWidth;
          }
        }
        return limit;
      });
    return !isTooNear && !ways.empty();
  }

  void TakeBack()
  {
    for (std::size_t chain = 0; chain < this->Given.size(); ++chain)
    {
      for (std::size_t k = 0; k < this->Given[chain].size(); ++k)
      {
        this->Given[chain][k] = this->Marks[this->Firsts[chain] + k].Way;
      }
    }
  }

  /// Divides pieces that have become long.
  void FillGaps()
  {
    constexpr double LongPiece = 1.35;
    this->TakeBack();
    for (std::size_t chain = 0; chain < this->Given.size(); ++chain)
    {
      std::vector<double>& marks = this->Given[chain];
      const double length = this->Ways.LengthOf(static_cast<Id>(chain));
      const double step = length / static_cast<double>(marks.size() + 1);
      std::vector<double> filled;
      double before = 0.0;
      for (std::size_t k = 0; k <= marks.size(); ++k)
      {
        const double after = k < marks.size() ? marks[k] : length;
        if (after - before > LongPiece && after - before > 1.2 * step)
        {
          filled.push_back(0.5 * (before + after));
        }
        if (k < marks.size())
        {
          filled.push_back(after);
        }
        before = after;
      }
      marks = std::move(filled);
    }
  }

  const SurfaceGround& Ground;
  const ChainWays& Ways;
  std::vector<std::vector<double>>& Given; ///< of chains, in order
  Pulse& Beats;
  std::vector<ChainMark> Marks; ///< of chains, then corners
  std::vector<std::size_t> Firsts;
  BoxTree<MarkItem, 3> Tree;
};

class ChainDivider
{
public:
  ChainDivider(const SurfaceGround& ground, SurfaceBites& bites, Pulse& pulse)
    : Ground(ground)
    , Bites(bites)
    , Beats(pulse)
    , Ways(ground)
    , BiteAt(ground.Mesh.Points.size(), NoId)
  {
  }

  void Run()
  {
    this->AddCorners();
    const std::vector<Id> pieces = this->CountPieces();
    std::vector<std::vector<double>> marks(pieces.size());
    for (std::size_t chain = 0; chain < pieces.size(); ++chain)
    {
      const double step = this->Ways.LengthOf(static_cast<Id>(chain)) / pieces[chain];
      for (Id k = this->Ways.IsRing(static_cast<Id>(chain)) ? 0 : 1; k < pieces[chain]; ++k)
      {
        marks[chain].push_back(k * step);
      }
    }
    MarkStagger(this->Ground, this->Ways, marks, this->Beats).Run();
    for (std::size_t chain = 0; chain < pieces.size(); ++chain)
    {
      this->Divide(static_cast<Id>(chain), marks[chain]);
    }
    this->SetSizes();
  }

private:
  void AddCorners()
  {
    for (std::size_t v = 0; v < this->Ground.Places.size(); ++v)
    {
      if (this->Ground.Places[v] == FeaturePlace::Corner)
      {
        const auto vertex = static_cast<Id>(v);
        this->BiteAt[v] =
          this->Add(this->Ground.Mesh.Points[v], this->Ground.TrianglesAt[vertex][0], vertex);
      }
    }
    this->Bites.NumberOfCorners = this->Bites.Size();
  }

  Id Add(const Point3& center, Id triangle, Id groundVertex)
  {
    this->Bites.Centers.push_back(center);
    this->Bites.Sizes.push_back(Infinity);
    this->Bites.Triangles.push_back(triangle);
    this->Bites.GroundVertices.push_back(groundVertex);
    return this->Bites.Size() - 1;
  }

  std::vector<Id> CountPieces() const
  {
    const FeatureChains& chains = this->Ground.Chains;
    std::vector<Id> pieces(At(chains.Size()));
    std::vector<std::pair<std::pair<Id, Id>, Id>> single;
    for (Id chain = 0; chain < chains.Size(); ++chain)
    {
      const double count = std::round(this->Ways.LengthOf(chain));
      const Id first = chains.At(chains.Begin(chain));
      const Id last = chains.At(chains.End(chain) - 1);
      pieces[At(chain)] = std::max(static_cast<Id>(count), first == last ? 3 : 1);
      if (pieces[At(chain)] == 1)
      {
        single.push_back({ { std::min(first, last), std::max(first, last) }, chain });
      }
    }
    std::sort(single.begin(), single.end());
    for (std::size_t k = 1; k < single.size(); ++k)
    {
      if (single[k].first == single[k - 1].first)
      {
        pieces[At(single[k].second)] = 2;
      }
    }
    return pieces;
  }

  void Divide(Id chain, const std::vector<double>& marks)
  {
    const FeatureChains& chains = this->Ground.Chains;
    const bool isRing = this->Ways.IsRing(chain);
    Id last = isRing ? NoId : this->BiteAt[At(chains.At(chains.Begin(chain)))];
    Id first = last;
    for (const double way : marks)
    {
      const Id k = this->Ways.EdgeAt(chain, way);
      const Id bite = this->Add(
        this->Ways.PlaceAt(chain, way), this->TriangleOf(chains.At(k - 1), chains.At(k)), NoId);
      if (last == NoId)
      {
        first = bite;
      }
      else
      {
        this->AddPiece(last, bite, chain);
      }
      last = bite;
    }
    this->AddPiece(
      last, isRing ? first : this->BiteAt[At(chains.At(chains.End(chain) - 1))], chain);
  }

  Id TriangleOf(Id a, Id b) const
  {
    for (const Id t : this->Ground.TrianglesAt[a])
    {
      const Id* corners = &this->Ground.Mesh.Corners[3 * At(t)];
      if (std::find(corners, corners + 3, b) != corners + 3)
      {
        return t;
      }
    }
    return NoId;
  }

  void AddPiece(Id from, Id to, Id chain)
  {
    this->Bites.PieceEnds.push_back(from);
    this->Bites.PieceEnds.push_back(to);
    this->Bites.PieceChains.push_back(chain);
    const double length = Distance(this->Bites.Centers[At(from)], this->Bites.Centers[At(to)]);
    for (const Id bite : { from, to })
    {
      double& size = this->Bites.Sizes[At(bite)];
      size = std::min(size, length);
    }
  }

  void SetSizes()
  {
    this->Bites.NumberOnLines = this->Bites.Size();
    constexpr double Beyond = 1e-7; // guards are just larger than balls, radii than guards
    for (std::size_t k = 0; k < this->Bites.Sizes.size(); ++k)
    {
      double& size = this->Bites.Sizes[k];
      if (size == Infinity) // a corner whose chains were merged into others
      {
        size = this->Ground.SizeAt(this->Bites.Triangles[k], this->Bites.Centers[k]);
      }
      this->Bites.Guards.push_back((1.0 + Beyond) * SurfaceBites::WeightShare * size);
      this->Bites.Radii.push_back((1.0 + 2.0 * Beyond) * SurfaceBites::WeightShare * size);
    }
  }

  const SurfaceGround& Ground;
  SurfaceBites& Bites;
  Pulse& Beats;
  ChainWays Ways;
  std::vector<Id> BiteAt; ///< corners
};

} // namespace

void DivideChains(const SurfaceGround& ground, SurfaceBites& bites, Pulse& pulse)
{
  ChainDivider(ground, bites, pulse).Run();
}

} // namespace biting
