// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCorpusChecks_h
#define BitingCorpusChecks_h

#include "CorpusCase.h"
#include "CorpusIndex.h"
#include "MeshChecker.h"

#include <algorithm> // for sort, all_of
#include <cmath>     // for isnan
#include <sstream>   // for places
#include <string>    // for verdicts
#include <vector>    // for segments

/// Whether a mesh is that of an input of the corpus.
namespace testing_filters
{

struct Segment
{
  vtkIdType Line;
  biting::Point2 Start;
  biting::Point2 End;
};

inline std::vector<Segment> SegmentsOf(vtkPolyData* input)
{
  std::vector<Segment> segments;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < input->GetNumberOfLines(); ++line)
  {
    input->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType k = 1; k < ids->GetNumberOfIds(); ++k)
    {
      const Place a = PointOf(input, ids->GetId(k - 1));
      const Place b = PointOf(input, ids->GetId(k));
      if (a != b)
      {
        segments.push_back({ line, { a[0], a[1] }, { b[0], b[1] } });
      }
    }
  }
  return segments;
}

inline double DistanceTo(const Segment& segment, const biting::Point2& p)
{
  const biting::Point2 along = segment.End - segment.Start;
  const double share = Dot(p - segment.Start, along) / Dot(along, along);
  const double t = std::min(std::max(share, 0.0), 1.0);
  return Distance(p, segment.Start + t * along);
}

// Whether another segment runs so near that the two cannot be told apart: as boundary they cancel.
inline bool HasTwin(const std::vector<Segment>& segments, const Segment& segment, double rounding)
{
  const biting::Point2 middle = Midpoint(segment.Start, segment.End);
  int near = 0;
  for (const Segment& other : segments)
  {
    near += DistanceTo(other, middle) <= rounding ? 1 : 0;
  }
  return near > 1;
}

// The segment, divided at all ends of other segments that cannot be told from points on it.
inline std::vector<Segment> PartsOf(
  const std::vector<Segment>& segments, const Segment& segment, double rounding)
{
  std::vector<biting::Point2> places{ segment.End };
  for (const Segment& other : segments)
  {
    if (DistanceTo(segment, other.Start) <= rounding)
    {
      places.push_back(other.Start);
    }
  }
  std::sort(places.begin(), places.end(),
    [&segment](const biting::Point2& a, const biting::Point2& b)
    { return Distance(a, segment.Start) < Distance(b, segment.Start); });
  std::vector<Segment> parts;
  biting::Point2 start = segment.Start;
  for (const biting::Point2& place : places)
  {
    if (place != start)
    {
      parts.push_back({ segment.Line, start, place });
    }
    start = place;
  }
  return parts;
}

inline std::string TextOf(const biting::Point2& p)
{
  std::ostringstream text;
  text.precision(17);
  text << '(' << p.X << ", " << p.Y << ')';
  return text.str();
}

// Checks that the lines of the input are unions of edges; interfaces only where none was dropped.
inline std::string CheckLines(vtkPolyData* input, vtkPolyData* first, const MeshChecker& checker)
{
  const bool areInterfacesKept = Figure(first, "DroppedOutsideInterfaces") == 0.0;
  const double rounding = RoundingOf(input);
  const std::vector<Segment> segments = SegmentsOf(input);
  const auto isCovered = [&](const Segment& segment)
  {
    const double tolerance = rounding + 1e-12 * Distance(segment.Start, segment.End);
    return checker.Covers(segment.Start, segment.End, tolerance);
  };
  const auto isCoveredOrCancelled = [&](const Segment& segment)
  { return isCovered(segment) || HasTwin(segments, segment, rounding); };
  for (const Segment& segment : segments)
  {
    const double kind = KindOf(input, input->GetNumberOfVerts() + segment.Line);
    const bool isWanted = kind == 0.0 || (kind == 1.0 && areInterfacesKept);
    if (isWanted && !isCovered(segment))
    {
      const std::vector<Segment> parts = PartsOf(segments, segment, rounding);
      if (!std::all_of(parts.begin(), parts.end(), isCoveredOrCancelled))
      {
        return "the segment of line " + std::to_string(segment.Line) + " from " +
          TextOf(segment.Start) + " to " + TextOf(segment.End) + " is no union of edges";
      }
    }
  }
  return "";
}

inline std::string CheckEmbeddedPoints(
  vtkPolyData* input, vtkPolyData* first, const MeshChecker& checker)
{
  double missing = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfVerts(); ++cell)
  {
    input->GetVerts()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const Place place = PointOf(input, ids->GetId(k));
      missing += checker.HasVertex({ place[0], place[1] }) ? 0.0 : 1.0;
    }
  }
  return missing <= Figure(first, "DroppedOutsidePoints") ? "" : "an embedded point is missing";
}

// Checks the area, up to the rounding of the input's coordinates.
inline std::string CheckArea(const Case& example, const MeshChecker& checker)
{
  const double rounding = PerimeterOf(example.Input) * RoundingOf(example.Input);
  return std::isnan(example.Area) ? ""
                                  : checker.CheckArea(example.Area, 1e-9 * example.Area + rounding);
}

/// Returns the first thing that is wrong with a mesh of an input, empty where nothing is. What the
/// mesher dropped of the input the `first` mesh tells, from which it may have been made.
inline std::string CheckMesh(const Case& example, vtkPolyData* mesh, vtkPolyData* first)
{
  const MeshChecker checker(mesh);
  std::string verdict = checker.CheckValidity();
  verdict = verdict.empty() ? CheckArea(example, checker) : verdict;
  verdict = verdict.empty() ? CheckLines(example.Input, first, checker) : verdict;
  return verdict.empty() ? CheckEmbeddedPoints(example.Input, first, checker) : verdict;
}

inline bool IsFlat(vtkPolyData* input)
{
  double bounds[6];
  input->GetBounds(bounds);
  return bounds[4] == bounds[5];
}

inline Case CaseOf(const CorpusEntry& entry)
{
  return { entry.File, ReadPolyData(SharedInputs() + "/" + entry.File), entry.Spacing, entry.Area };
}

} // namespace testing_filters

#endif
