// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkBitingMesherExecution_h
#define vtkBitingMesherExecution_h

#include "vtkBitingMesher.h"

#include "Bridge/Drawing.h"
#include "Bridge/FilterRun.h"
#include "Bridge/PolylinesFromPolyData.h"
#include "Bridge/RankCrew.h"
#include "Bridge/Ranks.h"
#include "Kernel/BitingMesh.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string> // for refusals

VTK_ABI_NAMESPACE_BEGIN

// One execution: reads, meshes, writes, and says what is wrong. Methods return false where nothing
// is left to do.
class vtkBitingMesher::Execution : private biting::FilterRun
{
public:
  Execution(vtkBitingMesher* filter, biting::RankCrew& crew);

  /// On ranks that are not the first: works for that one, where it calls.
  void Help(const biting::WholeInput& drawing, const biting::WholeInput& source);

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& drawing, const biting::WholeInput& source,
    vtkInformationVector* outputs);

  /// Hands out the mesh to all ranks, where it is of blocks: returns whether it has.
  bool Spread(const biting::Ranks& ranks, vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& drawing, const biting::WholeInput& source);
  bool ReadParameters();
  bool ReadChains();
  bool ReadSpacing();
  bool MakeMesh();
  void Write(vtkInformationVector* outputs);
  std::string AddBoundaryArray();
  std::string AddSourceArray();
  bool ReportErrors();
  void ReportNotes() const;
  vtkSmartPointer<vtkPoints> MakePoints(biting::Pulse& pulse) const;
  void WriteMesh(vtkPoints* points, vtkPolyData* output, biting::Pulse& pulse) const;
  void WriteEdges(vtkPoints* points, vtkPolyData* output, biting::Pulse& pulse) const;

  vtkBitingMesher* Filter;
  biting::RankCrew& Crew;
  biting::Drawing Drawing;
  vtkSmartPointer<vtkDataObject> Source;
  biting::PlanarInput Planar;
  biting::BitingMeshOptions Options;
  biting::BitingMesh Mesh;
};

VTK_ABI_NAMESPACE_END
#endif
