// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../FilterTesting.h"
#include "Fault.h"

#include <gtest/gtest.h>

#include <ostream>

using namespace testing_filters;
using second_look::Fault;

namespace second_look
{

Fault TheFault = Fault::None;

} // namespace second_look

namespace
{

struct BrokenThing
{
  Fault What;
  const char* Name;
  const char* Violation; ///< a part of what the error says
};

void PrintTo(const BrokenThing& broken, std::ostream* stream)
{
  *stream << broken.Name;
}

class BitingMesherSecondLook : public testing::TestWithParam<BrokenThing>
{
protected:
  void SetUp() override
  {
    auto input = UnitSquare();
    AddChain(input, { { 0.0, 0.5, 0.0 }, { 1.0, 0.5, 0.0 } }, false);
    this->Mesher->SetInputData(input);
    this->Mesher->SetUniformSpacing(0.1);
    this->Mesher->GenerateBitesOn();
  }

  void TearDown() override { second_look::TheFault = Fault::None; }

  /// Executes with the fault, again where it has done so before.
  void Execute(Fault fault)
  {
    second_look::TheFault = fault;
    this->Mesher->Modified();
    this->Mesher->Update();
  }

  vtkNew<vtkBitingMesher> Mesher;
};

} // namespace

TEST_F(BitingMesherSecondLook, HasNothingToSayOfAFaultlessMesh)
{
  Messages messages(this->Mesher);
  this->Execute(Fault::None);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NEAR(AreaOf(this->Mesher->GetOutput()), 1.0, 1e-12);
}

TEST_P(BitingMesherSecondLook, WithholdsABrokenMeshAndAsksForTheInput)
{
  Messages messages(this->Mesher);
  this->Execute(GetParam().What);
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "failed its own check")) << messages.Errors[0];
  EXPECT_TRUE(Has(messages.Errors[0], "report it, with the input")) << messages.Errors[0];
  EXPECT_TRUE(Has(messages.Errors[0], GetParam().Violation)) << messages.Errors[0];
  EXPECT_TRUE(messages.Warnings.empty());
  EXPECT_TRUE(AreAllEmpty(this->Mesher));
  EXPECT_TRUE(IsEmpty(this->Mesher->GetOutput(vtkBitingMesher::PROBLEMS)));
  EXPECT_TRUE(messages.OfExecutive.empty());
}

TEST_P(BitingMesherSecondLook, LeavesAFilterThatWorks)
{
  Messages messages(this->Mesher);
  this->Execute(Fault::None);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->Mesher->GetOutput());
  this->Execute(GetParam().What);
  EXPECT_TRUE(AreAllEmpty(this->Mesher));
  this->Execute(Fault::None);
  EXPECT_TRUE(AreSame(before, this->Mesher->GetOutput()));
  EXPECT_EQ(messages.Errors.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Faults, BitingMesherSecondLook,
  testing::Values(BrokenThing{ Fault::SwappedCorners, "SwappedCorners", "is not counterclockwise" },
    BrokenThing{ Fault::MissingTriangle, "MissingTriangle", "no constraint covers the boundary" },
    BrokenThing{ Fault::DoubledTriangle, "DoubledTriangle", "Euler's formula fails" },
    BrokenThing{ Fault::MovedVertex, "MovedVertex", "is not counterclockwise" },
    BrokenThing{ Fault::MovedBoundary, "MovedBoundary", "the area is" },
    BrokenThing{ Fault::UnlinkedNeighbor, "UnlinkedNeighbor", "no constraint covers the boundary" },
    BrokenThing{ Fault::OneSidedNeighbor, "OneSidedNeighbor", "neighbors are not mutual" },
    BrokenThing{
      Fault::ForgottenConstraint, "ForgottenConstraint", "no constraint covers the boundary" },
    BrokenThing{
      Fault::ForgottenInterface, "ForgottenInterface", "are not a chain between its ends" },
    BrokenThing{ Fault::UnusedVertex, "UnusedVertex", "belongs to no triangle" },
    BrokenThing{
      Fault::UncoveredSegment, "UncoveredSegment", "a part of a segment is not in the mesh" },
    BrokenThing{ Fault::MistakenSegment, "MistakenSegment", "are not a chain between its ends" }),
  [](const testing::TestParamInfo<BrokenThing>& broken) { return broken.param.Name; });
