// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshingStages_h
#define BitingMeshingStages_h

#include <array> // for the sequence

namespace biting
{

/// A stage of the work as a monitor shows it.
struct Stage
{
  const char* Text;
  double Share; ///< of the time of a run, roughly: that of a mesh of a million vertices
};

/// The stages of MakeBitingMesh.
namespace MeshingStages
{
inline constexpr Stage Domain{ "Reading the domain", 0.03 };
inline constexpr Stage Spacing{ "Preparing the spacing", 0.05 };
inline constexpr Stage Biting{ "Biting", 0.42 };
inline constexpr Stage Triangulation{ "Triangulating", 0.32 };
inline constexpr Stage Quality{ "Measuring quality", 0.18 };

inline constexpr std::array<Stage, 5> InOrder{ Domain, Spacing, Biting, Triangulation, Quality };
} // namespace MeshingStages

} // namespace biting

#endif
