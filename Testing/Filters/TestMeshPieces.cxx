// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Pieces of a mesh as ranks have them: together they are the mesh.

#include "Bridge/MeshPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace
{

constexpr int Size = 8; // squares a side, two triangles each
constexpr biting::Id Ranks = 3;

/// A grid of triangles; points and triangles have an array, squares of their number.
vtkSmartPointer<vtkPolyData> Grid()
{
  auto grid = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> ofPoints;
  vtkNew<vtkDoubleArray> ofCells;
  ofPoints->SetName("P");
  ofCells->SetName("C");
  for (int k = 0; k < (Size + 1) * (Size + 1); ++k)
  {
    points->InsertNextPoint(k % (Size + 1), k / (Size + 1), 0.1 * k);
    ofPoints->InsertNextValue(k * k);
  }
  for (int k = 0; k < Size * Size; ++k)
  {
    const vtkIdType first = k % Size + (k / Size) * (Size + 1);
    const vtkIdType low[] = { first, first + 1, first + Size + 2 };
    const vtkIdType high[] = { first, first + Size + 2, first + Size + 1 };
    cells->InsertNextCell(3, low);
    cells->InsertNextCell(3, high);
    ofCells->InsertNextValue(4.0 * k * k);
    ofCells->InsertNextValue((2.0 * k + 1) * (2.0 * k + 1));
  }
  grid->SetPoints(points);
  grid->SetPolys(cells);
  grid->GetPointData()->AddArray(ofPoints);
  grid->GetCellData()->SetScalars(ofCells);
  vtkNew<vtkDoubleArray> figure;
  figure->SetName("Figure");
  figure->InsertNextValue(5.0);
  grid->GetFieldData()->AddArray(figure);
  return grid;
}

/// In columns of 5, 2 and 1 squares.
biting::Id PieceOf(vtkIdType triangle)
{
  const int column = static_cast<int>(triangle / 2) % Size;
  return column < 5 ? 0 : (column < 7 ? 1 : 2);
}

std::vector<vtkSmartPointer<vtkPolyData>> PiecesOfGrid(int ghostLevels)
{
  std::vector<biting::Id> pieces;
  for (vtkIdType triangle = 0; triangle < 2 * Size * Size; ++triangle)
  {
    pieces.push_back(PieceOf(triangle));
  }
  biting::MeshPieces made(Grid(), pieces, Ranks);
  made.SetGhostLevels(ghostLevels);
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  for (biting::Id piece = 0; piece < Ranks; ++piece)
  {
    all.push_back(made.Make(piece));
  }
  return all;
}

vtkIdType GlobalId(vtkDataSetAttributes* data, vtkIdType k)
{
  return static_cast<vtkIdType>(data->GetGlobalIds()->GetTuple1(k));
}

bool IsGhost(vtkDataSetAttributes* data, vtkIdType k)
{
  vtkDataArray* ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
  return ghosts && ghosts->GetTuple1(k) != 0.0;
}

/// Corners by global id.
std::vector<vtkIdType> CornersOf(vtkPolyData* piece, vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  piece->GetCellPoints(cell, points);
  std::vector<vtkIdType> corners;
  for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
  {
    corners.push_back(GlobalId(piece->GetPointData(), points->GetId(k)));
  }
  return corners;
}

class MeshPieces : public ::testing::TestWithParam<int>
{
};

} // namespace

TEST_P(MeshPieces, EachPointAndTriangleIsOwnedOnceAndAsInTheMesh)
{
  const auto grid = Grid();
  std::set<vtkIdType> points;
  std::set<vtkIdType> cells;
  for (const auto& piece : PiecesOfGrid(GetParam()))
  {
    for (vtkIdType k = 0; k < piece->GetNumberOfPoints(); ++k)
    {
      const vtkIdType id = GlobalId(piece->GetPointData(), k);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(piece->GetPoint(k)[axis], grid->GetPoint(id)[axis]);
      }
      EXPECT_EQ(piece->GetPointData()->GetArray("P")->GetTuple1(k), static_cast<double>(id * id));
      EXPECT_TRUE(IsGhost(piece->GetPointData(), k) || points.insert(id).second);
    }
    for (vtkIdType k = 0; k < piece->GetNumberOfCells(); ++k)
    {
      const vtkIdType id = GlobalId(piece->GetCellData(), k);
      EXPECT_EQ(CornersOf(piece, k), CornersOf(piece, k));
      vtkNew<vtkIdList> corners;
      grid->GetCellPoints(id, corners);
      EXPECT_EQ(CornersOf(piece, k),
        (std::vector<vtkIdType>{ corners->GetId(0), corners->GetId(1), corners->GetId(2) }));
      EXPECT_EQ(piece->GetCellData()->GetScalars()->GetTuple1(k), static_cast<double>(id * id));
      EXPECT_TRUE(IsGhost(piece->GetCellData(), k) || cells.insert(id).second);
    }
  }
  EXPECT_EQ(points.size(), static_cast<std::size_t>(grid->GetNumberOfPoints()));
  EXPECT_EQ(cells.size(), static_cast<std::size_t>(grid->GetNumberOfCells()));
}

TEST_P(MeshPieces, OrderIsThatOfTheMeshAndNoPointIsUnused)
{
  for (const auto& piece : PiecesOfGrid(GetParam()))
  {
    std::set<vtkIdType> used;
    for (vtkIdType k = 0; k < piece->GetNumberOfCells(); ++k)
    {
      const auto corners = CornersOf(piece, k);
      used.insert(corners.begin(), corners.end());
      EXPECT_TRUE(
        k == 0 || GlobalId(piece->GetCellData(), k - 1) < GlobalId(piece->GetCellData(), k));
    }
    EXPECT_EQ(used.size(), static_cast<std::size_t>(piece->GetNumberOfPoints()));
    for (vtkIdType k = 1; k < piece->GetNumberOfPoints(); ++k)
    {
      EXPECT_LT(GlobalId(piece->GetPointData(), k - 1), GlobalId(piece->GetPointData(), k));
    }
    EXPECT_EQ(piece->GetFieldData()->GetArray("Figure")->GetTuple1(0), 5.0);
  }
}

// Triangles that share a point with what is there are the next level.
TEST_P(MeshPieces, GhostsAreAllTrianglesWithinTheirLevelsAndNoOthers)
{
  const auto grid = Grid();
  const auto pieces = PiecesOfGrid(GetParam());
  for (biting::Id piece = 0; piece < Ranks; ++piece)
  {
    std::set<vtkIdType> points;
    std::set<vtkIdType> expected;
    vtkNew<vtkIdList> corners;
    for (int level = -1; level < GetParam(); ++level)
    {
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        bool touches = PieceOf(cell) == piece;
        grid->GetCellPoints(cell, corners);
        for (vtkIdType k = 0; k < 3; ++k)
        {
          touches = touches || points.count(corners->GetId(k)) > 0;
        }
        if (touches)
        {
          expected.insert(cell);
        }
      }
      for (const vtkIdType cell : expected)
      {
        grid->GetCellPoints(cell, corners);
        points.insert(corners->begin(), corners->end());
      }
    }
    vtkPolyData* made = pieces[static_cast<std::size_t>(piece)];
    EXPECT_EQ(made->GetNumberOfCells(), static_cast<vtkIdType>(expected.size()));
    for (vtkIdType k = 0; k < made->GetNumberOfCells(); ++k)
    {
      const vtkIdType id = GlobalId(made->GetCellData(), k);
      EXPECT_EQ(expected.count(id), 1u);
      EXPECT_EQ(IsGhost(made->GetCellData(), k), PieceOf(id) != piece);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, MeshPieces, ::testing::Values(0, 1, 2));

TEST(MeshPieces, ASharedPointBelongsToTheFirstPieceThatUsesIt)
{
  const auto pieces = PiecesOfGrid(0);
  for (vtkIdType k = 0; k < pieces[0]->GetNumberOfPoints(); ++k)
  {
    EXPECT_FALSE(IsGhost(pieces[0]->GetPointData(), k));
  }
  for (vtkIdType k = 0; k < pieces[1]->GetNumberOfPoints(); ++k)
  {
    EXPECT_EQ(IsGhost(pieces[1]->GetPointData(), k), pieces[1]->GetPoint(k)[0] == 5.0);
  }
}
