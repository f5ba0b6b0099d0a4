// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ProblemReport.h"

#include "../Data/ArrayFromVector.h"
#include "../Data/Arrays.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>   // for any_of, remove_if
#include <array>       // for the wordings
#include <numeric>     // for iota
#include <type_traits> // for decay
#include <utility>     // for declval

namespace biting
{

namespace
{

// The words for a kind of problem. FirstId and SecondId say what the ids of the problem number;
// they are empty where it has none.
struct Wording
{
  const char* Kind;
  const char* What;
  const char* FirstId;
  const char* SecondId;
  const char* Advice;
};

// In the order of ProblemCode.
constexpr std::array<Wording, NumberOfProblemKinds + 1> Wordings = { {
  { "DuplicatePoints", "Duplicate points", "point", "point", "They were merged." },
  { "ZeroLengthSegments", "Segments of zero length", "cell", "point", "They were dropped." },
  { "DuplicateSegments", "Duplicate or overlapping segments", "cell", "cell",
    "They were merged; where a boundary is drawn an even number of times, it cancels itself." },
  { "Crossings", "Crossing segments", "cell", "cell", "They were split where they cross." },
  { "Touches", "Points that lie on segments", "cell", "point", "The segments were split there." },
  { "OutsidePoints", "Embedded points outside of the domain", "point", "", "They were dropped." },
  { "OutsideInterfaces", "Interfaces outside of the domain", "cell", "",
    "They were dropped. Where they are to bound the domain, close them; where a Contour ends at "
    "the rim of its input, Clip or IsoVolume give the whole area." },
  { "NoClosedLoop", "There is no closed loop, and so no domain", "open end at point", "",
    "Close the polylines, or mark as Kind 0 what is boundary; where a Contour ends at the rim of "
    "its input, Clip or IsoVolume give the whole area." },
  { "NotFinite", "Coordinates that are not finite", "point", "",
    "Correct or remove these points." },
  { "OutOfRange", "Coordinates that are too large, or too close together, to compute with", "point",
    "", "Scale the input." },
  { "NotPlanar", "The input is not planar; points off the fitted plane", "point", "",
    "Project the input onto a plane." },
  { "BadSpacing", "The spacing cannot be used", "", "", "Spacing is an edge length: positive." },
  { "TooManyVertices", "The mesh would be too large", "", "",
    "Choose a larger spacing, or raise Maximum Number Of Vertices." },
  { "NotResolved", "Segments that cross, touch or overlap, and could not be resolved", "cell",
    "cell", "Correct the input there." },
  { "CheckFailed", "The mesh failed its own check and is withheld", "", "",
    "This is a defect of the mesher: please report it, with the input." },
  { "OverlappingCells", "Cells that lie on top of others", "cell", "",
    "The domain is what an odd number of them covers; with the Domain Rule Union it is all of "
    "them, "
    "the last one on top. Where borders of neighbors are the same but for rounding, as in maps, a "
    "Merge Tolerance makes them one." },
  { "NearPoints", "Points too near to others, or to segments, to be told apart", "point", "point",
    "They were merged." },
  { "NarrowAngles", "Angles below 0.01 degrees between segments", "cell", "cell",
    "Triangles there are as thin." },
  { "RaisedSpacing", "The spacing is below the rounding of the coordinates", "", "",
    "Vertices nearer to each other could not be told apart." },
  { "SmallLoops", "Closed loops smaller than Minimum Loop Size", "cell", "",
    "They were left out." },
  { "FineDrawing", "The drawing is much finer than the spacing", "", "",
    "With a Boundary Tolerance, such as 0.2, the mesh follows the spacing." },
  { "BadTriangles", "Triangles that form no mesh", "cell", "",
    "Correct or remove them; Mesh Conformity shows which are poor." },
  { "FlatTriangles", "Triangles without area", "cell", "",
    "The triangles beside them were divided in their place; at the rim they were left out." },
  { "JoinedEnds", "Open ends that nearly touch others, or a segment", "point", "cell",
    "They were joined with these; with an End Tolerance of 0 they stay." },
  { "OpenOutlines", "Outlines that do not close, and are not among the boundaries",
    "open end at point", "point",
    "Close them, or raise End Tolerance; mark as Kind 1 what bounds nothing." },
  { "NearMisses", "Segments that nearly touch", "cell", "cell",
    "They were left apart: triangles between them are as thin. Where they are meant to meet, join "
    "them." },
  { "ChangedArea", "Boundary Tolerance changed the area of the domain", "", "",
    "It is as wide as what is drawn: a smaller Boundary Tolerance changes the area less." },
  { "NestedCells", "Cells within others", "cell", "",
    "They are holes. With the Domain Rule Union they belong to the domain, as regions of it." },
  { "OpenEdges", "Open edges", "from point", "", "Fill the holes, or close the surface." },
  { "NonManifoldEdges", "Edges of more than two triangles", "cell", "cell",
    "Remove the walls that do not belong to the surface." },
  { "PinchedVertices", "Pinched vertices, where fans of triangles meet", "point", "",
    "Divide the vertex." },
  { "Folds", "Folds, neighbors that lie on each other", "cell", "cell",
    "Unfold them; where walls of bodies lie on each other in part, divide the larger one at the "
    "border of the smaller one." },
  { "SelfCrossings", "Self-crossings", "cell", "cell", "Cut the surface there, or move it apart." },
  { "NotOrientable", "Surfaces with one side only", "cell", "cell", "They bound nothing." },
  { "DuplicateTriangles", "Duplicate triangles", "cell", "cell", "They were left out." },
  { "InconsistentEdges", "Triangles oriented against each other", "cell", "cell",
    "They were turned." },
  { "SurfaceTouches", "Touches within rounding", "cell", "cell", "" },
  { "UnmatchedSides", "Sides that Periodic Translation does not map onto others", "cell", "",
    "Draw both sides alike, or correct the translation." },
  { "TooThin", "Walls too near to each other, or shapes too fine, for the spacing", "cell", "",
    "Choose a smaller spacing there; unite bodies that touch or lie on each other." },
  { "TooSharp", "Faces at too small an angle for the spacing", "cell", "",
    "Choose a smaller spacing there, or a larger Feature Angle." },
  { "LostFeatures", "Features that the mesh cuts off or leaves out", "point", "",
    "They are too fine for the spacing." },
  { "ClosedHoles", "Holes and slits in the surface", "from point", "",
    "They were closed: they are narrower than a third of the spacing there." },
  { "SmallCrossings", "Small crossings and folds of the surface", "cell", "cell",
    "They were cut out and closed: they are smaller than a third of the spacing there." },
  { "UnitedSurfaces", "Closed surfaces that cross or touch", "cell", "cell",
    "The mesh is that of their union." },
  { "Aborted", "Aborted", "", "", "" },
} };

const Wording& WordingOf(ProblemCode code)
{
  return Wordings[static_cast<std::size_t>(code)];
}

// For each point that is not finite, a finite one beside it in a chain; NoId where there is none.
class Neighbors
{
public:
  explicit Neighbors(const PlanarInput& input)
    : Input(input)
    , Beside(input.IsUsed.size(), NoId)
  {
    const Polylines& chains = input.Chains;
    for (Id chain = 0; chain < chains.NumberOfChains(); ++chain)
    {
      const Id first = chains.Offsets[chain];
      const Id last = chains.Offsets[static_cast<std::size_t>(chain) + 1] - 1;
      this->Walk(first, last, 1);
      this->Walk(last, first, -1);
    }
  }

  Id operator[](std::int64_t point) const { return this->Beside[point]; }

private:
  void Walk(Id from, Id to, Id step)
  {
    Id finite = NoId;
    for (Id k = from; k != to + step; k += step)
    {
      const Id point = this->Input.Chains.Connectivity[k];
      const double* place = this->Input.Place(point);
      if (AreFinite(place))
      {
        finite = point;
      }
      else if (this->Beside[point] == NoId)
      {
        this->Beside[point] = finite;
      }
    }
  }

  const PlanarInput& Input;
  std::vector<Id> Beside;
};

std::string IdsText(const Problem& problem, const Wording& wording)
{
  const std::vector<std::int64_t> ids = ShownIdsOf(problem);
  if (ids.empty())
  {
    return problem.Detail;
  }
  const bool hasSecond = ids.size() > 1 && ids[1] >= 0;
  return std::string(wording.FirstId) + ' ' + std::to_string(ids[0]) +
    (hasSecond ? std::string(" with ") + wording.SecondId + ' ' + std::to_string(ids[1]) : "");
}

ProblemPlace PlaceAt(const Problem& problem, const Point3& where)
{
  const Wording& wording = WordingOf(problem.Code);
  const std::vector<std::int64_t> ids = ShownIdsOf(problem);
  const std::string which = IdsText(problem, wording);
  ProblemPlace place;
  place.Kind = problem.Code;
  place.IsError = IsError(problem.Code);
  place.FirstId = ids.empty() ? -1 : ids[0];
  place.SecondId = ids.size() < 2 ? -1 : ids[1];
  place.Place = where;
  place.Message = std::string(wording.What) + (which.empty() ? "" : ": ") + which + " at " +
    PlaceText(where) + (ids.empty() || problem.Detail.empty() ? "" : " (" + problem.Detail + ")");
  return place;
}

void MoveToNeighbors(const PlanarInput& input, std::size_t first, std::vector<ProblemPlace>& places)
{
  const Neighbors neighbors(input);
  for (std::size_t k = first; k < places.size(); ++k)
  {
    const Id neighbor = neighbors[places[k].FirstId];
    if (neighbor != NoId)
    {
      const double* place = input.Place(neighbor);
      places[k].Place = { place[0], place[1], place[2] };
    }
  }
}

void AddGroup(const ProblemGroup& group, const PlanarInput& input, bool isError,
  std::vector<ProblemPlace>& places)
{
  const std::size_t first = places.size();
  for (const Problem& problem : group.First)
  {
    if (!problem.Ids.empty())
    {
      places.push_back(PlaceAt(problem, PlaceInSpace(problem, input)));
      places.back().IsError = isError;
    }
  }
  if (group.Code == ProblemCode::NotFinite)
  {
    MoveToNeighbors(input, first, places);
  }
  const auto end = std::remove_if(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
    [](const ProblemPlace& place) { return !AreFinite(place.Place.Data()); });
  places.erase(end, places.end());
}

void SetPoints(const std::vector<ProblemPlace>& places, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    points->SetPoint(static_cast<vtkIdType>(k), places[k].Place.Data());
  }
  output->SetPoints(points);
  std::vector<Id> vertices(places.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  vtkNew<vtkCellArray> cells;
  SetCells(cells, 1, vertices);
  output->SetVerts(cells);
}

// The array `name` of `member` of each place.
template <typename ArrayType, typename Value>
void AddMember(const std::vector<ProblemPlace>& places, const char* name,
  Value ProblemPlace::*member, vtkFieldData* data)
{
  using Stored = std::decay_t<decltype(std::declval<ArrayType>().GetValue(0))>;
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    array->SetValue(static_cast<vtkIdType>(k), static_cast<Stored>(places[k].*member));
  }
  data->AddArray(array);
}

void AddKinds(const ProblemPlaces& problems, vtkFieldData* data)
{
  vtkNew<vtkStringArray> names;
  names->SetName("ProblemKindNames");
  for (std::size_t kind = 0; kind < NumberOfProblemKinds; ++kind)
  {
    names->InsertNextValue(Wordings[kind].Kind);
  }
  data->AddArray(names);
  const std::vector<std::int64_t> counts(problems.Counts.begin(), problems.Counts.end());
  AddArray<vtkIdTypeArray>(data, "ProblemCounts", counts);
  HideFromChoices(data, "ProblemKindNames");
  HideFromChoices(data, "ProblemCounts");
}

// Which id of the problem is the point of the input where it is; 2 where there is no such point.
std::size_t PointIdOf(ProblemCode code)
{
  const auto isPoint = [](const std::string& word)
  { return word == "point" || word == "open end at point"; };
  const Wording& wording = WordingOf(code);
  return isPoint(wording.FirstId) ? 0 : isPoint(wording.SecondId) ? 1 : 2;
}

// `place` is that of the first.
std::string Occurrences(const ProblemGroup& group, const Wording& wording, const std::string& place)
{
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(group.First.size(), ShownIds); ++k)
  {
    const Problem& problem = group.First[k];
    first.push_back(IdsText(problem, wording));
    if (k == 0)
    {
      first.back() += " near " + place;
      first.back() += problem.Detail.empty() ? "" : " (" + problem.Detail + ")";
    }
  }
  const char* what = group.Code == ProblemCode::NoClosedLoop ? " open ends" : "";
  return " (" + std::to_string(group.Count) + what + "): " + ListText(first, group.Count);
}

// What, how many, which and where.
std::string FactsOf(const ProblemGroup& group, const std::string& place)
{
  const Wording& wording = WordingOf(group.Code);
  const Problem& first = group.First.front();
  if (!ShownIdsOf(first).empty())
  {
    return wording.What + Occurrences(group, wording, place) + ".";
  }
  return wording.What + (first.Detail.empty() ? "" : ": " + first.Detail) +
    (place.empty() ? "" : " near " + place) + ".";
}

std::string FactsOf(const ProblemGroup& group, const PlanarInput& input)
{
  const Problem& first = group.First.front();
  const bool hasPlace = !ShownIdsOf(first).empty() ||
    (first.Code == ProblemCode::NoClosedLoop && !first.Detail.empty());
  return FactsOf(group, hasPlace ? PlaceText(PlaceInSpace(first, input)) : "");
}

} // namespace

void AddPlaces(
  const ProblemList& problems, const PlanarInput& input, RepairPolicy policy, ProblemPlaces& places)
{
  const bool isLeft = policy == RepairPolicy::Left && problems.Has(ProblemCode::NotResolved);
  for (const ProblemGroup& group : problems.Groups())
  {
    // What was left is there already, kind by kind.
    const bool isSaid = isLeft && group.Code == ProblemCode::NotResolved;
    if (group.Code != ProblemCode::Aborted && !isSaid)
    {
      AddGroup(group, input, isLeft || IsError(group.Code), places.Places);
      places.Counts[static_cast<std::size_t>(group.Code)] += group.Count;
    }
  }
}

void AddPlacesInSpace(const ProblemList& problems, ProblemPlaces& places)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::Aborted)
    {
      continue;
    }
    for (const Problem& problem : group.First)
    {
      places.Places.push_back(PlaceAt(problem, problem.Place));
    }
    places.Counts[static_cast<std::size_t>(group.Code)] += group.Count;
  }
}

void ProblemsToPolyData(const ProblemPlaces& problems, vtkPolyData* output)
{
  output->Initialize();
  SetPoints(problems.Places, output);
  vtkPointData* data = output->GetPointData();
  AddMember<vtkUnsignedCharArray>(problems.Places, "ProblemKind", &ProblemPlace::Kind, data);
  AddMember<vtkUnsignedCharArray>(problems.Places, "IsError", &ProblemPlace::IsError, data);
  AddMember<vtkIdTypeArray>(problems.Places, "FirstId", &ProblemPlace::FirstId, data);
  AddMember<vtkIdTypeArray>(problems.Places, "SecondId", &ProblemPlace::SecondId, data);
  AddMember<vtkStringArray>(problems.Places, "Message", &ProblemPlace::Message, data);
  data->SetActiveScalars("ProblemKind");
  AddKinds(problems, output->GetFieldData());
}

std::string MessageFrom(const ProblemGroup& group, const PlanarInput& input)
{
  return FactsOf(group, input) + " " + WordingOf(group.Code).Advice;
}

std::string MessageInSpace(const ProblemGroup& group)
{
  // Of duplicates those with a detail: JoinSharedWalls.
  const bool areWalls = group.Code == ProblemCode::DuplicateTriangles &&
    std::any_of(group.First.begin(), group.First.end(),
      [](const Problem& problem) { return !problem.Detail.empty(); });
  const std::string advice = areWalls
    ? "Walls that two regions have, each its own, were made alike; other triangles were left out."
    : WordingOf(group.Code).Advice;
  const bool hasPlace = group.Code != ProblemCode::TooManyVertices;
  return FactsOf(group, hasPlace ? PlaceText(group.First.front().Place) : "") +
    (advice.empty() ? "" : " ") + advice;
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

std::vector<std::int64_t> ShownIdsOf(const Problem& problem)
{
  const Wording& wording = WordingOf(problem.Code);
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

std::string RefuseWhereNot(const std::function<bool(const double*)>& isGood,
  const std::vector<Id>& points, const double* coordinates, const std::string& what,
  const std::string& advice)
{
  std::vector<std::string> first;
  std::int64_t count = 0;
  for (const Id point : points)
  {
    const double* place = coordinates + 3 * static_cast<std::size_t>(point);
    if (!isGood(place) && ++count <= static_cast<std::int64_t>(ShownIds))
    {
      first.push_back(
        "point " + std::to_string(point) + " at " + PlaceText({ place[0], place[1], place[2] }));
    }
  }
  return count == 0
    ? ""
    : what + " (" + std::to_string(count) + "): " + ListText(first, count) + ". " + advice;
}

std::string PlaceText(const Point3& place)
{
  constexpr int Digits = 12;
  return '(' + Figure(place.X, Digits) + ", " + Figure(place.Y, Digits) + ", " +
    Figure(place.Z, Digits) + ')';
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
