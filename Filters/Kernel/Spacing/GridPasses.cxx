// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridPasses.h"

#include "../Base/Tasks.h"
#include "GridStrip.h"

#include <atomic> // for what strips wait for
#include <thread> // for waiting

namespace biting
{
namespace
{

/// Parts of lines that are done at once are at least that wide, and there are up to so many a
/// thread.
constexpr std::size_t LeastPart = 8 * MostBesideNode;
constexpr std::size_t PartsPerThread = 4;

/// From line to line, in both directions.
///
/// On several threads lines are cut into parts. Of some lines at a time, a band, each part is done
/// but for what the nodes of other parts reach: it becomes narrower from line to line. Then what is
/// left between two parts is done. So each node sees what it would on one thread.
class Pass
{
public:
  Pass(const std::vector<double>& nodes, const std::vector<double>& lines, int threads)
    : Along(nodes, lines)
    , Parts(PartsOf(this->Along, threads))
  {
    for (std::size_t part = 0; part < this->Parts; ++part)
    {
      this->Strips.emplace_back(this->Along, NodeRange{ this->Cut(part), this->Cut(part + 1) });
    }
    for (std::size_t cut = 1; cut < this->Parts; ++cut)
    {
      this->Strips.emplace_back(this->Along,
        NodeRange{
          this->Cut(cut) - this->LargestMargin(), this->Cut(cut) + this->LargestMargin() });
    }
  }

  bool Run(GridLines& lines, Pulse& pulse)
  {
    return this->Go(lines, false, pulse, 0.0) && this->Go(lines, true, pulse, 0.5);
  }

private:
  /// In a band, what the parts are narrower by on each side, line by line.
  struct Band
  {
    std::size_t FirstStep;
    std::vector<std::size_t> Margins;
  };

  static std::size_t PartsOf(const GridAxes& along, int threads)
  {
    const std::size_t size = along.Nodes.size();
    const std::size_t most = PartsPerThread * static_cast<std::size_t>(threads);
    return threads == 1 || size * along.Places.size() <= StepsPerTask || along.HasFarLines()
      ? 1
      : std::max<std::size_t>(std::min(size / LeastPart, most), 1);
  }

  std::size_t Cut(std::size_t part) const { return this->Along.Nodes.size() * part / this->Parts; }

  std::size_t LargestMargin() const { return this->Along.Nodes.size() / this->Parts / 4; }

  bool Go(GridLines& lines, bool isBack, Pulse& pulse, double begin)
  {
    const PulsePart half(pulse, begin, begin + 0.5);
    if (this->Parts == 1)
    {
      for (std::size_t step = 1; step < lines.Count && pulse.Beat(4 * lines.Size); ++step)
      {
        this->Step(this->Strips[0], lines, step, isBack, { 0, lines.Size });
      }
      return !pulse.HasStopped();
    }
    const std::vector<Band> bands = this->MakeBands(lines.Count, isBack);
    const std::size_t strips = this->Strips.size();
    std::vector<std::atomic<std::size_t>> done(strips); // bands of each
    return DoTasks(pulse, bands.size() * strips,
      [&](std::size_t task, Monitor& monitor)
      {
        const std::size_t strip = task % strips;
        if (this->Wait(done, strip, task / strips, monitor))
        {
          this->DoBand(lines, bands[task / strips], isBack, strip);
          done[strip].fetch_add(1, std::memory_order_release);
        }
      });
  }

  std::vector<Band> MakeBands(std::size_t count, bool isBack) const
  {
    std::vector<Band> bands;
    for (std::size_t step = 1; step < count; ++step)
    {
      const double distance =
        this->Along.DistanceOf(LineOf(step, isBack), LineOf(step - 1, isBack));
      const std::size_t margin =
        bands.empty() ? 0 : bands.back().Margins.back() + this->Along.Beside(distance, 1);
      if (bands.empty() || margin > this->LargestMargin())
      {
        bands.push_back({ step, { 0 } });
      }
      else
      {
        bands.back().Margins.push_back(margin);
      }
    }
    return bands;
  }

  /// For the strips beside it, which are a band further after a cut, and before a part.
  bool Wait(const std::vector<std::atomic<std::size_t>>& done, std::size_t strip, std::size_t band,
    Monitor& monitor) const
  {
    const auto isDone = [&done](std::size_t other, std::size_t bands)
    { return done[other].load(std::memory_order_acquire) >= bands; };
    const auto isReady = [this, &isDone, strip, band]
    {
      if (strip >= this->Parts)
      {
        const std::size_t part = strip - this->Parts;
        return isDone(part, band + 1) && isDone(part + 1, band + 1);
      }
      return (strip == 0 || isDone(this->Parts + strip - 1, band)) &&
        (strip + 1 == this->Parts || isDone(this->Parts + strip, band));
    };
    while (!isReady())
    {
      if (!monitor.Advance(0.0))
      {
        return false;
      }
      std::this_thread::yield();
    }
    return true;
  }

  void DoBand(GridLines& lines, const Band& band, bool isBack, std::size_t strip)
  {
    for (std::size_t k = 0; k < band.Margins.size(); ++k)
    {
      this->Step(this->Strips[strip], lines, band.FirstStep + k, isBack,
        this->RangeOf(strip, band.Margins[k]));
    }
  }

  NodeRange RangeOf(std::size_t strip, std::size_t margin) const
  {
    if (strip >= this->Parts)
    {
      const std::size_t cut = this->Cut(strip - this->Parts + 1);
      return { cut - margin, cut + margin };
    }
    return { strip == 0 ? 0 : this->Cut(strip) + margin,
      strip + 1 == this->Parts ? this->Along.Nodes.size() : this->Cut(strip + 1) - margin };
  }

  std::size_t LineOf(std::size_t step, bool isBack) const
  {
    return isBack ? this->Along.Places.size() - 1 - step : step;
  }

  void Step(
    GridStrip& strip, GridLines& lines, std::size_t step, bool isBack, const NodeRange& range) const
  {
    for (std::size_t away = 1; away <= std::min(step, GridStrip::LinesBefore); ++away)
    {
      strip.Step(lines, LineOf(step - away, isBack), LineOf(step, isBack), away, range);
    }
  }

  const GridAxes Along;
  const std::size_t Parts;
  std::vector<GridStrip> Strips; ///< parts, then what lies around the cuts between them
};

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

std::vector<double> Times(std::vector<double> nodes, double factor)
{
  for (double& node : nodes)
  {
    node *= factor;
  }
  return nodes;
}

} // namespace

bool RunGridPasses(const std::vector<double>& columns, const std::vector<double>& rows,
  double gradation, std::vector<float>& values, Pulse& pulse)
{
  const std::vector<double> x = Times(columns, gradation);
  const std::vector<double> y = Times(rows, gradation);
  const int threads = pulse.Threads().NumberOfThreads();
  GridLines byColumn(x.size(), y.size());
  GridLines byRow(y.size(), x.size());
  const auto run = [&pulse, threads](const std::vector<double>& nodes,
                     const std::vector<double>& places, GridLines& lines, double begin)
  {
    const PulsePart part(pulse, begin, begin + 0.4);
    return Pass(nodes, places, threads).Run(lines, pulse);
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
