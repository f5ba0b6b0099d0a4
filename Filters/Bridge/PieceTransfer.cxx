// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceTransfer.h"

#include "Ranks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for min
#include <new>       // for bad_alloc
#include <string>    // for names
#include <vector>    // for arrays

namespace biting
{

namespace
{

constexpr int Tag = 18420;

using Arrays = std::vector<vtkSmartPointer<vtkDataArray>>;

void SendBytes(vtkMultiProcessController* controller, int rank, vtkDataArray* array)
{
  const auto* bytes = static_cast<const char*>(array->GetVoidPointer(0));
  vtkIdType left = array->GetNumberOfValues() * array->GetDataTypeSize();
  for (; left > 0; left -= LargestMessage, bytes += LargestMessage)
  {
    controller->Send(bytes, std::min(left, LargestMessage), rank, Tag);
  }
}

void ReceiveBytes(vtkMultiProcessController* controller, int rank, vtkDataArray* array)
{
  auto* bytes = static_cast<char*>(array->GetVoidPointer(0));
  vtkIdType left = array->GetNumberOfValues() * array->GetDataTypeSize();
  for (; left > 0; left -= LargestMessage, bytes += LargestMessage)
  {
    controller->Receive(bytes, std::min(left, LargestMessage), rank, Tag);
  }
}

void Describe(vtkDataArray* array, vtkMultiProcessStream& stream)
{
  stream << std::string(array->GetName() ? array->GetName() : "") << array->GetDataType()
         << array->GetNumberOfComponents() << static_cast<vtkTypeInt64>(array->GetNumberOfTuples());
}

// With room for its values.
vtkSmartPointer<vtkDataArray> MakeArray(vtkMultiProcessStream& stream)
{
  std::string name;
  int type = 0;
  int components = 0;
  vtkTypeInt64 tuples = 0;
  stream >> name >> type >> components >> tuples;
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

// What is active, after the arrays.
void Describe(vtkDataSetAttributes* attributes, Arrays& arrays, vtkMultiProcessStream& stream)
{
  stream << attributes->GetNumberOfArrays();
  for (int k = 0; k < attributes->GetNumberOfArrays(); ++k)
  {
    arrays.emplace_back(attributes->GetArray(k));
    Describe(arrays.back(), stream);
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = attributes->GetAbstractAttribute(type);
    stream << std::string(active && active->GetName() ? active->GetName() : "");
  }
}

void MakeArrays(vtkMultiProcessStream& stream, vtkDataSetAttributes* attributes, Arrays& arrays)
{
  int count = 0;
  stream >> count;
  for (int k = 0; k < count; ++k)
  {
    arrays.push_back(MakeArray(stream));
    attributes->AddArray(arrays.back());
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    std::string name;
    stream >> name;
    if (!name.empty())
    {
      attributes->SetActiveAttribute(name.c_str(), type);
    }
  }
}

// What is sent as bytes, in this order: places, corners, arrays of points and of triangles.
Arrays DescribePiece(vtkPolyData* piece, vtkMultiProcessStream& stream)
{
  Arrays arrays{ piece->GetPoints()->GetData(), piece->GetPolys()->GetConnectivityArray() };
  Describe(arrays[0], stream);
  Describe(arrays[1], stream);
  Describe(piece->GetPointData(), arrays, stream);
  Describe(piece->GetCellData(), arrays, stream);
  return arrays;
}

Arrays MakePiece(vtkMultiProcessStream& stream, vtkPolyData* output)
{
  Arrays arrays{ MakeArray(stream) };
  arrays.push_back(MakeArray(stream));
  vtkNew<vtkPoints> points;
  points->SetData(arrays[0]);
  output->SetPoints(points);
  MakeArrays(stream, output->GetPointData(), arrays);
  MakeArrays(stream, output->GetCellData(), arrays);
  return arrays;
}

void SetTriangles(vtkDataArray* corners, vtkPolyData* output)
{
  const auto offsets = vtk::TakeSmartPointer(corners->NewInstance());
  const vtkIdType count = corners->GetNumberOfTuples() / 3;
  offsets->SetNumberOfTuples(count + 1);
  for (vtkIdType triangle = 0; triangle <= count; ++triangle)
  {
    offsets->SetTuple1(triangle, static_cast<double>(3 * triangle));
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, corners);
  output->SetPolys(triangles);
}

} // namespace

bool SendPiece(vtkMultiProcessController* controller, int toRank, vtkPolyData* piece)
{
  vtkMultiProcessStream stream;
  stream << (piece ? 1 : 0);
  Arrays arrays;
  if (piece)
  {
    arrays = DescribePiece(piece, stream);
  }
  controller->Send(stream, toRank, Tag);
  int isReady = 0;
  controller->Receive(&isReady, 1, toRank, Tag);
  for (std::size_t k = 0; k < arrays.size() && isReady != 0; ++k)
  {
    SendBytes(controller, toRank, arrays[k]);
  }
  return isReady != 0;
}

bool ReceivePiece(vtkMultiProcessController* controller, int fromRank, vtkPolyData* output)
{
  vtkMultiProcessStream stream;
  controller->Receive(stream, fromRank, Tag);
  int isReady = 0;
  stream >> isReady;
  output->Initialize();
  Arrays arrays;
  try
  {
    arrays = isReady != 0 ? MakePiece(stream, output) : arrays;
    if (isReady != 0)
    {
      SetTriangles(arrays[1], output);
    }
  }
  catch (const std::bad_alloc&)
  {
    isReady = 0;
    output->Initialize();
  }
  controller->Send(&isReady, 1, fromRank, Tag);
  for (std::size_t k = 0; k < arrays.size() && isReady != 0; ++k)
  {
    ReceiveBytes(controller, fromRank, arrays[k]);
  }
  return isReady != 0;
}

} // namespace biting
