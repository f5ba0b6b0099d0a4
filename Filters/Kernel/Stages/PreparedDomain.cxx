// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedDomain.h"

#include "PreparedSpacing.h"
#include "StageProblems.h"

#include <functional> // for the spacing
#include <memory>     // for what is made once
#include <optional>   // for what is made once
#include <utility>    // for move

namespace biting
{

namespace
{

constexpr double GivenSpacingEnd = 0.3; // of the time

// The spacing before gradation and any limit by feature size, made where it is first asked for.
// Problems of it are told later, by PrepareSpacing.
std::function<double(const Point2&)> SpacingAsGiven(
  const Polylines& input, const BitingMeshOptions& options, Monitor& monitor)
{
  auto made = std::make_shared<std::optional<Spacing>>();
  return [&input, &options, &monitor, made](const Point2& x)
  {
    if (!*made)
    {
      const Box2 bounds = Box2::Around(input.Points, input.Connectivity);
      SpacingOptions given = options.Spacing;
      given.Gradation = 0.0;
      ProblemList unheard;
      PartOfStage standing(monitor, 0.0, 0.0);
      made->emplace(MakeSpacing(given, bounds, unheard, standing));
    }
    return (**made)(x);
  };
}

SimplifiedDomain Reduce(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  SimplificationOptions wanted = options.Simplification;
  wanted.Tolerance = options.PreserveBoundary ? 0.0 : wanted.Tolerance;
  SimplifiedDomain result;
  if (!wanted.IsAsked())
  {
    result.Drawing = std::move(drawing);
    return result;
  }
  PartOfStage preparing(monitor, 0.0, GivenSpacingEnd);
  const Spacing given = PrepareGivenSpacing(options, drawing, problems, preparing);
  if (!AddAborted(preparing, problems) && !problems.HasErrors())
  {
    PartOfStage simplifying(monitor, GivenSpacingEnd, 1.0);
    result = Simplify(
      drawing, wanted, [&given](const Point2& x) { return given(x); }, problems, simplifying);
  }
  return result;
}

} // namespace

Domain ReadDrawing(
  const Polylines& input, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  DomainOptions wanted = options.Domain;
  wanted.GivenSpacing = SpacingAsGiven(input, options, monitor);
  return MakeDomain(input, wanted, problems, monitor);
}

SimplifiedDomain SimplifyDrawing(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, PartOfStage& part)
{
  SimplifiedDomain result = Reduce(std::move(drawing), options, problems, part);
  const Id vertices = result.Drawing.NumberOfVertices();
  if (!part.HasStopped() && vertices > options.MaximumNumberOfVertices)
  {
    AddProblem(ProblemCode::TooManyVertices,
      "the input alone has " + std::to_string(vertices) + " vertices, the limit is " +
        std::to_string(options.MaximumNumberOfVertices),
      problems);
  }
  return result;
}

} // namespace biting
