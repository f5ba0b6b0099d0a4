// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CorpusChecks.h"
#include "RemesherTesting.h"

#include "vtkDelaunay2D.h"

#include <gtest/gtest.h>

#include <iostream>

/// Meshes of all kinds are refined to f/2 and coarsened to 2f: what bounds them stays.
namespace
{

using namespace testing_filters;

// Of drawings and meshes: larger ones show no more, and take long.
constexpr vtkIdType MostPoints = 3000;

constexpr double Halved = 0.5;
constexpr double Doubled = 2.0;

struct Meshing
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Edges;
};

Meshing MeshOf(const Case& example)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(example.Input);
  mesher->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  mesher->SetUniformSpacing(example.Spacing);
  mesher->Update();
  return { mesher->GetOutput(0), mesher->GetOutput(1) };
}

/// To its own spacing times a factor.
Meshing Remeshed(const Meshing& old, double scale, int policy, std::string& verdict)
{
  const auto remesher = RemesherOf(old.Mesh);
  const Messages messages(remesher);
  remesher->SetTaggedLinesData(old.Edges);
  remesher->SetSpacingScale(scale);
  remesher->SetEdgePolicy(policy);
  remesher->Update();
  if (!messages.Errors.empty())
  {
    verdict = messages.Errors.front();
  }
  return { remesher->GetOutput(0), remesher->GetOutput(1) };
}

/// Where vertices of straight parts may go only the area tells that nothing else went.
std::string Judge(const Case& example, const Meshing& mesh, const Meshing& first, int policy)
{
  if (policy == vtkBitingRemesher::SPLIT_ONLY)
  {
    return CheckMesh(example, mesh.Mesh, first.Mesh);
  }
  const MeshChecker checker(mesh.Mesh);
  const std::string verdict = checker.CheckValidity();
  return verdict.empty() ? CheckArea(example, checker) : verdict;
}

/// The first thing that is wrong with one of the meshes, empty where nothing is.
std::string JudgeRoundTrip(const Case& example, const Meshing& first, double scale, int policy)
{
  std::string verdict;
  Meshing mesh = first;
  for (const double factor : { scale, 1.0 / scale })
  {
    mesh = Remeshed(mesh, factor, policy, verdict);
    verdict = verdict.empty() ? Judge(example, mesh, first, policy) : verdict;
  }
  return verdict;
}

/// Mean lengths of the edges at each point, as `Wanted`.
void AddLengths(vtkPolyData* mesh)
{
  std::vector<double> sums(mesh->GetNumberOfPoints(), 0.0);
  std::vector<double> counts(sums.size(), 0.0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType start = ids->GetId(k);
      const vtkIdType end = ids->GetId((k + 1) % 3);
      const double length = std::sqrt(
        vtkMath::Distance2BetweenPoints(PointOf(mesh, start).data(), PointOf(mesh, end).data()));
      for (const vtkIdType point : { start, end })
      {
        sums[point] += length;
        counts[point] += 1.0;
      }
    }
  }
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Wanted");
  for (std::size_t point = 0; point < sums.size(); ++point)
  {
    lengths->InsertNextValue(counts[point] > 0.0 ? sums[point] / counts[point] : 1.0);
  }
  mesh->GetPointData()->AddArray(lengths);
}

} // namespace

TEST(SharedCorpus, IsRefinedAndCoarsenedAndBack)
{
  const auto entries = SharedEntries({ "V", "W" });
  if (entries.empty())
  {
    std::cout << "No shared inputs: nothing judged.\n";
  }
  int meshes = 0;
  for (const CorpusEntry& entry : entries)
  {
    const Case example = CaseOf(entry);
    const bool isSmall = example.Input->GetNumberOfPoints() <= MostPoints;
    const Meshing first = isSmall && IsFlat(example.Input) ? MeshOf(example) : Meshing();
    if (first.Mesh && first.Mesh->GetNumberOfPoints() <= MostPoints)
    {
      ++meshes;
      EXPECT_EQ(JudgeRoundTrip(example, first, Halved, vtkBitingRemesher::SPLIT_ONLY), "")
        << entry.File;
      EXPECT_EQ(JudgeRoundTrip(example, first, Doubled, vtkBitingRemesher::FREE), "") << entry.File;
    }
  }
  std::cout << meshes << " meshes of inputs.\n";
  EXPECT_TRUE(entries.empty() || meshes > 20);
}

// They are no good meshes: slivers along the hull, and edges of all lengths.
TEST(SharedCorpus, HasPointsWhoseDelaunayMeshesAreRefinedAndCoarsened)
{
  int meshes = 0;
  for (const CorpusEntry& entry : SharedEntries({ "V", "W", "R" }))
  {
    const Case example = CaseOf(entry);
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(example.Input->GetPoints());
    vtkNew<vtkDelaunay2D> delaunay;
    delaunay->SetInputData(cloud);
    delaunay->Update();
    vtkPolyData* mesh = delaunay->GetOutput();
    const MeshChecker given(mesh);
    if (!IsFlat(example.Input) || mesh->GetNumberOfPolys() == 0 || !given.CheckValidity().empty())
    {
      continue;
    }
    ++meshes;
    AddLengths(mesh);
    for (const double scale : { Halved, Doubled })
    {
      const auto remesher = RemesherOf(mesh);
      const Messages messages(remesher);
      remesher->SetSpacingScale(scale);
      remesher->Update();
      EXPECT_EQ(messages.Errors.size(), 0u) << entry.File << ": " << messages.Errors.front();
      const MeshChecker checker(remesher->GetOutput());
      EXPECT_EQ(checker.CheckValidity(), "") << entry.File;
      EXPECT_EQ(checker.CheckArea(given.Area(), 1e-9 * given.Area()), "") << entry.File;
    }
  }
  std::cout << meshes << " meshes of points by Delaunay.\n";
  EXPECT_TRUE(SharedInputs().empty() || meshes > 20);
}
