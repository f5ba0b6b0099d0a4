// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearDrawings.h"

#include "FuzzRun.h"
#include "Mover.h"

#include <algorithm> // for find_if, max, min, rotate
#include <cmath>     // for abs, pow
#include <limits>    // for epsilon
#include <string>    // for figures

namespace biting
{

namespace
{

constexpr double LeastAngle = 1.0; // in degrees
constexpr double TrustedArea = 1e-9;

class NearDrawingMaker
{
public:
  explicit NearDrawingMaker(FuzzNumbers& numbers)
    : Numbers(numbers)
    , Spacing(0.02 + 0.28 * numbers.Unit())
    , Gap(this->Spacing * std::pow(10.0, -15.0 + 14.0 * numbers.Unit()))
  {
  }

  NearCase Make();

private:
  void DrawOutline();
  void DrawInterfaces();
  void DrawMap();
  void DrawHoles();
  void Move();
  void RoundToFloats(Places& places);
  Point2 Shift();
  Places Border();
  void Add(const Places& places, ChainKind kind, bool isClosed, Id region = 0);

  FuzzNumbers& Numbers;
  const double Spacing;
  double Gap;
  NearCase Result;
  double Length = 0.0;
};

NearCase NearDrawingMaker::Make()
{
  BitingMeshOptions& options = this->Result.Case.Options;
  options.Spacing.Uniform = this->Spacing;
  options.MaximumNumberOfVertices = 20000;
  switch (this->Numbers.Below(4))
  {
    case 0:
      this->DrawOutline();
      break;
    case 1:
      this->DrawInterfaces();
      break;
    case 2:
      this->DrawMap();
      break;
    default:
      this->DrawHoles();
  }
  this->Result.Slack = 4.0 * this->Gap * this->Length + TrustedArea;
  this->Move();
  return std::move(this->Result);
}

/// About as long as the gap, in any direction.
Point2 NearDrawingMaker::Shift()
{
  const Turn turn = Turn::OfHalfTangent(2.0 * this->Numbers.Unit() - 1.0);
  return turn({ this->Numbers.OneIn(2) ? this->Gap : -this->Gap, 0.0 });
}

void NearDrawingMaker::Add(const Places& places, ChainKind kind, bool isClosed, Id region)
{
  Polylines& input = this->Result.Case.Input;
  const auto first = static_cast<Id>(input.Points.size());
  for (const Point2& place : places)
  {
    this->Length += input.Points.size() > static_cast<std::size_t>(first)
      ? Distance(place, input.Points.back())
      : 0.0;
    input.Connectivity.push_back(static_cast<Id>(input.Points.size()));
    input.Points.push_back(place);
  }
  if (isClosed)
  {
    input.Connectivity.push_back(first);
  }
  input.Cells.push_back(input.NumberOfChains());
  input.Kinds.push_back(kind);
  input.Regions.push_back(region);
  input.Offsets.push_back(static_cast<Id>(input.Connectivity.size()));
}

/// A plate in up to three chains, the ends of which nearly meet.
void NearDrawingMaker::DrawOutline()
{
  Places corners{ { 0, 0 }, { 0.6, 0 }, { 1, 0.3 }, { 1, 1 }, { 0.4, 1 }, { 0, 0.7 } };
  std::rotate(corners.begin(), corners.begin() + this->Numbers.Below(6), corners.end());
  const int chains = this->Numbers.Between(1, 3);
  for (int chain = 0; chain < chains; ++chain)
  {
    Places part;
    for (int k = 6 * chain / chains; k <= 6 * (chain + 1) / chains; ++k)
    {
      part.push_back(corners[static_cast<std::size_t>(k % 6)]);
    }
    part.back() = part.back() + this->Shift();
    this->Add(part, ChainKind::Automatic, false);
  }
  this->Result.Area = 1.0 - 0.5 * 0.4 * 0.3 - 0.5 * 0.4 * 0.3;
  this->Result.MayBeRefused = true;
  if (this->Numbers.OneIn(2))
  {
    this->Add({ { 0.4, 0.4 }, { 0.6, 0.4 }, { 0.5, 0.6 } }, ChainKind::Automatic, true);
    this->Result.Area -= 0.02;
  }
}

/// In a square: to a side, to a corner, or to each other.
void NearDrawingMaker::DrawInterfaces()
{
  this->Add({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, ChainKind::Automatic, true);
  this->Result.Area = 1.0;
  const Point2 middle{ 0.4 + 0.2 * this->Numbers.Unit(), 0.4 + 0.2 * this->Numbers.Unit() };
  const Places ends{ { 0, 0.3 }, { 0, 0 }, { 0.2, 1 }, { 1, 0.55 }, { 1, 0 } };
  for (const Point2& end : ends)
  {
    if (this->Numbers.OneIn(2))
    {
      this->Add({ middle + this->Shift(), end + this->Shift() }, ChainKind::Automatic, false);
    }
  }
}

/// From (0.5, 0) to (0.5, 1), with bends.
Places NearDrawingMaker::Border()
{
  Places border{ { 0.5, 0 } };
  const int count = this->Numbers.Below(6);
  for (int k = 1; k <= count; ++k)
  {
    const double bend = this->Numbers.OneIn(2) ? 0.15 * (this->Numbers.Unit() - 0.5) : 0.0;
    border.push_back({ 0.5 + bend, static_cast<double>(k) / (count + 1) });
  }
  border.push_back({ 0.5, 1 });
  return border;
}

/// Two neighbors whose common border is not the same.
void NearDrawingMaker::DrawMap()
{
  const ChainKind kind = this->Numbers.OneIn(2) ? ChainKind::Automatic : ChainKind::Face;
  const Places border = this->Border();
  Places left{ { 0, 1 }, { 0, 0 } };
  Places right{ { 1, 0 }, { 1, 1 } };
  left.insert(left.end(), border.begin(), border.end());
  const bool isMoved = this->Numbers.OneIn(2); // as a whole
  const Point2 all = this->Shift();
  for (std::size_t k = border.size(); k-- > 0;)
  {
    const bool isEnd = k == 0 || k + 1 == border.size();
    const bool isStraight =
      !isEnd && border[k - 1].X == border[k].X && border[k].X == border[k + 1].X;
    if (isStraight && this->Numbers.OneIn(3))
    {
      continue; // its neighbor has a vertex more
    }
    const Point2 own = this->Numbers.OneIn(4) ? Point2() : this->Shift();
    right.push_back(border[k] + (isMoved ? all : own));
  }
  this->Add(left, kind, true, 0);
  this->Add(right, kind, true, kind == ChainKind::Face ? 1 : 0);
  this->Result.Area = 1.0;
}

/// Beside each other and beside the rim of a square.
void NearDrawingMaker::DrawHoles()
{
  this->Add({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, ChainKind::Automatic, true);
  this->Add({ { 0.2, 0.2 }, { 0.5, 0.2 }, { 0.5, 0.5 } }, ChainKind::Automatic, true);
  this->Result.Area = 1.0 - 0.045;
  if (this->Numbers.OneIn(2))
  {
    const Point2 shift{ this->Gap, 0.0 };
    this->Add({ Point2{ 0.5, 0.3 } + shift, Point2{ 0.8, 0.35 } + shift, { 0.6, 0.7 } },
      ChainKind::Automatic, true);
    this->Result.Area -= 0.5 * (0.3 * 0.4 - 0.1 * 0.05);
  }
  if (this->Numbers.OneIn(2))
  {
    this->Add({ { 0.3, this->Gap }, { 0.6, 0.1 }, { 0.4, 0.15 } }, ChainKind::Automatic, true);
    this->Result.Area -= 0.5 * (0.3 * 0.15 - 0.1 * 0.1);
  }
}

/// By powers of two, so that areas and spacings follow.
void NearDrawingMaker::Move()
{
  Places& places = this->Result.Case.Input.Points;
  double factor = this->Numbers.OneIn(2) ? std::ldexp(1.0, this->Numbers.Between(-20, 20)) : 1.0;
  const bool areFloats = this->Numbers.OneIn(6);
  const bool isFar = this->Numbers.OneIn(3);
  factor = areFloats && isFar ? 4096.0 : factor;
  const Turn turn = Turn::OfHalfTangent(this->Numbers.OneIn(2) ? this->Numbers.Unit() : 0.0);
  const Point2 shift = isFar
    ? (areFloats ? Point2{ 412345.0, 6350123.0 } : factor * Point2{ 1234.5, 98765.25 })
    : Point2();
  for (Point2& place : places)
  {
    place = factor * turn(place) + shift;
  }
  double largest = std::max(std::abs(shift.X), std::abs(shift.Y)) + 2.0 * factor;
  double rounding = largest * std::numeric_limits<double>::epsilon();
  if (areFloats)
  {
    this->RoundToFloats(places);
    rounding = largest * static_cast<double>(std::numeric_limits<float>::epsilon());
  }
  this->Result.Case.Options.Spacing.Uniform *= factor;
  this->Result.Area *= factor * factor;
  this->Result.Slack =
    factor * factor * this->Result.Slack + NoiseInUlp * rounding * factor * this->Length;
}

/// As the bridge reads floats.
void NearDrawingMaker::RoundToFloats(Places& places)
{
  Box2 box;
  for (Point2& place : places)
  {
    place = { static_cast<float>(place.X), static_cast<float>(place.Y) };
    box.Add(place);
  }
  const double extent = std::max(box.Width(), box.Height());
  const auto along = [extent](double low, double high)
  {
    const double largest = std::max({ std::abs(low), std::abs(high), extent });
    return static_cast<double>(std::numeric_limits<float>::epsilon()) *
      (largest + (NoiseInUlp - 1.0) * extent);
  };
  this->Result.Case.Input.Rounding = { along(box.Low.X, box.High.X), along(box.Low.Y, box.High.Y) };
}

double AreaOfMesh(const BitingMesh& mesh)
{
  double area = 0.0;
  for (std::size_t k = 0; k < mesh.Corners.size(); k += 3)
  {
    const Point2& a = mesh.Points[static_cast<std::size_t>(mesh.Corners[k])];
    const Point2& b = mesh.Points[static_cast<std::size_t>(mesh.Corners[k + 1])];
    const Point2& c = mesh.Points[static_cast<std::size_t>(mesh.Corners[k + 2])];
    area += 0.5 * Cross(b - a, c - a);
  }
  return area;
}

/// What the first near miss names; 0 where there is none.
double NamedTolerance(const ProblemList& problems)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    const std::string name = "Merge Tolerance ";
    const std::string& detail = group.First.front().Detail;
    if (group.Code == ProblemCode::NearMisses && detail.find(name) != std::string::npos)
    {
      return std::stod(detail.substr(detail.find(name) + name.size()));
    }
  }
  return 0.0;
}

std::string JudgeNear(const NearCase& nearCase, const FuzzRun& run)
{
  const ProblemList& problems = run.Problems;
  if (problems.HasErrors())
  {
    const bool isMeant = problems.Has(ProblemCode::TooManyVertices) ||
      (nearCase.MayBeRefused && !problems.Has(ProblemCode::CheckFailed));
    const auto groups = problems.Groups();
    const auto error = std::find_if(
      groups.begin(), groups.end(), [](const ProblemGroup& group) { return IsError(group.Code); });
    return isMeant ? ""
                   : "refused, code " + std::to_string(static_cast<int>(error->Code)) + ": " +
        error->First.front().Detail;
  }
  const double area = AreaOfMesh(run.Mesh);
  if (!(std::abs(area - nearCase.Area) <= nearCase.Slack))
  {
    return "the area is " + std::to_string(area / nearCase.Area) + " of what is meant";
  }
  if (run.Mesh.Quality.SmallestAngle < LeastAngle && problems.Groups().empty())
  {
    return "an angle of " + std::to_string(run.Mesh.Quality.SmallestAngle) + " without a word";
  }
  return {};
}

std::string JudgeJoined(const NearCase& nearCase, double tolerance)
{
  FuzzCase joined = nearCase.Case;
  joined.Options.Domain.MergeTolerance = tolerance;
  const FuzzRun run = Run(joined);
  return run.Problems.Has(ProblemCode::NearMisses)
    ? "MergeTolerance " + std::to_string(tolerance) + " leaves near misses"
    : "";
}

} // namespace

NearCase MakeNearCase(FuzzNumbers& numbers)
{
  return NearDrawingMaker(numbers).Make();
}

FuzzOutcome RunNearCase(const NearCase& nearCase)
{
  const FuzzRun run = Run(nearCase.Case);
  std::string violation = JudgeNear(nearCase, run);
  const double tolerance = NamedTolerance(run.Problems);
  if (violation.empty() && tolerance > 0.0)
  {
    violation = JudgeJoined(nearCase, tolerance);
  }
  return { !violation.empty()         ? Verdict::Violation
      : run.Problems.HasErrors()      ? Verdict::Refusal
      : run.Problems.Groups().empty() ? Verdict::Mesh
                                      : Verdict::RepairedMesh,
    violation };
}

} // namespace biting
