// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingTetrahedralizer.h"

#include "Bridge/Mesh/BitingBodyToGrid.h"
#include "Bridge/Mesh/SurfaceToPolyData.h"
#include "Kernel/Space/Meshing/BodyMesher.h"
#include "vtkBitingSpaceMesherExecution.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

VTK_ABI_NAMESPACE_BEGIN

static_assert(
  static_cast<int>(biting::SpaceBiteShape::Sphere) == vtkBitingTetrahedralizer::SPHERE &&
    static_cast<int>(biting::SpaceBiteShape::Cube) == vtkBitingTetrahedralizer::CUBE,
  "The shapes that users see are those of the kernel.");

//------------------------------------------------------------------------------
class vtkBitingTetrahedralizer::Execution : public vtkBitingSpaceMesher::Execution
{
public:
  explicit Execution(vtkBitingTetrahedralizer* filter)
    // Reading, the three of CheckSurface, the six of MakeBitingBody, writing.
    : vtkBitingSpaceMesher::Execution(
        filter, { 0.01, 0.01, 0.02, 0.01, 0.02, 0.08, 0.35, 0.1, 0.3, 0.05, 0.05 }, 0.04)
    , Filter(filter)
  {
  }

private:
  bool ReadOwnParameters() override;
  void MakeMesh() override;
  std::string Write(vtkInformationVector* outputs) override;

  vtkBitingTetrahedralizer* Filter;
  biting::BodyMesherOptions Own;
  biting::BitingBody Body;
};

vtkStandardNewMacro(vtkBitingTetrahedralizer);

//------------------------------------------------------------------------------
int vtkBitingTetrahedralizer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == MESH ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkBitingTetrahedralizer::GetOutput()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(MESH));
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkBitingSpaceMesher::Execution> vtkBitingTetrahedralizer::NewExecution()
{
  return std::make_unique<Execution>(this);
}

//------------------------------------------------------------------------------
bool vtkBitingTetrahedralizer::Execution::ReadOwnParameters()
{
  const vtkIdType most = this->Filter->MaximumNumberOfBites;
  this->Own.Shape = static_cast<biting::SpaceBiteShape>(this->Filter->BiteShape);
  this->Own.BitingConstant = this->Filter->BitingConstant;
  this->Own.MaximumNumberOfBites = most == -1 ? 0 : most;
  return this->Accept(biting::CheckBitingConstant(this->Own.BitingConstant)) &&
    this->Accept(most == 0 ? "Maximum Number Of Bites is 0; it must be at least 1, or -1: until "
                             "nothing is left."
                           : biting::CheckMostBites(most));
}

//------------------------------------------------------------------------------
void vtkBitingTetrahedralizer::Execution::MakeMesh()
{
  // Beyond, products of lengths that angles are compared by leave the range of doubles.
  const double size = this->Surface.Mesh.Bounds().Diagonal();
  if (!(size >= 1e-15 && size <= 1e30))
  {
    this->Refuse("The diagonal of the surface is " + biting::Figure(size, 6) +
      ": too small or too large to compute volumes with. Scale it, as by Transform.");
    return;
  }
  this->Own.Surface = this->Options;
  this->Own.Surface.Relaxation = this->Options.Relaxation && this->Own.MaximumNumberOfBites == 0;
  if (!this->Regions.Array)
  {
    this->Own.Surface.Regions.clear(); // a part in another one bounds a cavity
  }
  this->Body = biting::MakeBitingBody(this->Surface, this->Own, this->Problems, this->Progress);
  const bool isIgnored =
    this->Regions.Array && !this->Body.Corners.empty() && !this->Body.HasRegionValues;
  this->Warn(isIgnored ? "The values of RegionArray are not those of what surfaces enclose: their "
                         "borders are kept as lines, and regions are numbered."
                       : "");
}

//------------------------------------------------------------------------------
std::string vtkBitingTetrahedralizer::Execution::Write(vtkInformationVector* outputs)
{
  if (this->Options.KeepBites)
  {
    biting::SpheresToPolyData(
      this->Body.BiteCenters, this->Body.BiteRadii, vtkPolyData::GetData(outputs, BITES));
  }
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(outputs, MESH);
  const std::string text = biting::BitingBodyToGrid(this->Body, this->Surface, this->Drawing, mesh,
    vtkPolyData::GetData(outputs, BOUNDARY_EDGES), this->Progress);
  if (this->Body.HasRegionValues)
  {
    biting::AddRegionValues(this->Regions, this->Body.Regions, mesh->GetCellData());
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkBitingTetrahedralizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BiteShape: " << this->BiteShape << "\n"
     << indent << "BitingConstant: " << this->BitingConstant << "\n"
     << indent << "MaximumNumberOfBites: " << this->MaximumNumberOfBites << "\n";
}

VTK_ABI_NAMESPACE_END
