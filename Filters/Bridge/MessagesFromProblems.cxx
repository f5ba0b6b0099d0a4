// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MessagesFromProblems.h"

#include <algorithm> // for min
#include <sstream>   // for texts

namespace biting
{

namespace
{

// The words for a kind of problem. FirstId and SecondId say what the ids of the problem number;
// they are empty where it has none.
struct Wording
{
  const char* What;
  const char* FirstId;
  const char* SecondId;
  const char* Advice;
};

Wording WordingOfRepair(ProblemCode code)
{
  switch (code)
  {
    case ProblemCode::DuplicatePoints:
      return { "Duplicate points", "point", "point", "They were merged." };
    case ProblemCode::ZeroLengthSegments:
      return { "Segments of zero length", "cell", "point", "They were dropped." };
    case ProblemCode::DuplicateSegments:
      return { "Duplicate or overlapping segments", "cell", "cell",
        "They were merged; where a boundary is drawn an even number of times, it cancels itself." };
    case ProblemCode::Crossings:
      return { "Crossing segments", "cell", "cell", "They were split where they cross." };
    case ProblemCode::Touches:
      return { "Points that lie on segments", "cell", "point", "The segments were split there." };
    case ProblemCode::OverlappingCells:
      return { "Cells that lie on top of others", "cell", "",
        "The domain is what an odd number of them covers. Where borders of neighbors are the same "
        "but for rounding, as in maps, a Merge Tolerance makes them one." };
    case ProblemCode::NearPoints:
      return { "Points too near to others, or to segments, to be told apart", "point", "point",
        "They were merged." };
    case ProblemCode::JoinedEnds:
      return { "Open ends that nearly touch others, or a segment", "point", "cell",
        "They were joined with these; with an End Tolerance of 0 they stay." };
    case ProblemCode::NarrowAngles:
      return { "Angles below 0.01 degrees between segments", "cell", "cell",
        "Triangles there are as thin." };
    case ProblemCode::NearMisses:
      return { "Segments that nearly touch", "cell", "cell",
        "They were left apart: triangles between them are as thin. Where they are meant to meet, "
        "join them." };
    case ProblemCode::RaisedSpacing:
      return { "The spacing is below the rounding of the coordinates", "", "",
        "Vertices nearer to each other could not be told apart." };
    case ProblemCode::FlatTriangles:
      return { "Triangles without area", "cell", "",
        "The triangles beside them were divided in their place; at the rim they were left out." };
    case ProblemCode::ChangedArea:
      return { "Boundary Tolerance changed the area of the domain", "", "",
        "It is as wide as what is drawn: a smaller Boundary Tolerance changes the area less." };
    case ProblemCode::OutsidePoints:
      return { "Embedded points outside of the domain", "point", "", "They were dropped." };
    default:
      return { "Interfaces outside of the domain", "cell", "",
        "They were dropped. Where they are to bound the domain, close them; where a Contour ends "
        "at the rim of its input, Clip or IsoVolume give the whole area." };
  }
}

Wording WordingOfSurface(ProblemCode code)
{
  switch (code)
  {
    case ProblemCode::OpenEdges:
      return { "Open edges", "from point", "", "Fill the holes, or close the surface." };
    case ProblemCode::NonManifoldEdges:
      return { "Edges of more than two triangles", "cell", "cell",
        "Remove the walls that do not belong to the surface." };
    case ProblemCode::PinchedVertices:
      return { "Pinched vertices, where fans of triangles meet", "point", "",
        "Divide the vertex." };
    case ProblemCode::Folds:
      return { "Folds, neighbors that lie on each other", "cell", "cell", "Unfold them." };
    case ProblemCode::SelfCrossings:
      return { "Self-crossings", "cell", "cell", "Cut the surface there, or move it apart." };
    case ProblemCode::NotOrientable:
      return { "Surfaces with one side only", "cell", "cell", "They bound nothing." };
    case ProblemCode::DuplicateTriangles:
      return { "Duplicate triangles", "cell", "cell", "They were left out." };
    case ProblemCode::InconsistentEdges:
      return { "Triangles oriented against each other", "cell", "cell", "They were turned." };
    default:
      return { "Touches within rounding", "cell", "cell", "" };
  }
}

Wording WordingOf(ProblemCode code)
{
  const bool isOfSurface = code >= ProblemCode::OpenEdges && code <= ProblemCode::SurfaceTouches;
  if (isOfSurface)
  {
    return WordingOfSurface(code);
  }
  switch (code)
  {
    case ProblemCode::NoClosedLoop:
      return { "There is no closed loop, and so no domain", "open end at point", "",
        "Close the polylines, or mark as Kind 0 what is boundary; where a Contour ends at the rim "
        "of its input, Clip or IsoVolume give the whole area." };
    case ProblemCode::OpenOutlines:
      return { "Outlines that do not close, and are not among the boundaries", "open end at point",
        "point", "Close them, or raise End Tolerance; mark as Kind 1 what bounds nothing." };
    case ProblemCode::NotFinite:
      return { "Coordinates that are not finite", "point", "", "Correct or remove these points." };
    case ProblemCode::OutOfRange:
      return { "Coordinates that are too large, or too close together, to compute with", "point",
        "", "Scale the input." };
    case ProblemCode::NotPlanar:
      return { "The input is not planar; points off the fitted plane", "point", "",
        "Project the input onto a plane." };
    case ProblemCode::BadSpacing:
      return { "The spacing cannot be used", "", "", "Spacing is an edge length: positive." };
    case ProblemCode::TooManyVertices:
      return { "The mesh would be too large", "", "",
        "Choose a larger spacing, or raise Maximum Number Of Vertices." };
    case ProblemCode::NotResolved:
      return { "Segments that cross, touch or overlap, and could not be resolved", "cell", "cell",
        "Correct the input there." };
    case ProblemCode::CheckFailed:
      return { "The mesh failed its own check and is withheld", "", "",
        "This is a defect of the mesher: please report it, with the input." };
    case ProblemCode::SmallLoops:
      return { "Closed loops smaller than Minimum Loop Size", "cell", "", "They were left out." };
    case ProblemCode::FineDrawing:
      return { "The drawing is much finer than the spacing", "", "",
        "With a Boundary Tolerance, such as 0.2, the mesh follows the spacing." };
    case ProblemCode::BadTriangles:
      return { "Triangles that form no mesh", "cell", "",
        "Correct or remove them; Mesh Conformity shows which are poor." };
    case ProblemCode::Aborted:
      return { "Aborted", "", "", "" };
    default:
      return WordingOfRepair(code);
  }
}

std::string IdsText(const Problem& problem, const Wording& wording)
{
  const std::vector<std::int64_t> ids = ShownIdsOf(problem);
  if (ids.empty())
  {
    return problem.Detail;
  }
  std::ostringstream text;
  text << wording.FirstId << ' ' << ids[0];
  if (ids.size() > 1 && ids[1] >= 0)
  {
    text << " with " << wording.SecondId << ' ' << ids[1];
  }
  return text.str();
}

// Which id of the problem is the point of the input where it is; none where there is no such point.
std::size_t PointIdOf(ProblemCode code)
{
  constexpr std::size_t None = 2;
  switch (code)
  {
    case ProblemCode::DuplicatePoints:
    case ProblemCode::NearPoints:
    case ProblemCode::OutsidePoints:
    case ProblemCode::NoClosedLoop:
    case ProblemCode::OpenOutlines:
    case ProblemCode::JoinedEnds:
    case ProblemCode::NotFinite:
    case ProblemCode::OutOfRange:
    case ProblemCode::NotPlanar:
      return 0;
    case ProblemCode::ZeroLengthSegments:
    case ProblemCode::Touches:
      return 1;
    default:
      return None;
  }
}

std::string Occurrences(const ProblemGroup& group, const Wording& wording, const PlanarInput& input)
{
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(group.First.size(), ShownIds); ++k)
  {
    const Problem& problem = group.First[k];
    first.push_back(IdsText(problem, wording));
    if (k == 0)
    {
      first.back() += " near " + PlaceText(PlaceInSpace(problem, input));
      first.back() += problem.Detail.empty() ? "" : " (" + problem.Detail + ")";
    }
  }
  const char* what = group.Code == ProblemCode::NoClosedLoop ? " open ends" : "";
  return " (" + std::to_string(group.Count) + what + "): " + ListText(first, group.Count);
}

// What, how many, which and where.
std::string FactsOf(const ProblemGroup& group, const PlanarInput& input)
{
  const Wording wording = WordingOf(group.Code);
  const Problem& first = group.First.front();
  if (!ShownIdsOf(first).empty())
  {
    return wording.What + Occurrences(group, wording, input) + ".";
  }
  const bool hasPlace = first.Code == ProblemCode::NoClosedLoop && !first.Detail.empty();
  return wording.What + (first.Detail.empty() ? "" : ": " + first.Detail) +
    (hasPlace ? " near " + PlaceText(PlaceInSpace(first, input)) : "") + ".";
}

} // namespace

std::string MessageFrom(const ProblemGroup& group, const PlanarInput& input)
{
  return FactsOf(group, input) + " " + WordingOf(group.Code).Advice;
}

std::string HeadingOf(const ProblemGroup& group)
{
  return WordingOf(group.Code).What + (" (" + std::to_string(group.Count) + ")");
}

std::string RefusalFrom(
  const ProblemGroup& group, const ProblemList& problems, const PlanarInput& input)
{
  std::string text = MessageFrom(group, input);
  for (const ProblemGroup& other : problems.Groups())
  {
    if (group.Code == ProblemCode::NoClosedLoop && other.Code == ProblemCode::NearPoints)
    {
      text += " " + MessageFrom(other, input);
    }
  }
  return text;
}

std::string NotResolvedMessageFrom(const ProblemList& problems, const PlanarInput& input)
{
  std::string text = "Repair Input is off, and the input is not clean.";
  for (const ProblemGroup& group : problems.Groups())
  {
    if (!IsError(group.Code) || !group.First.front().Detail.empty())
    {
      text += " " + FactsOf(group, input);
    }
  }
  return text + " Correct the input, or turn Repair Input on.";
}

std::string MessageOfPlace(const Problem& problem, const PlanarInput& input)
{
  const Wording wording = WordingOf(problem.Code);
  const bool hasIds = !ShownIdsOf(problem).empty();
  return std::string(wording.What) + ": " + IdsText(problem, wording) + " at " +
    PlaceText(PlaceInSpace(problem, input)) +
    (hasIds && !problem.Detail.empty() ? " (" + problem.Detail + ")" : "");
}

std::string MessageInSpace(const Problem& problem)
{
  const Wording wording = WordingOf(problem.Code);
  return std::string(wording.What) + ": " + IdsText(problem, wording) + " at " +
    PlaceText(problem.Place) + (problem.Detail.empty() ? "" : " (" + problem.Detail + ")");
}

std::vector<std::int64_t> ShownIdsOf(const Problem& problem)
{
  const Wording wording = WordingOf(problem.Code);
  const std::size_t most = *wording.SecondId ? 2 : *wording.FirstId ? 1 : 0;
  std::vector<std::int64_t> ids = problem.Ids;
  ids.resize(std::min(ids.size(), most));
  return ids;
}

Point3 PlaceInSpace(const Problem& problem, const PlanarInput& input)
{
  const std::size_t which = PointIdOf(problem.Code);
  const std::int64_t point = which < problem.Ids.size() ? problem.Ids[which] : NoId;
  if (point >= 0 && point < static_cast<std::int64_t>(input.IsUsed.size()))
  {
    const double* place = input.Place(static_cast<Id>(point));
    return { place[0], place[1], place[2] };
  }
  return input.Frame.ToSpace(InPlane(problem.Place));
}

std::string PlaceText(const Point3& place)
{
  constexpr int Digits = 12;
  std::ostringstream text;
  text.precision(Digits);
  text << '(' << place[0] << ", " << place[1] << ", " << place[2] << ')';
  return text.str();
}

std::string ListText(const std::vector<std::string>& first, std::int64_t count)
{
  std::string text;
  for (const std::string& entry : first)
  {
    text += (text.empty() ? "" : ", ") + entry;
  }
  const std::int64_t more = count - static_cast<std::int64_t>(first.size());
  return more > 0 ? text + ", ... and " + std::to_string(more) + " more" : text;
}

} // namespace biting
