// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGroundPatches_h
#define BitingGroundPatches_h

#include "SurfaceGround.h"

#include <vector> // for the patches

namespace biting
{

/// A place on the ground.
struct GroundPlace
{
  Id Triangle;
  Point3 Place;
};

/// The patches of a ground that feature lines bound.
class GroundPatches
{
public:
  explicit GroundPatches(const SurfaceGround& ground);

  /// A number of the patch.
  Id PatchOf(Id triangle) const { return this->Patches[At(triangle)]; }

  /// The nearest place of the patch, by descent from `triangle` to neighbors: a local minimum.
  GroundPlace Project(Id triangle, const Point3& place) const;

private:
  const SurfaceGround& Ground;
  std::vector<Id> Patches; ///< of triangles: the first triangle of the patch
};

} // namespace biting

#endif
