// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkBitingSpaceMesherExecution_h
#define vtkBitingSpaceMesherExecution_h

#include "vtkBitingSpaceMesher.h"

#include "Bridge/Drawing/CellTags.h"
#include "Bridge/Drawing/SurfaceFromDrawing.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Kernel/Space/Meshing/SurfaceMesher.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string> // for the summary
#include <vector> // for shares

VTK_ABI_NAMESPACE_BEGIN

// One execution: reads surface and spacing, meshes, writes, and says what is wrong. Methods that
// return a bool return false where nothing is left to do.
class vtkBitingSpaceMesher::Execution : protected biting::FilterRun
{
public:
  /// `shares` of the time: of reading, the three stages of CheckSurface, those of MakeMesh, and
  /// writing. Where no spacing is given it is `defaultSpacing` of the diagonal.
  Execution(vtkBitingSpaceMesher* filter, const std::vector<double>& shares, double defaultSpacing);
  virtual ~Execution() = default;

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& surface, const biting::WholeInput& source,
    vtkInformationVector* outputs);

protected:
  /// Refuses what is wrong with the parameters of the one filter.
  virtual bool ReadOwnParameters() { return true; }

  /// Whether an open surface can be meshed.
  virtual bool TakesOpen() const { return false; }

  /// Makes a mesh of Surface with Options; what is wrong goes to Problems.
  virtual void MakeMesh() = 0;

  /// Fills the outputs but that of problems; returns the mesh in a few lines.
  virtual std::string Write(vtkInformationVector* outputs) = 0;

  biting::Drawing Drawing;
  biting::CheckedSurface Surface;
  biting::SurfaceMesherOptions Options;
  biting::RegionValues Regions; ///< of cells of the drawing; empty without RegionArray

private:
  bool Gather(const biting::WholeInput& surface, const biting::WholeInput& source);
  bool ReadParameters();
  bool ReadSurface();
  bool Check();
  bool ReadRegions();
  bool ReadSpacing();
  bool Mesh();

  vtkBitingSpaceMesher* Filter;
  double DefaultSpacing;
  vtkSmartPointer<vtkDataObject> Source;
  biting::GivenSurface Given;
  biting::SpacingOptions Spacing;
};

VTK_ABI_NAMESPACE_END
#endif
