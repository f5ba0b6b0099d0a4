// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeDivision.h"

#include <algorithm> // for upper_bound, clamp, reverse
#include <cmath>     // for round

namespace biting
{

namespace
{

constexpr double PanelLength = 0.25; // of a part: Simpson's rule on each of its panels
constexpr double LeastPanel = 1e-3;  // of f: where f jumps, a panel is no shorter
constexpr double PanelRatio = 1.5;   // of f at the ends of a panel
constexpr double PartMargin = 1e-9;  // keeps parts shorter than two half-widths after rounding
constexpr double MeetingMargin = 1e-9;
constexpr int GreatestRefinement = 8; // more parts where bites do not meet

} // namespace

EdgeDivider::EdgeDivider(const Spacing& spacing, double bitingConstant, double targetLength,
  Pulse& pulse, double leastPart)
  : F(spacing)
  , BitingConstant(bitingConstant)
  , TargetLength(targetLength)
  , LeastLength(leastPart)
  , Beats(pulse)
{
}

// Edges are divided from their lexicographically smaller end, so that it does not matter which end
// is the start.
bool EdgeDivider::Divide(const Point2& a, const Point2& b, Id limit, DivisionPoints& points)
{
  points.Parameters.clear();
  points.Spacings.clear();
  const bool isReversed = b < a;
  if (isReversed ? !this->DivideForward(b, a, limit, points)
                 : !this->DivideForward(a, b, limit, points))
  {
    return false;
  }
  if (isReversed)
  {
    std::reverse(points.Parameters.begin(), points.Parameters.end());
    std::reverse(points.Spacings.begin(), points.Spacings.end());
    for (double& parameter : points.Parameters)
    {
      parameter = 1.0 - parameter;
    }
  }
  return true;
}

bool EdgeDivider::DivideForward(const Point2& a, const Point2& b, Id limit, DivisionPoints& points)
{
  if (!this->Integrate(a, b, limit) || this->Total / this->TargetLength > limit)
  {
    return false;
  }
  const Id parts = this->NumberOfParts();
  for (int refinement = 0; refinement <= GreatestRefinement; ++refinement)
  {
    this->Place(a, b, parts + refinement, points);
    if (this->Covers(a, b, points))
    {
      break;
    }
  }
  return !this->Beats.HasStopped();
}

// Panels follow f: a quarter of a part each, shorter where f changes fast.
bool EdgeDivider::Integrate(const Point2& a, const Point2& b, Id limit)
{
  const double length = Distance(a, b);
  const auto density = [&](double t) { return length / this->F(a + t * (b - a)); };
  this->Panels.clear();
  this->Total = 0.0;
  double t = 0.0;
  double first = density(0.0);
  while (t < 1.0)
  {
    double step = PanelLength * this->TargetLength / first;
    double last = density(std::min(1.0, t + step));
    while ((last > PanelRatio * first || first > PanelRatio * last) && step * first > LeastPanel)
    {
      step *= 0.5;
      last = density(std::min(1.0, t + step));
    }
    // A remainder of up to half a panel is taken along.
    const double end = t + 1.5 * step >= 1.0 ? 1.0 : t + step;
    last = end == 1.0 ? density(1.0) : last;
    const double middle = density(0.5 * (t + end));
    this->Panels.push_back({ t, end, first, middle, last, this->Total });
    this->Total += (end - t) * (first + 4.0 * middle + last) / 6.0;
    t = end;
    first = last;
    const bool isStuck = this->Panels.back().Start == end;
    if (isStuck || this->Total > this->TargetLength * limit || !this->Beats.Beat())
    {
      return false;
    }
  }
  return true;
}

Id EdgeDivider::NumberOfParts() const
{
  const double least = std::ceil(this->Total / (2.0 * this->BitingConstant) * (1.0 + PartMargin));
  const double greatest = std::floor(this->Total / (this->LeastLength * this->BitingConstant));
  const double wanted = std::round(this->Total / this->TargetLength);
  return static_cast<Id>(std::max(1.0, std::max(least, std::min(wanted, greatest))));
}

void EdgeDivider::Place(const Point2& a, const Point2& b, Id parts, DivisionPoints& points) const
{
  points.Parameters.clear();
  points.Spacings.clear();
  for (Id k = 1; k < parts && this->Beats.Beat(); ++k)
  {
    const double t = this->ParameterAt(this->Total * k / parts);
    points.Parameters.push_back(t);
    points.Spacings.push_back(this->F(a + t * (b - a)));
  }
}

// Newton's method on the integral of the parabola through the panel's three densities.
double EdgeDivider::ParameterAt(double integral) const
{
  auto panel = std::upper_bound(this->Panels.begin(), this->Panels.end(), integral,
    [](double value, const Panel& candidate) { return value < candidate.Before; });
  --panel;
  const double width = panel->End - panel->Start;
  const double slope = -3.0 * panel->First + 4.0 * panel->Middle - panel->Last;
  const double bend = 2.0 * panel->First - 4.0 * panel->Middle + 2.0 * panel->Last;
  const double rest = (integral - panel->Before) / width;
  double s = rest * 6.0 / (panel->First + 4.0 * panel->Middle + panel->Last);
  for (int step = 0; step < 3; ++step)
  {
    const double value = s * (panel->First + s * (slope / 2.0 + s * bend / 3.0));
    s = std::clamp(s - (value - rest) / (panel->First + s * (slope + s * bend)), 0.0, 1.0);
  }
  return panel->Start + s * width;
}

// Whether each two neighbouring bites meet. The bite of an end reaches at least its half-width along
// the edge, whatever its orientation.
bool EdgeDivider::Covers(const Point2& a, const Point2& b, const DivisionPoints& points) const
{
  const double length = Distance(a, b);
  double parameter = 0.0;
  double spacing = this->F(a);
  for (std::size_t k = 0; k <= points.Parameters.size() && this->Beats.Beat(); ++k)
  {
    const bool isLast = k == points.Parameters.size();
    const double nextParameter = isLast ? 1.0 : points.Parameters[k];
    const double nextSpacing = isLast ? this->F(b) : points.Spacings[k];
    const double reach = this->BitingConstant * (spacing + nextSpacing);
    if ((nextParameter - parameter) * length > reach * (1.0 - MeetingMargin))
    {
      return false;
    }
    parameter = nextParameter;
    spacing = nextSpacing;
  }
  return true;
}

} // namespace biting
