// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for any_of, copy_if, inplace_merge, min, sort, unique
#include <iterator>  // for back_inserter
#include <numeric>   // for iota, partial_sum
#include <utility>   // for move

namespace biting
{

namespace
{

using Numbers = std::vector<vtkIdType>;

// Groups 0 .. count - 1 by what `groupOf` says of each, in their order: where the first of each of
// `groups` is in `members`, and the end.
template <typename GroupOf>
Numbers GroupBy(vtkIdType count, std::size_t groups, const GroupOf& groupOf, Numbers& members)
{
  Numbers first(groups + 1, 0);
  for (vtkIdType k = 0; k < count; ++k)
  {
    ++first[static_cast<std::size_t>(groupOf(k)) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  Numbers next(first.begin(), first.end() - 1);
  members.resize(static_cast<std::size_t>(count));
  for (vtkIdType k = 0; k < count; ++k)
  {
    members[static_cast<std::size_t>(next[static_cast<std::size_t>(groupOf(k))]++)] = k;
  }
  return first;
}

// Sorted, each once.
void SortOnce(Numbers& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

// The tuples of all arrays, and with that their numbers as global ids.
void CopyTuples(
  vtkDataSetAttributes* from, const Numbers& ids, const char* idsName, vtkDataSetAttributes* to)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> fromIds;
  vtkNew<vtkIdList> toIds;
  fromIds->SetNumberOfIds(count);
  toIds->SetNumberOfIds(count);
  std::copy(ids.begin(), ids.end(), fromIds->GetPointer(0));
  std::iota(toIds->GetPointer(0), toIds->GetPointer(0) + count, vtkIdType{ 0 });
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->CopyData(from, fromIds, toIds);
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName(idsName);
  globalIds->SetNumberOfValues(count);
  std::copy(ids.begin(), ids.end(), globalIds->GetPointer(0));
  to->SetGlobalIds(globalIds);
}

vtkUnsignedCharArray* AddGhostArray(std::size_t count, vtkDataSetAttributes* to)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(static_cast<vtkIdType>(count));
  to->AddArray(ghosts);
  return ghosts;
}

} // namespace

std::vector<Id> PiecesOfTriangles(const BitingMesh& mesh, Id numberOfPieces, Pulse& pulse)
{
  if (mesh.Cuts.Nodes.empty())
  {
    return {};
  }
  const std::vector<Id> dealt = DealLeaves(mesh.Cuts, numberOfPieces);
  std::vector<Id> pieces(mesh.Regions.size());
  pulse.ForEach(pieces.size(),
    [&mesh, &dealt, &pieces](std::size_t triangle)
    {
      const Id* corners = mesh.Corners.data() + 3 * triangle;
      const Point2 sum =
        mesh.Points[corners[0]] + mesh.Points[corners[1]] + mesh.Points[corners[2]];
      const Id leaf = mesh.Cuts.NodeAt((1.0 / 3.0) * sum);
      pieces[triangle] = dealt[mesh.Cuts.Nodes[leaf].Leaf];
    });
  return pieces;
}

MeshPieces::MeshPieces(
  vtkSmartPointer<vtkPolyData> mesh, std::vector<Id> piecesOfTriangles, Id numberOfPieces)
  : Mesh(std::move(mesh))
  , Pieces(std::move(piecesOfTriangles))
  , NumberOfPieces(numberOfPieces)
  , NewIds(static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()))
{
  this->Corners.reserve(3 * this->Pieces.size());
  for (vtkIdType cell = 0; cell < this->Mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    const vtkIdType* corners = nullptr;
    vtkIdType size = 0;
    this->Mesh->GetPolys()->GetCellAtId(cell, size, corners);
    this->Corners.insert(this->Corners.end(), corners, corners + size);
  }
  this->OwnPoints();
  this->ListTriangles();
}

void MeshPieces::SetGhostLevels(int levels)
{
  this->GhostLevels = levels;
  if (levels > 0)
  {
    this->ListUses();
  }
}

void MeshPieces::OwnPoints()
{
  this->Owners.assign(this->NewIds.size(), this->NumberOfPieces);
  for (std::size_t slot = 0; slot < this->Corners.size(); ++slot)
  {
    Id& owner = this->Owners[static_cast<std::size_t>(this->Corners[slot])];
    owner = std::min(owner, this->Pieces[slot / 3]);
  }
  // A point that no triangle uses is in no piece.
  this->FirstPoints = GroupBy(
    static_cast<vtkIdType>(this->Owners.size()), static_cast<std::size_t>(this->NumberOfPieces) + 1,
    [this](vtkIdType point) { return this->Owners[static_cast<std::size_t>(point)]; },
    this->OwnedPoints);
}

void MeshPieces::ListTriangles()
{
  this->FirstTriangles = GroupBy(
    static_cast<vtkIdType>(this->Pieces.size()), static_cast<std::size_t>(this->NumberOfPieces),
    [this](vtkIdType triangle) { return this->Pieces[static_cast<std::size_t>(triangle)]; },
    this->Triangles);
}

void MeshPieces::ListUses()
{
  this->FirstUses = GroupBy(
    static_cast<vtkIdType>(this->Corners.size()), this->NewIds.size(),
    [this](vtkIdType slot) { return this->Corners[static_cast<std::size_t>(slot)]; }, this->Uses);
  for (vtkIdType& use : this->Uses)
  {
    use /= 3;
  }
}

vtkSmartPointer<vtkPolyData> MeshPieces::Make(Id piece)
{
  const Numbers triangles = this->TrianglesOf(piece);
  const Numbers points = this->PointsOf(piece, triangles);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    this->NewIds[static_cast<std::size_t>(points[k])] = static_cast<vtkIdType>(k);
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  this->AddPoints(piece, points, output);
  this->AddTriangles(piece, triangles, output);
  output->SetFieldData(this->Mesh->GetFieldData());
  return output;
}

Numbers MeshPieces::TrianglesOf(Id piece) const
{
  const auto own = static_cast<std::size_t>(piece);
  const auto begin = this->Triangles.begin();
  Numbers triangles(begin + this->FirstTriangles[own], begin + this->FirstTriangles[own + 1]);
  Numbers ghosts;
  Numbers points;
  for (const vtkIdType triangle : this->GhostLevels > 0 ? triangles : Numbers())
  {
    const auto corner = this->Corners.begin() + 3 * triangle;
    std::copy_if(corner, corner + 3, std::back_inserter(points),
      [this](vtkIdType point) { return this->IsShared(point); });
  }
  for (int level = 0; level < this->GhostLevels; ++level)
  {
    this->AddLevel(piece, points, ghosts);
  }
  triangles.insert(triangles.end(), ghosts.begin(), ghosts.end());
  std::inplace_merge(triangles.begin(),
    triangles.end() - static_cast<Numbers::difference_type>(ghosts.size()), triangles.end());
  return triangles;
}

bool MeshPieces::IsShared(vtkIdType point) const
{
  const auto begin = this->Uses.begin();
  const auto first = begin + this->FirstUses[static_cast<std::size_t>(point)];
  const auto end = begin + this->FirstUses[static_cast<std::size_t>(point) + 1];
  const Id piece = this->Pieces[static_cast<std::size_t>(*first)];
  return std::any_of(first, end,
    [this, piece](vtkIdType triangle)
    { return this->Pieces[static_cast<std::size_t>(triangle)] != piece; });
}

// The triangles of other pieces around the points, which become those of these triangles.
void MeshPieces::AddLevel(Id piece, Numbers& points, Numbers& ghosts) const
{
  SortOnce(points);
  for (const vtkIdType point : points)
  {
    const auto begin = this->Uses.begin();
    std::copy_if(begin + this->FirstUses[static_cast<std::size_t>(point)],
      begin + this->FirstUses[static_cast<std::size_t>(point) + 1], std::back_inserter(ghosts),
      [this, piece](vtkIdType triangle)
      { return this->Pieces[static_cast<std::size_t>(triangle)] != piece; });
  }
  SortOnce(ghosts);
  points.clear();
  for (const vtkIdType triangle : ghosts)
  {
    const auto corner = this->Corners.begin() + 3 * triangle;
    points.insert(points.end(), corner, corner + 3);
  }
}

// Those that it owns, and those that its triangles share with others.
Numbers MeshPieces::PointsOf(Id piece, const Numbers& triangles) const
{
  const auto own = static_cast<std::size_t>(piece);
  const auto begin = this->OwnedPoints.begin();
  Numbers points(begin + this->FirstPoints[own], begin + this->FirstPoints[own + 1]);
  Numbers others;
  for (const vtkIdType triangle : triangles)
  {
    const auto corner = this->Corners.begin() + 3 * triangle;
    std::copy_if(corner, corner + 3, std::back_inserter(others),
      [this, piece](vtkIdType point)
      { return this->Owners[static_cast<std::size_t>(point)] != piece; });
  }
  SortOnce(others);
  points.insert(points.end(), others.begin(), others.end());
  std::inplace_merge(points.begin(),
    points.end() - static_cast<Numbers::difference_type>(others.size()), points.end());
  return points;
}

void MeshPieces::AddPoints(Id piece, const Numbers& points, vtkPolyData* output) const
{
  CopyTuples(this->Mesh->GetPointData(), points, "GlobalPointIds", output->GetPointData());
  vtkNew<vtkPoints> places;
  places->SetDataType(this->Mesh->GetPoints()->GetDataType());
  places->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  vtkUnsignedCharArray* ghosts = AddGhostArray(points.size(), output->GetPointData());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const auto id = static_cast<vtkIdType>(k);
    const bool isOwn = this->Owners[static_cast<std::size_t>(points[k])] == piece;
    places->SetPoint(id, this->Mesh->GetPoints()->GetPoint(points[k]));
    ghosts->SetValue(id, isOwn ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
  }
  output->SetPoints(places);
}

void MeshPieces::AddTriangles(Id piece, const Numbers& triangles, vtkPolyData* output) const
{
  CopyTuples(this->Mesh->GetCellData(), triangles, "GlobalCellIds", output->GetCellData());
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(triangles.size()) + 1);
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  offsets->SetValue(0, 0);
  vtkIdType end = 0;
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    for (vtkIdType slot = 3 * triangles[k]; slot < 3 * triangles[k] + 3; ++slot)
    {
      const auto point = static_cast<std::size_t>(this->Corners[static_cast<std::size_t>(slot)]);
      corners->SetValue(end++, this->NewIds[point]);
    }
    offsets->SetValue(static_cast<vtkIdType>(k) + 1, end);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetPolys(cells);
  if (this->GhostLevels > 0)
  {
    vtkUnsignedCharArray* ghosts = AddGhostArray(triangles.size(), output->GetCellData());
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
      const bool isOwn = this->Pieces[static_cast<std::size_t>(triangles[k])] == piece;
      ghosts->SetValue(static_cast<vtkIdType>(k), isOwn ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
  }
}

} // namespace biting
