// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSummaryText_h
#define BitingSummaryText_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include <chrono> // for the time
#include <string> // for the text

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Measures the time since it was made.
class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Begin).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Begin = Clock::now();
};

/// A few lines on a mesh with the arrays and figures of our filters: size, time, angles,
/// conformity, thin triangles. Empty where the mesh has no such figures.
std::string SummaryOf(vtkDataSet* mesh, double seconds);

/// Sums over the triangles of a piece of a mesh, without ghosts. Sums of pieces add up;
/// LargestSpacing is a maximum.
struct SummaryCounts
{
  double Triangles = 0.0;
  double SumOfAngles = 0.0; ///< the smallest ones
  double Thin = 0.0;        ///< triangles
  double ThinAtInput = 0.0;
  double LargestSpacing = 0.0;
};

/// All are 0 where the mesh lacks the arrays.
SummaryCounts CountForSummary(vtkDataSet* mesh);

/// The summary of a mesh that `piece` is a piece of, given the sums of all pieces.
std::string SummaryOf(vtkDataSet* piece, const SummaryCounts& counts, double seconds);

/// The numbers of kept, removed and new vertices and of unchanged triangles, in two lines; empty
/// where no remesher made the mesh.
std::string CountsOf(vtkDataSet* mesh);

/// A line that says that Uniform Spacing is above f everywhere, and so without effect; empty where
/// it is not.
std::string UnreachedLine(const SummaryCounts& counts, double uniformSpacing);

} // namespace biting

#endif
