// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DividedEdges.h"

#include "KeepRules.h"

#include <utility> // for move

namespace biting
{

namespace
{

class Dividing
{
public:
  Dividing(const OldMesh& mesh, const ChangedRegion& region,
    const std::vector<std::uint8_t>& isKept, const std::vector<double>& spacings)
    : Mesh(mesh)
    , Region(region)
    , IsKept(isKept)
    , Spacings(spacings)
    , IsDivisible(mesh.Regions.size(), 0)
    , IsDivided(mesh.Corners.size(), 0)
  {
  }

  std::vector<Point2> Run()
  {
    for (const Id triangle : this->Region.Triangles)
    {
      const Id first = 3 * triangle;
      this->IsDivisible[triangle] = this->HasGoodHalves(first) && this->HasGoodHalves(first + 1) &&
        this->HasGoodHalves(first + 2);
      for (Id slot = first; this->IsDivisible[triangle] != 0 && slot < first + 3; ++slot)
      {
        if (this->IsLastOfInner(slot) && this->IsDivisible[this->Mesh.Neighbors[slot]] != 0)
        {
          this->Divide(slot, this->Mesh.Across(slot));
        }
      }
    }
    return std::move(this->Middles);
  }

private:
  double SpacingAt(Id vertex) const { return this->Spacings[this->Region.Numbers[vertex]]; }
  double MeanSpacing(Id slot) const
  {
    return 0.5 * (this->SpacingAt(this->Mesh.Start(slot)) + this->SpacingAt(this->Mesh.End(slot)));
  }
  Point2 Middle(Id slot) const
  {
    const Point2& start = this->Mesh.Points[this->Mesh.Start(slot)];
    return start + 0.5 * (this->Mesh.Points[this->Mesh.End(slot)] - start);
  }

  bool IsLastOfInner(Id slot) const;
  bool HasGoodHalves(Id slot) const;
  bool HasRoom(Id slot, const Point2& middle, double room) const;
  void Divide(Id slot, Id across);

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  const std::vector<std::uint8_t>& IsKept;
  const std::vector<double>& Spacings;
  std::vector<std::uint8_t> IsDivisible; ///< one a triangle
  std::vector<std::uint8_t> IsDivided;   ///< one a slot
  std::vector<Point2> Middles;
};

// Each edge between two changed triangles once, but for marked ones: with the second triangle.
bool Dividing::IsLastOfInner(Id slot) const
{
  const Id neighbor = this->Mesh.Neighbors[slot];
  return this->Mesh.Marks[slot] == NoId && neighbor != NoId && neighbor < slot / 3 &&
    this->Region.IsChanged[neighbor] != 0;
}

bool Dividing::HasGoodHalves(Id slot) const
{
  const Id start = this->Mesh.Start(slot);
  const Id end = this->Mesh.End(slot);
  const double half = 0.5 * Distance(this->Mesh.Points[start], this->Mesh.Points[end]);
  const double part = half / this->MeanSpacing(slot);
  return this->IsKept[this->Region.Numbers[start]] != 0 &&
    this->IsKept[this->Region.Numbers[end]] != 0 && KeepRules::IsGoodHalf(part * part);
}

// In the triangle of the slot: above the edge, and beside the middles of its other edges.
bool Dividing::HasRoom(Id slot, const Point2& middle, double room) const
{
  const Point2& start = this->Mesh.Points[this->Mesh.Start(slot)];
  const Point2 along = this->Mesh.Points[this->Mesh.End(slot)] - start;
  const Point2 up = this->Mesh.Points[this->Mesh.Corners[slot]] - start;
  bool hasRoom = Cross(along, up) >= room * Length(along);
  for (Id other = slot - slot % 3; other < slot - slot % 3 + 3; ++other)
  {
    hasRoom &= this->IsDivided[other] == 0 || Distance(middle, this->Middle(other)) >= room;
  }
  return hasRoom;
}

void Dividing::Divide(Id slot, Id across)
{
  const Point2 middle = this->Middle(slot);
  const double room = KeepRules::RadiusOfFitting * this->MeanSpacing(slot);
  if (this->HasRoom(slot, middle, room) && this->HasRoom(across, middle, room))
  {
    this->IsDivided[slot] = 1;
    this->IsDivided[across] = 1;
    this->Middles.push_back(middle);
  }
}

} // namespace

std::vector<Point2> FindMiddles(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<std::uint8_t>& isKept, const std::vector<double>& spacings)
{
  return Dividing(mesh, region, isKept, spacings).Run();
}

} // namespace biting
