// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WholeFromPieces.h"

#include "../Data/AlikeArrays.h"
#include "../Data/DataTree.h"
#include "MeshFromPieces.h"
#include "StructuredFromPieces.h"

#include "vtkDataSet.h"
#include "vtkPartitionedDataSet.h"

#include <algorithm> // for all_of, find_if, max
#include <string>    // for names

namespace biting
{

namespace
{

// Those that have anything, and a number of blocks.
Pieces Contributing(const Pieces& pieces)
{
  Pieces contributing;
  for (const auto& piece : pieces)
  {
    if (piece && !LeavesOf(piece).empty())
    {
      contributing.push_back(piece);
    }
  }
  return contributing;
}

vtkSmartPointer<vtkDataObject> FirstOf(const Pieces& pieces)
{
  const auto first =
    std::find_if(pieces.begin(), pieces.end(), [](const auto& piece) { return piece != nullptr; });
  return first == pieces.end() ? nullptr : *first;
}

Pieces LeavesOfAll(const Pieces& pieces)
{
  Pieces all;
  for (const auto& piece : pieces)
  {
    for (const auto& leaf : LeavesOf(piece))
    {
      all.emplace_back(leaf);
    }
  }
  return all;
}

bool AreTrees(const Pieces& pieces)
{
  const int type = pieces.front()->GetDataObjectType();
  return vtkDataObjectTree::SafeDownCast(pieces.front()) &&
    std::all_of(pieces.begin(), pieces.end(),
      [type](const auto& piece) { return piece->GetDataObjectType() == type; });
}

vtkSmartPointer<vtkDataObject> PartsAsOne(const Pieces& pieces)
{
  auto* like = vtkPartitionedDataSet::SafeDownCast(pieces.front());
  auto whole = vtk::TakeSmartPointer(like->NewInstance());
  whole->SetPartition(0, WholeFromPieces(LeavesOfAll(pieces)));
  return whole;
}

vtkSmartPointer<vtkDataObject> TreeFromPieces(const Pieces& pieces)
{
  if (vtkPartitionedDataSet::SafeDownCast(pieces.front()))
  {
    return PartsAsOne(pieces);
  }
  auto* like = vtkDataObjectTree::SafeDownCast(pieces.front());
  auto whole = vtk::TakeSmartPointer(like->NewInstance());
  unsigned int count = 0;
  for (const auto& piece : pieces)
  {
    count = std::max(count, NumberOfChildren(vtkDataObjectTree::SafeDownCast(piece)));
  }
  for (unsigned int child = 0; child < count; ++child)
  {
    Pieces children;
    std::string name;
    for (const auto& piece : pieces)
    {
      auto* tree = vtkDataObjectTree::SafeDownCast(piece);
      const bool isThere = child < NumberOfChildren(tree);
      children.emplace_back(isThere ? ChildOf(tree, child) : nullptr);
      name = isThere && name.empty() ? NameOfChild(tree, child) : name;
    }
    SetChild(whole, child, WholeFromPieces(children), name);
  }
  return whole;
}

} // namespace

vtkSmartPointer<vtkDataObject> WholeFromPieces(const Pieces& pieces)
{
  const Pieces contributing = Contributing(pieces);
  if (contributing.size() < 2)
  {
    return contributing.empty() ? FirstOf(pieces) : contributing.front();
  }
  if (AreTrees(contributing))
  {
    return TreeFromPieces(contributing);
  }
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
  for (const auto& leaf : LeavesOfAll(contributing))
  {
    leaves.emplace_back(vtkDataSet::SafeDownCast(leaf));
  }
  MakeArraysAlike(leaves);
  const auto structured = StructuredFromPieces(leaves);
  return structured ? structured : MeshFromPieces(leaves);
}

} // namespace biting
