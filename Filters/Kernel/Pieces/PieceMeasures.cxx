// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceMeasures.h"

#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Blocks/ByteStream.h"
#include "../FineDrawing.h"
#include "../Meshing/StageProblems.h"
#include "../Quality/CheckSums.h"
#include "../Quality/MeshCheck.h"
#include "../Quality/NearestNeighbors.h"
#include "../Quality/NearestQueries.h"

#include <algorithm> // for lower_bound, max, min
#include <cmath>     // for abs
#include <cstdint>   // for counts
#include <limits>    // for the infinite
#include <sstream>   // for messages
#include <string>    // for violations
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double CheckEnd = 0.4;
constexpr double NearestEnd = 0.6;
constexpr double AskingEnd = 0.65;

using Bytes = CrewRounds::Bytes;

// A vertex that may have its nearest neighbor in another piece.
struct Suspect
{
  Point2 Place;
  double Distance;
  std::int64_t PointId;
};

// What a member finds by itself.
struct Report
{
  std::vector<char> Violation;
  double DoubledArea = 0.0;
  double AreaMagnitude = 0.0;
  std::vector<Suspect> Suspects;
};

Bytes Pack(const Report& report)
{
  ByteWriter writer;
  writer.Put(report.Violation);
  writer.Put(report.DoubledArea);
  writer.Put(report.AreaMagnitude);
  writer.Put(report.Suspects);
  return std::move(writer.Bytes);
}

Report UnpackReport(const Bytes& bytes)
{
  Report report;
  ByteReader reader(bytes);
  reader.Take(report.Violation);
  reader.Take(report.DoubledArea);
  reader.Take(report.AreaMagnitude);
  reader.Take(report.Suspects);
  return report;
}

class PieceMeasurer
{
public:
  PieceMeasurer(const MeasuredPiece& piece, CrewRounds& rounds, BitingMesh& mesh, ExactSum& density,
    ProblemList& problems, PartOfStage& part)
    : Piece(piece)
    , Rounds(rounds)
    , Mesh(mesh)
    , Density(density)
    , Problems(problems)
    , Part(part)
  {
  }

  bool Measure();

private:
  Report Look();
  std::string Check();
  void AddArea(Report& report);
  std::vector<Suspect> FindSuspects();
  bool CompareReports();
  std::string ViolationOf(const std::vector<Report>& reports) const;
  bool FindNearest();
  std::vector<double> Answer();
  bool AddUp();
  Bytes MeasureOwn();
  bool Refuse(const std::string& violation);

  const MeasuredPiece& Piece;
  CrewRounds& Rounds;
  BitingMesh& Mesh;
  ExactSum& Density;
  ProblemList& Problems;
  PartOfStage& Part;
  std::vector<double> Distances;
  std::vector<Id> SuspectVertices;          ///< its own
  std::vector<Suspect> Suspects;            ///< of all members, one after the other
  std::vector<std::uint64_t> FirstSuspects; ///< of the members
  std::uint64_t OwnFirst = 0;               ///< among them
};

bool PieceMeasurer::Measure()
{
  return this->CompareReports() && this->FindNearest() && this->AddUp();
}

Report PieceMeasurer::Look()
{
  Report report;
  const std::string violation = this->Check();
  report.Violation.assign(violation.begin(), violation.end());
  if (violation.empty())
  {
    this->AddArea(report);
    report.Suspects = this->FindSuspects();
  }
  return report;
}

std::string PieceMeasurer::Check()
{
  PartOfStage checking(this->Part, 0.0, CheckEnd);
  MeshCheckInput input{ this->Mesh.Points, this->Mesh.Corners, this->Mesh.Neighbors,
    this->Piece.Constraints, 1.0, std::numeric_limits<double>::infinity() };
  input.IsDelaunay = true;
  return CheckMesh(input, checking);
}

void PieceMeasurer::AddArea(Report& report)
{
  Pulse pulse(this->Part);
  const BitingMesh& mesh = this->Mesh;
  const TurnSum sum = SumAtOnce(pulse, mesh.Regions.size(), TurnSum(),
    [&mesh](TurnSum& own, std::size_t triangle)
    {
      if (mesh.Piece.Levels[triangle] == 0)
      {
        const Id* corners = mesh.Corners.data() + 3 * triangle;
        own.AddArea(mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]]);
      }
    });
  report.DoubledArea = sum.DoubledArea.Value();
  report.AreaMagnitude = sum.AreaMagnitude;
}

// Of vertices that are handed out.
std::vector<Suspect> PieceMeasurer::FindSuspects()
{
  PartOfStage searching(this->Part, CheckEnd, NearestEnd);
  const BitingMesh& mesh = this->Mesh;
  std::vector<Id> suspects;
  this->Distances =
    NearestNeighborDistances(mesh.Points, mesh.Corners, mesh.Neighbors, searching, &suspects);
  std::vector<std::uint8_t> isWanted(mesh.Points.size(), 0);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    if (mesh.Piece.Levels[slot / 3] <= this->Piece.GhostLevels)
    {
      isWanted[mesh.Corners[slot]] = 1;
    }
  }
  std::vector<Suspect> found;
  for (const Id vertex : searching.HasStopped() ? std::vector<Id>() : suspects)
  {
    if (isWanted[vertex] != 0)
    {
      this->SuspectVertices.push_back(vertex);
      found.push_back(
        { mesh.Points[vertex], this->Distances[vertex], mesh.Piece.PointIds[vertex] });
    }
  }
  return found;
}

// Then all members have all suspects.
bool PieceMeasurer::CompareReports()
{
  const std::vector<Bytes> all = this->Rounds.Gather(Pack(this->Look()), this->Part);
  std::vector<Bytes> replies;
  if (this->Rounds.IsFirst())
  {
    if (this->Part.HasStopped())
    {
      return false;
    }
    std::vector<Report> reports;
    std::vector<Suspect> suspects;
    for (const Bytes& bytes : all)
    {
      this->FirstSuspects.push_back(suspects.size());
      reports.push_back(bytes.empty() ? Report() : UnpackReport(bytes));
      suspects.insert(
        suspects.end(), reports.back().Suspects.begin(), reports.back().Suspects.end());
    }
    const std::string violation = this->ViolationOf(reports);
    if (!violation.empty())
    {
      this->Rounds.Scatter({});
      return this->Refuse(violation);
    }
    for (const std::uint64_t first : this->FirstSuspects)
    {
      ByteWriter writer;
      writer.Put(first);
      writer.Put(suspects);
      replies.push_back(std::move(writer.Bytes));
    }
  }
  const Bytes reply = this->Rounds.Scatter(replies);
  ByteReader reader(reply);
  reader.Take(this->OwnFirst);
  reader.Take(this->Suspects);
  return reader.IsAtEnd();
}

// The rounding of the area is that of MeshCheck.h.
std::string PieceMeasurer::ViolationOf(const std::vector<Report>& reports) const
{
  const Domain& domain = this->Piece.Geometry;
  CompensatedSum doubled;
  double magnitude = 0.0;
  for (const Report& report : reports)
  {
    if (!report.Violation.empty())
    {
      return std::string(report.Violation.begin(), report.Violation.end());
    }
    doubled.Add(report.DoubledArea);
    magnitude += report.AreaMagnitude;
  }
  double length = 0.0;
  double largest = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    length += domain.IsBoundary[segment] != 0 ? Distance(start, end) : 0.0;
    largest =
      std::max({ largest, std::abs(start.X), std::abs(start.Y), std::abs(end.X), std::abs(end.Y) });
  }
  const double area = 0.5 * doubled.Value();
  const double rounding =
    std::numeric_limits<double>::epsilon() * (magnitude + 4.0 * length * largest);
  if (std::abs(area - domain.Area) <= rounding + 1e-12 * std::abs(domain.Area))
  {
    return {};
  }
  std::ostringstream text;
  text.precision(17);
  text << "the area is " << area << " instead of " << domain.Area;
  return text.str();
}

// For its own suspects each member takes the least of what all of them have answered.
bool PieceMeasurer::FindNearest()
{
  ByteWriter own;
  own.Put(this->Answer());
  const std::vector<Bytes> all = this->Rounds.Gather(std::move(own.Bytes), this->Part);
  std::vector<Bytes> replies;
  if (this->Rounds.IsFirst())
  {
    if (this->Part.HasStopped())
    {
      return false;
    }
    std::vector<double> least(this->Suspects.size(), std::numeric_limits<double>::infinity());
    for (const Bytes& bytes : all)
    {
      std::vector<double> answers;
      ByteReader reader(bytes);
      reader.Take(answers);
      for (std::size_t k = 0; k < std::min(least.size(), answers.size()); ++k)
      {
        least[k] = std::min(least[k], answers[k]);
      }
    }
    this->FirstSuspects.push_back(least.size());
    for (std::size_t member = 0; member < all.size(); ++member)
    {
      const auto begin = least.begin();
      ByteWriter writer;
      writer.Put(
        std::vector<double>(begin + static_cast<std::ptrdiff_t>(this->FirstSuspects[member]),
          begin + static_cast<std::ptrdiff_t>(this->FirstSuspects[member + 1])));
      replies.push_back(std::move(writer.Bytes));
    }
  }
  const Bytes reply = this->Rounds.Scatter(replies);
  std::vector<double> least;
  ByteReader reader(reply);
  reader.Take(least);
  for (std::size_t k = 0; k < std::min(least.size(), this->SuspectVertices.size()); ++k)
  {
    double& distance = this->Distances[this->SuspectVertices[k]];
    distance = std::min(distance, least[k]);
  }
  return reader.IsAtEnd();
}

// Of all suspects but its own, which know what is in this piece.
std::vector<double> PieceMeasurer::Answer()
{
  PartOfStage asking(this->Part, NearestEnd, AskingEnd);
  const std::vector<std::int64_t>& ids = this->Mesh.Piece.PointIds;
  std::vector<NearestQuery> queries;
  for (std::size_t k = 0; k < this->Suspects.size(); ++k)
  {
    const Suspect& suspect = this->Suspects[k];
    const bool isOwn = k >= this->OwnFirst && k < this->OwnFirst + this->SuspectVertices.size();
    if (!isOwn)
    {
      const auto place = std::lower_bound(ids.begin(), ids.end(), suspect.PointId);
      const bool isHere = place != ids.end() && *place == suspect.PointId;
      queries.push_back({ suspect.Place, suspect.Distance,
        isHere ? static_cast<Id>(place - ids.begin()) : Id{ NoId } });
    }
  }
  const std::vector<double> found = NearestDistances(this->Mesh.Points, queries, asking);
  std::vector<double> answers(this->Suspects.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  for (std::size_t k = 0; k < answers.size() && !asking.HasStopped(); ++k)
  {
    const bool isOwn = k >= this->OwnFirst && k < this->OwnFirst + this->SuspectVertices.size();
    answers[k] = isOwn ? answers[k] : found[next++];
  }
  return answers;
}

bool PieceMeasurer::AddUp()
{
  const std::vector<Bytes> all = this->Rounds.Gather(this->MeasureOwn(), this->Part);
  std::vector<Bytes> replies;
  if (this->Rounds.IsFirst())
  {
    if (this->Part.HasStopped())
    {
      return false;
    }
    QualitySums sums;
    ExactSum density;
    for (const Bytes& bytes : all)
    {
      QualitySums own;
      ExactSum ownDensity;
      ByteReader reader(bytes);
      reader.Take(own);
      reader.Take(ownDensity);
      if (!bytes.empty())
      {
        sums.Join(own);
        density.Join(ownDensity);
      }
    }
    this->Mesh.Quality.Conclude(sums);
    this->Density = density;
    if (this->Mesh.Quality.SmallestConformity == 0.0)
    {
      this->Rounds.Scatter({});
      return this->Refuse("two vertices are at one place");
    }
    replies = this->Rounds.ForEach(Bytes(1, 1));
  }
  return !this->Rounds.Scatter(replies).empty();
}

Bytes PieceMeasurer::MeasureOwn()
{
  PartOfStage measuring(this->Part, AskingEnd, 1.0);
  Pulse pulse(measuring);
  MeshView view{ this->Mesh.Points, this->Mesh.Spacing, this->Mesh.Corners, this->Mesh.Neighbors };
  view.ForeignVertices = &this->Mesh.Piece.ForeignPoints;
  view.ForeignTriangles = &this->Mesh.Piece.Levels;
  this->Mesh.Quality = MeasureQuality(view, std::move(this->Distances), measuring);
  const ExactSum density =
    this->Piece.CountsAsked ? CountAsked(this->Mesh, this->Piece.F, pulse) : ExactSum();
  ByteWriter writer;
  writer.Put(this->Mesh.Quality.Sums);
  writer.Put(density);
  return std::move(writer.Bytes);
}

bool PieceMeasurer::Refuse(const std::string& violation)
{
  AddProblem(ProblemCode::CheckFailed, violation, this->Problems);
  return false;
}

} // namespace

bool MeasurePieces(const MeasuredPiece& piece, CrewRounds& rounds, BitingMesh& mesh,
  ExactSum& density, ProblemList& problems, PartOfStage& part)
{
  return PieceMeasurer(piece, rounds, mesh, density, problems, part).Measure();
}

} // namespace biting
