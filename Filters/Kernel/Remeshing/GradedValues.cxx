// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GradedValues.h"

#include "../Base/IdLists.h"
#include "../Base/Pulse.h"
#include "../Spacing/SegmentCone.h"

#include <cstdint>    // for flags
#include <functional> // for greater
#include <queue>      // for the order of values
#include <utility>    // for pair, swap

namespace biting
{

namespace
{

constexpr double SlopeTolerance = 1.02; // that of the law of Spacing
constexpr double SlightShare = 0.003;   // less than this is not handed on

class Lowering
{
public:
  Lowering(const OldMesh& mesh, double gradation, std::vector<double>& values, Pulse& pulse)
    : Mesh(mesh)
    , Gradation(gradation)
    , Values(values)
    , Progress(pulse)
  {
  }

  void Run()
  {
    this->FindSteep();
    if (this->Waiting.empty())
    {
      return;
    }
    this->ListSlots();
    while (!this->Waiting.empty() && this->Progress.Beat())
    {
      const auto [value, vertex] = this->Waiting.top();
      this->Waiting.pop();
      if (value == this->Values[vertex])
      {
        this->HandOn(vertex);
      }
    }
  }

private:
  using Entry = std::pair<double, Id>;

  // The lower ends of edges that are.
  void FindSteep()
  {
    std::vector<std::uint8_t> isLow(this->Values.size(), 0);
    this->Progress.ForEach(this->Mesh.Corners.size(),
      [this, &isLow](std::size_t place)
      {
        const Id slot = static_cast<Id>(place);
        const Id a = this->Mesh.Start(slot);
        const Id b = this->Mesh.End(slot);
        const double rise = this->Values[b] - this->Values[a];
        const double most =
          SlopeTolerance * this->Gradation * Distance(this->Mesh.Points[a], this->Mesh.Points[b]);
        isLow[a] |= rise > most;
        isLow[b] |= -rise > most;
      });
    for (std::size_t vertex = 0; vertex < isLow.size(); ++vertex)
    {
      if (isLow[vertex])
      {
        this->Waiting.emplace(this->Values[vertex], static_cast<Id>(vertex));
      }
    }
  }

  void ListSlots()
  {
    // The last slot first: the order in which values are handed on decides in the last digits.
    this->Slots = IdLists(this->Values.size(),
      [this](const auto& add)
      {
        const std::vector<Id>& corners = this->Mesh.Corners;
        this->Progress.ForEach(corners.size(),
          [&corners, &add](std::size_t k)
          {
            const std::size_t slot = corners.size() - 1 - k;
            add(corners[slot], static_cast<Id>(slot));
          });
      });
  }

  void HandOn(Id vertex)
  {
    for (const Id slot : this->Slots[vertex])
    {
      const Id start = this->Mesh.Start(slot);
      const Id end = this->Mesh.End(slot);
      this->Lower(start, vertex, end);
      this->Lower(end, vertex, start);
    }
  }

  // To what the edge allows.
  void Lower(Id vertex, Id start, Id end)
  {
    if (!(this->Values[start] < this->Values[vertex]))
    {
      return;
    }
    const Point2 edge = this->Mesh.Points[end] - this->Mesh.Points[start];
    const Point2 way = this->Mesh.Points[vertex] - this->Mesh.Points[start];
    const double length = Length(edge);
    double along = Dot(way, edge) / length;
    const double across = Cross(edge, way) / length;
    if (this->Values[end] < this->Values[start])
    {
      std::swap(start, end);
      along = length - along;
    }
    SegmentCone cone; // of an edge along the x axis
    cone.SetValues(
      length, this->Values[start], this->Values[end] - this->Values[start], this->Gradation);
    const double value = cone({ along, across }, this->Gradation);
    if (value < (1.0 - SlightShare) * this->Values[vertex])
    {
      this->Values[vertex] = value;
      this->Waiting.emplace(value, vertex);
    }
  }

  const OldMesh& Mesh;
  const double Gradation;
  std::vector<double>& Values;
  Pulse& Progress;
  IdLists Slots; ///< at each vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Waiting;
};

} // namespace

void LowerToGradation(
  const OldMesh& mesh, double gradation, std::vector<double>& values, Monitor& monitor)
{
  Pulse pulse(monitor);
  if (gradation > 0.0)
  {
    Lowering(mesh, gradation, values, pulse).Run();
  }
}

} // namespace biting
