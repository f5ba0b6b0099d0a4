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

/// A few lines on a mesh with the arrays and the summary of our filters: how large and how good it
/// is, how long it took, and what keeps it from being better. Empty where there is no summary.
std::string SummaryOf(vtkDataSet* mesh, double seconds);

/// What is counted for it, of the pieces of a mesh: without ghosts, to be added up, but for the
/// last one, of which the largest is wanted.
struct SummaryCounts
{
  double Triangles = 0.0;
  double SumOfAngles = 0.0; ///< the smallest ones
  double Thin = 0.0;        ///< triangles
  double ThinAtInput = 0.0;
  double LargestSpacing = 0.0;
};

/// All are 0 where the mesh has not the arrays.
SummaryCounts CountForSummary(vtkDataSet* mesh);

/// The same of a mesh of which this is one piece.
std::string SummaryOf(vtkDataSet* piece, const SummaryCounts& counts, double seconds);

/// What the remesher kept and made, in two lines; empty where it made nothing.
std::string CountsOf(vtkDataSet* mesh);

/// The line that says that a uniform spacing is above what the mesh has everywhere, and so without
/// effect; empty where it is not.
std::string UnreachedLine(const SummaryCounts& counts, double uniformSpacing);

} // namespace biting

#endif
