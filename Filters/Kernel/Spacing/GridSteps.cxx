// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridSteps.h"

#include "../Base/Numbers.h"

#include <utility> // for move

namespace biting
{
namespace
{

/// A node is offered what others of the line before allow that are nearer along the line than so
/// many times the distance of the lines.
constexpr double ReachAlong = 7.0;

/// No fewer of the line before, and just as many of the two before that one: what is nearer by way
/// of lines in between is offered there.
constexpr std::array<std::size_t, GridSteps::LinesBefore> LeastBeside = { 1, 1, 2 };

/// Where those reach less far than so many times what they should, all that are that near are
/// looked at.
constexpr double ShareOfReach = 2.0 / 3.0;

/// Lines are as far away as the last ones up to that share.
constexpr double RoundingOfDistance = 1e-6;

/// So many nodes are offered something at once.
constexpr std::size_t FewNodes = 8;

} // namespace

GridAxes::GridAxes(const std::vector<double>& nodes, const std::vector<double>& lines)
  : Nodes(nodes)
  , Places(lines)
  , Widths(nodes.size() + 1, 1.0f)
{
  for (std::size_t node = 1; node < nodes.size(); ++node)
  {
    this->Widths[node] = static_cast<float>(nodes[node] - nodes[node - 1]);
  }
  for (std::size_t k = 0; k <= std::min(nodes.size(), MostBesideNode); ++k)
  {
    double least = Infinity;
    for (std::size_t node = k; node < nodes.size(); ++node)
    {
      least = std::min(least, nodes[node] - nodes[node - k]);
    }
    this->LeastReaches.push_back(least);
  }
}

std::size_t GridAxes::Beside(double distance, std::size_t away) const
{
  const double meanWidth =
    (this->Nodes.back() - this->Nodes.front()) / static_cast<double>(this->Nodes.size() - 1);
  const double reach = std::ceil(ReachAlong * distance / meanWidth - RoundingOfDistance);
  return away > 1 || !(reach > 1.0)
    ? LeastBeside[away - 1]
    : std::min(this->Nodes.size(),
        static_cast<std::size_t>(std::min(reach, static_cast<double>(MostBesideNode))));
}

NodeRange GridAxes::FarFrom(double distance) const
{
  const std::size_t beside = this->Beside(distance, 1);
  const double reach = ShareOfReach * ReachAlong * distance;
  const std::size_t size = this->Nodes.size();
  NodeRange far{ size, 0 };
  for (std::size_t k = beside; k < size && this->LeastReaches[beside] < reach; ++k)
  {
    if (this->Nodes[k] - this->Nodes[k - beside] < reach)
    {
      far = { std::min(far.Begin, k - beside), k + 1 };
    }
  }
  return far;
}

NodeRange GridAxes::Around(const NodeRange& nodes, double distance) const
{
  const auto begin = this->Nodes.begin();
  const auto end = this->Nodes.end();
  const double low = this->Nodes[nodes.Begin] - ReachAlong * distance;
  const double high = this->Nodes[nodes.End - 1] + ReachAlong * distance;
  return { static_cast<std::size_t>(std::lower_bound(begin, end, low) - begin),
    static_cast<std::size_t>(std::upper_bound(begin, end, high) - begin) };
}

void GridSteps::Ways::Set(double distance, std::size_t beside)
{
  for (std::size_t k = this->Squares.size(); k < beside; ++k)
  {
    this->AddSquares(k + 1);
  }
  if (std::abs(distance - this->Distance) <= RoundingOfDistance * distance &&
    this->Costs.size() == beside)
  {
    return;
  }
  this->Distance = distance;
  this->Costs.resize(beside);
  const auto square = static_cast<float>(distance * distance);
  for (std::size_t k = 0; k < beside; ++k)
  {
    const std::vector<float>& squares = this->Squares[k];
    this->Costs[k].resize(squares.size());
    for (std::size_t node = 0; node < squares.size(); ++node)
    {
      this->Costs[k][node] = std::sqrt(square + squares[node]);
    }
  }
}

void GridSteps::Ways::Offer(const float* from, float* to) const
{
  for (std::size_t k = 1; k <= this->Costs.size(); ++k)
  {
    const float* cost = this->CostsTo(k);
    const float* left = from - k;
    const float* costLeft = cost - k;
    const float* right = from + k;
    for (std::size_t node = 0; node < this->Nodes.size(); ++node)
    {
      const float least = std::min(left[node] + costLeft[node], right[node] + cost[node]);
      to[node] = std::min(to[node], least);
    }
  }
}

void GridSteps::Ways::AddSquares(std::size_t k)
{
  std::vector<float> squares(this->Nodes.size() + MostBesideNode, 0.0f);
  for (std::size_t node = 0; node + k < this->Nodes.size(); ++node)
  {
    const double along = this->Nodes[node + k] - this->Nodes[node];
    squares[MostBesideNode + node] = static_cast<float>(along * along);
  }
  this->Squares.push_back(std::move(squares));
}

void GridSteps::Step(GridLines& lines, std::size_t from, std::size_t to, std::size_t away)
{
  const double distance = this->Axes.DistanceOf(from, to);
  if (away > 1 && this->Axes.LeastReaches[1] > ReachAlong * distance)
  {
    return; // passes across these lines offer what is between neighbors so far away
  }
  Ways& ways = this->Before[away - 1];
  const NodeRange all{ 0, lines.Size };
  const NodeRange far = away == 1 ? this->Axes.FarFrom(distance) : NodeRange{ 0, 0 };
  const bool areAllFar = far.Begin == all.Begin && far.End == all.End;
  ways.Set(distance, areAllFar ? LeastBeside[0] : this->Axes.Beside(distance, away));
  ways.Offer(lines.At(from), lines.At(to));
  if (away == 1)
  {
    this->OfferBetween(lines.At(from), static_cast<float>(distance), lines.At(to));
  }
  if (far.Begin < far.End)
  {
    this->OfferFar(lines.At(from), static_cast<float>(distance), lines.At(to), far);
  }
}

/// Nothing where the largest value is no more than what grows from the least one.
void GridSteps::OfferFar(const float* from, float distance, float* to, const NodeRange& far)
{
  const NodeRange among = this->Axes.Around(far, distance);
  const float least = *std::min_element(from + among.Begin, from + among.End);
  if (*std::max_element(to + far.Begin, to + far.End) > least + distance)
  {
    this->OfferAll(from, distance, to, far, among);
  }
}

/// What the part `among` of a line allows along a part of another one. As what ways cost is convex,
/// those that are best for two nodes do not cross: so what is best for the middle one divides both
/// parts.
void GridSteps::OfferAll(
  const float* from, float distance, float* to, const NodeRange& nodes, const NodeRange& among)
{
  const float square = distance * distance;
  if (nodes.End - nodes.Begin <= FewNodes)
  {
    for (std::size_t k = among.Begin; k < among.End; ++k)
    {
      const double place = this->Axes.Nodes[k];
      for (std::size_t node = nodes.Begin; node < nodes.End; ++node)
      {
        const auto along = static_cast<float>(this->Axes.Nodes[node] - place);
        to[node] = std::min(to[node], from[k] + std::sqrt(square + along * along));
      }
    }
    return;
  }
  const std::size_t middle = nodes.Begin + (nodes.End - nodes.Begin) / 2;
  const std::size_t best = this->BestOf(from, square, middle, among);
  this->OfferAll(from, distance, to, { nodes.Begin, middle }, { among.Begin, best + 1 });
  this->OfferAll(from, distance, to, { middle, nodes.End }, { best, among.End });
}

/// Which of `among` allows least at a node of the next line.
std::size_t GridSteps::BestOf(
  const float* from, float square, std::size_t node, const NodeRange& among)
{
  const std::size_t count = among.End - among.Begin;
  const double place = this->Axes.Nodes[node];
  const double* places = &this->Axes.Nodes[among.Begin];
  const float* values = from + among.Begin;
  float* offers = this->Offers.data();
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto along = static_cast<float>(places[k] - place);
    offers[k] = values[k] + std::sqrt(square + along * along);
  }
  return among.Begin + static_cast<std::size_t>(std::min_element(offers, offers + count) - offers);
}

/// Along a way at an angle a with the lines' normal, of which the sine is the slope p along the
/// line, what is offered rises by cos a times the distance of the lines. The ways to neighbors
/// are the steepest ones.
void GridSteps::OfferBetween(const float* from, float distance, float* to) const
{
  const float* width = this->Axes.Widths.data();
  const float* toLeft = this->Before[0].ToNext() - 1;
  const float* left = from - 1;
  for (std::size_t node = 0; node < this->Axes.Nodes.size(); ++node)
  {
    const float slopes[2] = {
      std::min(width[node] / toLeft[node], (from[node] - left[node]) / width[node]),
      std::min(width[node + 1] / toLeft[node + 1], (from[node] - left[node + 2]) / width[node + 1])
    };
    const float slope = std::max(std::max(0.0f, slopes[0]), slopes[1]);
    to[node] = std::min(to[node], from[node] + distance * std::sqrt(1.0f - slope * slope));
  }
}

} // namespace biting
