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
inline constexpr Stage Domain{ "Reading the domain", 0.02 };
inline constexpr Stage Simplification{ "Simplifying the drawing", 0.02 }; ///< where it is asked for
inline constexpr Stage Spacing{ "Preparing the spacing", 0.03 };
inline constexpr Stage Biting{ "Biting", 0.4 };
inline constexpr Stage Triangulation{ "Triangulating", 0.08 };
inline constexpr Stage Relaxation{ "Relaxing", 0.33 }; ///< without it, it is over at once
inline constexpr Stage Quality{ "Measuring quality", 0.12 };

inline constexpr std::array<Stage, 7> InOrder{ Domain, Simplification, Spacing, Biting,
  Triangulation, Relaxation, Quality };
} // namespace MeshingStages

} // namespace biting

#endif
