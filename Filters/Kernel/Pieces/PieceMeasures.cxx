// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceMeasures.h"

#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Blocks/ByteStream.h"
#include "../Quality/CheckSums.h"
#include "../Quality/MeshCheck.h"
#include "../Stages/FineDrawing.h"
#include "../Stages/StageProblems.h"

#include <algorithm> // for max
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

// Where the check ends, as a share of the time.
constexpr double PieceCheckEnd = 0.5;

using Bytes = CrewRounds::Bytes;

// The check of one piece.
struct Report
{
  std::vector<char> Violation;
  double DoubledArea = 0.0;
  double AreaMagnitude = 0.0;
};

Bytes Pack(const Report& report)
{
  ByteWriter writer;
  writer.Put(report.Violation);
  writer.Put(report.DoubledArea);
  writer.Put(report.AreaMagnitude);
  return std::move(writer.Bytes);
}

Report UnpackReport(const Bytes& bytes)
{
  Report report;
  ByteReader reader(bytes);
  reader.Take(report.Violation);
  reader.Take(report.DoubledArea);
  reader.Take(report.AreaMagnitude);
  return report;
}

class PieceMeasurer
{
public:
  bool Measure() { return this->CompareReports() && this->AddUp(); }

  const MeasuredPiece& Piece;
  CrewRounds& Rounds;
  BitingMesh& Mesh;
  ExactSum& Density;
  ProblemList& Problems;
  PartOfStage& Part;

private:
  Report Look()
  {
    Report report;
    const std::string violation = this->Check();
    report.Violation.assign(violation.begin(), violation.end());
    if (violation.empty())
    {
      this->AddArea(report);
    }
    return report;
  }

  std::string Check()
  {
    PartOfStage checking(this->Part, 0.0, PieceCheckEnd);
    MeshCheckInput input{ this->Mesh.Points, this->Mesh.Corners, this->Mesh.Neighbors,
      this->Piece.Constraints, 1.0, std::numeric_limits<double>::infinity() };
    input.IsDelaunay = true;
    return CheckMesh(input, checking);
  }

  void AddArea(Report& report)
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

  bool CompareReports()
  {
    return this->Rounds.GoOn(Pack(this->Look()), this->Part,
      [this](const std::vector<Bytes>& all)
      {
        std::vector<Report> reports;
        reports.reserve(all.size());
        for (const Bytes& bytes : all)
        {
          reports.push_back(bytes.empty() ? Report() : UnpackReport(bytes));
        }
        const std::string violation = this->ViolationOf(reports);
        if (!violation.empty())
        {
          AddProblem(ProblemCode::CheckFailed, violation, this->Problems);
        }
        return violation.empty();
      });
  }

  // The rounding of the area is that of MeshCheck.h.
  std::string ViolationOf(const std::vector<Report>& reports) const
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
      largest = std::max(
        { largest, std::abs(start.X), std::abs(start.Y), std::abs(end.X), std::abs(end.Y) });
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

  bool AddUp()
  {
    return this->Rounds.GoOn(this->MeasureOwn(), this->Part,
      [this](const std::vector<Bytes>& all)
      {
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
        return true;
      });
  }

  Bytes MeasureOwn()
  {
    PartOfStage measuring(this->Part, PieceCheckEnd, 1.0);
    Pulse pulse(measuring);
    MeshView view{ this->Mesh.Points, this->Mesh.Spacing, this->Mesh.Corners,
      this->Mesh.Neighbors };
    view.ForeignVertices = &this->Mesh.Piece.ForeignPoints;
    view.ForeignTriangles = &this->Mesh.Piece.Levels;
    this->Mesh.Quality = MeasureQuality(view, measuring);
    const ExactSum density =
      this->Piece.CountsAsked ? CountAsked(this->Mesh, this->Piece.F, pulse) : ExactSum();
    ByteWriter writer;
    writer.Put(this->Mesh.Quality.Sums);
    writer.Put(density);
    return std::move(writer.Bytes);
  }
};

} // namespace

bool MeasurePieces(const MeasuredPiece& piece, CrewRounds& rounds, BitingMesh& mesh,
  ExactSum& density, ProblemList& problems, PartOfStage& part)
{
  return PieceMeasurer{ piece, rounds, mesh, density, problems, part }.Measure();
}

} // namespace biting
