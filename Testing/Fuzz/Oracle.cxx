// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Oracle.h"

#include "EvenOddArea.h"
#include "FuzzRun.h"
#include "JudgedMesh.h"
#include "Repetition.h"
#include "SimplificationOracle.h"

#include <algorithm> // for all_of, clamp, remove_if
#include <cmath>     // for isfinite, ldexp
#include <cstring>   // for memcmp
#include <limits>    // for infinity
#include <memory>    // for sources

namespace biting
{

namespace
{

constexpr std::size_t RepeatPeriod = 16; // of cases, by the number of their points and chains

bool IsEmpty(const BitingMesh& mesh)
{
  return mesh.Points.empty() && mesh.Corners.empty() && mesh.EdgeStarts.empty() &&
    mesh.Spacing.empty() && mesh.Bites.Size() == 0 && mesh.Front.empty() &&
    mesh.Quality.MinimumAngle.empty();
}

bool IsResolution(ProblemCode code)
{
  return code == ProblemCode::DuplicateSegments || code == ProblemCode::Crossings ||
    code == ProblemCode::Touches;
}

/// Which of the ids of a problem number points; the others number cells.
bool IsPointId(const Problem& problem, std::size_t k)
{
  switch (problem.Code)
  {
    case ProblemCode::DuplicatePoints:
    case ProblemCode::NearPoints:
    case ProblemCode::OutsidePoints:
    case ProblemCode::NoClosedLoop:
    case ProblemCode::OpenOutlines:
    case ProblemCode::NotFinite:
    case ProblemCode::OutOfRange:
      return true;
    case ProblemCode::JoinedEnds:
      return k == 0;
    case ProblemCode::ZeroLengthSegments:
    case ProblemCode::Touches:
      return k == 1;
    default:
      return false;
  }
}

std::size_t ExpectedIds(const Problem& problem)
{
  switch (problem.Code)
  {
    case ProblemCode::OutsidePoints:
    case ProblemCode::OutsideInterfaces:
    case ProblemCode::OverlappingCells:
    case ProblemCode::NestedCells:
    case ProblemCode::NotFinite:
      return 1;
    case ProblemCode::DuplicatePoints:
    case ProblemCode::NearPoints:
    case ProblemCode::NarrowAngles:
    case ProblemCode::NearMisses:
    case ProblemCode::ZeroLengthSegments:
    case ProblemCode::DuplicateSegments:
    case ProblemCode::Crossings:
    case ProblemCode::Touches:
    case ProblemCode::NotResolved:
    case ProblemCode::JoinedEnds:
    case ProblemCode::OpenOutlines:
      return 2;
    default:
      return problem.Ids.size();
  }
}

std::size_t MostValues(const SpacingOptions& spacing)
{
  std::size_t most = 0;
  for (const GivenSource& source : spacing.Sources)
  {
    most =
      std::max(most, std::visit([](const auto& given) { return given->Values.size(); }, source));
  }
  return most;
}

bool HasValidIds(const Problem& problem, const FuzzCase& fuzzCase)
{
  if (problem.Ids.size() != ExpectedIds(problem))
  {
    return false;
  }
  const bool isSpacing = problem.Code == ProblemCode::BadSpacing;
  const std::size_t points = fuzzCase.Input.Points.size();
  const std::size_t values = MostValues(fuzzCase.Options.Spacing);
  for (std::size_t k = 0; k < problem.Ids.size(); ++k)
  {
    const std::size_t end = isSpacing ? values
      : IsPointId(problem, k)         ? points
                                      : fuzzCase.Input.Cells.size();
    const bool isOptional = k == 1 &&
      (problem.Code == ProblemCode::Touches || problem.Code == ProblemCode::NearPoints ||
        problem.Code == ProblemCode::OpenOutlines);
    if (problem.Ids[k] < (isOptional ? NoId : 0) ||
      problem.Ids[k] >= static_cast<std::int64_t>(end))
    {
      return false;
    }
  }
  return true;
}

bool HasValidPlace(const Problem& problem)
{
  const bool isWhatIsWrong =
    problem.Code == ProblemCode::NotFinite || problem.Code == ProblemCode::BadSpacing;
  return isWhatIsWrong || (std::isfinite(problem.Place.X) && std::isfinite(problem.Place.Y));
}

/// What is wrong with what was said, whether there is a mesh or not.
std::string JudgeProblems(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  int errors = 0;
  for (const ProblemGroup& group : run.Problems.Groups())
  {
    errors += IsError(group.Code) ? 1 : 0;
    const bool areValid = std::all_of(group.First.begin(), group.First.end(),
      [&fuzzCase](const Problem& problem)
      { return HasValidIds(problem, fuzzCase) && HasValidPlace(problem); });
    if (!areValid || group.Count < 1 || group.First.empty())
    {
      return "a problem of code " + std::to_string(static_cast<int>(group.Code)) +
        " has wrong ids or no place";
    }
    if (group.Code == ProblemCode::CheckFailed)
    {
      return "the kernel's own check failed: " + group.First.front().Detail;
    }
  }
  if (!run.Mesh.BlocksViolation.empty())
  {
    return "the check of the blocks failed: " + run.Mesh.BlocksViolation;
  }
  return errors > 1 ? "more than one kind of error" : "";
}

bool HasFinitePoints(const Polylines& input)
{
  return std::all_of(input.Connectivity.begin(), input.Connectivity.end(),
    [&input](Id id)
    {
      const Point2& point = input.Points[static_cast<std::size_t>(id)];
      return std::isfinite(point.X) && std::isfinite(point.Y);
    });
}

/// Whether most of the drawing is smaller than the rounding of its largest coordinate.
bool IsBlurred(const Drawing& drawing)
{
  const auto isShort = [&drawing](const DrawnSegment& segment)
  { return Distance(segment.Start, segment.End) <= drawing.Slack(); };
  const auto shortOnes = std::count_if(drawing.Segments.begin(), drawing.Segments.end(), isShort);
  return 2 * static_cast<std::size_t>(shortOnes) > drawing.Segments.size();
}

/// Whether the refusal is one that the input deserves.
std::string JudgeRefusal(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  if (run.Problems.Has(ProblemCode::NoClosedLoop))
  {
    const Drawing drawing = ReadDrawing(fuzzCase.Input);
    const EvenOddArea area = drawing.IsExplicit ? MeasureEvenOddArea(drawing) : EvenOddArea();
    return area.Area > area.Tolerance ? "there is a closed loop" : "";
  }
  if (run.Problems.Has(ProblemCode::NotFinite))
  {
    return HasFinitePoints(fuzzCase.Input) ? "all points are finite" : "";
  }
  if (run.Problems.Has(ProblemCode::NotResolved))
  {
    const bool isDeserved =
      !fuzzCase.Options.Domain.Repair || IsBlurred(ReadDrawing(fuzzCase.Input));
    return isDeserved ? "" : "not resolved";
  }
  return "";
}

/// Whether a face winds about some of its area more than once: then it is not the area of its
/// outline.
bool HasFaceOnItself(const Drawing& drawing)
{
  for (const std::vector<DrawnSegment>& face : FacesOf(drawing))
  {
    std::vector<std::pair<Point2, Point2>> outline;
    for (const DrawnSegment& segment : face)
    {
      outline.emplace_back(segment.Start, segment.End);
    }
    const Rational wound = abs(EnclosedArea(outline));
    const EvenOddArea area = MeasureEvenOddArea(drawing.Of(face));
    if (abs(wound - area.Area) > area.Tolerance)
    {
      return true;
    }
  }
  return false;
}

/// Whether a face is so thin that rounding may turn it over, or lay it onto its neighbors.
bool HasFaceBelowRounding(const Drawing& drawing)
{
  const std::vector<std::vector<DrawnSegment>> faces = FacesOf(drawing);
  return std::any_of(faces.begin(), faces.end(),
    [&drawing](const std::vector<DrawnSegment>& face)
    {
      const EvenOddArea area = MeasureEvenOddArea(drawing.Of(face));
      return area.Area > 0 && area.Area <= area.Tolerance;
    });
}

/// Whether two faces have area in common, and each has some of its own, all of it more than
/// rounding.
bool OverlapInPart(const Drawing& first, const Drawing& second)
{
  Drawing both = first;
  both.Segments.insert(both.Segments.end(), second.Segments.begin(), second.Segments.end());
  const EvenOddArea a = MeasureEvenOddArea(first);
  const EvenOddArea b = MeasureEvenOddArea(second);
  const EvenOddArea odd = MeasureEvenOddArea(both);
  const Rational common = (a.Area + b.Area - odd.Area) / 2;
  return common > odd.Tolerance && a.Area - common > odd.Tolerance &&
    b.Area - common > odd.Tolerance;
}

bool DoAnyOverlapInPart(const Drawing& drawing)
{
  const std::vector<std::vector<DrawnSegment>> faces = FacesOf(drawing);
  for (std::size_t first = 0; first < faces.size(); ++first)
  {
    for (std::size_t second = first + 1; second < faces.size(); ++second)
    {
      if (OverlapInPart(drawing.Of(faces[first]), drawing.Of(faces[second])))
      {
        return true;
      }
    }
  }
  return false;
}

Drawing WithoutLines(Drawing drawing)
{
  drawing.Segments.erase(std::remove_if(drawing.Segments.begin(), drawing.Segments.end(),
                           [](const DrawnSegment& segment) { return segment.Face == NoId; }),
    drawing.Segments.end());
  return drawing;
}

/// Faces that share no area are not told of; those that overlap in part are, unless one crosses
/// itself.
std::string JudgeOverlaps(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  const Drawing drawing = ReadDrawing(fuzzCase.Input);
  const bool isTold = run.Problems.Has(ProblemCode::OverlappingCells);
  if (!drawing.HasFaces)
  {
    return isTold ? "cells overlap where there are none" : "";
  }
  const Drawing faces = WithoutLines(drawing);
  if (run.Problems.Has(ProblemCode::Crossings) || HasFaceOnItself(faces))
  {
    return "";
  }
  const EvenOddArea sum = SumOfFaces(faces);
  const EvenOddArea odd = MeasureEvenOddArea(faces);
  const Rational excess = sum.Area - odd.Area;
  if (isTold && excess <= Blur(faces))
  {
    return HasFaceBelowRounding(faces) ? "" : "cells overlap where none do";
  }
  const bool mayOverlap = !isTold && excess > sum.Tolerance + odd.Tolerance;
  return mayOverlap && DoAnyOverlapInPart(faces) ? "cells that overlap are not told of" : "";
}

/// A simplified drawing is judged by itself, and the mesh then by what is left of it.
std::string JudgeGeometry(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  if (!fuzzCase.Options.Simplification.IsAsked())
  {
    return FindMeshViolation(run.Mesh, fuzzCase.Input, fuzzCase.Options);
  }
  const std::string violation = JudgeSimplification(fuzzCase);
  Polylines lines;
  return violation.empty() && ReadSimplified(fuzzCase, lines)
    ? FindMeshViolation(run.Mesh, lines, fuzzCase.Options)
    : violation;
}

/// What must hold of a mesh besides itself.
std::string JudgeMesh(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  for (const ProblemGroup& group : run.Problems.Groups())
  {
    if (!fuzzCase.Options.Domain.Repair && IsResolution(group.Code))
    {
      return "resolved without leave";
    }
  }
  const std::string violation = JudgeGeometry(run, fuzzCase);
  return violation.empty() ? JudgeOverlaps(run, fuzzCase) : violation;
}

FuzzOutcome Violated(const std::string& violation)
{
  return { Verdict::Violation, violation };
}

FuzzOutcome Judge(const FuzzRun& run, const FuzzCase& fuzzCase)
{
  const bool wasAborted = run.Problems.Has(ProblemCode::Aborted);
  const bool hasErrors = run.Problems.HasErrors();
  std::string violation = JudgeProblems(run, fuzzCase);
  if (violation.empty() && run.HasBadFraction)
  {
    violation = "progress is not within 0 and 1";
  }
  if (violation.empty() && wasAborted != run.SaidStop && (wasAborted || !hasErrors))
  {
    violation = wasAborted ? "aborted for no reason" : "stop was not heard";
  }
  if (violation.empty() && hasErrors)
  {
    violation = IsEmpty(run.Mesh) ? JudgeRefusal(run, fuzzCase) : "an error and a mesh";
  }
  if (!violation.empty() || hasErrors)
  {
    return { !violation.empty() ? Verdict::Violation
        : wasAborted            ? Verdict::Aborted
                                : Verdict::Refusal,
      violation };
  }
  if (IsEmpty(run.Mesh) && fuzzCase.Input.Kinds.empty())
  {
    return { Verdict::Mesh, "" };
  }
  violation = JudgeMesh(run, fuzzCase);
  const bool isRepaired = !run.Problems.Groups().empty();
  return { !violation.empty() ? Verdict::Violation
      : isRepaired            ? Verdict::RepairedMesh
                              : Verdict::Mesh,
    violation };
}

} // namespace

FuzzOutcome RunFuzzCase(const FuzzCase& fuzzCase)
{
  const FuzzRun run = Run(fuzzCase);
  FuzzOutcome outcome = Judge(run, fuzzCase);
  outcome.IsOfBlocks = run.Mesh.NumberOfBlocks > 1;
  const std::size_t choice = fuzzCase.Input.Points.size() + fuzzCase.Input.Connectivity.size();
  if (outcome.Violation.empty() && choice % RepeatPeriod == 0)
  {
    const std::string violation = JudgeRepetition(run, fuzzCase);
    return violation.empty() ? outcome : Violated(violation);
  }
  return outcome;
}

} // namespace biting
