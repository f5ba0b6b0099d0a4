// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingSurfaceMesher.h"

#include "Bridge/Mesh/SurfaceToPolyData.h"
#include "vtkBitingSpaceMesherExecution.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
class vtkBitingSurfaceMesher::Execution : public vtkBitingSpaceMesher::Execution
{
public:
  explicit Execution(vtkBitingSpaceMesher* filter)
    // Reading, the three of CheckSurface, the three of MakeBitingSurface, writing.
    : vtkBitingSpaceMesher::Execution(
        filter, { 0.05, 0.05, 0.1, 0.05, 0.15, 0.4, 0.15, 0.05 }, 0.02)
  {
  }

private:
  bool TakesOpen() const override { return true; }
  void MakeMesh() override
  {
    this->Mesh =
      biting::MakeBitingSurface(this->Surface, this->Options, this->Problems, this->Progress);
  }

  std::string Write(vtkInformationVector* outputs) override;

  biting::BitingSurface Mesh;
};

vtkStandardNewMacro(vtkBitingSurfaceMesher);

//------------------------------------------------------------------------------
std::unique_ptr<vtkBitingSpaceMesher::Execution> vtkBitingSurfaceMesher::NewExecution()
{
  return std::make_unique<Execution>(this);
}

//------------------------------------------------------------------------------
std::string vtkBitingSurfaceMesher::Execution::Write(vtkInformationVector* outputs)
{
  biting::Pulse pulse(this->Progress);
  vtkPolyData* mesh = vtkPolyData::GetData(outputs, MESH);
  const std::string summary =
    biting::BitingSurfaceToPolyData(this->Mesh, this->Surface, this->Drawing, mesh, pulse);
  biting::EdgesToPolyData(this->Mesh.Points, this->Mesh.EdgeEnds, this->Mesh.EdgeKinds, mesh,
    vtkPolyData::GetData(outputs, BOUNDARY_EDGES));
  if (this->Options.KeepBites)
  {
    biting::SpheresToPolyData(
      this->Mesh.BiteCenters, this->Mesh.BiteRadii, vtkPolyData::GetData(outputs, BITES));
  }
  return summary;
}

VTK_ABI_NAMESPACE_END
