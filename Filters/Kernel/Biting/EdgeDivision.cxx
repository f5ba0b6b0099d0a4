// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeDivision.h"

#include <algorithm> // for upper_bound, min, max, reverse
#include <cmath>     // for sqrt, ceil, floor, abs

namespace biting
{

namespace
{

constexpr double PanelLength = 0.4;     // of a part: Simpson's rule on each of its panels
constexpr double GreatestJump = 1000.0; // of f between samples, for panels of one length
constexpr double PartMargin = 1e-9;     // keeps parts shorter than two half-widths after rounding
constexpr double MeetingMargin = 1e-9;
constexpr int GreatestRefinement = 8; // more parts where bites do not meet
constexpr int GreatestSteps = 60;     // of Newton's method: halvings at worst
constexpr double SmallestStep = 1e-12;

} // namespace

EdgeDivider::EdgeDivider(const Spacing& spacing, double bitingConstant, double targetLength,
  Pulse& pulse, double leastPart)
  : F(spacing)
  , Samples(spacing)
  , BitingConstant(bitingConstant)
  , TargetLength(targetLength)
  , LeastLength(leastPart)
  , Beats(pulse)
{
}

bool EdgeDivider::Divide(const Point2& a, const Point2& b, Id limit, DivisionPoints& points)
{
  return this->Divide(a, b, {}, limit, points);
}

// Edges are divided from their lexicographically smaller end, so that it does not matter which end
// is the start.
bool EdgeDivider::Divide(
  const Point2& a, const Point2& b, const EndShells& shells, Id limit, DivisionPoints& points)
{
  points.Parameters.clear();
  points.Spacings.clear();
  const bool isReversed = b < a;
  if (isReversed ? !this->DivideForward(b, a, shells.End, shells.Start, limit, points)
                 : !this->DivideForward(a, b, shells.Start, shells.End, limit, points))
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

bool EdgeDivider::DivideForward(const Point2& a, const Point2& b,
  const std::vector<double>& startShells, const std::vector<double>& endShells, Id limit,
  DivisionPoints& points)
{
  this->AskAtEnds(a, b);
  if (!this->Integrate(a, b, limit) || this->Total / this->TargetLength > limit)
  {
    return false;
  }
  this->FitShells(Distance(a, b), startShells, endShells);
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

// Most edges begin where the one before ends.
void EdgeDivider::AskAtEnds(const Point2& a, const Point2& b)
{
  const Ends last = this->AtEnds;
  const auto ask = [this, &last](const Point2& p)
  {
    return last.StartSpacing > 0.0 && p == last.Start ? last.StartSpacing
      : last.EndSpacing > 0.0 && p == last.End        ? last.EndSpacing
                                                      : this->F(p);
  };
  this->AtEnds = { a, b, ask(a), ask(b) };
}

// Takes the shells that leave enough between them.
void EdgeDivider::FitShells(
  double length, const std::vector<double>& startShells, const std::vector<double>& endShells)
{
  this->Before.clear();
  this->Behind.clear();
  for (const double distance : startShells)
  {
    this->Before.push_back(distance / length);
  }
  for (const double distance : endShells)
  {
    this->Behind.push_back(1.0 - distance / length);
  }
  while (true)
  {
    const double before = this->Before.empty() ? 0.0 : this->Before.back();
    const double behind = this->Behind.empty() ? 1.0 : this->Behind.back();
    this->From = before > 0.0 ? this->IntegralAt(before) : 0.0;
    this->To = behind < 1.0 ? this->IntegralAt(behind) : this->Total;
    const bool isEnough = this->To - this->From >= LeastRest * this->TargetLength;
    if (isEnough || (this->Before.empty() && this->Behind.empty()))
    {
      return;
    }
    const bool isStartFarther = before > 1.0 - behind;
    (isStartFarther ? this->Before : this->Behind).pop_back();
  }
}

bool EdgeDivider::Integrate(const Point2& a, const Point2& b, Id limit)
{
  const double length = Distance(a, b);
  this->Panels.clear();
  this->Total = 0.0;
  this->Samples.Begin(a, b, this->AtEnds.StartSpacing, this->AtEnds.EndSpacing);
  EdgeSamples::Sample last = { 0.0, this->AtEnds.StartSpacing };
  while (last.Parameter < 1.0)
  {
    const EdgeSamples::Sample next = this->Samples.Next();
    if (!this->AddStretches(length, last, next, limit))
    {
      return false;
    }
    last = next;
  }
  return true;
}

// Between two samples. Where f jumps, panels as short as the smaller f asks for would be too many:
// there f halves, or doubles, from one stretch of them to the next.
bool EdgeDivider::AddStretches(
  double length, const EdgeSamples::Sample& from, const EdgeSamples::Sample& to, Id limit)
{
  const double growth = to.Spacing - from.Spacing;
  const double low = std::min(from.Spacing, to.Spacing);
  const double high = std::max(from.Spacing, to.Spacing);
  const bool isJump = high > GreatestJump * low;
  const double factor = growth > 0.0 ? 2.0 : 0.5;
  EdgeSamples::Sample last = from;
  for (double f = factor * from.Spacing; isJump && low < f && f < high; f *= factor)
  {
    const double share = (f - from.Spacing) / growth;
    const EdgeSamples::Sample next = { from.Parameter + share * (to.Parameter - from.Parameter),
      f };
    if (next.Parameter > last.Parameter && !this->AddPanels(length, last, next, limit))
    {
      return false;
    }
    last = next;
  }
  return !(last.Parameter < to.Parameter) || this->AddPanels(length, last, to, limit);
}

// f is linear between.
bool EdgeDivider::AddPanels(
  double length, const EdgeSamples::Sample& from, const EdgeSamples::Sample& to, Id limit)
{
  const double width = to.Parameter - from.Parameter;
  const double growth = to.Spacing - from.Spacing;
  const double least = std::min(from.Spacing, to.Spacing);
  const double count = std::ceil(width * length / (PanelLength * this->TargetLength * least));
  double start = from.Parameter;
  double first = length / from.Spacing;
  for (double k = 1.0; k <= count; ++k)
  {
    const double end = k < count ? from.Parameter + k / count * width : to.Parameter;
    const double last = length / (from.Spacing + k / count * growth);
    // As much as keeps the parabola through the three from falling below zero.
    const double middle =
      std::max(length / (from.Spacing + (k - 0.5) / count * growth), 0.25 * (first + last));
    this->Panels.push_back({ start, end, first, middle, last, this->Total });
    this->Total += (end - start) * (first + 4.0 * middle + last) / 6.0;
    start = end;
    first = last;
    if (this->Total > this->TargetLength * limit || !this->Beats.Beat())
    {
      return false;
    }
  }
  return true;
}

// Of what lies between the shells. n parts are nearer to the wanted length, as a ratio, than n + 1
// as long as the whole is at most sqrt(n (n + 1)) wanted lengths.
Id EdgeDivider::NumberOfParts() const
{
  const double whole = this->To - this->From;
  const double least = std::ceil(whole / (2.0 * this->BitingConstant) * (1.0 + PartMargin));
  const double greatest = std::floor(whole / (this->LeastLength * this->BitingConstant));
  const double lengths = whole / this->TargetLength;
  const double wanted = std::ceil(std::sqrt(0.25 + lengths * lengths) - 0.5);
  return static_cast<Id>(std::max(1.0, std::max(least, std::min(wanted, greatest))));
}

void EdgeDivider::Place(const Point2& a, const Point2& b, Id parts, DivisionPoints& points) const
{
  points.Parameters.clear();
  points.Spacings.clear();
  for (const double parameter : this->Before)
  {
    this->PlaceAt(parameter, a, b, points);
  }
  for (Id k = 1; k < parts && this->Beats.Beat(); ++k)
  {
    const double integral = this->From + (this->To - this->From) * k / parts;
    this->PlaceAt(this->ParameterAt(integral), a, b, points);
  }
  for (auto parameter = this->Behind.rbegin(); parameter != this->Behind.rend(); ++parameter)
  {
    this->PlaceAt(*parameter, a, b, points);
  }
}

void EdgeDivider::PlaceAt(
  double parameter, const Point2& a, const Point2& b, DivisionPoints& points) const
{
  points.Parameters.push_back(parameter);
  points.Spacings.push_back(this->F(a + parameter * (b - a)));
}

// Newton's method on the integral of the parabola through the panel's three densities, halving
// where it leaves the bounds.
double EdgeDivider::ParameterAt(double integral) const
{
  auto panel = std::upper_bound(this->Panels.begin(), this->Panels.end(), integral,
    [](double value, const Panel& candidate) { return value < candidate.Before; });
  --panel;
  const double width = panel->End - panel->Start;
  const double slope = -3.0 * panel->First + 4.0 * panel->Middle - panel->Last;
  const double bend = 2.0 * panel->First - 4.0 * panel->Middle + 2.0 * panel->Last;
  const double rest = (integral - panel->Before) / width;
  double low = 0.0;
  double high = 1.0;
  double s = std::min(rest * 6.0 / (panel->First + 4.0 * panel->Middle + panel->Last), 1.0);
  double change = 1.0;
  for (int step = 0; step < GreatestSteps && change > SmallestStep; ++step)
  {
    const double excess = s * (panel->First + s * (slope / 2.0 + s * bend / 3.0)) - rest;
    (excess > 0.0 ? high : low) = s;
    const double next = s - excess / (panel->First + s * (slope + s * bend));
    const double kept = next >= low && next <= high ? next : 0.5 * (low + high);
    change = std::abs(kept - s);
    s = kept;
  }
  return panel->Start + s * width;
}

// The integral of the same parabola.
double EdgeDivider::IntegralAt(double parameter) const
{
  auto panel = std::upper_bound(this->Panels.begin(), this->Panels.end(), parameter,
    [](double value, const Panel& candidate) { return value < candidate.Start; });
  --panel;
  const double width = panel->End - panel->Start;
  const double slope = -3.0 * panel->First + 4.0 * panel->Middle - panel->Last;
  const double bend = 2.0 * panel->First - 4.0 * panel->Middle + 2.0 * panel->Last;
  const double s = (parameter - panel->Start) / width;
  return panel->Before + width * s * (panel->First + s * (slope / 2.0 + s * bend / 3.0));
}

// Whether each two neighbouring bites meet. The bite of an end reaches at least its half-width
// along the edge, whatever its orientation.
bool EdgeDivider::Covers(const Point2& a, const Point2& b, const DivisionPoints& points) const
{
  const double length = Distance(a, b);
  double parameter = 0.0;
  double spacing = this->AtEnds.StartSpacing;
  for (std::size_t k = 0; k <= points.Parameters.size() && this->Beats.Beat(); ++k)
  {
    const bool isLast = k == points.Parameters.size();
    const double nextParameter = isLast ? 1.0 : points.Parameters[k];
    const double nextSpacing = isLast ? this->AtEnds.EndSpacing : points.Spacings[k];
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
