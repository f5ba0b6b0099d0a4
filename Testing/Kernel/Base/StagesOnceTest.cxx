// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/StagesOnce.h"

#include <gtest/gtest.h>

#include <string> // for stages

namespace biting
{

namespace
{

/// Writes down what it is told.
class WritingMonitor : public Monitor
{
public:
  bool Advance(double fraction) override
  {
    this->Text += " " + std::to_string(static_cast<int>(100.0 * fraction));
    return fraction < 1.0;
  }
  void BeginStage(const char* text) override { this->Text += std::string(" ") + text; }

  std::string Text;
};

constexpr const char* One = "one";
constexpr const char* Two = "two";
constexpr const char* Three = "three";

TEST(StagesOnce, ShowsWorkThatIsDoneOnceAsItIs)
{
  WritingMonitor whole;
  StagesOnce stages(whole);
  stages.BeginStage(One);
  EXPECT_TRUE(stages.Advance(0.25));
  stages.BeginStage(Two);
  EXPECT_FALSE(stages.Advance(1.0));
  EXPECT_EQ(whole.Text, " one 25 two 100");
}

TEST(StagesOnce, StandsStillWhereWorkIsDoneAgainUntilItIsAsFarAsBefore)
{
  WritingMonitor whole;
  StagesOnce stages(whole);
  stages.BeginStage(One);
  stages.Advance(0.25);
  stages.BeginStage(Two);
  stages.Advance(0.5);
  stages.BeginStage(One);
  stages.Advance(0.75);
  stages.BeginStage(Two);
  stages.Advance(0.25);
  stages.Advance(0.75);
  stages.BeginStage(Three);
  stages.Advance(0.25);
  EXPECT_EQ(whole.Text, " one 25 two 50 50 50 75 three 25");
}

} // namespace

} // namespace biting
