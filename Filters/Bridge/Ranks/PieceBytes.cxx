// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceBytes.h"

#include "../Data/DataTree.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"

#include <cstring> // for copies of bytes
#include <string>  // for names

namespace biting
{

namespace
{

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
  int Extent[6];
  double Origin[3];
  double Spacing[3];
  double Direction[9];
};

class Packer
{
public:
  explicit Packer(std::vector<char>& bytes)
    : Bytes(bytes)
  {
  }

  bool Pack(vtkDataObject* piece);

private:
  bool PackTree(vtkDataObjectTree* tree);
  bool PackLeaf(vtkDataObject* leaf);
  void PackAxes(vtkImageData* image);

  template <typename Value>
  void Put(const Value& value)
  {
    const char* first = reinterpret_cast<const char*>(&value);
    this->Bytes.insert(this->Bytes.end(), first, first + sizeof(value));
  }

  std::vector<char>& Bytes;
};

bool Packer::Pack(vtkDataObject* piece)
{
  if (!piece)
  {
    this->Put(Form::Nothing);
    return true;
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(piece))
  {
    return this->PackTree(tree);
  }
  if (auto* image = vtkImageData::SafeDownCast(piece))
  {
    this->Put(Form::Image);
    this->PackAxes(image);
    return this->PackLeaf(piece);
  }
  this->Put(Form::Other);
  return vtkDataSet::SafeDownCast(piece) && this->PackLeaf(piece);
}

bool Packer::PackTree(vtkDataObjectTree* tree)
{
  this->Put(Form::Tree);
  this->Put(tree->GetDataObjectType());
  const unsigned int count = NumberOfChildren(tree);
  this->Put(count);
  bool isPacked = true;
  for (unsigned int child = 0; child < count && isPacked; ++child)
  {
    const std::string name = NameOfChild(tree, child);
    this->Put(name.size());
    this->Bytes.insert(this->Bytes.end(), name.begin(), name.end());
    isPacked = this->Pack(ChildOf(tree, child));
  }
  return isPacked;
}

void Packer::PackAxes(vtkImageData* image)
{
  ImageAxes axes;
  image->GetExtent(axes.Extent);
  image->GetOrigin(axes.Origin);
  image->GetSpacing(axes.Spacing);
  std::memcpy(axes.Direction, image->GetDirectionMatrix()->GetData(), sizeof(axes.Direction));
  this->Put(axes.Extent);
  this->Put(axes.Origin);
  this->Put(axes.Spacing);
  this->Put(axes.Direction);
}

bool Packer::PackLeaf(vtkDataObject* leaf)
{
  vtkNew<vtkCharArray> message;
  if (vtkCommunicator::MarshalDataObject(leaf, message) == 0)
  {
    return false;
  }
  const auto length = static_cast<std::size_t>(message->GetNumberOfValues());
  this->Put(length);
  const char* first = message->GetPointer(0);
  this->Bytes.insert(this->Bytes.end(), first, first + length);
  return true;
}

class Unpacker
{
public:
  explicit Unpacker(const char* bytes)
    : Next(bytes)
  {
  }

  vtkSmartPointer<vtkDataObject> Unpack();

private:
  vtkSmartPointer<vtkDataObject> UnpackTree();
  vtkSmartPointer<vtkDataObject> UnpackImage();
  vtkSmartPointer<vtkDataObject> UnpackLeaf();

  template <typename Value>
  void Take(Value& value)
  {
    std::memcpy(&value, this->Next, sizeof(value));
    this->Next += sizeof(value);
  }

  const char* Next;
};

vtkSmartPointer<vtkDataObject> Unpacker::Unpack()
{
  Form form = Form::Nothing;
  this->Take(form);
  switch (form)
  {
    case Form::Tree:
      return this->UnpackTree();
    case Form::Image:
      return this->UnpackImage();
    case Form::Other:
      return this->UnpackLeaf();
    default:
      return nullptr;
  }
}

vtkSmartPointer<vtkDataObject> Unpacker::UnpackTree()
{
  int type = 0;
  unsigned int count = 0;
  this->Take(type);
  this->Take(count);
  const auto object = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type));
  auto* tree = vtkDataObjectTree::SafeDownCast(object);
  for (unsigned int child = 0; child < count; ++child)
  {
    std::size_t length = 0;
    this->Take(length);
    const std::string name(this->Next, length);
    this->Next += length;
    SetChild(tree, child, this->Unpack(), name);
  }
  return object;
}

vtkSmartPointer<vtkDataObject> Unpacker::UnpackImage()
{
  ImageAxes axes;
  this->Take(axes.Extent);
  this->Take(axes.Origin);
  this->Take(axes.Spacing);
  this->Take(axes.Direction);
  const auto leaf = this->UnpackLeaf();
  if (auto* image = vtkImageData::SafeDownCast(leaf))
  {
    image->SetExtent(axes.Extent);
    image->SetOrigin(axes.Origin);
    image->SetSpacing(axes.Spacing);
    image->SetDirectionMatrix(axes.Direction);
  }
  return leaf;
}

vtkSmartPointer<vtkDataObject> Unpacker::UnpackLeaf()
{
  std::size_t length = 0;
  this->Take(length);
  vtkNew<vtkCharArray> message;
  message->SetNumberOfValues(static_cast<vtkIdType>(length));
  std::memcpy(message->GetPointer(0), this->Next, length);
  this->Next += length;
  return vtkCommunicator::UnMarshalDataObject(message);
}

} // namespace

bool PackPiece(vtkDataObject* piece, std::vector<char>& bytes)
{
  return Packer(bytes).Pack(piece);
}

vtkSmartPointer<vtkDataObject> UnpackPiece(const char* bytes)
{
  return Unpacker(bytes).Unpack();
}

} // namespace biting
