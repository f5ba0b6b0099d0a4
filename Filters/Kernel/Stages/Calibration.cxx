// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Calibration.h"

#include "../Base/Monitor.h"
#include "../Biting/VertexEstimate.h"
#include "../Delaunay/Triangulation.h"

#include <algorithm> // for clamp, min, max
#include <cmath>     // for sqrt, abs

namespace biting
{

namespace
{

constexpr double VerticesOfTrials = 12000.0; // as many as cost the same, roughly
constexpr double MostTrialVertices = 6000.0;
constexpr double LeastTrialVertices = 600.0;
constexpr double ShareOfTrial = 0.5;    // of the vertices of the mesh
constexpr double LeastEstimate = 300.0; // a smaller mesh is all border
constexpr int LeastInnerEdges = 300;
constexpr int MostTrials = 2;
constexpr double TrialBitingEnd = 0.6;     // of the time of a trial
constexpr double CloseEnough = 0.01;       // of the mean length
constexpr double GreatestCorrection = 1.2; // of the constant: what packings differ by

bool HasTrials(const BitingOptions& options)
{
  return options.FollowSlope && options.Placement == Placement::Corners;
}

struct MeanLength
{
  double Sum = 0.0;
  int Count = 0;
};

// Between vertices off the boundary: those on it are as near as the input wants them.
MeanLength InnerMeanLength(
  const BitingResult& bites, const Triangulation& mesh, Id numberOfOldVertices)
{
  const auto isInner = [&](Id vertex)
  { return vertex >= numberOfOldVertices && bites.Segments[vertex] == NoId; };
  MeanLength mean;
  for (Id half = 0; half < static_cast<Id>(mesh.Corners.size()); ++half)
  {
    const Id u = mesh.Corners[half];
    const Id v = mesh.Corners[half % 3 == 2 ? half - 2 : half + 1];
    if (isInner(u) && isInner(v))
    {
      mean.Sum +=
        2.0 * Distance(bites.Points[u], bites.Points[v]) / (bites.Spacings[u] + bites.Spacings[v]);
      ++mean.Count;
    }
  }
  return mean;
}

MeanLength RunTrial(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, double expectedVertices, Monitor& monitor)
{
  PartOfStage biting(monitor, 0.0, TrialBitingEnd);
  const BitingResult bites =
    BiteDomain(domain, locator, spacing, expectedVertices, options, biting);
  if (bites.End != BitingEnd::Complete)
  {
    return {};
  }
  PartOfStage triangulating(monitor, TrialBitingEnd, 1.0);
  const TriangulationResult result =
    Triangulate(bites.Points, ConstraintsOf(bites, domain), {}, triangulating);
  return InnerMeanLength(bites, result.Mesh, domain.NumberOfVertices());
}

} // namespace

Forecast MakeForecast(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, Monitor& monitor)
{
  PartOfStage integrating(monitor, 0.0, 0.5);
  const double density = IntegrateDensity(domain, locator, spacing, integrating);
  PartOfStage dividing(monitor, 0.5, 1.0);
  const double divisionPoints =
    options.PreserveBoundary ? 0.0 : EstimateDivisionPoints(domain, spacing, 1.0, dividing);
  return { density,
    EstimateNumberOfVertices(density, options.PartLength) + domain.NumberOfVertices() +
      divisionPoints };
}

double ShareOfTrials(const BitingOptions& options, double vertices)
{
  return HasTrials(options) ? VerticesOfTrials / (VerticesOfTrials + vertices) : 0.0;
}

// A coarser spacing k f is the same as k c_b and parts of length k.
double CalibrateBitingConstant(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, double integratedDensity, const BitingOptions& options, Monitor& monitor)
{
  const double first = options.BitingConstant;
  const double wanted = EstimateNumberOfVertices(integratedDensity);
  if (!HasTrials(options) || wanted < LeastEstimate ||
    domain.NumberOfVertices() > MostTrialVertices)
  {
    return first;
  }
  BitingOptions trial = options;
  trial.MaximumNumberOfBites = -1;
  trial.KeepFront = false;
  const double most = std::clamp(ShareOfTrial * wanted, LeastTrialVertices, MostTrialVertices);
  const double coarsening = std::max(1.0, std::sqrt(wanted / most));
  double constant = first;
  for (int count = 0; count < MostTrials; ++count)
  {
    trial.BitingConstant = coarsening * constant;
    trial.PartLength = coarsening;
    PartOfStage part(monitor, static_cast<double>(count) / MostTrials, (count + 1.0) / MostTrials);
    const MeanLength mean = RunTrial(domain, locator, spacing, trial, std::min(wanted, most), part);
    if (mean.Count < LeastInnerEdges)
    {
      return constant;
    }
    const double length = mean.Sum / mean.Count / coarsening;
    if (std::abs(length - 1.0) < CloseEnough)
    {
      break; // what was tried stays: packings jump, a correction could only lose it
    }
    constant =
      std::clamp(constant / length, first / GreatestCorrection, first * GreatestCorrection);
  }
  return constant;
}

} // namespace biting
