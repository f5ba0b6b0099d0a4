// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SurfaceTesting_h
#define SurfaceTesting_h

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

/// Closed surfaces about the origin.
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

} // namespace testing_filters

#endif
