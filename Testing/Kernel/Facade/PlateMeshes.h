// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPlateMeshes_h
#define BitingPlateMeshes_h

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"

namespace biting
{

// Drawings and options that tests of whole meshes share.

inline Polylines UnitSquare()
{
  return PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines();
}

/// A square with a round hole, an interface from side to side and an embedded point.
inline Polylines Plate()
{
  return PolylineBuilder()
    .Loop(
      { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.125 }, { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.125 } })
    .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 24))
    .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
    .Chain({ { 0.25, 0.875 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

inline BitingMeshOptions UniformOptions(double length, double bitingConstant = 0.0)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(length);
  options.BitingConstant = bitingConstant;
  return options;
}

/// The mesh of the paper.
inline BitingMeshOptions Raw(BitingMeshOptions options)
{
  options.Placement = Placement::Corners;
  options.Relaxation = false;
  return options;
}

inline BitingMeshOptions RadialOptions()
{
  BitingMeshOptions options;
  options.Spacing = RadialSpacing({ 0.3, 0.25 }, 0.01, 0.1);
  options.KeepBites = true;
  return options;
}

} // namespace biting

#endif
