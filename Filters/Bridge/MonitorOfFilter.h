// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMonitorOfFilter_h
#define BitingMonitorOfFilter_h

#include "../Kernel/Base/Monitor.h"
#include "../vtkBitingCompat.h" // for the ABI namespace

#include <chrono> // for the time of the last report

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Shows the kernel's stages as progress text and progress of a filter, and asks the filter whether
/// to stop. Each stage is given an equal share of the progress; it is reported when it has moved by
/// one percent or when a tenth of a second has passed.
class MonitorOfFilter : public Monitor
{
public:
  MonitorOfFilter(vtkAlgorithm* filter, int numberOfStages);

  bool Advance(double fraction) override;
  void BeginStage(const char* text) override;

private:
  using Clock = std::chrono::steady_clock;

  void Report(double progress);

  vtkAlgorithm* Filter;
  int NumberOfStages;
  int Stage = -1;
  double Reported = 0.0;
  Clock::time_point ReportTime;
};

} // namespace biting

#endif
