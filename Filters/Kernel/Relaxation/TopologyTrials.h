// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTopologyTrials_h
#define BitingTopologyTrials_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "AngleDescent.h"
#include "DelaunayMesh.h"

#include <cstddef> // for the limit
#include <cstdint> // for flags
#include <limits>  // for infinity
#include <vector>  // for the lists

namespace biting
{

/// Collapses and splits edges around the few triangles that are still below 38 degrees.
///
/// 1. Around each of them, the worst first, every edge near by is collapsed and split on trial, and
///    the vertices next to it are smoothed once: that ranks the operations.
/// 2. The best ranked operations are tried in full: AngleDescent moves the vertices near by until
///    they are better than in the best trial so far.
/// 3. The best operation is kept if all triangles that it changes are better than the poor one was.
/// 4. Poor triangles near a change are tried again, as long as that improves any.
/// 5. In the end up to four of the worst are tried with every operation in full.
class TopologyTrials
{
public:
  TopologyTrials(DelaunayMesh& mesh, AngleDescent& descent)
    : Mesh(mesh)
    , Descent(descent)
  {
  }

  /// Tries at most `limit` triangles, and the very worst; each takes about as long as relaxing a
  /// hundred vertices.
  void Run(std::size_t limit, Pulse& pulse);

private:
  struct PoorTriangle
  {
    double Cotangent;
    Id Triangle;
  };
  struct Operation
  {
    Id Edge = NoId;
    bool IsCollapse = false;
    double Worst = std::numeric_limits<double>::infinity(); ///< after it, in a trial
  };
  struct Effort; // how much is spent on one triangle

  bool TryAll(std::size_t limit, Pulse& pulse);
  void TryWorst(Pulse& pulse);
  void FindCandidates(Pulse& pulse);
  void FindPoor(Pulse& pulse);
  bool IsToBeTried(Id triangle) const;
  bool Improve(const PoorTriangle& poor, const Effort& effort, Pulse& pulse);
  bool LookAround(const PoorTriangle& poor);
  void FindEdges(const std::vector<Id>& corners);
  bool RankOperations(const Effort& effort, Pulse& pulse);
  bool IsPromising(const Operation& operation, const Effort& effort) const;
  double QuickTrial(const Operation& operation, double limit);
  Operation TryInFull(const Effort& effort);
  double FullTrial(const Operation& operation, double good, double limit, bool isCutOff);
  bool Keep(const Operation& operation);
  Id Perform(const Operation& operation);
  void SmoothNear(Id vertex, int rings);
  double WorstChanged(Id added, double limit) const;
  void MarkUntried();

  DelaunayMesh& Mesh;
  AngleDescent& Descent;
  std::vector<Id> Candidates;     ///< triangles that may be poor
  std::size_t NumberOfSorted = 0; ///< of Candidates: later ones came after the sort
  std::vector<PoorTriangle> Poor;
  std::vector<std::uint8_t> AreTried; ///< one a triangle: tried, and nothing near has changed
  std::size_t NumberOfTried = 0;

  // Of the triangle at hand.
  PoorTriangle Worst{ 0.0, NoId };
  std::vector<Id> Judged;     ///< vertices whose stars are compared before and after
  std::vector<double> Before; ///< the objectives of their stars
  std::vector<Id> Edges;      ///< near it
  std::vector<Operation> Operations;
  std::vector<Id> Moved; ///< vertices that may move in a trial
};

} // namespace biting

#endif
