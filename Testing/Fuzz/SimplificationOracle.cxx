// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SimplificationOracle.h"

#include "JudgedMesh.h"
#include "Predicates/Predicates.h"

#include <algorithm> // for max, min, minmax
#include <cmath>     // for isfinite
#include <map>       // for numbers
#include <set>       // for segments
#include <tuple>     // for segments
#include <utility>   // for pair

namespace biting
{

namespace
{

using SpacingFunction = std::function<double(const Point2&)>;

constexpr Id MostSegments = 400; // all are compared with all
constexpr double RoomForRounding = 1.0 + 1e-6;

/// Who is joined to whom.
struct Graph
{
  explicit Graph(const Domain& domain)
    : Segments(domain.Vertices.size())
    , Pieces(domain.Vertices.size())
  {
    for (std::size_t v = 0; v < this->Pieces.size(); ++v)
    {
      this->Pieces[v] = static_cast<Id>(v);
    }
    for (Id s = 0; s < domain.NumberOfSegments(); ++s)
    {
      this->Segments[domain.Starts[s]].push_back(s);
      this->Segments[domain.Ends[s]].push_back(s);
    }
    // Each sweep carries the smallest number of a piece along.
    for (bool changes = true; changes;)
    {
      changes = false;
      for (Id s = 0; s < domain.NumberOfSegments(); ++s)
      {
        Id& a = this->Pieces[domain.Starts[s]];
        Id& b = this->Pieces[domain.Ends[s]];
        changes = changes || a != b;
        a = b = std::min(a, b);
      }
    }
  }

  std::vector<std::vector<Id>> Segments; ///< at each vertex
  std::vector<Id> Pieces;                ///< of each vertex
};

class SimplificationJudge
{
public:
  SimplificationJudge(const Domain& before, const SimplifiedDomain& after,
    const SimplificationOptions& options, const SpacingFunction& spacing)
    : Before(before)
    , After(after.Drawing)
    , Options(options)
    , Spacing(spacing)
    , Whole(before)
    , Images(before.Vertices.size(), NoId)
  {
  }

  std::string Judge()
  {
    for (const auto check : { &SimplificationJudge::JudgeVertices, &SimplificationJudge::JudgeLoops,
           &SimplificationJudge::JudgePaths, &SimplificationJudge::JudgeMeetings,
           &SimplificationJudge::JudgeSides })
    {
      std::string violation = (this->*check)();
      if (!violation.empty())
      {
        return "simplification: " + violation;
      }
    }
    return {};
  }

private:
  /// Lower vertex, higher vertex, whether it bounds.
  using Chord = std::tuple<Id, Id, bool>;

  std::string JudgeVertices();
  std::string JudgeLoops();
  std::string JudgePaths();
  std::string JudgeMeetings();
  std::string JudgeSides();
  std::string WalkPath(Id vertex, Id segment, std::map<Chord, int>& chords);
  bool IsSmallLoop(Id piece) const;
  bool IsOddBefore(const Point2& p, Id piece) const;
  bool IsOddAfter(const Point2& p, Id piece) const;
  static bool IsAbove(const Point2& p, const Point2& a, const Point2& b);

  const Domain& Before;
  const Domain& After;
  const SimplificationOptions& Options;
  const SpacingFunction& Spacing;
  Graph Whole;
  std::vector<Id> Images;    ///< of vertices of the drawing in the result
  std::vector<Id> Originals; ///< of vertices of the result in the drawing
  std::set<Id> LeftOut;      ///< pieces
};

std::string SimplificationJudge::JudgeVertices()
{
  std::map<std::pair<double, double>, Id> numbers;
  for (std::size_t v = 0; v < this->Before.Vertices.size(); ++v)
  {
    const Point2& p = this->Before.Vertices[v];
    numbers[{ p.X, p.Y }] = static_cast<Id>(v);
  }
  for (std::size_t v = 0; v < this->After.Vertices.size(); ++v)
  {
    const Point2& p = this->After.Vertices[v];
    const auto original = numbers.find({ p.X, p.Y });
    if (original == numbers.end() || this->Images[original->second] != NoId)
    {
      return "a vertex that is none of the drawing, or is there twice";
    }
    this->Images[original->second] = static_cast<Id>(v);
    this->Originals.push_back(original->second);
  }
  for (std::size_t v = 0; v < this->Before.Vertices.size(); ++v)
  {
    if (this->Before.HasPoint[v] && this->Images[v] == NoId)
    {
      return "an embedded point is gone";
    }
  }
  return {};
}

std::string SimplificationJudge::JudgeLoops()
{
  std::set<Id> kept;
  for (std::size_t v = 0; v < this->Images.size(); ++v)
  {
    if (this->Images[v] != NoId)
    {
      kept.insert(this->Whole.Pieces[v]);
    }
  }
  for (const Id piece : this->Whole.Pieces)
  {
    if (kept.count(piece) == 0 && this->LeftOut.insert(piece).second && !this->IsSmallLoop(piece))
    {
      return "a piece is gone that is no small loop";
    }
  }
  return {};
}

bool SimplificationJudge::IsSmallLoop(Id piece) const
{
  Box2 bounds;
  bool isLoop = true;
  bool isSmall = true;
  for (std::size_t v = 0; v < this->Whole.Pieces.size(); ++v)
  {
    if (this->Whole.Pieces[v] == piece)
    {
      bounds.Add(this->Before.Vertices[v]);
      isLoop = isLoop && this->Whole.Segments[v].size() == 2;
    }
  }
  const double extent = std::max(bounds.Width(), bounds.Height());
  for (std::size_t v = 0; v < this->Whole.Pieces.size(); ++v)
  {
    isSmall = isSmall &&
      (this->Whole.Pieces[v] != piece ||
        extent <= RoomForRounding * this->Options.MinimumLoopSize *
            this->Spacing(this->Before.Vertices[v]));
  }
  return isLoop && isSmall;
}

std::string SimplificationJudge::JudgePaths()
{
  // Each path is walked from both of its ends.
  std::map<Chord, int> chords;
  for (std::size_t v = 0; v < this->Images.size(); ++v)
  {
    for (const Id segment : this->Whole.Segments[v])
    {
      if (this->Images[v] != NoId)
      {
        std::string violation = this->WalkPath(static_cast<Id>(v), segment, chords);
        if (!violation.empty())
        {
          return violation;
        }
      }
    }
  }
  for (Id s = 0; s < this->After.NumberOfSegments(); ++s)
  {
    const auto [low, high] =
      std::minmax({ this->Originals[this->After.Starts[s]], this->Originals[this->After.Ends[s]] });
    if (chords[{ low, high, this->After.IsBoundary[s] != 0 }] != 2)
    {
      return "a segment that stands for no path, or for several";
    }
    chords.erase({ low, high, this->After.IsBoundary[s] != 0 });
  }
  return chords.empty() ? "" : "a path without a segment";
}

std::string SimplificationJudge::WalkPath(Id vertex, Id segment, std::map<Chord, int>& chords)
{
  const bool isBoundary = this->Before.IsBoundary[segment] != 0;
  std::vector<Id> path;
  const auto otherEnd = [this](Id s, Id v)
  { return this->Before.Starts[s] == v ? this->Before.Ends[s] : this->Before.Starts[s]; };
  Id end = otherEnd(segment, vertex);
  while (this->Images[end] == NoId)
  {
    const std::vector<Id>& around = this->Whole.Segments[end];
    if (around.size() != 2 || path.size() > this->Images.size())
    {
      return "a junction or an end is gone, or all of a loop";
    }
    path.push_back(end);
    segment = around[0] == segment ? around[1] : around[0];
    if ((this->Before.IsBoundary[segment] != 0) != isBoundary)
    {
      return "a vertex between boundary and interface is gone";
    }
    end = otherEnd(segment, end);
  }
  for (const Id between : path)
  {
    const Point2& p = this->Before.Vertices[between];
    const double distance =
      DistanceTo(p, this->Before.Vertices[vertex], this->Before.Vertices[end]);
    if (!(distance <= RoomForRounding * this->Options.Tolerance * this->Spacing(p)))
    {
      return "a vertex is farther away than the tolerance";
    }
  }
  const auto [low, high] = std::minmax({ vertex, end });
  ++chords[{ low, high, isBoundary }];
  return {};
}

std::string SimplificationJudge::JudgeMeetings()
{
  const auto at = [this](Id v) -> const Point2& { return this->After.Vertices[v]; };
  for (Id s = 0; s < this->After.NumberOfSegments(); ++s)
  {
    const Id a = this->After.Starts[s];
    const Id b = this->After.Ends[s];
    for (Id v = 0; v < this->After.NumberOfVertices(); ++v)
    {
      const bool isWithin = v != a && v != b && ExactOrientation(at(a), at(b), at(v)) == 0 &&
        std::min(at(a), at(b)) < at(v) && at(v) < std::max(at(a), at(b));
      if (isWithin)
      {
        return "a vertex lies on a segment";
      }
    }
    for (Id t = 0; t < s; ++t)
    {
      const Id c = this->After.Starts[t];
      const Id d = this->After.Ends[t];
      const bool doCross =
        ExactOrientation(at(a), at(b), at(c)) * ExactOrientation(at(a), at(b), at(d)) < 0 &&
        ExactOrientation(at(c), at(d), at(a)) * ExactOrientation(at(c), at(d), at(b)) < 0;
      if (doCross)
      {
        return "segments cross";
      }
    }
  }
  return {};
}

std::string SimplificationJudge::JudgeSides()
{
  const std::set<Id> pieces(this->Whole.Pieces.begin(), this->Whole.Pieces.end());
  for (const Id piece : pieces)
  {
    for (const Id original : this->Originals)
    {
      const Point2& p = this->Before.Vertices[original];
      const bool isOther = this->Whole.Pieces[original] != piece && this->LeftOut.count(piece) == 0;
      if (isOther && this->IsOddBefore(p, piece) != this->IsOddAfter(p, piece))
      {
        return "a vertex changed the side of a boundary";
      }
    }
  }
  return {};
}

bool SimplificationJudge::IsOddBefore(const Point2& p, Id piece) const
{
  bool isOdd = false;
  for (Id s = 0; s < this->Before.NumberOfSegments(); ++s)
  {
    if (this->Before.IsBoundary[s] && this->Whole.Pieces[this->Before.Starts[s]] == piece)
    {
      isOdd ^= IsAbove(p, this->Before.Vertices[this->Before.Starts[s]],
        this->Before.Vertices[this->Before.Ends[s]]);
    }
  }
  return isOdd;
}

bool SimplificationJudge::IsOddAfter(const Point2& p, Id piece) const
{
  bool isOdd = false;
  for (Id s = 0; s < this->After.NumberOfSegments(); ++s)
  {
    const Id start = this->After.Starts[s];
    if (this->After.IsBoundary[s] && this->Whole.Pieces[this->Originals[start]] == piece)
    {
      isOdd ^= IsAbove(p, this->After.Vertices[start], this->After.Vertices[this->After.Ends[s]]);
    }
  }
  return isOdd;
}

/// Whether the upright line through the place meets the segment above it.
bool SimplificationJudge::IsAbove(const Point2& p, const Point2& a, const Point2& b)
{
  const bool spans = (a.X <= p.X) != (b.X <= p.X);
  return spans && ExactOrientation(a.X < b.X ? a : b, a.X < b.X ? b : a, p) < 0;
}

SimplificationOptions WantedOf(const FuzzCase& fuzzCase)
{
  SimplificationOptions wanted = fuzzCase.Options.Simplification;
  wanted.Tolerance = fuzzCase.Options.PreserveBoundary ? 0.0 : wanted.Tolerance;
  return wanted;
}

bool IsUniform(const SpacingOptions& spacing)
{
  return spacing.Uniform > 0.0 && spacing.Scale == 1.0 && spacing.Minimum == 0.0 &&
    spacing.Maximum == 0.0 && spacing.Sources.empty();
}

SpacingFunction SpacingOf(const FuzzCase& fuzzCase, const Domain& domain)
{
  const double uniform = fuzzCase.Options.Spacing.Uniform;
  if (IsUniform(fuzzCase.Options.Spacing) && std::isfinite(uniform))
  {
    constexpr double Greatest = 1e4 * GreatestCoordinate; // f is no larger
    const double length = std::max(std::min(uniform, Greatest), domain.Resolution);
    return [length](const Point2&) { return length; };
  }
  const Box2 box = domain.Bounds;
  const double size = box.Diagonal();
  return [box, size](const Point2& p) { return 0.02 * size + 0.1 * (p.X - box.Low.X); };
}

struct SimplifiedCase
{
  Domain Before;
  SpacingFunction Spacing;
  SimplifiedDomain After;
};

SimplifiedCase SimplifyCase(const FuzzCase& fuzzCase)
{
  SimplifiedCase made;
  ProblemList problems;
  made.Before = MakeDomain(fuzzCase.Input, fuzzCase.Options.Domain, problems, NoMonitor());
  if (!problems.HasErrors() && made.Before.NumberOfSegments() > 0)
  {
    made.Spacing = SpacingOf(fuzzCase, made.Before);
    made.After = Simplify(made.Before, WantedOf(fuzzCase), made.Spacing, problems, NoMonitor());
  }
  return made;
}

} // namespace

std::string FindSimplificationViolation(const Domain& before, const SimplifiedDomain& after,
  const SimplificationOptions& options, const SpacingFunction& spacing)
{
  return before.NumberOfSegments() > MostSegments
    ? ""
    : SimplificationJudge(before, after, options, spacing).Judge();
}

std::string JudgeSimplification(const FuzzCase& fuzzCase)
{
  const SimplificationOptions wanted = WantedOf(fuzzCase);
  const SimplifiedCase made = wanted.IsAsked() ? SimplifyCase(fuzzCase) : SimplifiedCase();
  return made.Spacing ? FindSimplificationViolation(made.Before, made.After, wanted, made.Spacing)
                      : "";
}

bool ReadSimplified(const FuzzCase& fuzzCase, Polylines& lines)
{
  const SimplifiedCase made = SimplifyCase(fuzzCase);
  const Domain& drawing = made.After.Drawing;
  lines = Polylines();
  lines.Points = fuzzCase.Input.Points;
  const auto add = [&lines](std::initializer_list<Id> points, ChainKind kind, Id cell)
  {
    lines.Connectivity.insert(lines.Connectivity.end(), points);
    lines.Offsets.push_back(static_cast<Id>(lines.Connectivity.size()));
    lines.Kinds.push_back(kind);
    lines.Cells.push_back(cell);
  };
  for (Id s = 0; s < drawing.NumberOfSegments(); ++s)
  {
    const Id start = drawing.VertexPoints[drawing.Starts[s]];
    const Id end = drawing.VertexPoints[drawing.Ends[s]];
    add({ std::max(start, 0), std::max(end, 0) },
      drawing.IsBoundary[s] ? ChainKind::Boundary : ChainKind::Interface, drawing.Cells[s]);
  }
  bool isKnown = IsUniform(fuzzCase.Options.Spacing) && drawing.NumberOfSegments() > 0;
  for (Id v = 0; v < drawing.NumberOfVertices(); ++v)
  {
    isKnown = isKnown && drawing.VertexPoints[v] != NoId;
    if (isKnown && drawing.HasPoint[v])
    {
      add({ drawing.VertexPoints[v] }, ChainKind::EmbeddedPoint, 0);
    }
  }
  return isKnown;
}

} // namespace biting
