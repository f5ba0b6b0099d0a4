// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ProblemsToPolyData.h"

#include "ArrayFromVector.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <numeric>     // for iota
#include <type_traits> // for decay
#include <utility>     // for declval

namespace biting
{

namespace
{

// In the order of ProblemCode.
constexpr std::array<const char*, NumberOfProblemKinds> KindNames = { "DuplicatePoints",
  "ZeroLengthSegments", "DuplicateSegments", "Crossings", "Touches", "OutsidePoints",
  "OutsideInterfaces", "NoClosedLoop", "NotFinite", "OutOfRange", "NotPlanar", "BadSpacing",
  "TooManyVertices", "NotResolved", "CheckFailed", "OverlappingCells", "NearPoints", "NarrowAngles",
  "RaisedSpacing", "SmallLoops", "FineDrawing", "BadTriangles", "FlatTriangles", "JoinedEnds",
  "OpenOutlines", "NearMisses", "ChangedArea", "OpenEdges", "NonManifoldEdges", "PinchedVertices",
  "Folds", "SelfCrossings", "NotOrientable", "DuplicateTriangles", "InconsistentEdges",
  "SurfaceTouches" };

void SetPoints(const std::vector<ProblemPlace>& places, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    points->SetPoint(static_cast<vtkIdType>(k), places[k].Place.data());
  }
  output->SetPoints(points);
  std::vector<Id> vertices(places.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  vtkNew<vtkCellArray> cells;
  SetCells(cells, 1, vertices);
  output->SetVerts(cells);
}

// The array `name` of `member` of each place.
template <typename ArrayType, typename Value>
void AddMember(const std::vector<ProblemPlace>& places, const char* name,
  Value ProblemPlace::*member, vtkFieldData* data)
{
  using Stored = std::decay_t<decltype(std::declval<ArrayType>().GetValue(0))>;
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    array->SetValue(static_cast<vtkIdType>(k), static_cast<Stored>(places[k].*member));
  }
  data->AddArray(array);
}

void AddKinds(const ProblemPlaces& problems, vtkFieldData* data)
{
  vtkNew<vtkStringArray> names;
  names->SetName("ProblemKindNames");
  for (const char* name : KindNames)
  {
    names->InsertNextValue(name);
  }
  data->AddArray(names);
  const std::vector<std::int64_t> counts(problems.Counts.begin(), problems.Counts.end());
  AddArray<vtkIdTypeArray>(data, "ProblemCounts", counts);
  HideFromChoices(data, "ProblemKindNames");
  HideFromChoices(data, "ProblemCounts");
}

} // namespace

void ProblemsToPolyData(const ProblemPlaces& problems, vtkPolyData* output)
{
  output->Initialize();
  SetPoints(problems.Places, output);
  vtkPointData* data = output->GetPointData();
  AddMember<vtkUnsignedCharArray>(problems.Places, "ProblemKind", &ProblemPlace::Kind, data);
  AddMember<vtkUnsignedCharArray>(problems.Places, "IsError", &ProblemPlace::IsError, data);
  AddMember<vtkIdTypeArray>(problems.Places, "FirstId", &ProblemPlace::FirstId, data);
  AddMember<vtkIdTypeArray>(problems.Places, "SecondId", &ProblemPlace::SecondId, data);
  AddMember<vtkStringArray>(problems.Places, "Message", &ProblemPlace::Message, data);
  data->SetActiveScalars("ProblemKind");
  AddKinds(problems, output->GetFieldData());
}

} // namespace biting
