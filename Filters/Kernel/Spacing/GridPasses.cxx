// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridPasses.h"

#include "../Base/Tasks.h"
#include "GridInterpolator.h"
#include "GridSteps.h"

namespace biting
{
namespace
{

/// From line to line.
bool Go(const GridAxes& along, bool isBack, GridLines& lines, Pulse& pulse)
{
  GridSteps steps(along);
  const auto lineOf = [&lines, isBack](std::size_t step)
  { return isBack ? lines.Count - 1 - step : step; };
  for (std::size_t step = 1; step < lines.Count && pulse.Beat(4 * lines.Size); ++step)
  {
    pulse.SetFraction(static_cast<double>(step) / static_cast<double>(lines.Count));
    for (std::size_t away = 1; away <= std::min(step, GridSteps::LinesBefore); ++away)
    {
      steps.Step(lines, lineOf(step - away), lineOf(step), away);
    }
  }
  return !pulse.HasStopped();
}

/// To all nodes of the lines.
bool Transpose(const float* from, std::size_t fromStride, GridLines& to, Pulse& pulse)
{
  constexpr std::size_t Tile = 16;
  const auto transpose = [=, &to](std::size_t first, std::size_t last)
  {
    const std::size_t end = std::min(last * Tile, to.Count);
    for (std::size_t node = 0; node < to.Size; node += Tile)
    {
      const std::size_t lastNode = std::min(node + Tile, to.Size);
      for (std::size_t line = first * Tile; line < end; ++line)
      {
        for (std::size_t j = node; j < lastNode; ++j)
        {
          to.At(line)[j] = from[j * fromStride + line];
        }
      }
    }
    for (std::size_t line = first * Tile; line < end; ++line)
    {
      to.SetEnds(line);
    }
  };
  return ForRowsAtOnce(pulse, (to.Count + Tile - 1) / Tile, Tile * to.Size, transpose);
}

} // namespace

bool RunGridPasses(const std::vector<double>& columns, const std::vector<double>& rows,
  double gradation, std::vector<float>& values, Pulse& pulse)
{
  const std::vector<double> x = Times(columns, gradation);
  const std::vector<double> y = Times(rows, gradation);
  GridLines byColumn(x.size(), y.size());
  GridLines byRow(y.size(), x.size());
  const auto run = [&pulse](const std::vector<double>& nodes, const std::vector<double>& places,
                     GridLines& lines, double begin)
  {
    const GridAxes along(nodes, places);
    for (const bool isBack : { false, true })
    {
      const PulsePart part(pulse, begin, begin + 0.2);
      if (!Go(along, isBack, lines, pulse))
      {
        return false;
      }
      begin += 0.2;
    }
    return true;
  };
  const auto transpose = [&pulse](
                           const float* from, std::size_t stride, GridLines& to, double begin)
  {
    const PulsePart part(pulse, begin, begin + 0.05);
    return Transpose(from, stride, to, pulse);
  };
  return transpose(values.data(), x.size(), byColumn, 0.0) && run(y, x, byColumn, 0.05) &&
    transpose(byColumn.At(0), byColumn.Stride, byRow, 0.45) && run(x, y, byRow, 0.5) &&
    ForRowsAtOnce(pulse, y.size(), x.size(),
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t row = first; row < last; ++row)
        {
          std::copy_n(byRow.At(row), x.size(), &values[row * x.size()]);
        }
      });
}

} // namespace biting
