// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SurfaceTesting_h
#define SurfaceTesting_h

#include "FilterTesting.h"

#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <vector> // for values

/// Closed surfaces about the origin, and a spacing for them.
namespace testing_filters
{

inline vtkSmartPointer<vtkPolyData> Sphere(double radius = 0.5, int resolution = 60)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> Cube(double size = 1.0)
{
  vtkNew<vtkCubeSource> source;
  source->SetXLength(size);
  source->SetYLength(size);
  source->SetZLength(size);
  source->Update();
  return source->GetOutput();
}

/// The array grows by `slope` along x, from `least` at x = -.5; about the cube of size 1.
inline vtkSmartPointer<vtkImageData> GradedImage(const char* name, double least, double slope)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 3, 3);
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->SetSpacing(0.05, 0.5, 0.5);
  std::vector<double> values;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    values.push_back(least + slope * (image->GetPoint(point)[0] + 0.5));
  }
  AddArray<vtkDoubleArray>(image->GetPointData(), name, values);
  return image;
}

} // namespace testing_filters

#endif
