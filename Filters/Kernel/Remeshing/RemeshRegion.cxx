// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RemeshRegion.h"

#include "../Base/PartOfStage.h"
#include "RegionEdges.h"
#include "WantedSpacing.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double FirstComparisonEnd = 0.4;
constexpr double PiecesEnd = 0.5;

class RegionFinder
{
public:
  RegionFinder(
    const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor)
    : Mesh(mesh)
    , Options(options)
    , Problems(problems)
    , Whole(monitor, 0.0, 1.0)
  {
    const bool mayMove = options.Edges == EdgePolicy::Free;
    this->Result.Tolerance.Tolerance = mayMove ? options.BoundaryTolerance : 0.0;
    this->Result.Tolerance.FeatureAngle = options.FeatureAngle;
  }

  RemeshRegion Find()
  {
    PartOfStage comparing(this->Whole, 0.0, FirstComparisonEnd);
    WantedSpacing wanted(
      this->Mesh, this->Options.Spacing, this->Options.Values, this->Problems, comparing);
    this->Result.OldSpacings = wanted.AtVertices();
    if (!this->IsOver())
    {
      this->FindRegion();
    }
    if (this->Result.Region.IsEmpty())
    {
      return std::move(this->Result);
    }
    if (this->Result.Tolerance.IsAsked())
    {
      this->Result.Tolerance.Spacings = this->Result.OldSpacings;
    }
    if (this->Options.LimitByFeatureSize)
    {
      this->Limit(wanted);
    }
    else
    {
      this->Prepare(wanted, this->Result.Region, nullptr);
    }
    return std::move(this->Result);
  }

private:
  bool IsOver() const { return this->Problems.HasErrors() || this->Whole.HasStopped(); }

  void FindRegion()
  {
    const std::vector<double>& spacings = this->Result.OldSpacings;
    const std::vector<double> lengths = MeanLengths(this->Mesh, spacings);
    const EdgeFreedom freedom{ this->Options.Edges, this->Result.Tolerance.IsAsked() };
    this->Result.Region = this->Options.RelaxAll
      ? WholeRegion(this->Mesh, lengths)
      : FindChangedRegion(this->Mesh, lengths, FindMisfits(this->Mesh, spacings, lengths, freedom),
          this->Options.Rings);
  }

  void Limit(WantedSpacing& wanted)
  {
    ChangedRegion around = this->Result.Region;
    for (int rings = 1;; rings *= 2)
    {
      const RegionEdges pieces = this->FindPieces(around);
      this->Prepare(wanted, around, &pieces);
      if (this->IsOver())
      {
        return;
      }
      this->Result.OldSpacings = wanted.AtVertices();
      this->FindRegion();
      if (around.Covers(this->Result.Region))
      {
        return;
      }
      around = LargerRegion(this->Mesh, around, this->Result.Region, rings);
    }
  }

  void Prepare(WantedSpacing& wanted, const ChangedRegion& region, const RegionEdges* pieces)
  {
    PartOfStage preparing(this->Whole, PiecesEnd, 1.0);
    this->Result.F = wanted.Prepare(region, pieces,
      static_cast<double>(this->Options.MaximumNumberOfVertices), this->Problems, preparing);
  }

  RegionEdges FindPieces(const ChangedRegion& region)
  {
    PartOfStage finding(this->Whole, FirstComparisonEnd, PiecesEnd);
    return this->Result.Tolerance.IsAsked()
      ? SimplifiedPieces(this->Mesh, region, this->Result.Tolerance, finding)
      : StraightPieces(this->Mesh, region, this->Options.Edges);
  }

  const OldMesh& Mesh;
  const RemeshOptions& Options;
  ProblemList& Problems;
  PartOfStage Whole;
  RemeshRegion Result;
};

} // namespace

RemeshRegion FindRemeshRegion(
  const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  return RegionFinder(mesh, options, problems, monitor).Find();
}

} // namespace biting
