// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodySides.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/Numbers.h"
#include "../../Predicates/Predicates3.h"
#include "../Surface/SurfaceCrossings.h"
#include "../Surface/SurfaceLinks.h"
#include "../Surface/TriangleContact.h"
#include "InsideTest.h"

#include <algorithm> // for max, sort, find
#include <array>     // for candidates
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <utility>   // for swap

namespace biting
{

namespace
{

class BodyFinder
{
public:
  BodyFinder(SurfaceMesh& mesh, Pulse& pulse)
    : Mesh(mesh)
    , Values(mesh.Regions)
    , Beats(pulse)
    , Triangles(mesh.NumberOfTriangles())
    , Parts(2 * this->Triangles + 1)
    , Shells(this->Triangles)
    , IsOdd(this->Triangles, 0)
    , HasWalls(this->Triangles, 0)
    , IsMixed(this->Triangles, 0)
  {
  }

  BodySides Run()
  {
    const SurfaceLinks links = LinkSurface(this->Mesh, this->Beats);
    this->JoinAtEdges(links);
    this->JoinAtCrowdedEdges(links);
    this->JoinShells();
    for (std::size_t t = 0; t < this->Triangles; ++t)
    {
      if (this->PartAt(t, 0) == this->PartAt(t, 1))
      {
        this->Result.OpenTriangle = static_cast<Id>(t);
        return std::move(this->Result);
      }
    }
    this->DropBackground();
    this->FindValuesOfShells();
    this->DecideParts();
    this->NameWalledBodies();
    this->NumberLabels();
    return std::move(this->Result);
  }

private:
  enum class Kind : std::uint8_t
  {
    Unknown,
    Empty,
    Body
  };

  /// An item of Parts: side 0 is behind the triangle, side 1 in front.
  static Id SideOf(std::size_t triangle, std::size_t side)
  {
    return static_cast<Id>(2 * triangle + side);
  }
  Id Outside() const { return static_cast<Id>(2 * this->Triangles); }
  std::size_t PartAt(std::size_t triangle, std::size_t side)
  {
    return At(this->Parts.SetOf(SideOf(triangle, side)));
  }
  std::size_t ShellOf(std::size_t triangle)
  {
    return At(this->Shells.SetOf(static_cast<Id>(triangle)));
  }

  void JoinAtEdges(const SurfaceLinks& links)
  {
    for (std::size_t slot = 0; slot < this->Mesh.Corners.size() && this->Beats.Beat(1); ++slot)
    {
      const std::size_t t = slot / 3;
      if (links.Across[slot] == OpenEdge)
      {
        this->Parts.Unite(SideOf(t, 0), SideOf(t, 1));
        this->LargestCosine = Infinity; // nothing is folded: it is open
      }
      else if (links.Across[slot] > static_cast<Id>(slot))
      {
        const std::size_t other = At(links.Across[slot]) / 3;
        const std::size_t turn = AreAlike(this->Mesh, links, slot) ? 0 : 1;
        this->Parts.Unite(SideOf(t, 0), SideOf(other, turn));
        this->Parts.Unite(SideOf(t, 1), SideOf(other, 1 - turn));
        this->Shells.Unite(static_cast<Id>(t), static_cast<Id>(other));
      }
    }
  }

  void JoinAtCrowdedEdges(const SurfaceLinks& links)
  {
    std::vector<std::size_t> slots;
    for (std::size_t edge = 0; edge < links.NumberOfCrowded(); ++edge)
    {
      slots.clear();
      for (Id k = links.CrowdedOffsets[edge]; k < links.CrowdedOffsets[edge + 1]; ++k)
      {
        slots.push_back(At(links.CrowdedSlots[At(k)]));
      }
      const Id a = this->Mesh.Corners[NextSlotOf(slots[0])];
      const Id b = this->Mesh.Corners[PreviousSlotOf(slots[0])];
      this->SortAround(a, b, slots);
      for (std::size_t k = 0; k < slots.size(); ++k)
      {
        // Triangles that run through the edge from a to b are turned as the angle grows.
        const std::size_t next = slots[(k + 1) % slots.size()];
        const auto runs = [this, a](std::size_t slot)
        { return this->Mesh.Corners[NextSlotOf(slot)] == a ? 1 : 0; };
        this->Parts.Unite(
          SideOf(slots[k] / 3, At(runs(slots[k]))), SideOf(next / 3, At(1 - runs(next))));
        this->Shells.Unite(static_cast<Id>(slots[k] / 3), static_cast<Id>(next / 3));
        const double cosine = this->CosineAtEdge(a, b, slots[k], next);
        if (cosine > this->LargestCosine)
        {
          this->LargestCosine = cosine;
          this->Result.Folded = { static_cast<Id>(slots[k] / 3), static_cast<Id>(next / 3) };
        }
      }
    }
    for (std::size_t edge = 0; edge < links.NumberOfCrowded(); ++edge)
    {
      const Id first = links.CrowdedOffsets[edge];
      const std::size_t shell = this->ShellOf(At(links.CrowdedSlots[At(first)]) / 3);
      this->IsOdd[shell] |= (links.CrowdedOffsets[edge + 1] - first) % 2;
      this->HasWalls[shell] = 1;
    }
  }

  double CosineAtEdge(Id a, Id b, std::size_t one, std::size_t other) const
  {
    const Point3 axis = this->Mesh.Points[At(b)] - this->Mesh.Points[At(a)];
    const Point3 p = Cross(axis, this->Mesh.At(one) - this->Mesh.Points[At(a)]);
    const Point3 q = Cross(axis, this->Mesh.At(other) - this->Mesh.Points[At(a)]);
    return Dot(p, q) / (Length(p) * Length(q));
  }

  /// By the angle around the edge from a to b, from the first slot on.
  void SortAround(Id a, Id b, std::vector<std::size_t>& slots) const
  {
    const Point3& from = this->Mesh.Points[At(a)];
    const Point3& to = this->Mesh.Points[At(b)];
    const Point3 first = this->Mesh.At(slots[0]);
    const Point3 normal = Cross(to - from, first - from);
    const auto half = [&from, &to, &first, &normal](const Point3& p)
    {
      const int side = Orient3D(from, to, first, p);
      const bool isOpposite = Dot(normal, Cross(to - from, p - from)) < 0.0;
      return side > 0 ? 1 : side < 0 ? 3 : isOpposite ? 2 : 0;
    };
    std::sort(slots.begin() + 1, slots.end(),
      [this, &from, &to, &half](std::size_t one, std::size_t other)
      {
        const int own = half(this->Mesh.At(one));
        const int its = half(this->Mesh.At(other));
        const int turn =
          own == its ? Orient3D(from, to, this->Mesh.At(one), this->Mesh.At(other)) : its - own;
        return turn > 0 || (turn == 0 && one < other);
      });
  }

  /// What is around each shell, by a line along the first axis through its triangle that is seen
  /// largest from there: the part beyond its last triangle is before the next one of another shell.
  void JoinShells()
  {
    const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(this->Mesh, this->Beats);
    std::vector<Id> largest(this->Triangles, NoId); // of shells
    for (std::size_t t = 0; t < this->Triangles; ++t)
    {
      Id& best = largest[this->ShellOf(t)];
      best =
        best == NoId || std::abs(this->Mesh.Normal(At(best)).X) < std::abs(this->Mesh.Normal(t).X)
        ? static_cast<Id>(t)
        : best;
    }
    const double begin = this->Mesh.Bounds().Low.X - this->Mesh.Bounds().Diagonal();
    for (std::size_t shell = 0; shell < this->Triangles && this->Beats.Beat(); ++shell)
    {
      if (largest[shell] != NoId)
      {
        Point3 place = this->Mesh.Middle(At(largest[shell]));
        place.X = begin;
        this->JoinAlong(tree, place, shell);
      }
    }
  }

  void JoinAlong(const BoxTree<SurfaceItem, 3>& tree, const Point3& place, std::size_t shell)
  {
    std::vector<std::pair<double, Id>> met; // where along the line, and the triangle
    tree.AllOf(Box3::Around(place, { Infinity, place.Y, place.Z }),
      [this, &place, &met](const SurfaceItem& item)
      {
        const std::array<Point3, 3> triangle = this->Mesh.Triangle(At(item.Triangle));
        if (MeetRay(triangle, place))
        {
          const Point3 normal = this->Mesh.Normal(At(item.Triangle));
          const Point3 way = triangle[0] - place;
          const double rise = (normal.Y * way.Y + normal.Z * way.Z) / normal.X;
          met.push_back({ place.X + way.X + rise, item.Triangle });
        }
        return true;
      });
    std::sort(met.begin(), met.end());
    std::size_t last = met.size();
    for (std::size_t k = 0; k < met.size(); ++k)
    {
      last = this->ShellOf(At(met[k].second)) == shell ? k : last;
    }
    if (last < met.size())
    {
      const auto side = [this, &met](std::size_t k, bool isBeyond)
      {
        const std::size_t t = At(met[k].second);
        return SideOf(t, (this->Mesh.Normal(t).X > 0.0) == isBeyond ? 1 : 0);
      };
      this->Parts.Unite(
        side(last, true), last + 1 < met.size() ? side(last + 1, false) : this->Outside());
    }
  }

  /// Where all triangles at the outside have two values, the one that is common to them, or the
  /// second one, is no region: that of what is outside.
  void DropBackground()
  {
    const std::size_t outside = At(this->Parts.SetOf(this->Outside()));
    RegionPair common{ NoId, NoId };
    bool isFirst = true;
    for (std::size_t t = 0; t < this->Values.size(); ++t)
    {
      if (this->PartAt(t, 0) == outside || this->PartAt(t, 1) == outside)
      {
        const RegionPair& pair = this->Values[t];
        common = isFirst ? pair : common;
        isFirst = false;
        for (Id& value : common)
        {
          value = pair[1] != NoId && (value == pair[0] || value == pair[1]) ? value : NoId;
        }
      }
    }
    const Id background = common[1] != NoId ? common[1] : common[0];
    for (RegionPair& pair : this->Values)
    {
      pair[0] = pair[0] == background ? pair[1] : pair[0];
      pair[1] = pair[1] == background || pair[1] == pair[0] ? NoId : pair[1];
    }
  }

  /// Values count where each shell has one, but for those that may have walls between bodies.
  void FindValuesOfShells()
  {
    this->ValueOf.assign(this->Triangles, { NoId, NoId });
    std::vector<std::uint8_t> isSet(this->Triangles, 0);
    for (std::size_t t = 0; t < this->Values.size(); ++t)
    {
      const std::size_t shell = this->ShellOf(t);
      const bool hasTwo = this->Values[t][1] != NoId;
      const bool isOther = isSet[shell] != 0 && this->ValueOf[shell] != this->Values[t];
      this->HasWalls[shell] |= hasTwo ? 1 : 0;
      this->IsMixed[shell] |= hasTwo || isOther ? 1 : 0;
      this->ValueOf[shell] = this->Values[t];
      isSet[shell] = 1;
    }
    this->HasValues = !this->Values.empty();
    for (std::size_t shell = 0; shell < this->Triangles; ++shell)
    {
      this->HasValues = this->HasValues && this->IsMixed[shell] <= this->HasWalls[shell];
    }
  }

  /// From outside inwards, across one triangle after the other.
  void DecideParts()
  {
    this->Kinds.assign(2 * this->Triangles + 1, Kind::Unknown);
    this->Names.assign(this->Kinds.size(), 0);
    this->IsFixed.assign(this->Kinds.size(), 0);
    this->Kinds[At(this->Parts.SetOf(this->Outside()))] = Kind::Empty;
    this->IsFixed[At(this->Parts.SetOf(this->Outside()))] = 1;
    bool isChanged = true;
    while (isChanged && this->Beats.Ask())
    {
      isChanged = false;
      for (std::size_t t = 0; t < this->Triangles; ++t)
      {
        const std::size_t behind = this->PartAt(t, 0);
        const std::size_t front = this->PartAt(t, 1);
        const bool isKnown = this->Kinds[behind] != Kind::Unknown;
        if (isKnown != (this->Kinds[front] != Kind::Unknown))
        {
          this->Decide(isKnown ? front : behind, isKnown ? behind : front, this->ShellOf(t));
          isChanged = true;
        }
      }
    }
  }

  void Decide(std::size_t part, std::size_t around, std::size_t shell)
  {
    const bool isMixed = this->HasValues && this->IsMixed[shell] != 0;
    const bool hasOwn = this->HasValues && !isMixed;
    const bool isSame = this->Kinds[around] == Kind::Body &&
      (!hasOwn || this->Names[around] == this->ValueOf[shell][0]);
    const bool isEmpty = isSame && this->IsOdd[shell] == 0 && !isMixed;
    this->Kinds[part] = isEmpty ? Kind::Empty : Kind::Body;
    this->Names[part] = hasOwn ? this->ValueOf[shell][0] : 0;
    this->IsFixed[part] = isEmpty || hasOwn ? 1 : 0;
  }

  /// Whether a body on one of the sides of the triangle has the value. Where none has, and one side
  /// has another value, or is no body, it is the other side.
  bool FindOwner(std::size_t t, Id value, bool& isChanged)
  {
    const std::array<std::size_t, 2> parts{ this->PartAt(t, 0), this->PartAt(t, 1) };
    const auto isFixed = [this, &parts](std::size_t k) { return this->IsFixed[parts[k]] != 0; };
    const auto isOwner = [this, &parts, &isFixed, value](std::size_t k)
    { return isFixed(k) && this->Kinds[parts[k]] == Kind::Body && this->Names[parts[k]] == value; };
    if (isOwner(0) || isOwner(1))
    {
      return true;
    }
    this->HasValues = this->HasValues && !(isFixed(0) && isFixed(1));
    if (isFixed(0) != isFixed(1))
    {
      const std::size_t part = parts[isFixed(0) ? 1 : 0];
      this->Names[part] = value;
      this->IsFixed[part] = 1;
      isChanged = true;
    }
    return false;
  }

  /// Of shells of several values: each value of a triangle is that of the body on one of its sides
  /// (FindOwner). Parts without triangles of their own are cavities. Values do not count where that
  /// does not go.
  void NameWalledBodies()
  {
    bool isChanged = true;
    bool isOpen = true;
    while (isChanged && this->HasValues && this->Beats.Ask())
    {
      isChanged = false;
      isOpen = false;
      for (std::size_t t = 0; t < this->Triangles; ++t)
      {
        if (this->IsMixed[this->ShellOf(t)] == 0)
        {
          continue;
        }
        for (const Id value : this->Values[t])
        {
          const bool isOwned = value == NoId || this->FindOwner(t, value, isChanged);
          isOpen = isOpen || !isOwned;
        }
      }
    }
    this->HasValues = this->HasValues && !isOpen;
    for (std::size_t part = 0; part < this->Kinds.size() && this->HasValues; ++part)
    {
      const bool isCavity = this->Kinds[part] == Kind::Body && this->IsFixed[part] == 0;
      this->Kinds[part] = isCavity ? Kind::Empty : this->Kinds[part];
    }
  }

  void NumberLabels()
  {
    this->Result.HasValues = this->HasValues;
    std::vector<std::array<Id, 3>> bodies; // region, number by triangles, part
    std::vector<Id> labels(this->Kinds.size(), NoId);
    for (std::size_t side = 0; side < 2 * this->Triangles; ++side)
    {
      const std::size_t part = At(this->Parts.SetOf(static_cast<Id>(side)));
      if (labels[part] == NoId)
      {
        labels[part] = 0;
        if (this->Kinds[part] == Kind::Body)
        {
          const Id order = static_cast<Id>(bodies.size());
          const Id region = this->HasValues ? this->Names[part] : order;
          bodies.push_back({ region, order, static_cast<Id>(part) });
        }
      }
    }
    std::sort(bodies.begin(), bodies.end());
    for (const auto& [region, order, part] : bodies)
    {
      this->Result.Regions.push_back(region);
      labels[At(part)] = static_cast<Id>(this->Result.Regions.size());
    }
    for (std::size_t t = 0; t < this->Triangles; ++t)
    {
      TriangleSides sides{ labels[this->PartAt(t, 0)], labels[this->PartAt(t, 1)] };
      if (!IsBehind(sides[0], sides[1]))
      {
        std::swap(sides[0], sides[1]);
        std::swap(this->Mesh.Corners[3 * t + 1], this->Mesh.Corners[3 * t + 2]);
      }
      this->Result.Sides.push_back(sides);
    }
  }

  SurfaceMesh& Mesh;
  std::vector<RegionPair> Values; ///< of triangles
  Pulse& Beats;
  std::size_t Triangles;
  DisjointSets Parts;  ///< of sides of triangles, and of what is outside: parts of space
  DisjointSets Shells; ///< of triangles that hang together by edges
  std::vector<std::uint8_t> IsOdd; ///< of shells: they have edges of an odd number of triangles
  /// Of shells: they have edges of more than two triangles, or triangles of two values.
  std::vector<std::uint8_t> HasWalls;
  std::vector<std::uint8_t> IsMixed; ///< of shells: they have several values
  std::vector<RegionPair> ValueOf;   ///< of shells
  bool HasValues = false;
  std::vector<Kind> Kinds;           ///< of parts
  std::vector<Id> Names;             ///< of parts: their values
  std::vector<std::uint8_t> IsFixed; ///< of parts: kind and value are known
  double LargestCosine = -Infinity;  ///< between neighbors around edges of more than two triangles
  BodySides Result;
};

} // namespace

BodySides FindBodies(SurfaceMesh& mesh, Pulse& pulse)
{
  return BodyFinder(mesh, pulse).Run();
}

} // namespace biting
