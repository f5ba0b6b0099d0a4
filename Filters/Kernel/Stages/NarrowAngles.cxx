// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NarrowAngles.h"

#include "../Base/Numbers.h"
#include "../Biting/Spokes.h"

#include <cmath>   // for atan2
#include <sstream> // for angles

namespace biting
{

namespace
{

constexpr double NarrowInDegrees = 0.01;

double AngleInDegrees(const SharpSector& sector)
{
  const Point2& first = sector.First.Direction;
  const Point2& last = sector.Last.Direction;
  return DegreesPerRadian * std::atan2(Cross(first, last), Dot(first, last));
}

std::string AngleText(double degrees)
{
  std::ostringstream text;
  text.precision(2);
  text << degrees << " degrees";
  return text.str();
}

} // namespace

void ReportNarrowAngles(const Domain& domain, ProblemList& problems, Pulse& pulse)
{
  const SpokesOfVertices spokes(domain);
  for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(); ++vertex)
  {
    for (const SharpSector& sector : spokes.SharpSectorsAt(vertex))
    {
      const double degrees = AngleInDegrees(sector);
      if (degrees < NarrowInDegrees)
      {
        problems.Add({ ProblemCode::NarrowAngles,
          { domain.Cells[sector.First.Segment], domain.Cells[sector.Last.Segment] },
          domain.Vertices[vertex], AngleText(degrees) });
      }
    }
  }
}

} // namespace biting
