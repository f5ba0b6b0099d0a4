// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WindingNumber.h"

#include "../../Base/DisjointSets.h"

namespace biting
{

std::vector<int> WindingNumber::InFront(
  const SurfaceLinks& links, const std::vector<std::uint8_t>& isMarked, Pulse& pulse) const
{
  const std::size_t triangles = this->Mesh.NumberOfTriangles();
  DisjointSets sheets(triangles);
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
  {
    const Id other = links.Across[slot] / 3;
    if (links.Across[slot] >= 0 && isMarked[slot / 3] == 0 && isMarked[biting::At(other)] == 0)
    {
      sheets.Unite(static_cast<Id>(slot / 3), other);
    }
  }
  // From the largest triangle of each: rays from it are the clearest.
  std::vector<std::size_t> largest(triangles, triangles);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    std::size_t& best = largest[biting::At(sheets.SetOf(static_cast<Id>(t)))];
    const bool isLarger =
      best == triangles || Length(this->Mesh.Normal(best)) < Length(this->Mesh.Normal(t));
    best = isLarger ? t : best;
  }
  std::vector<int> numbers(triangles, 0);
  for (std::size_t t = 0; t < triangles && pulse.Beat(); ++t)
  {
    const std::size_t sheet = biting::At(sheets.SetOf(static_cast<Id>(t)));
    if (sheet == t && isMarked[t] == 0)
    {
      const std::size_t from = largest[t];
      const Point3 normal = this->Mesh.Normal(from);
      const std::size_t axis = LongestAxis(normal);
      numbers[t] = this->At(this->Mesh.Middle(from), axis,
                     [from](std::size_t other) { return other == from; }) -
        (normal[axis] > 0.0 ? 0 : 1);
    }
    numbers[t] = isMarked[t] == 0 ? numbers[sheet] : 0;
  }
  return numbers;
}

} // namespace biting
