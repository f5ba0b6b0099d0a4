// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutLine.h"

#include "../Base/PointOnSegment.h"
#include "../Predicates/Predicates.h"
#include "CutRows.h"

#include <algorithm> // for sort, unique, max_element, min, max, clamp
#include <cmath>     // for abs

namespace biting
{

namespace
{

// In units of f. Ends that near to a vertex are there; shorter stretches are as good as a narrow
// place.
constexpr double Snap = 1.6;
constexpr double LeastStretch = 6.0;
constexpr double Clearance = 2.0;

// Of the angle that a stretch makes with a piece, and by which others near its ends stay off it.
constexpr double CosineOfLeastAngle = 0.76604444311897801; // 40 degrees
constexpr double SineOfLeastAngle = 0.64278760968653925;

// Of an end that is open.
constexpr double OpenReach = 3.0;
constexpr double CosineOfOpenAngle = 0.42261826174069944; // 65 degrees

// How far ends may be moved, the least length of their stretches, both in f, and to how many
// vertices.
constexpr double MoveReach = 4.0;
constexpr double LeastMoved = 20.0;
constexpr std::size_t MostMoves = 8;

double DistanceTo(const Point2& p, const Point2& a, const Point2& b)
{
  const Point2 side = b - a;
  const double t = std::clamp(Dot(p - a, side) / Dot(side, side), 0.0, 1.0);
  return Distance(p, a + t * side);
}

bool HasRoom(const CutStretch& stretch)
{
  const double f = std::max(stretch.From.F, stretch.To.F);
  return Distance(stretch.From.Place, stretch.To.Place) >= LeastStretch * f;
}

bool IsAt(const CutGraph& graph, Id piece, const CutEnd& end)
{
  const auto& ends = graph.Pieces[piece];
  return end.Piece == piece ||
    (end.Vertex != NoId && (ends.Start == end.Vertex || ends.End == end.Vertex));
}

// Between the stretch, which leaves its end in that direction, and what the piece has there.
bool IsOpenAngle(const CutGraph& graph, const CutGraph::Piece& piece, const CutEnd& end,
  const Point2& direction, double cosineOfLeast)
{
  const Point2 along = graph.Vertices[piece.End] - graph.Vertices[piece.Start];
  const double product = Dot(along, direction);
  const double limit = cosineOfLeast * Length(along) * Length(direction);
  if (end.Vertex == NoId)
  {
    return std::abs(product) <= limit;
  }
  return (piece.Start == end.Vertex ? product : -product) <= limit;
}

class LineMaker
{
public:
  LineMaker(const CutScene& scene, const AxisLine& line, CutEffort effort)
    : Scene(scene)
    , Line(line)
    , Effort(effort)
  {
  }

  CutLine Make()
  {
    CutLine line;
    line.IsGood = this->FindEnds() && this->MayBeGood();
    for (std::size_t k = 0; k + 1 < this->Ends.size() && line.IsGood; ++k)
    {
      if (this->IsWanted(this->Ends[k], this->Ends[k + 1]))
      {
        line.IsGood = this->Add({ this->Ends[k], this->Ends[k + 1] }, line);
      }
    }
    line.IsGood = line.IsGood && (this->Effort == CutEffort::AsItIs || !line.Stretches.empty());
    return line;
  }

private:
  double Across(const Point2& p) const
  {
    const Point2 place = this->Scene.Frame.To(p);
    return this->Line.IsVertical ? place.X : place.Y;
  }
  double Along(const Point2& p) const
  {
    const Point2 place = this->Scene.Frame.To(p);
    return this->Line.IsVertical ? place.Y : place.X;
  }
  Point2 PlaceAt(double along) const
  {
    return this->Scene.Frame.From(
      this->Line.IsVertical ? Point2{ this->Line.At, along } : Point2{ along, this->Line.At });
  }
  const Point2& Vertex(Id vertex) const { return this->Scene.Graph.Vertices[vertex]; }

  // False where a piece lies on the line. The margin is four times f at the ends: what is farther
  // away does not matter, unless f grows very fast.
  bool FindEnds()
  {
    const Box2& box = this->Scene.Around;
    const Box2 place = this->Line.Band(0.0, Coordinate(box.Low, !this->Line.IsVertical),
      Coordinate(box.High, !this->Line.IsVertical));
    const bool areOff = this->Scene.AllPieces(place,
      [this](Id piece)
      {
        const auto& ends = this->Scene.Graph.Pieces[piece];
        const double start = this->Across(this->Vertex(ends.Start)) - this->Line.At;
        const double end = this->Across(this->Vertex(ends.End)) - this->Line.At;
        if ((start <= 0.0) != (end <= 0.0))
        {
          this->Ends.push_back(this->MakeEnd(piece));
          this->Margin = std::max(this->Margin, 2.0 * Clearance * this->Ends.back().F);
        }
        return start != 0.0 || end != 0.0;
      });
    std::sort(this->Ends.begin(), this->Ends.end(),
      [](const CutEnd& a, const CutEnd& b)
      { return a.Along != b.Along ? a.Along < b.Along : a.Vertex < b.Vertex; });
    this->Unite();
    return areOff;
  }

  // By the room of its stretches alone, before what is near is looked at: a fringe has short ones.
  bool MayBeGood() const
  {
    const bool mayLeaveOut = this->Effort == CutEffort::MoveEnds;
    for (std::size_t k = 0; k + 1 < this->Ends.size(); ++k)
    {
      const bool hasRoom = HasRoom({ this->Ends[k], this->Ends[k + 1] });
      if (hasRoom == mayLeaveOut && this->IsWanted(this->Ends[k], this->Ends[k + 1]))
      {
        return mayLeaveOut;
      }
    }
    return !mayLeaveOut;
  }

  CutEnd MakeEnd(Id piece) const
  {
    const auto& ends = this->Scene.Graph.Pieces[piece];
    const Point2& a = this->Vertex(ends.Start);
    const Point2& b = this->Vertex(ends.End);
    const double t = (this->Line.At - this->Across(a)) / (this->Across(b) - this->Across(a));
    CutEnd end;
    end.Place = a + t * (b - a);
    end.Along = this->Along(end.Place);
    end.F = this->Scene.F(end.Place);
    const double toStart = Distance(end.Place, a);
    const double toEnd = Distance(end.Place, b);
    if (std::min(toStart, toEnd) < Snap * end.F)
    {
      end.Vertex = toStart <= toEnd ? ends.Start : ends.End;
      end.Place = this->Vertex(end.Vertex);
      return end;
    }
    end.Piece = piece;
    end.Place = PointOnSegment(a, b, t, end.F);
    return end;
  }

  // Pieces that meet in a vertex near the line make one end.
  void Unite()
  {
    std::size_t count = 0;
    for (const CutEnd& end : this->Ends)
    {
      if (count == 0 || end.Vertex == NoId || this->Ends[count - 1].Vertex != end.Vertex)
      {
        this->Ends[count++] = end;
      }
    }
    this->Ends.resize(count);
  }

  bool IsWanted(const CutEnd& from, const CutEnd& to) const
  {
    const double along = 0.5 * (from.Along + to.Along);
    const Box2& box = this->Scene.Box;
    return along >= Coordinate(box.Low, !this->Line.IsVertical) &&
      along <= Coordinate(box.High, !this->Line.IsVertical) &&
      this->Scene.Locator.IsInside(this->PlaceAt(along));
  }

  // False where it is not good.
  bool Add(CutStretch stretch, CutLine& line) const
  {
    if (!this->IsGood(stretch))
    {
      const bool isLeftOut = this->Effort == CutEffort::MoveEnds && !HasRoom(stretch);
      if (isLeftOut || this->Effort == CutEffort::AsItIs || !this->MoveEnds(stretch))
      {
        return isLeftOut;
      }
    }
    stretch.From.IsOpen = this->IsOpen(stretch.From, stretch.To);
    stretch.To.IsOpen = this->IsOpen(stretch.To, stretch.From);
    line.Stretches.push_back(stretch);
    return true;
  }

  // False where there are no good ends.
  bool MoveEnds(CutStretch& stretch) const
  {
    const double f = std::max(stretch.From.F, stretch.To.F);
    if (Distance(stretch.From.Place, stretch.To.Place) < LeastMoved * f)
    {
      return false;
    }
    for (const CutEnd& from : this->EndsNear(stretch.From, stretch.To))
    {
      for (const CutEnd& to : this->EndsNear(stretch.To, stretch.From))
      {
        const CutStretch moved{ from, to };
        if (this->IsGood(moved) && this->Scene.Locator.IsInside(Midpoint(from.Place, to.Place)))
        {
          stretch = moved;
          return true;
        }
      }
    }
    return false;
  }

  // The end itself, and vertices, the nearest first. Of a fringe the nearest are all within it: so
  // the last is the one that stands out most towards the other end.
  std::vector<CutEnd> EndsNear(const CutEnd& end, const CutEnd& other) const
  {
    std::vector<CutEnd> ends{ end };
    const double reach = MoveReach * end.F;
    this->Scene.AllVertices(this->Line.Band(this->Margin, end.Along - reach, end.Along + reach),
      [this, &ends, &end, reach](Id vertex)
      {
        const Point2& place = this->Vertex(vertex);
        if (vertex != end.Vertex && Distance(place, end.Place) <= reach)
        {
          ends.push_back({ place, this->Along(place), vertex, NoId, this->Scene.F(place), false });
        }
        return true;
      });
    std::sort(ends.begin() + 1, ends.end(),
      [&end](const CutEnd& a, const CutEnd& b)
      {
        const double first = Distance(a.Place, end.Place);
        const double second = Distance(b.Place, end.Place);
        return first != second ? first < second : a.Vertex < b.Vertex;
      });
    const auto isSame = [](const CutEnd& a, const CutEnd& b) { return a.Vertex == b.Vertex; };
    ends.erase(std::unique(ends.begin() + 1, ends.end(), isSame), ends.end());
    if (ends.size() > MostMoves)
    {
      const Point2 way = other.Place - end.Place;
      const CutEnd outermost = *std::max_element(ends.begin(), ends.end(),
        [&way](const CutEnd& a, const CutEnd& b) { return Dot(a.Place, way) < Dot(b.Place, way); });
      ends.resize(MostMoves);
      ends.push_back(outermost);
    }
    return ends;
  }

  bool IsGood(const CutStretch& stretch) const
  {
    if (!HasRoom(stretch))
    {
      return false;
    }
    const double from = this->Along(stretch.From.Place);
    const double to = this->Along(stretch.To.Place);
    const double low = std::min(from, to) - this->Margin;
    const double high = std::max(from, to) + this->Margin;
    const Box2 place = this->Line.Band(this->Margin, low, high);
    return this->Scene.AllPieces(
             place, [this, &stretch](Id piece) { return this->IsClearOf(piece, stretch); }) &&
      this->Scene.AllVertices(
        place, [this, &stretch](Id vertex) { return this->IsClearOfVertex(vertex, stretch); });
  }

  bool IsClearOf(Id piece, const CutStretch& stretch) const
  {
    const auto& ends = this->Scene.Graph.Pieces[piece];
    const Point2 direction = stretch.To.Place - stretch.From.Place;
    const bool isAtFrom = IsAt(this->Scene.Graph, piece, stretch.From);
    const bool isAtTo = IsAt(this->Scene.Graph, piece, stretch.To);
    if (isAtFrom || isAtTo)
    {
      const bool isDivided = stretch.From.Piece == piece || stretch.To.Piece == piece;
      return !(isAtFrom && isAtTo) && this->Scene.MayEndOn(ends) &&
        (!isDivided || this->Scene.MayDivide(ends)) &&
        (isAtFrom
            ? IsOpenAngle(this->Scene.Graph, ends, stretch.From, direction, CosineOfLeastAngle)
            : IsOpenAngle(
                this->Scene.Graph, ends, stretch.To, -1.0 * direction, CosineOfLeastAngle));
    }
    return Meet(stretch.From.Place, stretch.To.Place, this->Vertex(ends.Start),
             this->Vertex(ends.End)) == Meeting::None;
  }

  bool IsClearOfVertex(Id vertex, const CutStretch& stretch) const
  {
    if (vertex == stretch.From.Vertex || vertex == stretch.To.Vertex)
    {
      return true;
    }
    const Point2& place = this->Vertex(vertex);
    const double distance = DistanceTo(place, stretch.From.Place, stretch.To.Place);
    const double nearest =
      std::min(Distance(place, stretch.From.Place), Distance(place, stretch.To.Place));
    return distance >= SineOfLeastAngle * nearest || distance >= Clearance * this->Scene.F(place);
  }

  bool IsOpen(const CutEnd& end, const CutEnd& other) const
  {
    const double along = this->Along(end.Place);
    const double reach = OpenReach * end.F;
    return this->Scene.AllPieces(this->Line.Band(this->Margin, along - reach, along + reach),
      [this, &end, &other, reach](Id piece)
      {
        const auto& ends = this->Scene.Graph.Pieces[piece];
        return IsAt(this->Scene.Graph, piece, end)
          ? IsOpenAngle(this->Scene.Graph, ends, end, other.Place - end.Place, CosineOfOpenAngle)
          : DistanceTo(end.Place, this->Vertex(ends.Start), this->Vertex(ends.End)) >= reach;
      });
  }

  const CutScene& Scene;
  const AxisLine& Line;
  CutEffort Effort;
  std::vector<CutEnd> Ends;
  double Margin = 0.0;
};

} // namespace

CutLine MakeCutLine(const CutScene& scene, const AxisLine& line, CutEffort effort)
{
  return LineMaker(scene, line, effort).Make();
}

} // namespace biting
