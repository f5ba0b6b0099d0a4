// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include "Kernel/Stages/MeshingStages.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>

using namespace testing_filters;

namespace
{

// Asks the filter to stop at a given report of progress, and remembers all reports.
class ProgressWatcher
{
public:
  explicit ProgressWatcher(vtkAlgorithm* filter)
    : Filter(filter)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(Watch);
    this->Tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  }

  ~ProgressWatcher() { this->Filter->RemoveObserver(this->Tag); }

  ProgressWatcher(const ProgressWatcher&) = delete;
  void operator=(const ProgressWatcher&) = delete;

  std::size_t StopAt = std::numeric_limits<std::size_t>::max();
  bool WasStopped = false;
  double ProgressAtStop = 1.0;
  std::vector<double> Progress;
  std::vector<std::string> Texts;

private:
  static void Watch(vtkObject*, unsigned long, void* data, void* progress)
  {
    static_cast<ProgressWatcher*>(data)->Note(*static_cast<double*>(progress));
  }

  void Note(double progress)
  {
    this->Progress.push_back(progress);
    const char* text = this->Filter->GetProgressText();
    if (text && (this->Texts.empty() || this->Texts.back() != text))
    {
      this->Texts.push_back(text);
    }
    if (this->Progress.size() == this->StopAt + 1)
    {
      this->ProgressAtStop = progress;
      this->WasStopped = true;
      this->Filter->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Filter;
  unsigned long Tag;
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

// Copies of all outputs.
std::vector<vtkSmartPointer<vtkPolyData>> OutputsOf(vtkBitingMesher* mesher)
{
  mesher->Update();
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  for (int port = 0; port < mesher->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(vtkSmartPointer<vtkPolyData>::New());
    outputs.back()->DeepCopy(mesher->GetOutput(port));
  }
  return outputs;
}

// Whether no output has anything: points, cells, or arrays.
bool AreAllBare(vtkBitingMesher* mesher)
{
  bool areBare = AreAllEmpty(mesher);
  for (int port = 0; port < mesher->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* output = mesher->GetOutput(port);
    areBare = areBare && output->GetPointData()->GetNumberOfArrays() == 0 &&
      output->GetCellData()->GetNumberOfArrays() == 0 &&
      output->GetFieldData()->GetNumberOfArrays() == 0;
  }
  return areBare;
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

TEST(BitingMesherProgress, GrowsFromZeroToOne)
{
  vtkNew<vtkBitingMesher> mesher;
  ProgressWatcher watcher(mesher);
  mesher->SetInputData(UnitSquare());
  mesher->SetUniformSpacing(0.005);
  mesher->Update();
  ASSERT_GT(watcher.Progress.size(), 50u);
  for (std::size_t k = 1; k < watcher.Progress.size(); ++k)
  {
    EXPECT_GE(watcher.Progress[k], watcher.Progress[k - 1]);
    EXPECT_LE(watcher.Progress[k] - watcher.Progress[k - 1], 0.1);
  }
  EXPECT_EQ(watcher.Progress.front(), 0.0);
  EXPECT_EQ(watcher.Progress.back(), 1.0);
}

TEST(BitingMesherProgress, NamesAllStagesInTheirOrder)
{
  vtkNew<vtkBitingMesher> mesher;
  ProgressWatcher watcher(mesher);
  mesher->SetInputData(UnitSquare());
  mesher->Update();
  std::vector<std::string> texts{ "Reading the input" };
  for (const biting::Stage& stage : biting::MeshingStages::InOrder)
  {
    texts.push_back(stage.Text);
  }
  texts.push_back("Writing the mesh");
  EXPECT_EQ(watcher.Texts, texts);
}

TEST(BitingMesherAbort, AtAnyReportLeavesEmptyOutputsAndAFilterThatGivesTheSameMesh)
{
  vtkNew<vtkBitingMesher> mesher;
  Messages messages(mesher);
  mesher->SetInputData(SquareWithHole());
  mesher->SetSpacingSourceData(Source());
  mesher->GenerateBitesOn();
  const std::vector<vtkSmartPointer<vtkPolyData>> expected = OutputsOf(mesher);
  // Report 0 comes from the pipeline, before the filter begins.
  for (std::size_t report = 0;; ++report)
  {
    ProgressWatcher watcher(mesher);
    watcher.StopAt = report;
    mesher->Modified();
    EXPECT_TRUE(mesher->GetExecutive()->Update()) << report;
    // The last report comes when there is nothing left to stop.
    if (watcher.ProgressAtStop == 1.0)
    {
      EXPECT_GT(report, 30u);
      break;
    }
    ASSERT_TRUE(AreAllBare(mesher)) << report;
  }
  mesher->Modified();
  const std::vector<vtkSmartPointer<vtkPolyData>> again = OutputsOf(mesher);
  for (std::size_t port = 0; port < expected.size(); ++port)
  {
    EXPECT_TRUE(
      (IsEmpty(again[port]) && IsEmpty(expected[port])) || AreSame(again[port], expected[port]))
      << port;
  }
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_TRUE(messages.Warnings.empty());
}

TEST(BitingMesherAbort, ByStopIsAnErrorThatStaysUntilSomethingChanges)
{
  for (const vtkCommand::EventIds event : { vtkCommand::StartEvent, vtkCommand::ProgressEvent })
  {
    vtkNew<vtkBitingMesher> mesher;
    mesher->SetInputData(UnitSquare());
    mesher->SetUniformSpacing(0.02);
    Messages messages(mesher);
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(mesher);
    stop->SetCallback([](vtkObject*, unsigned long, void* filter, void*)
      { static_cast<vtkBitingMesher*>(filter)->Stop(); });
    const unsigned long tag = mesher->AddObserver(event, stop);
    mesher->Update();
    mesher->RemoveObserver(tag);
    EXPECT_TRUE(AreAllBare(mesher));
    mesher->Update();
    EXPECT_TRUE(AreAllBare(mesher));
    ASSERT_EQ(messages.Errors.size(), 1u);
    EXPECT_TRUE(Has(messages.Errors[0], "Stopped")) << messages.Errors[0];
    EXPECT_EQ(mesher->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    mesher->Modified();
    mesher->Update();
    EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  }
}

TEST(BitingMesherAbort, IsForgottenByTheNextExecution)
{
  vtkNew<vtkBitingMesher> mesher;
  mesher->SetInputData(UnitSquare());
  for (const double spacing : { 0.1, 0.05, 0.02 })
  {
    {
      ProgressWatcher watcher(mesher);
      watcher.StopAt = 5;
      mesher->SetUniformSpacing(1.01 * spacing);
      mesher->Update();
      EXPECT_TRUE(watcher.WasStopped);
      EXPECT_TRUE(AreAllBare(mesher));
    }
    mesher->SetUniformSpacing(spacing);
    mesher->Update();
    EXPECT_NEAR(AreaOf(mesher->GetOutput()), 1.0, 1e-12);
  }
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

TEST(BitingMesherResult, IsTheSameBytesForAnyNumberOfThreads)
{
  const auto meshWith = [](int numberOfThreads)
  {
    vtkNew<vtkBitingMesher> mesher;
    mesher->SetInputData(SquareWithHole());
    mesher->SetUniformSpacing(0.006);
    mesher->SetNumberOfThreads(numberOfThreads);
    mesher->Update();
    return vtkSmartPointer<vtkPolyData>(mesher->GetOutput());
  };
  const auto alone = meshWith(1);
  ASSERT_GT(alone->GetNumberOfCells(), 40000);
  for (const int numberOfThreads : { 0, 2, 3, 8 })
  {
    EXPECT_TRUE(AreSame(meshWith(numberOfThreads), alone)) << numberOfThreads;
  }
}

/// Two blocks' worth of vertices and more, of which progress is shown once from stage to stage.
TEST(BitingMesherResult, IsTheSameBytesForAnyNumberOfThreadsThatMeshBlocks)
{
  const auto meshWith = [](int numberOfThreads)
  {
    vtkNew<vtkBitingMesher> mesher;
    const ProgressWatcher watcher(mesher);
    mesher->SetInputData(UnitSquare());
    mesher->SetUniformSpacing(0.0028);
    mesher->SetNumberOfThreads(numberOfThreads);
    mesher->Update();
    EXPECT_TRUE(std::is_sorted(watcher.Progress.begin(), watcher.Progress.end()));
    return vtkSmartPointer<vtkPolyData>(mesher->GetOutput());
  };
  const auto alone = meshWith(1);
  ASSERT_GT(alone->GetNumberOfPoints(), 128000);
  for (const int numberOfThreads : { 2, 8 })
  {
    EXPECT_TRUE(AreSame(meshWith(numberOfThreads), alone)) << numberOfThreads;
  }
}

TEST(BitingMesherProgress, IsReportedByTheThreadThatCalls)
{
  struct Caller
  {
    std::thread::id Thread = std::this_thread::get_id();
    bool IsAlone = true;
  } caller;
  vtkNew<vtkBitingMesher> mesher;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&caller);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* known = static_cast<Caller*>(data);
      known->IsAlone = known->IsAlone && known->Thread == std::this_thread::get_id();
    });
  mesher->AddObserver(vtkCommand::ProgressEvent, command);
  mesher->SetInputData(SquareWithHole());
  mesher->SetUniformSpacing(0.006);
  mesher->SetNumberOfThreads(4);
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(caller.IsAlone);
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
