// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Ranks.h"

#include "../../Kernel/Blocks/ByteStream.h"
#include "../Data/DataTree.h"
#include "WholeFromPieces.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm> // for copy_n, equal, min
#include <array>     // for axes
#include <limits>    // for what a message can hold
#include <new>       // for bad_alloc
#include <string>    // for names

namespace biting
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

// What an output says of itself where it has nothing.
constexpr int Associations[] = { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW };

enum class Form : char
{
  Nothing,
  Tree,
  Image,
  Other
};

// What the legacy format of messages rounds or leaves out.
struct ImageAxes
{
  std::array<int, 6> Extent;
  std::array<double, 3> Origin;
  std::array<double, 3> Spacing;
  std::array<double, 9> Direction;
};

bool PackLeaf(vtkDataObject* leaf, ByteWriter& bytes)
{
  vtkNew<vtkCharArray> message;
  if (vtkCommunicator::MarshalDataObject(leaf, message) == 0)
  {
    return false;
  }
  const char* first = message->GetPointer(0);
  bytes.PutAll(first, first + message->GetNumberOfValues());
  return true;
}

void PackAxes(vtkImageData* image, ByteWriter& bytes)
{
  ImageAxes axes;
  image->GetExtent(axes.Extent.data());
  image->GetOrigin(axes.Origin.data());
  image->GetSpacing(axes.Spacing.data());
  std::copy_n(image->GetDirectionMatrix()->GetData(), axes.Direction.size(), axes.Direction.data());
  bytes.Put(axes.Extent);
  bytes.Put(axes.Origin);
  bytes.Put(axes.Spacing);
  bytes.Put(axes.Direction);
}

// Makes bytes of a dataset or a tree of datasets; false where `piece`, which may be null, is of
// another kind. Nothing is lost: names of blocks, extents and axes of images come back bit for bit.
// Equal data make equal bytes.
bool Pack(vtkDataObject* piece, ByteWriter& bytes)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(piece);
  auto* image = vtkImageData::SafeDownCast(piece);
  bytes.Put(!piece ? Form::Nothing : tree ? Form::Tree : image ? Form::Image : Form::Other);
  if (!piece)
  {
    return true;
  }
  if (image)
  {
    PackAxes(image, bytes);
  }
  if (!tree)
  {
    return vtkDataSet::SafeDownCast(piece) && PackLeaf(piece, bytes);
  }
  const unsigned int count = NumberOfChildren(tree);
  bytes.Put(tree->GetDataObjectType());
  bytes.Put(count);
  bool isPacked = true;
  for (unsigned int child = 0; child < count && isPacked; ++child)
  {
    const std::string name = NameOfChild(tree, child);
    bytes.PutAll(name.begin(), name.end());
    isPacked = Pack(ChildOf(tree, child), bytes);
  }
  return isPacked;
}

vtkSmartPointer<vtkDataObject> UnpackLeaf(ByteReader& bytes)
{
  std::vector<char> values;
  bytes.Take(values);
  vtkNew<vtkCharArray> message;
  message->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1);
  return vtkCommunicator::UnMarshalDataObject(message);
}

vtkSmartPointer<vtkDataObject> UnpackImage(ByteReader& bytes)
{
  ImageAxes axes;
  bytes.Take(axes.Extent);
  bytes.Take(axes.Origin);
  bytes.Take(axes.Spacing);
  bytes.Take(axes.Direction);
  const auto leaf = UnpackLeaf(bytes);
  if (auto* image = vtkImageData::SafeDownCast(leaf))
  {
    image->SetExtent(axes.Extent.data());
    image->SetOrigin(axes.Origin.data());
    image->SetSpacing(axes.Spacing.data());
    image->SetDirectionMatrix(axes.Direction.data());
  }
  return leaf;
}

vtkSmartPointer<vtkDataObject> Unpack(ByteReader& bytes)
{
  Form form = Form::Nothing;
  bytes.Take(form);
  if (form != Form::Tree)
  {
    return form == Form::Nothing ? nullptr
      : form == Form::Image      ? UnpackImage(bytes)
                                 : UnpackLeaf(bytes);
  }
  int type = 0;
  unsigned int count = 0;
  bytes.Take(type);
  bytes.Take(count);
  const auto object = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type));
  auto* tree = vtkDataObjectTree::SafeDownCast(object);
  for (unsigned int child = 0; tree && child < count; ++child)
  {
    std::vector<char> name;
    bytes.Take(name);
    SetChild(tree, child, Unpack(bytes), std::string(name.begin(), name.end()));
  }
  return object;
}

vtkInformation* RequestedOutput(vtkInformation* request, vtkInformationVector* outputs)
{
  const int port = request->Has(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT())
    ? request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT())
    : 0;
  return outputs->GetInformationObject(port < 0 ? 0 : port);
}

void DescribeArrays(vtkDataObject* output, int association, vtkMultiProcessStream& stream)
{
  vtkDataSetAttributes* attributes = output->GetAttributes(association);
  const int count = attributes ? attributes->GetNumberOfArrays() : 0;
  stream << count;
  for (int k = 0; k < count; ++k)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(k);
    stream << std::string(array->GetName() ? array->GetName() : "") << array->GetDataType()
           << array->GetNumberOfComponents();
  }
}

void MakeArrays(vtkDataObject* output, int association, vtkMultiProcessStream& stream)
{
  int count = 0;
  stream >> count;
  for (int k = 0; k < count; ++k)
  {
    std::string name;
    int type = 0;
    int components = 0;
    stream >> name >> type >> components;
    const auto array = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(type));
    vtkDataSetAttributes* attributes = output->GetAttributes(association);
    if (array && attributes)
    {
      array->SetName(name.c_str());
      array->SetNumberOfComponents(components);
      attributes->AddArray(array);
    }
  }
}

// Of no points and cells, as bytes.
void DescribeFieldData(vtkDataObject* output, vtkMultiProcessStream& stream)
{
  vtkNew<vtkPolyData> empty;
  empty->SetFieldData(output->GetFieldData());
  ByteWriter packed;
  Pack(empty, packed);
  stream << std::string(packed.Bytes.begin(), packed.Bytes.end());
}

void MakeFieldData(vtkDataObject* output, vtkMultiProcessStream& stream)
{
  std::string text;
  stream >> text;
  const std::vector<char> bytes(text.begin(), text.end());
  ByteReader packed(bytes);
  const auto empty = Unpack(packed);
  if (empty)
  {
    output->SetFieldData(empty->GetFieldData());
  }
}

// Empty as well, but of a rank that has none of the mesh.
bool IsPiece(vtkDataObject* output)
{
  auto* pointSet = vtkPointSet::SafeDownCast(output);
  return pointSet && pointSet->GetPoints();
}

void MakePoints(vtkDataObject* output)
{
  if (auto* pointSet = vtkPointSet::SafeDownCast(output))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    pointSet->SetPoints(points);
  }
}

} // namespace

Ranks::Ranks(vtkInformation* request, vtkInformationVector* outputs)
{
  vtkInformation* asked = RequestedOutput(request, outputs);
  const int pieces = asked->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
    ? asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
    : 1;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && pieces > 1 && controller->GetNumberOfProcesses() == pieces)
  {
    this->Controller = controller;
    this->Piece = controller->GetLocalProcessId();
  }
  else if (pieces > 1)
  {
    this->Piece = asked->Get(Pipeline::UPDATE_PIECE_NUMBER());
  }
}

Ranks Ranks::All()
{
  Ranks all;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    all.Controller = controller;
    all.Piece = controller->GetLocalProcessId();
  }
  return all;
}

int Ranks::Count() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void Ranks::AskForPieces(vtkInformationVector** inputs, int numberOfPorts) const
{
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int k = 0; k < inputs[port]->GetNumberOfInformationObjects(); ++k)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(k);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (!this->AreSeveral())
      {
        input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
        input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      }
    }
  }
}

void Ranks::AskForOwn(vtkInformation* input) const
{
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), this->Piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), this->Count());
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

GatheredBytes Ranks::Gather(vtkDataObject* piece) const
{
  ByteWriter packed;
  bool isPacked = false;
  try
  {
    isPacked = Pack(piece, packed);
  }
  catch (const std::bad_alloc&)
  {
    packed.Bytes.clear();
  }
  const std::vector<char>& bytes = packed.Bytes;
  GatheredBytes gathered;
  const auto length = static_cast<vtkIdType>(bytes.size());
  gathered.IsComplete = this->CanReceive(isPacked, length, gathered);
  if (gathered.IsComplete)
  {
    std::vector<vtkIdType> lengths;
    for (std::size_t rank = 1; rank < gathered.Offsets.size(); ++rank)
    {
      lengths.push_back(gathered.Offsets[rank] - gathered.Offsets[rank - 1]);
    }
    this->Controller->GatherV(
      bytes.data(), gathered.Bytes.data(), length, lengths.data(), gathered.Offsets.data(), 0);
  }
  return gathered;
}

// Whether all ranks have packed their pieces, and the first has memory for them, which it takes.
bool Ranks::CanReceive(bool isPacked, vtkIdType length, GatheredBytes& gathered) const
{
  std::vector<vtkIdType> lengths(
    static_cast<std::size_t>(this->Controller->GetNumberOfProcesses()));
  const vtkIdType sent = isPacked ? length : -1;
  this->Controller->Gather(&sent, lengths.data(), 1, 0);
  int isReady = 1;
  if (this->IsFirst())
  {
    gathered.Offsets.assign(lengths.size() + 1, 0);
    for (std::size_t rank = 0; rank < lengths.size(); ++rank)
    {
      isReady = lengths[rank] < 0 ? 0 : isReady;
      gathered.Offsets[rank + 1] = gathered.Offsets[rank] + lengths[rank];
    }
    // One message holds as many bytes as an int can count.
    isReady = gathered.Offsets.back() > std::numeric_limits<int>::max() ? 0 : isReady;
    try
    {
      gathered.Bytes.resize(isReady != 0 ? static_cast<std::size_t>(gathered.Offsets.back()) : 0);
    }
    catch (const std::bad_alloc&)
    {
      isReady = 0;
    }
  }
  this->Controller->Broadcast(&isReady, 1, 0);
  return isReady != 0;
}

unsigned long Ranks::ShareOutcome(unsigned long errorCode, bool areSpread, vtkAlgorithm* filter,
  vtkInformationVector* outputs) const
{
  if (!this->AreSeveral())
  {
    return errorCode;
  }
  vtkMultiProcessStream stream;
  const int numberOfPorts = outputs->GetNumberOfInformationObjects();
  if (this->IsFirst())
  {
    stream << static_cast<vtkTypeUInt64>(errorCode)
           << static_cast<int>(vtkBitingCompat::WasAborted(filter)) << static_cast<int>(areSpread);
    for (int port = 0; port < numberOfPorts; ++port)
    {
      for (const int association : Associations)
      {
        DescribeArrays(vtkDataObject::GetData(outputs, port), association, stream);
      }
      DescribeFieldData(vtkDataObject::GetData(outputs, port), stream);
    }
  }
  this->Controller->Broadcast(stream, 0);
  if (this->IsFirst())
  {
    return errorCode;
  }
  vtkTypeUInt64 code = 0;
  int isAborted = 0;
  int isKept = 0;
  stream >> code >> isAborted >> isKept;
  if (isAborted != 0)
  {
    vtkBitingCompat::Abort(filter);
  }
  for (int port = 0; port < numberOfPorts; ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    // Of a piece that is kept, what follows is the same once more.
    vtkNew<vtkPolyData> unused;
    vtkDataObject* made = port == 0 && isKept != 0 && IsPiece(output) ? unused.Get() : output;
    made->Initialize();
    MakePoints(made);
    for (const int association : Associations)
    {
      MakeArrays(made, association, stream);
    }
    MakeFieldData(output, stream);
  }
  return static_cast<unsigned long>(code);
}

unsigned long Ranks::ShareCode(unsigned long errorCode) const
{
  unsigned long code = errorCode;
  if (this->AreSeveral())
  {
    this->Controller->Broadcast(&code, 1, 0);
  }
  return code;
}

void Ranks::AddUp(double* values, vtkIdType count) const
{
  if (this->AreSeveral())
  {
    const std::vector<double> own(values, values + count);
    this->Controller->AllReduce(own.data(), values, count, vtkCommunicator::SUM_OP);
  }
}

double Ranks::Largest(double value) const
{
  double largest = value;
  if (this->AreSeveral())
  {
    this->Controller->AllReduce(&value, &largest, 1, vtkCommunicator::MAX_OP);
  }
  return largest;
}

WholeInput::WholeInput(const Ranks& ranks, vtkInformationVector* input)
  : WholeInput(ranks, vtkDataObject::GetData(input))
{
}

WholeInput::WholeInput(const Ranks& ranks, vtkDataObject* piece)
{
  if (ranks.AreSeveral())
  {
    this->Gathered = ranks.Gather(piece);
  }
  else
  {
    this->Own = piece;
  }
}

bool WholeInput::Share(vtkMultiProcessController* controller)
{
  const bool isFirst = controller->GetLocalProcessId() == 0;
  this->Gathered.Offsets.resize(static_cast<std::size_t>(controller->GetNumberOfProcesses()) + 1);
  controller->Broadcast(
    this->Gathered.Offsets.data(), static_cast<vtkIdType>(this->Gathered.Offsets.size()), 0);
  int isReady = 1;
  try
  {
    this->Gathered.Bytes.resize(static_cast<std::size_t>(this->Gathered.Offsets.back()));
  }
  catch (const std::bad_alloc&)
  {
    isReady = 0;
  }
  int areReady = 0;
  controller->AllReduce(&isReady, &areReady, 1, vtkCommunicator::MIN_OP);
  std::vector<char>& bytes = this->Gathered.Bytes;
  if (areReady == 0 && !isFirst)
  {
    this->Gathered = GatheredBytes();
  }
  for (std::size_t first = 0; areReady != 0 && first < bytes.size(); first += LargestMessage)
  {
    const std::size_t size = std::min<std::size_t>(bytes.size() - first, LargestMessage);
    controller->Broadcast(bytes.data() + first, static_cast<vtkIdType>(size), 0);
  }
  return areReady != 0;
}

vtkSmartPointer<vtkDataObject> WholeInput::Make() const
{
  if (this->Gathered.Offsets.empty())
  {
    return this->Own;
  }
  const char* bytes = this->Gathered.Bytes.data();
  const std::vector<vtkIdType>& offsets = this->Gathered.Offsets;
  Pieces pieces;
  for (std::size_t rank = 0; rank + 1 < offsets.size(); ++rank)
  {
    bool isRepeated = false;
    for (std::size_t other = 0; other < rank && !isRepeated; ++other)
    {
      isRepeated = std::equal(bytes + offsets[rank], bytes + offsets[rank + 1],
        bytes + offsets[other], bytes + offsets[other + 1]);
    }
    if (!isRepeated)
    {
      ByteReader packed(this->Gathered.Bytes, static_cast<std::size_t>(offsets[rank]));
      pieces.push_back(Unpack(packed));
    }
  }
  return WholeFromPieces(pieces);
}

} // namespace biting
