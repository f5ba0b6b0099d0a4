// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawing.h"

#include "DataTree.h"
#include "DoubleArray.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm> // for fill
#include <limits>    // for NaN

namespace biting
{

namespace
{

// Collects the datasets of a tree.
class BlockCollector
{
public:
  explicit BlockCollector(Drawing& drawing)
    : Result(drawing)
  {
  }

  void Visit(vtkDataObject* object, const std::string& name);

private:
  void VisitTree(vtkDataObjectTree* tree, const std::string& name);
  void VisitLeaves(vtkCompositeDataSet* composite, const std::string& name);
  void Add(vtkDataSet* data, const std::string& name);

  Drawing& Result;
};

void BlockCollector::Visit(vtkDataObject* object, const std::string& name)
{
  if (auto* data = vtkDataSet::SafeDownCast(object))
  {
    this->Add(data, name);
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    this->VisitTree(tree, name);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    this->VisitLeaves(composite, name);
  }
}

void BlockCollector::VisitTree(vtkDataObjectTree* tree, const std::string& name)
{
  for (unsigned int child = 0; child < NumberOfChildren(tree); ++child)
  {
    const std::string own = NameOfChild(tree, child);
    this->Visit(ChildOf(tree, child), own.empty() ? name : own);
  }
}

void BlockCollector::VisitLeaves(vtkCompositeDataSet* composite, const std::string& name)
{
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    this->Visit(leaf->GetCurrentDataObject(), name);
  }
}

void BlockCollector::Add(vtkDataSet* data, const std::string& name)
{
  DrawingBlock block;
  block.Data = data;
  block.Name = name;
  block.FirstPoint = this->Result.NumberOfPoints;
  block.FirstCell = this->Result.NumberOfCells;
  this->Result.Blocks.push_back(block);
  this->Result.NumberOfPoints += data->GetNumberOfPoints();
  this->Result.NumberOfCells += data->GetNumberOfCells();
}

// Arrays of one kind in all blocks.
class ArrayUnion
{
public:
  ArrayUnion(const Drawing& drawing, int association, vtkFieldData* united)
    : Blocks(drawing.Blocks)
    , Association(association)
    , Size(association == vtkDataObject::POINT ? drawing.NumberOfPoints : drawing.NumberOfCells)
    , United(united)
  {
  }

  void Run();

private:
  vtkFieldData* ArraysOf(const DrawingBlock& block) const
  {
    return block.Data->GetAttributes(this->Association);
  }
  vtkIdType SizeOf(const DrawingBlock& block) const
  {
    return block.Data->GetNumberOfElements(this->Association);
  }
  vtkIdType FirstOf(const DrawingBlock& block) const
  {
    return this->Association == vtkDataObject::POINT ? block.FirstPoint : block.FirstCell;
  }
  void Add(vtkAbstractArray* model);
  bool Fits(vtkAbstractArray* array, vtkAbstractArray* model, const DrawingBlock& block) const;

  const std::vector<DrawingBlock>& Blocks;
  int Association;
  vtkIdType Size;
  vtkFieldData* United;
};

void ArrayUnion::Run()
{
  for (const DrawingBlock& block : this->Blocks)
  {
    vtkFieldData* arrays = this->ArraysOf(block);
    for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
    {
      const char* name = arrays->GetAbstractArray(k)->GetName();
      const bool isGhosts = name && std::string(name) == vtkDataSetAttributes::GhostArrayName();
      if (name && !isGhosts && !this->United->HasArray(name))
      {
        this->Add(arrays->GetAbstractArray(k));
      }
    }
  }
}

void FillWithNaNOrZero(vtkAbstractArray* array)
{
  if (auto* values = vtkDataArray::SafeDownCast(array))
  {
    const bool isReal = values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE;
    values->Fill(isReal ? std::numeric_limits<double>::quiet_NaN() : 0.0);
  }
}

void ArrayUnion::Add(vtkAbstractArray* model)
{
  auto united = vtk::TakeSmartPointer(model->NewInstance());
  united->SetName(model->GetName());
  united->SetNumberOfComponents(model->GetNumberOfComponents());
  united->CopyComponentNames(model);
  united->SetNumberOfTuples(this->Size);
  FillWithNaNOrZero(united);
  for (const DrawingBlock& block : this->Blocks)
  {
    vtkAbstractArray* array = this->ArraysOf(block)->GetAbstractArray(model->GetName());
    if (array && this->Fits(array, model, block))
    {
      united->InsertTuples(this->FirstOf(block), this->SizeOf(block), 0, array);
    }
  }
  this->United->AddArray(united);
}

bool ArrayUnion::Fits(
  vtkAbstractArray* array, vtkAbstractArray* model, const DrawingBlock& block) const
{
  return array->IsNumeric() == model->IsNumeric() &&
    array->GetNumberOfComponents() == model->GetNumberOfComponents() &&
    array->GetNumberOfTuples() >= this->SizeOf(block);
}

vtkSmartPointer<vtkDataSet> UnitedPoints(const Drawing& drawing)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(drawing.NumberOfPoints);
  for (const DrawingBlock& block : drawing.Blocks)
  {
    const auto own = CoordinatesOf(block.Data);
    coordinates->InsertTuples(block.FirstPoint, own->GetNumberOfTuples(), 0, own);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto united = vtkSmartPointer<vtkPolyData>::New();
  united->SetPoints(points);
  ArrayUnion(drawing, vtkDataObject::POINT, united->GetPointData()).Run();
  return united;
}

vtkSmartPointer<vtkFieldData> UnitedCellArrays(const Drawing& drawing)
{
  auto united = vtkSmartPointer<vtkFieldData>::New();
  ArrayUnion(drawing, vtkDataObject::CELL, united).Run();
  vtkNew<vtkStringArray> names;
  names->SetName("BlockName");
  names->SetNumberOfValues(drawing.NumberOfCells);
  for (const DrawingBlock& block : drawing.Blocks)
  {
    const vtkIdType cells = block.Data->GetNumberOfCells();
    std::fill_n(names->GetPointer(block.FirstCell), cells, vtkStdString(block.Name));
  }
  united->AddArray(names);
  return united;
}

} // namespace

std::vector<unsigned char> Drawing::FindGiven(const char* name) const
{
  std::vector<unsigned char> isGiven(static_cast<std::size_t>(this->NumberOfPoints), 1);
  bool haveAll = true;
  for (const DrawingBlock& block : this->Blocks)
  {
    if (!block.Data->GetPointData()->HasArray(name))
    {
      std::fill_n(isGiven.begin() + block.FirstPoint, block.Data->GetNumberOfPoints(),
        static_cast<unsigned char>(0));
      haveAll = false;
    }
  }
  return haveAll ? std::vector<unsigned char>() : isGiven;
}

int Drawing::CoordinateType() const
{
  int type = VTK_DOUBLE;
  for (const DrawingBlock& block : this->Blocks)
  {
    const int own = TypeOfCoordinates(block.Data);
    type = own == VTK_DOUBLE || type == VTK_FLOAT ? type : own;
  }
  return type;
}

Drawing ReadDrawing(vtkDataObject* input)
{
  Drawing drawing;
  BlockCollector(drawing).Visit(input, "");
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    drawing.Points = data;
    drawing.CellArrays = data->GetCellData();
  }
  else
  {
    drawing.Points = UnitedPoints(drawing);
    drawing.CellArrays = UnitedCellArrays(drawing);
  }
  return drawing;
}

} // namespace biting
