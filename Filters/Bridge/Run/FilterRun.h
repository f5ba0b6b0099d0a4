// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFilterRun_h
#define BitingFilterRun_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Base/Point.h"
#include "../../Kernel/Base/Problem.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingMesh.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../../Kernel/Stages/MeshingStages.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/PlaneFrame.h"
#include "../Ranks/Ranks.h"
#include "../Source/SourceData.h"
#include "MonitorOfFilter.h"
#include "ProblemReport.h"

#include <algorithm>        // for find_if
#include <cmath>            // for isfinite
#include <functional>       // for steps
#include <initializer_list> // for inputs
#include <string>           // for messages
#include <vector>           // for shares

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// What a filter knows of itself while it runs.
struct RunningFilter
{
  vtkAlgorithm* Filter;
  unsigned long* ErrorCode; ///< of it
  std::string* Summary;     ///< null where it has none
  const bool* IsStopping;   ///< whether it was asked to end for good; null where it cannot be
  int NumberOfThreads = 0;
  bool IsSilent = false; ///< it works for another process, which says what is wrong
};

/// The shares of the time of a run: `reading`, those of `stages` in the rest, `writing`.
template <typename Stages>
std::vector<double> SharesOfStages(const Stage& reading, const Stages& stages, const Stage& writing)
{
  std::vector<double> shares{ reading.Share };
  for (const Stage& stage : stages)
  {
    shares.push_back((1.0 - reading.Share - writing.Share) * stage.Share);
  }
  shares.push_back(writing.Share);
  return shares;
}

/// Leaves nothing in them.
void EmptyOutputs(vtkInformationVector* outputs);

/// What a pipeline asks of a filter.
struct PipelineRequest
{
  vtkInformation* Request;
  vtkInformationVector** Inputs;
  vtkInformationVector* Outputs;
};

/// Of each input port.
using WholeInputs = std::vector<WholeInput>;

/// REQUEST_DATA of a filter whose first rank does all of the work, which is `run`: gathers the
/// inputs for it, and shares what comes of it. `errorCode` is that of the filter. Returns 1, also
/// where there was an error: views keep what was before it where that is 0.
int RunOnFirstRank(vtkAlgorithm* filter, unsigned long& errorCode, const PipelineRequest& request,
  const std::function<void(const WholeInputs&)>& run);

/// One execution of a filter: progress, refusals, warnings, and the places of problems.
class FilterRun
{
protected:
  FilterRun(const RunningFilter& filter, std::vector<double> shares);

  /// Calls `run`, which fills the outputs. Where it was aborted, or there is too little memory,
  /// these are empty; where it was asked to end for good, that is an error.
  void Guard(vtkInformationVector* outputs, const std::function<void()>& run,
    const char* noMemory = "There is not enough memory for this mesh. Choose a larger spacing.");

  /// Whether all inputs are complete; else says that they are not.
  bool AcceptComplete(std::initializer_list<const WholeInput*> inputs);

  /// Whether there is no refusal; else says it.
  bool Accept(const std::string& refusal);

  /// Reports an error, in the summary too.
  void Refuse(const std::string& reason);

  /// Reports a warning, in the summary too; nothing where the text is empty.
  void Warn(const std::string& text) const;

  /// An error for each kind of Problems that is one. Whether there is none, nor was before. Without
  /// `planar` they are problems of space.
  bool AcceptProblems(const PlanarInput* planar);

  /// A warning for each kind of repair.
  void WarnOfRepairs(const PlanarInput* planar) const;

  /// The array of `source` that `information` names; warns where there is none.
  SourceData Choose(vtkInformation* information, vtkDataObject* source);

  /// Adds the array of `source`, where there is any, to `spacing`; `information` names it.
  /// `isWanted` as of AddSourceSpacing. Returns a refusal.
  std::string AddSource(vtkInformation* information, vtkDataObject* source, const PlaneFrame& frame,
    const std::function<bool(const Point2&)>& isWanted, SpacingOptions& spacing, Monitor& part);

  /// Also where there is no mesh: the pipeline keeps what a failed execution leaves.
  void WriteProblems(const PlanarInput& planar, RepairPolicy policy, vtkPolyData* output);

  bool WasAborted() const { return this->Progress.HasStopped(); }

  ProblemList Problems;
  ProblemPlaces Places; ///< of what is refused before the kernel sees it
  MonitorOfFilter Progress;
  bool IsRefused = false;

private:
  void Warn(const std::string& text, const std::string& inShort) const;
  void Note(const std::string& line) const;
  void EndWhereStopped();

  RunningFilter Running;
};

/// In REQUEST_INFORMATION: the times of the outputs are those of all inputs, not of the first port
/// alone, as VTK has it. So a filter runs anew where only its spacing source changes with time.
/// Returns 1, as requests do.
int PassTimes(vtkInformationVector** inputs, int numberOfPorts, vtkInformationVector* outputs);

/// Why `value` of the parameter `name` cannot be; empty where it is finite, and 0 or more.
inline std::string CheckAtLeastZero(const char* name, double value)
{
  if (value >= 0.0 && std::isfinite(value))
  {
    return {};
  }
  return std::string(name) + " is " + Figure(value, 6) + "; it must be finite, and 0 or more.";
}

/// The first that is not empty; empty where all are.
inline std::string FirstRefusal(std::initializer_list<std::string> refusals)
{
  const auto first = std::find_if(
    refusals.begin(), refusals.end(), [](const std::string& refusal) { return !refusal.empty(); });
  return first == refusals.end() ? std::string() : *first;
}

/// Of the parameters that mesher and remesher have in common.
inline std::string CheckSpacingParameters(const SpacingOptions& spacing)
{
  const std::string refusal = FirstRefusal({ CheckAtLeastZero("Uniform Spacing", spacing.Uniform),
    CheckAtLeastZero("Spacing Scale", spacing.Scale),
    CheckAtLeastZero("Minimum Spacing", spacing.Minimum),
    CheckAtLeastZero("Maximum Spacing", spacing.Maximum),
    CheckAtLeastZero("Gradation", spacing.Gradation),
    spacing.Scale == 0.0 ? "Spacing Scale is 0; it must be above 0." : "" });
  const bool isCrossed = spacing.Maximum > 0.0 && spacing.Minimum > spacing.Maximum;
  return refusal.empty() && isCrossed ? "Minimum Spacing is above Maximum Spacing." : refusal;
}

inline std::string CheckMergeTolerance(double tolerance)
{
  const std::string refusal = CheckAtLeastZero("Merge Tolerance", tolerance);
  return refusal.empty() && tolerance >= 1.0 ? "Merge Tolerance is " + Figure(tolerance, 6) +
      "; it is relative to the diagonal of the input, and must be below 1."
                                             : refusal;
}

inline std::string CheckMostVertices(std::int64_t most)
{
  return most < 1 ? "Maximum Number Of Vertices is below 1." : "";
}

inline std::string CheckBitingConstant(double constant)
{
  return constant == 0.0 || (constant >= 0.1 && constant <= 1.0) ? ""
                                                                 : "Biting Constant is " +
      Figure(constant, 6) + "; it must be 0 (automatic) or within [0.1, 1].";
}

inline std::string CheckMostBites(std::int64_t most)
{
  return most < -1 ? "Maximum Number Of Bites is below -1; -1 means until the front is empty." : "";
}

/// Of all that the mesher has.
std::string CheckMesherParameters(const BitingMeshOptions& options);

} // namespace biting

#endif
