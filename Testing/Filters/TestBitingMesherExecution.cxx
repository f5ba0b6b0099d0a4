// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace testing_filters;

namespace
{

// Asks the filter to stop at the first report of progress beyond `fraction`, and remembers all.
struct ProgressWatcher
{
  double StopAt = 2.0;
  bool WasStopped = false;
  std::chrono::steady_clock::time_point StopTime;
  std::vector<double> Progress;
  std::vector<std::string> Texts;

  static void Watch(vtkObject* caller, unsigned long, void* data, void* progress)
  {
    auto* watcher = static_cast<ProgressWatcher*>(data);
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    watcher->Progress.push_back(*static_cast<double*>(progress));
    const char* text = filter->GetProgressText();
    if (text && (watcher->Texts.empty() || watcher->Texts.back() != text))
    {
      watcher->Texts.push_back(text);
    }
    if (watcher->Progress.back() >= watcher->StopAt)
    {
      watcher->StopTime =
        watcher->WasStopped ? watcher->StopTime : std::chrono::steady_clock::now();
      watcher->WasStopped = true;
      filter->SetAbortExecute(1);
    }
  }

  void Observe(vtkAlgorithm* filter)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(Watch);
    filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
};

vtkSmartPointer<vtkPolyData> MeshOf(vtkPolyData* input, vtkDataSet* source)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetSpacingSourceData(source);
  mesher->SetUniformSpacing(0.01);
  mesher->GenerateBitesOn();
  mesher->Update();
  return mesher->GetOutput();
}

vtkSmartPointer<vtkPolyData> SquareWithHole()
{
  auto input = UnitSquare();
  AddChain(input, Rectangle(0.3, 0.3, 0.4, 0.7), true);
  AddArray<vtkDoubleArray>(
    input->GetPointData(), "Spacing", { 0.1, 0.1, 0.1, 0.1, 0.02, 0.02, 0.02, 0.02 });
  return input;
}

vtkSmartPointer<vtkImageData> Source()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 1);
  image->SetSpacing(0.5, 0.5, 1.0);
  AddArray<vtkDoubleArray>(
    image->GetPointData(), "Spacing", { 0.02, 0.03, 0.02, 0.05, 0.06, 0.02, 0.02, 0.03, 0.02 });
  return image;
}

} // namespace

TEST(BitingMesherProgress, GrowsToOneAndNamesTheStages)
{
  vtkNew<vtkBitingMesher> mesher;
  ProgressWatcher watcher;
  watcher.Observe(mesher);
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.005);
  mesher->Update();
  ASSERT_GT(watcher.Progress.size(), 10u);
  for (std::size_t k = 1; k < watcher.Progress.size(); ++k)
  {
    EXPECT_GE(watcher.Progress[k], watcher.Progress[k - 1]);
    EXPECT_LE(watcher.Progress[k], 1.0);
  }
  EXPECT_LT(watcher.Progress.size(), 250u);
  EXPECT_EQ(watcher.Progress.back(), 1.0);
  EXPECT_GE(watcher.Texts.size(), 5u);
}

TEST(BitingMesherAbort, LeavesEmptyOutputsAndAFilterThatWorks)
{
  vtkNew<vtkBitingMesher> mesher;
  ProgressWatcher watcher;
  watcher.Observe(mesher);
  Messages messages(mesher);
  mesher->SetInputData(UnitSquare());
  mesher->GenerateBitesOn();
  for (const double stopAt : { 0.0, 0.3, 0.5, 0.7 })
  {
    mesher->SetUniformSpacing(0.005 + 1e-6 * stopAt);
    watcher.StopAt = stopAt;
    watcher.WasStopped = false;
    mesher->Update();
    EXPECT_TRUE(watcher.WasStopped);
    EXPECT_TRUE(AreAllEmpty(mesher)) << "stopped at " << stopAt;
  }
  watcher.StopAt = 2.0;
  mesher->SetUniformSpacing(0.05);
  mesher->Update();
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(BitingMesherAbort, IsAnsweredWithinASecond)
{
  vtkNew<vtkBitingMesher> mesher;
  ProgressWatcher watcher;
  watcher.Observe(mesher);
  watcher.StopAt = 0.42;
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.001);
  mesher->Update();
  EXPECT_TRUE(watcher.WasStopped);
  EXPECT_TRUE(AreAllEmpty(mesher));
  EXPECT_LT(std::chrono::steady_clock::now() - watcher.StopTime, std::chrono::seconds(1));
}

TEST(BitingMesherPipeline, ExecutesAgainWhenAParameterChanges)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.1);
  mesher->Update();
  const vtkIdType coarse = mesher->GetOutput()->GetNumberOfCells();
  const vtkMTimeType time = mesher->GetOutput()->GetMTime();
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetMTime(), time);
  mesher->SetSpacingScale(0.5);
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 3 * coarse);
  mesher->SetSpacingScale(1.0);
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), coarse);
}

TEST(BitingMesherPipeline, ExecutesAgainWhenTheSourceChanges)
{
  const auto source = Source();
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  mesher->SetSpacingSourceData(source);
  mesher->Update();
  const vtkIdType fine = mesher->GetOutput()->GetNumberOfCells();
  source->GetPointData()->GetArray("Spacing")->Fill(0.2);
  source->GetPointData()->GetArray("Spacing")->Modified();
  source->Modified();
  mesher->Update();
  EXPECT_LT(mesher->GetOutput()->GetNumberOfCells(), fine / 2);
}

TEST(BitingMesherPipeline, EmptiesItsOutputsAfterARefusalAndRecovers)
{
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(UnitSquare());
  mesher->GenerateBitesOn();
  mesher->Update();
  EXPECT_FALSE(AreAllEmpty(mesher));
  mesher->SetUniformSpacing(-1.0);
  mesher->Update();
  EXPECT_TRUE(AreAllEmpty(mesher));
  EXPECT_EQ(messages.Errors.size(), 1u);
  mesher->SetUniformSpacing(0.1);
  mesher->Update();
  EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
}

TEST(BitingMesherPipeline, LeavesInputAndParametersAlone)
{
  const auto input = SquareWithHole();
  const auto source = Source();
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->SetSpacingSourceData(source);
  const vtkMTimeType inputTime = input->GetMTime();
  const vtkMTimeType sourceTime = source->GetMTime();
  const vtkMTimeType filterTime = mesher->GetMTime();
  mesher->Update();
  EXPECT_EQ(input->GetMTime(), inputTime);
  EXPECT_EQ(source->GetMTime(), sourceTime);
  EXPECT_EQ(mesher->GetMTime(), filterTime);
}

TEST(BitingMesherPipeline, PassesFieldDataOfTheInputOn)
{
  auto input = UnitSquare();
  AddArray<vtkDoubleArray>(input->GetFieldData(), "Datum", { 42.0 });
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_EQ(Figure(mesher->GetOutput(), "Datum"), 42.0);
}

TEST(BitingMesherResult, IsTheSameBytesTwice)
{
  const auto first = MeshOf(SquareWithHole(), Source());
  const auto second = MeshOf(SquareWithHole(), Source());
  ASSERT_GT(first->GetNumberOfCells(), 1000);
  EXPECT_TRUE(AreSame(first, second));
}

TEST(BitingMesherResult, IsTheSameBytesInTwoThreadsAtOnce)
{
  const auto expected = MeshOf(SquareWithHole(), Source());
  std::vector<vtkSmartPointer<vtkPolyData>> meshes(4);
  std::vector<std::thread> threads;
  for (auto& mesh : meshes)
  {
    threads.emplace_back([&mesh]() { mesh = MeshOf(SquareWithHole(), Source()); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& mesh : meshes)
  {
    EXPECT_TRUE(AreSame(mesh, expected));
  }
}
