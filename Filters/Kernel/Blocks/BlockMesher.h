// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockMesher_h
#define BitingBlockMesher_h

#include "../Base/Crew.h"
#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "CutStrip.h"
#include "CutTree.h"
#include "JoinedBlocks.h"
#include "WholeNumbers.h"

#include <cstdint> // for flags, limits
#include <vector>  // for the blocks

namespace biting
{

/// Meshes a domain block by block, each by itself, on the threads of the monitor: biting,
/// triangulation, relaxation; then joins the blocks and relaxes what lies along the cuts.
///
/// Blocks are a function of the domain, f and the options alone, and so is the mesh. Where the
/// domain is too small for two blocks, or no good cut is found, there is none, and the mesher is
/// not in use. The domain and the spacing must outlive it. Problems are added in the order of the
/// blocks.
///
/// The members of a crew share the blocks. A block stays with its member; the first member gets its
/// collar (BlockCollar.h). The first member joins and relaxes the collars, and has their mesh in
/// `bites` and `triangles`. It makes the blocks that do not arrive. Where the collars do not
/// suffice, or no member has sent any, it makes all blocks and has the mesh of the whole.
class BlockMesher
{
public:
  /// The collars' mesh has `ghostLevels` + 2 rings of vertices around the part of a member. One
  /// process may have `mostInProcess` vertices.
  BlockMesher(const Domain& domain, const Spacing& spacing, Crew& crew = NoCrew(),
    int ghostLevels = 0, std::int64_t mostInProcess = MostVerticesInIds)
    : Geometry(domain)
    , F(spacing)
    , Members(crew)
    , GhostLevels(ghostLevels)
    , MostOfMember(mostInProcess)
  {
  }

  bool IsInUse() const { return !this->Own.Parts.Blocks.empty(); }

  /// Another process is the first.
  bool IsHelping() const { return this->Members.Own() != 0; }

  /// The blocks, and after the last step what is kept of them, where there are several members.
  KeptBlocks& Kept() { return this->Own; }

  /// The first step cuts the domain, bites its blocks and triangulates them. `vertices` are
  /// expected. Returns false where there are no blocks, as where `verticesPerBlock` is 0: then
  /// nothing is done.
  bool Bite(const DomainLocator& locator, double vertices, double verticesPerBlock,
    const BitingOptions& options, ProblemList& problems, Monitor& monitor);

  /// The second step relaxes the blocks and joins them. `bites` and `triangles` are then the mesh
  /// of the whole domain.
  void Relax(
    BitingResult& bites, Triangulation& triangles, ProblemList& problems, Monitor& monitor);

private:
  void Plan(const DomainLocator& locator, double vertices, double verticesPerBlock,
    ProblemList& problems, Monitor& monitor);
  void BiteBlocks(Monitor& monitor);
  void ConcludeBiting(ProblemList& problems);
  void BiteBlock(std::size_t block, Monitor& monitor);
  void RelaxBlocks(Monitor& monitor);
  void TakeCollars();
  bool Collect(Monitor& monitor);
  void MakeMissing(ProblemList& problems, Monitor& monitor);
  bool MendCollars(ProblemList& problems, PartOfStage& part);
  void MendWhole(ProblemList& problems, PartOfStage& part);
  StripChange Mend(std::vector<BlockMesh> meshes, ProblemList& problems, Monitor& monitor);

  const Domain& Geometry;
  const Spacing& F;
  Crew& Members;
  int GhostLevels;
  std::int64_t MostOfMember;    ///< vertices
  std::int64_t MostOfWhole = 0; ///< the same
  BitingOptions Options;        ///< of a block
  double Expected = 0.0;        ///< vertices
  KeptBlocks Own;
  CutTree Tree;
  std::vector<std::size_t> LargestFirst;        ///< the blocks that this process makes, as tasks
  std::vector<std::vector<std::size_t>> Shares; ///< of the members: blocks, the largest first
  std::vector<ProblemList> Found;               ///< in the triangulations of the blocks
  JoinedMesh Joined;
};

} // namespace biting

#endif
