// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawing.h"

#include "../Data/ArrayFromVector.h"
#include "../Data/Arrays.h"
#include "../Data/DataTree.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm> // for fill, max

namespace biting
{

namespace
{

// Collects the datasets of a tree.
class BlockCollector
{
public:
  void Visit(vtkDataObject* object, const std::string& name);

  Drawing& Result;

private:
  void VisitTree(vtkDataObjectTree* tree, const std::string& name);
  void VisitLeaves(vtkCompositeDataSet* composite, const std::string& name);
  void Add(vtkDataSet* data, const std::string& name);
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

// Puts the arrays of all blocks, those of points or those of cells, together by name.
void UniteArrays(const Drawing& drawing, int association, vtkFieldData* united)
{
  std::vector<PieceArrays> pieces;
  vtkIdType size = 0;
  for (const DrawingBlock& block : drawing.Blocks)
  {
    pieces.push_back(
      { vtkSmartPointer<vtkFieldData>::New(), block.Data->GetNumberOfElements(association) });
    pieces.back().Arrays->ShallowCopy(block.Data->GetAttributes(association));
    pieces.back().Arrays->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    size += pieces.back().Size;
  }
  for (const std::string& name : MakeArraysAlike(pieces))
  {
    vtkAbstractArray* like = pieces.front().Arrays->GetAbstractArray(name.c_str());
    const auto whole = NewArrayLike(like, size);
    vtkIdType first = 0;
    vtkIdType lacking = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      vtkAbstractArray* own =
        drawing.Blocks[k].Data->GetAttributes(association)->GetAbstractArray(name.c_str());
      const vtkIdType given = own ? own->GetNumberOfTuples() : pieces[k].Size;
      lacking += std::max(pieces[k].Size - given, vtkIdType{ 0 });
      whole->InsertTuples(
        first, pieces[k].Size, 0, pieces[k].Arrays->GetAbstractArray(name.c_str()));
      first += pieces[k].Size;
    }
    // One that has too few values is refused, or left out, as it would be of one dataset.
    whole->SetNumberOfTuples(size - lacking);
    united->AddArray(whole);
  }
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
  UniteArrays(drawing, vtkDataObject::POINT, united->GetPointData());
  return united;
}

vtkSmartPointer<vtkFieldData> UnitedCellArrays(const Drawing& drawing)
{
  auto united = vtkSmartPointer<vtkFieldData>::New();
  UniteArrays(drawing, vtkDataObject::CELL, united);
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
  BlockCollector{ drawing }.Visit(input, "");
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
