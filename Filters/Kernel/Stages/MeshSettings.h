// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshSettings_h
#define BitingMeshSettings_h

#include "../Base/Crew.h"
#include "../Biting/BitingScheme.h"
#include "../Mesh/BitingMeshOptions.h"

#include <algorithm> // for min
#include <limits>    // for the largest number of a bite

namespace biting
{

/// What the options of a mesh come to: made once, before the first stage. What is automatic has its
/// value here, what excludes each other is decided, and no stage derives it again.
struct MeshSettings
{
  MeshSettings(const BitingMeshOptions& options, const Crew& members)
    : Biting(options.BiteShape, options.Placement, options.Order, options.BitingConstant)
    , IsRelaxed(options.Relaxation && options.MaximumNumberOfBites < 0)
    , IsDelaunay(options.Phi == 1.0 || this->IsRelaxed)
  {
    const bool mayCut = this->IsRelaxed && RuleOf(options.Order).MayCut && !options.KeepBites &&
      !options.PreserveBoundary;
    this->VerticesPerBlock = mayCut ? static_cast<double>(options.VerticesPerBlock) : 0.0;
    this->IsShared = this->VerticesPerBlock > 0.0 && !options.Opens &&
      !options.Domain.KeepCellEdges && options.PeriodicTranslations.empty();
    this->Biting.MaximumNumberOfBites = options.MaximumNumberOfBites;
    this->Biting.MaximumNumberOfVertices = std::min({ options.MaximumNumberOfVertices,
      options.MostVerticesOfProcess * (this->IsShared ? members.Size() : 1), MostVerticesInAll });
    this->Biting.KeepFront = options.KeepBites;
    this->Biting.Phi = options.Phi;
    this->Biting.PreserveBoundary = options.PreserveBoundary;
  }

  /// Of all members of a crew. Bites have numbers of 32 bits; there are fewer than two a vertex.
  static constexpr std::int64_t MostVerticesInAll = std::numeric_limits<Id>::max() / 2;

  BitingOptions Biting;
  double VerticesPerBlock; ///< 0: one block
  bool IsShared;           ///< among the members of a crew, where there are blocks
  bool IsRelaxed;          ///< not where biting is stopped: the front is to be seen as it is then
  bool IsDelaunay;         ///< the mesh must be
};

} // namespace biting

#endif
