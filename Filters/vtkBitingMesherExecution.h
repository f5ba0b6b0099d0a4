// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkBitingMesherExecution_h
#define vtkBitingMesherExecution_h

#include "vtkBitingMesher.h"

#include "Bridge/Drawing/Drawing.h"
#include "Bridge/Drawing/PolylinesFromDrawing.h"
#include "Bridge/Ranks/RankCrew.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Kernel/Base/Monitor.h"
#include "Kernel/BitingMesh.h"
#include "Kernel/Stages/CoveringFaces.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string> // for refusals
#include <vector> // for cells

VTK_ABI_NAMESPACE_BEGIN

// One execution: reads, meshes, writes, and says what is wrong. Methods return false where nothing
// is left to do.
class vtkBitingMesher::Execution : private biting::FilterRun
{
public:
  Execution(vtkBitingMesher* filter, biting::RankCrew& crew);

  /// On ranks that are not the first: works with that one, where it calls. The mesh is this rank's
  /// piece then, or nothing.
  void Help(const biting::WholeInput& drawing, const biting::WholeInput& source,
    vtkInformationVector* outputs);

  /// Fills the outputs of the filter; says what is wrong.
  void Run(const biting::WholeInput& drawing, const biting::WholeInput& source,
    vtkInformationVector* outputs);

  /// After Run: whether all ranks have their pieces of the mesh.
  bool HasSpread() const { return this->IsSpread && !this->IsRefused && !this->WasAborted(); }

private:
  bool Gather(const biting::WholeInput& drawing, const biting::WholeInput& source);
  bool ReadParameters();
  bool ReadChains();
  bool ReadSpacing();
  void ReadGhostLevels(vtkInformationVector* outputs);
  bool MakeMesh();
  bool FindCells();
  biting::CoveringFaces::Votes VotesOfAll(
    const biting::CoveringFaces::Votes& votes, biting::PartOfStage& part);
  bool ReadTranslations();
  bool Deliver();
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
  std::vector<biting::Id> TriangleCells; // of the input, where it has faces
  bool IsSpread = false;
};

VTK_ABI_NAMESPACE_END
#endif
