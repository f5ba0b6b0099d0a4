// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCorpusCase_h
#define BitingCorpusCase_h

#include "FilterTesting.h"

#include "vtkDataSet.h"
#include "vtkDataSetReader.h"

#include <functional> // for changes
#include <string>     // for paths

namespace testing_filters
{

// An input as it lies in the corpus or changed, and what is expected of its mesh.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Input;
  double Spacing = 0.0;
  double Area = 0.0; // not a number where it is not known
};

using Change = std::function<void(Case&)>;

// Numbers of points: of inputs for every change, and for those that the largest inputs undergo too.
constexpr vtkIdType Ordinary = 20000;
constexpr vtkIdType AnySize = std::numeric_limits<vtkIdType>::max();

inline vtkSmartPointer<vtkDataSet> Read(const std::string& path)
{
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return reader->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path)
{
  return vtkPolyData::SafeDownCast(Read(path));
}

inline double SizeOf(vtkPolyData* input)
{
  return input->GetLength();
}

// How far a vertex may lie from a segment that it divides: the rounding of coordinates.
inline double RoundingOf(vtkPolyData* input)
{
  double bounds[6];
  input->GetBounds(bounds);
  double largest = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    largest = std::max(largest, std::abs(bounds[k]));
  }
  return 16.0 * std::numeric_limits<double>::epsilon() * largest;
}

inline double LengthOf(vtkPolyData* input, vtkCellArray* chains)
{
  double length = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType chain = 0; chain < chains->GetNumberOfCells(); ++chain)
  {
    chains->GetCellAtId(chain, ids);
    for (vtkIdType k = 1; k < ids->GetNumberOfIds(); ++k)
    {
      const Place a = PointOf(input, ids->GetId(k - 1));
      const Place b = PointOf(input, ids->GetId(k));
      length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }
  return length;
}

// By the arrays of cells: GetCellPoints of VTK 9.1 ends the program where a line has one point.
inline double PerimeterOf(vtkPolyData* input)
{
  return LengthOf(input, input->GetLines()) + LengthOf(input, input->GetPolys());
}

inline void MapPoints(Case& example, const std::function<Place(const Place&)>& map)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < example.Input->GetNumberOfPoints(); ++point)
  {
    points->InsertNextPoint(map(PointOf(example.Input, point)).data());
  }
  example.Input->SetPoints(points);
}

inline void Turn(Case& example)
{
  const double cosine = std::sqrt(0.75);
  MapPoints(example,
    [cosine](const Place& p) {
      return Place{ cosine * p[0] - 0.5 * p[1], 0.5 * p[0] + cosine * p[1], p[2] };
    });
}

inline void Move(Case& example)
{
  const double shift = 1e6 * SizeOf(example.Input);
  MapPoints(example, [shift](const Place& p) { return Place{ p[0] + shift, p[1] - shift, p[2] }; });
}

inline void Scale(Case& example, double factor)
{
  MapPoints(example,
    [factor](const Place& p) {
      return Place{ factor * p[0], factor * p[1], factor * p[2] };
    });
  example.Spacing *= factor;
  example.Area *= factor * factor;
}

// Rebuilds lines and polygons from their point ids.
inline void MapCells(
  Case& example, const std::function<void(vtkIdList*, vtkPolyData* from, vtkPolyData* to)>& insert)
{
  auto changed = vtkSmartPointer<vtkPolyData>::New();
  changed->SetPoints(example.Input->GetPoints());
  changed->SetVerts(example.Input->GetVerts());
  changed->SetLines(vtkNew<vtkCellArray>());
  changed->SetPolys(example.Input->GetPolys());
  changed->GetCellData()->ShallowCopy(example.Input->GetCellData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < example.Input->GetNumberOfLines(); ++cell)
  {
    example.Input->GetLines()->GetCellAtId(cell, ids);
    insert(ids, example.Input, changed);
  }
  example.Input = changed;
}

inline void Reverse(Case& example)
{
  MapCells(example,
    [](vtkIdList* ids, vtkPolyData*, vtkPolyData* to)
    {
      std::reverse(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds());
      to->GetLines()->InsertNextCell(ids);
    });
}

// Gives every cell points of its own; a closed line stays closed by place only.
inline void Unmerge(Case& example)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(example.Input->GetPoints());
  MapCells(example,
    [&points](vtkIdList* ids, vtkPolyData* from, vtkPolyData* to)
    {
      to->GetLines()->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        to->GetLines()->InsertCellPoint(
          points->InsertNextPoint(PointOf(from, ids->GetId(k)).data()));
      }
    });
  example.Input->SetPoints(points);
}

inline double KindOf(vtkPolyData* input, vtkIdType cell)
{
  vtkDataArray* kinds = input->GetCellData()->GetArray("Kind");
  return kinds ? kinds->GetComponent(cell, 0) : 0.0;
}

} // namespace testing_filters

#endif
