// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RuleDrawings.h"

#include "../Kernel/Support/RuleOracle.h"
#include "FuzzRun.h"
#include "Stages/CoveringFaces.h"

#include <cmath> // for abs
#include <map>   // for parts of regions

namespace biting
{

namespace
{

constexpr double AreaSlack = 1e-9;
constexpr double NearlyNothing = 1e-3;
constexpr double NearEdge = 1e-7; ///< rounding of middles, and of what the oracle says of them

Point2 CornerOf(const BitingMesh& mesh, std::size_t triangle, std::size_t corner)
{
  return mesh.Points[static_cast<std::size_t>(mesh.Corners[3 * triangle + corner])];
}

Point2 MiddleOfTriangle(const BitingMesh& mesh, std::size_t triangle)
{
  return (1.0 / 3.0) *
    (CornerOf(mesh, triangle, 0) + CornerOf(mesh, triangle, 1) + CornerOf(mesh, triangle, 2));
}

double MeshedArea(const BitingMesh& mesh)
{
  double area = 0.0;
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    const Point2 a = CornerOf(mesh, triangle, 0);
    area += 0.5 * Cross(CornerOf(mesh, triangle, 1) - a, CornerOf(mesh, triangle, 2) - a);
  }
  return area;
}

/// Whether the oracle says the same all around a place.
bool IsClear(const Loops& loops, const Point2& place)
{
  const auto cover = CoverOf(loops, place);
  return CoverOf(loops, place + Point2{ NearEdge, 0.0 }) == cover &&
    CoverOf(loops, place - Point2{ NearEdge, 0.0 }) == cover &&
    CoverOf(loops, place + Point2{ 0.0, NearEdge }) == cover &&
    CoverOf(loops, place - Point2{ 0.0, NearEdge }) == cover;
}

std::string CheckParts(const RuleCase& ruleCase, Id outer, const BitingMesh& mesh)
{
  const DomainRule rule = ruleCase.Case.Options.Domain.Rule;
  Pulse pulse(NoMonitor());
  const CoveringFaces covering(ruleCase.Case.Input, ruleCase.Case.Options.Domain, pulse);
  std::vector<Id> faces(mesh.Regions.size(), NoId);
  if (!covering.IsEmpty())
  {
    faces = covering.FacesOf(mesh, pulse);
    covering.CorrectBy(covering.Count(mesh, faces), mesh, faces, pulse);
  }
  std::map<Id, Id> parts;
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    const Point2 middle = MiddleOfTriangle(mesh, triangle);
    if (!IsClear(ruleCase.Loops, middle))
    {
      continue;
    }
    const std::vector<Id> cover = CoverOf(ruleCase.Loops, middle);
    const Id part = PartAt(ruleCase.Loops, rule, outer, middle);
    const bool isFace = rule == DomainRule::EvenOdd
      ? std::find(cover.begin(), cover.end(), faces[triangle]) != cover.end()
      : faces[triangle] == part;
    if (part == NoId || parts.emplace(mesh.Regions[triangle], part).first->second != part)
    {
      return "triangle " + std::to_string(triangle) + " lies in another part than its region";
    }
    if (!covering.IsEmpty() && !isFace)
    {
      return "triangle " + std::to_string(triangle) + " has another face than its middle";
    }
  }
  return {};
}

/// As chains of that kind, or of a segment each.
Polylines DrawingOf(const Loops& loops, bool areSegments, ChainKind kindOfLoops)
{
  Polylines drawing;
  const auto addChain = [&drawing, kindOfLoops](const Loop& chain, std::size_t loop)
  {
    for (const Point2& p : chain)
    {
      drawing.Connectivity.push_back(static_cast<Id>(drawing.Points.size()));
      drawing.Points.push_back(p);
    }
    drawing.Offsets.push_back(static_cast<Id>(drawing.Connectivity.size()));
    drawing.Kinds.push_back(kindOfLoops);
    drawing.Cells.push_back(static_cast<Id>(drawing.Cells.size()));
    drawing.Regions.push_back(static_cast<Id>(loop));
  };
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    Loop closed = loops[k];
    closed.push_back(closed.front());
    if (!areSegments)
    {
      addChain(closed, k);
      drawing.Connectivity.back() = drawing.Connectivity[drawing.Offsets[k]];
    }
    for (std::size_t i = 0; areSegments && i + 1 < closed.size(); ++i)
    {
      addChain({ closed[i + i % 2], closed[i + 1 - i % 2] }, k);
    }
  }
  return drawing;
}

/// Then rounding decides which of them is the outer one.
bool HasTwoLargest(const Loops& loops)
{
  const Id largest = LargestOf(loops);
  Loops others = loops;
  others.erase(others.begin() + largest);
  const auto area = [](const Loop& loop) { return AreaBy({ loop }, DomainRule::EvenOdd, 0); };
  return area(others[static_cast<std::size_t>(LargestOf(others))]) >
    area(loops[static_cast<std::size_t>(largest)]) - AreaSlack;
}

} // namespace

RuleCase MakeRuleCase(FuzzNumbers& numbers)
{
  const bool isOnGrid = numbers.OneIn(2);
  const auto number = [&numbers, isOnGrid]
  { return isOnGrid ? 0.125 * numbers.Below(9) : numbers.Unit(); };
  RuleCase made;
  for (int k = numbers.Between(2, 6); k > 0; --k)
  {
    const double size = isOnGrid ? numbers.Between(1, 2) : 0.2 + 2.0 * numbers.Unit();
    const Point2 corner{ number(), number() };
    Loop loop;
    for (int n = numbers.Between(3, 6); n > 0; --n)
    {
      loop.push_back(corner + size * Point2{ number(), number() });
    }
    made.Loops.push_back(loop);
  }
  // Segments of loops that meet at a point would be one loop; those of a loop that crosses itself
  // may be interfaces by EvenOdd, as closed chains may that nobody says to be boundary.
  const bool areSegments = !isOnGrid && numbers.OneIn(3);
  auto rule = static_cast<DomainRule>(areSegments ? numbers.Between(1, 2) : numbers.Below(3));
  rule = HasTwoLargest(made.Loops) ? DomainRule::Union : rule;
  const ChainKind ofLines =
    rule == DomainRule::EvenOdd ? ChainKind::Boundary : ChainKind::Automatic;
  const bool areFaces = !areSegments && numbers.OneIn(2);
  made.Case.Input = DrawingOf(made.Loops, areSegments, areFaces ? ChainKind::Face : ofLines);
  made.Case.Options.Domain.Rule = rule;
  made.Case.Options.Spacing.Uniform = numbers.Power(-4, 0);
  return made;
}

FuzzOutcome RunRuleCase(const RuleCase& ruleCase)
{
  FuzzOutcome outcome;
  const FuzzRun run = Run(ruleCase.Case);
  const Id outer = LargestOf(ruleCase.Loops);
  const double wanted = AreaBy(ruleCase.Loops, ruleCase.Case.Options.Domain.Rule, outer);
  if (run.Problems.HasErrors())
  {
    outcome.Violation = wanted > NearlyNothing ? "refused, with an area of its own" : "";
    outcome.Kind = outcome.Violation.empty() ? Verdict::Refusal : Verdict::Violation;
    return outcome;
  }
  const double area = MeshedArea(run.Mesh);
  outcome.Violation = std::abs(area - wanted) > AreaSlack
    ? "the area is " + std::to_string(area) + " and not " + std::to_string(wanted)
    : CheckParts(ruleCase, outer, run.Mesh);
  const bool isQuiet = run.Problems.Groups().empty();
  outcome.Kind = !outcome.Violation.empty() ? Verdict::Violation
    : isQuiet                               ? Verdict::Mesh
                                            : Verdict::RepairedMesh;
  return outcome;
}

} // namespace biting
