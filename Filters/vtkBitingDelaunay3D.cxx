// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingDelaunay3D.h"

#include "Bridge/Data/ArrayFromVector.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"
#include "Kernel/Base/Pulse.h"
#include "Kernel/Space/Delaunay/SpaceTriangulation.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for max, min, sort
#include <cmath>     // for abs, ilogb, isfinite, ldexp
#include <string>    // for messages
#include <vector>    // for points

VTK_ABI_NAMESPACE_BEGIN

namespace
{

/// Facets have ids of 31 bits, four a cell; there are 6.8 cells a point in ordinary inputs.
constexpr vtkIdType MostPoints = (vtkIdType(1) << 29) / 8;

/// What is said of points without volume, by their dimension.
constexpr const char* FlatSentences[] = {
  "All points are at one place: there is no tetrahedron between them.",
  "All points lie on one line: there is no tetrahedron between them.",
  "All points lie in one plane: there is no tetrahedron between them. Use Delaunay 2D."
};

//------------------------------------------------------------------------------
std::string DuplicatesText(std::vector<biting::PointPair> pairs)
{
  std::sort(pairs.begin(), pairs.end(),
    [](const biting::PointPair& a, const biting::PointPair& b) { return a.Point < b.Point; });
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(biting::ShownIds, pairs.size()); ++k)
  {
    first.push_back(
      "point " + std::to_string(pairs[k].Point) + " at point " + std::to_string(pairs[k].Of));
  }
  const std::string what = pairs.size() == 1
    ? " point lies at the place of another one and is a corner of no tetrahedron: "
    : " points lie at the places of others and are corners of no tetrahedra: ";
  const auto count = static_cast<std::int64_t>(pairs.size());
  return count == 0 ? "" : std::to_string(count) + what + biting::ListText(first, count) + ".";
}

} // namespace

//------------------------------------------------------------------------------
// One execution. Methods return false where nothing is left to do.
class vtkBitingDelaunay3D::Execution : private biting::FilterRun
{
public:
  explicit Execution(vtkBitingDelaunay3D* filter)
    : FilterRun({ filter, &filter->ErrorCode, nullptr, nullptr, 1 }, { 0.05, 0.85, 0.1 })
    , Filter(filter)
  {
  }

  /// Fills the output of the filter; says what is wrong.
  void Run(const biting::WholeInput& input, vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& input);
  bool ReadPoints();
  bool Triangulate();
  void Write(vtkUnstructuredGrid* output);
  bool IsWanted(biting::Id cell) const;

  vtkBitingDelaunay3D* Filter;
  vtkSmartPointer<vtkPointSet> Input;
  std::vector<biting::Point3> Points; ///< divided by two to the power of Exponent
  int Exponent = 0;
  biting::SpaceTriangulation Result;
};

vtkStandardNewMacro(vtkBitingDelaunay3D);

//------------------------------------------------------------------------------
int vtkBitingDelaunay3D::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingDelaunay3D::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkBitingDelaunay3D::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { Execution(this).Run(inputs[0], outputVector); });
}

//------------------------------------------------------------------------------
void vtkBitingDelaunay3D::Execution::Run(
  const biting::WholeInput& input, vtkInformationVector* outputs)
{
  const auto run = [this, &input, outputs]()
  {
    if (this->Accept(biting::CheckAtLeastZero("Alpha", this->Filter->Alpha)) &&
      this->Gather(input) && this->ReadPoints() && this->Triangulate())
    {
      this->Write(vtkUnstructuredGrid::GetData(outputs));
    }
  };
  this->Guard(
    outputs, run, "There is not enough memory for the tetrahedra between so many points.");
}

//------------------------------------------------------------------------------
bool vtkBitingDelaunay3D::Execution::Gather(const biting::WholeInput& input)
{
  if (!this->AcceptComplete({ &input }))
  {
    return false;
  }
  this->Input = vtkPointSet::SafeDownCast(input.Make());
  const vtkIdType count = this->Input ? this->Input->GetNumberOfPoints() : 0;
  if (count > MostPoints)
  {
    this->Refuse("There are " + std::to_string(count) + " points; at most " +
      std::to_string(MostPoints) + " can be triangulated.");
    return false;
  }
  return count > 0;
}

//------------------------------------------------------------------------------
bool vtkBitingDelaunay3D::Execution::ReadPoints()
{
  this->Progress.BeginStage("Reading the points");
  this->Points.resize(static_cast<std::size_t>(this->Input->GetNumberOfPoints()));
  double largest = 0.0;
  vtkIdType firstBad = -1;
  vtkIdType numberOfBad = 0;
  biting::Pulse pulse(this->Progress);
  pulse.ForEach(this->Points.size(),
    [this, &largest, &firstBad, &numberOfBad](std::size_t k)
    {
      biting::Point3& point = this->Points[k];
      this->Input->GetPoint(static_cast<vtkIdType>(k), point.Data());
      const double size = std::abs(point.X) + std::abs(point.Y) + std::abs(point.Z);
      if (!std::isfinite(size))
      {
        firstBad = numberOfBad++ == 0 ? static_cast<vtkIdType>(k) : firstBad;
      }
      largest = std::max(largest, size);
    });
  if (numberOfBad > 0 && !pulse.HasStopped())
  {
    this->Refuse("Point " + std::to_string(firstBad) +
      " has a coordinate that is not finite, or too large" +
      (numberOfBad > 1 ? "; so have " + std::to_string(numberOfBad - 1) + " more." : "."));
    return false;
  }
  this->Exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  pulse.ForEach(this->Points.size(),
    [this](std::size_t k)
    {
      for (double& x : this->Points[k])
      {
        x = std::ldexp(x, -this->Exponent);
        x = std::abs(x) < biting::LeastCoordinate3 ? 0.0 : x;
      }
    });
  return !pulse.HasStopped();
}

//------------------------------------------------------------------------------
bool vtkBitingDelaunay3D::Execution::Triangulate()
{
  this->Progress.BeginStage("Triangulating");
  this->Result = biting::TriangulateSpace(this->Points, {}, this->Progress);
  if (this->Result.WasAborted)
  {
    return false;
  }
  const bool isSolid = this->Result.Dimension == 3;
  const std::string text =
    isSolid ? DuplicatesText(this->Result.Duplicates) : FlatSentences[this->Result.Dimension];
  this->Warn(text);
  return isSolid;
}

//------------------------------------------------------------------------------
bool vtkBitingDelaunay3D::Execution::IsWanted(biting::Id cell) const
{
  const biting::TetMesh& mesh = this->Result.Mesh;
  if (!mesh.IsTetrahedron(cell) || this->Filter->Alpha == 0.0)
  {
    return mesh.IsTetrahedron(cell);
  }
  const auto corner = [&mesh, cell](std::size_t k) -> biting::WeightedPoint {
    return { mesh.PointAt(mesh.Corners[4 * static_cast<std::size_t>(cell) + k]), 0.0 };
  };
  const double radius = Length(biting::PowerCenter(corner(0), corner(1), corner(2), corner(3)));
  return radius <= std::ldexp(this->Filter->Alpha, -this->Exponent);
}

//------------------------------------------------------------------------------
void vtkBitingDelaunay3D::Execution::Write(vtkUnstructuredGrid* output)
{
  this->Progress.BeginStage("Writing the tetrahedra");
  const biting::TetMesh& mesh = this->Result.Mesh;
  std::vector<biting::Id> corners;
  corners.reserve(mesh.Corners.size());
  biting::Pulse pulse(this->Progress);
  pulse.ForEach(static_cast<std::size_t>(mesh.NumberOfSlots()),
    [this, &mesh, &corners](std::size_t cell)
    {
      if (this->IsWanted(static_cast<biting::Id>(cell)))
      {
        for (std::size_t k = 0; k < 4; ++k)
        {
          const biting::Id vertex = mesh.Corners[4 * cell + k];
          corners.push_back(this->Result.Order[vertex]);
        }
      }
    });
  vtkNew<vtkCellArray> cells;
  biting::SetCells(cells, 4, corners, pulse);
  if (!pulse.HasStopped())
  {
    output->SetPoints(this->Input->GetPoints());
    output->SetCells(VTK_TETRA, cells);
    output->GetPointData()->PassData(this->Input->GetPointData());
    output->GetFieldData()->PassData(this->Input->GetFieldData());
  }
}

//------------------------------------------------------------------------------
void vtkBitingDelaunay3D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Alpha: " << this->Alpha << "\n";
}

VTK_ABI_NAMESPACE_END
