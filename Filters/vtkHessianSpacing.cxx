// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHessianSpacing.h"

#include "Bridge/Data/ArrayFromVector.h"
#include "Bridge/Data/Arrays.h"
#include "Bridge/Drawing/FacesFromDataSet.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Source/SourceData.h"
#include "Kernel/Base/Box.h"
#include "Kernel/Hessian/HessianRecovery.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm> // for all_of, count_if, max
#include <cmath>     // for isfinite
#include <limits>    // for NaN
#include <string>    // for messages

VTK_ABI_NAMESPACE_BEGIN

namespace
{

constexpr double DefaultShareOfRange = 0.01;

//------------------------------------------------------------------------------
std::int64_t CountNotFinite(const std::vector<double>& values)
{
  return std::count_if(
    values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
}

//------------------------------------------------------------------------------
// Largest minus smallest finite value; 0 where there is none.
double RangeOf(const std::vector<double>& values)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return std::max(high - low, 0.0);
}

//------------------------------------------------------------------------------
// Of the finite values, as a power of two: what is divided by it neither overflows nor vanishes.
int LargestExponent(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
  }
  return largest > 0.0 ? std::ilogb(largest) : 0;
}

} // namespace

//------------------------------------------------------------------------------
// One execution. Methods return false where nothing is left to do.
class vtkHessianSpacing::Execution : private biting::FilterRun
{
public:
  explicit Execution(vtkHessianSpacing* filter)
    : FilterRun({ filter, &filter->ErrorCode, nullptr, nullptr, 1 }, { 0.5, 0.5 })
    , Filter(filter)
  {
  }

  /// Fills the output of the filter; says what is wrong.
  void Run(const biting::WholeInput& input, vtkInformationVector* outputs);

private:
  bool Gather(const biting::WholeInput& input);
  bool ReadFaces();
  bool ReadScalar();
  bool Recover();
  void Write(vtkDataSet* output) const;
  std::string ParameterRefusal() const;
  double Tolerance() const;
  double LargestSpacing() const;

  vtkHessianSpacing* Filter;
  vtkSmartPointer<vtkDataSet> Input;
  biting::PlanarFaces Faces;
  std::vector<double> Values;
  std::vector<double> Norms;
  int Exponent = 0; ///< values, and norms with them, are divided by two to the power of it
};

vtkStandardNewMacro(vtkHessianSpacing);

//------------------------------------------------------------------------------
vtkHessianSpacing::vtkHessianSpacing()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
int vtkHessianSpacing::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkBitingCompat::ForgetAbort(this);
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  biting::Ranks(request, outputVector).AskForPieces(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkHessianSpacing::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return biting::RunOnFirstRank(this, this->ErrorCode, { request, inputVector, outputVector },
    [this, outputVector](const biting::WholeInputs& inputs)
    { Execution(this).Run(inputs[0], outputVector); });
}

//------------------------------------------------------------------------------
void vtkHessianSpacing::Execution::Run(
  const biting::WholeInput& input, vtkInformationVector* outputs)
{
  const auto run = [this, &input, outputs]()
  {
    if (this->Gather(input) && this->ReadFaces() && this->ReadScalar() && this->Recover())
    {
      this->Write(vtkDataSet::GetData(outputs));
    }
  };
  this->Guard(outputs, run, "There is not enough memory for the Hessian of this input.");
}

//------------------------------------------------------------------------------
bool vtkHessianSpacing::Execution::Gather(const biting::WholeInput& input)
{
  if (!this->AcceptComplete({ &input }))
  {
    return false;
  }
  this->Input = vtkDataSet::SafeDownCast(input.Make());
  const bool isAsBefore =
    !this->Input || this->Input->IsA(this->Filter->GetOutputDataObject(0)->GetClassName());
  return this->Accept(isAsBefore ? "" : biting::NotOneGrid) && this->Input != nullptr;
}

//------------------------------------------------------------------------------
bool vtkHessianSpacing::Execution::ReadFaces()
{
  this->Progress.BeginStage("Reading the faces");
  this->Faces.IsOnGlobe = this->Filter->Coordinates == LONGITUDE_LATITUDE;
  if (!this->Accept(this->ParameterRefusal()) ||
    !this->Accept(biting::FacesFromDataSet(
      this->Input, biting::FaceRule::Polygons, this->Faces, this->Progress)) ||
    !this->Progress.Advance(1.0))
  {
    return false;
  }
  const bool isEmpty = this->Faces.CellIds.empty();
  if (isEmpty && this->Input->GetNumberOfPoints() + this->Input->GetNumberOfCells() > 0)
  {
    return this->Accept("The input has no faces to recover a Hessian on.");
  }
  biting::OrderByPlace(this->Faces);
  return !isEmpty;
}

//------------------------------------------------------------------------------
std::string vtkHessianSpacing::Execution::ParameterRefusal() const
{
  biting::SpacingOptions bounds;
  bounds.Minimum = this->Filter->MinimumSpacing;
  bounds.Maximum = this->Filter->MaximumSpacing;
  return biting::FirstRefusal(
    { biting::CheckAtLeastZero("Error Tolerance", this->Filter->ErrorTolerance),
      biting::CheckSpacingParameters(bounds) });
}

//------------------------------------------------------------------------------
bool vtkHessianSpacing::Execution::ReadScalar()
{
  const biting::ChosenArray chosen = biting::ChooseArray(
    this->Filter->GetInputArrayInformation(0), this->Input, { "scalar array", "input" });
  // A script may make the filter before its input is known: no name is chosen then.
  vtkDataArray* array = chosen.Array ? chosen.Array : this->Input->GetPointData()->GetScalars();
  if (!this->Accept(chosen.Refusal) ||
    !this->Accept(array ? "" : "No scalar point array of the input was chosen."))
  {
    return false;
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return this->Accept("The scalar array " +
      std::string(array->GetName() ? array->GetName() : "") + " has " +
      std::to_string(array->GetNumberOfComponents()) + " components; it takes one.");
  }
  const auto doubles = biting::AsDoubles(array);
  for (const vtkIdType point : this->Faces.PointIds)
  {
    this->Values.push_back(doubles->GetValue(point));
  }
  this->Exponent = LargestExponent(this->Values);
  for (double& value : this->Values)
  {
    value = std::ldexp(value, -this->Exponent);
  }
  const std::int64_t count = CountNotFinite(this->Values);
  if (count > 0)
  {
    this->Warn(
      "The scalar is not finite at " + std::to_string(count) + " points; they get no spacing.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHessianSpacing::Execution::Recover()
{
  this->Progress.BeginStage("Recovering the Hessian");
  const std::vector<biting::Hessian2> hessians = biting::RecoverHessians(
    { this->Faces.Points, this->Faces.Offsets, this->Faces.Corners }, this->Values, this->Progress);
  if (hessians.empty())
  {
    return false;
  }
  for (std::size_t vertex = 0; vertex < hessians.size(); ++vertex)
  {
    const double stretch = this->Faces.Frame.StretchAt(this->Faces.Points[vertex]);
    this->Norms.push_back(stretch * stretch * biting::SpectralNorm(hessians[vertex]));
  }
  const std::int64_t unknown = CountNotFinite(this->Norms);
  if (unknown == static_cast<std::int64_t>(this->Norms.size()))
  {
    return this->Accept("No point has enough finite values around it to determine a Hessian: at "
                        "least six points that are not on two lines, joined by cells.");
  }
  const std::int64_t isolated = unknown - CountNotFinite(this->Values);
  if (isolated > 0)
  {
    this->Warn(std::to_string(isolated) +
      " points have too few others around them to determine a Hessian; the spacing there is that "
      "of the points around them.");
  }
  return this->Progress.Advance(1.0);
}

//------------------------------------------------------------------------------
void vtkHessianSpacing::Execution::Write(vtkDataSet* output) const
{
  const double tolerance = this->Tolerance();
  const double maximum = this->LargestSpacing();
  const auto size = static_cast<std::size_t>(this->Input->GetNumberOfPoints());
  const std::vector<double> joined = biting::WithThoseAround(
    { this->Faces.Points, this->Faces.Offsets, this->Faces.Corners }, this->Values, this->Norms);
  std::vector<double> norms(size, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> spacings = norms;
  for (std::size_t vertex = 0; vertex < this->Norms.size(); ++vertex)
  {
    const auto point = static_cast<std::size_t>(this->Faces.PointIds[vertex]);
    norms[point] = std::ldexp(this->Norms[vertex], this->Exponent);
    spacings[point] =
      biting::NumericalSpacing(joined[vertex], tolerance, this->Filter->MinimumSpacing, maximum);
  }
  output->ShallowCopy(this->Input);
  biting::AddArray<vtkDoubleArray>(output->GetPointData(), "Spacing", spacings);
  biting::AddArray<vtkDoubleArray>(output->GetPointData(), "HessianNorm", norms);
  output->GetPointData()->SetActiveScalars("Spacing");
  biting::AddFigure(
    output->GetFieldData(), "ErrorTolerance", std::ldexp(tolerance, this->Exponent));
}

//------------------------------------------------------------------------------
double vtkHessianSpacing::Execution::Tolerance() const
{
  return this->Filter->ErrorTolerance > 0.0
    ? std::max(std::ldexp(this->Filter->ErrorTolerance, -this->Exponent),
        std::numeric_limits<double>::min())
    : DefaultShareOfRange * RangeOf(this->Values);
}

//------------------------------------------------------------------------------
double vtkHessianSpacing::Execution::LargestSpacing() const
{
  return this->Filter->MaximumSpacing > 0.0
    ? this->Filter->MaximumSpacing
    : std::max(biting::Box2::Around(this->Faces.Points).Diagonal(), this->Filter->MinimumSpacing);
}

//------------------------------------------------------------------------------
void vtkHessianSpacing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n"
     << indent << "MinimumSpacing: " << this->MinimumSpacing << "\n"
     << indent << "MaximumSpacing: " << this->MaximumSpacing << "\n"
     << indent << "Coordinates: " << this->Coordinates << "\n";
}

VTK_ABI_NAMESPACE_END
