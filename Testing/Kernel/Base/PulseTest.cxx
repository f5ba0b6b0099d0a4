// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/Monitors.h"

#include "Base/Monitor.h"
#include "Base/Pulse.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

constexpr int ManyCalls = 1 << 30;

TEST(Pulse, AsksOnceIn1024Steps)
{
  StoppingMonitor monitor(ManyCalls);
  Pulse pulse(monitor);
  for (int step = 0; step < 10 * 1024; ++step)
  {
    EXPECT_TRUE(pulse.Beat());
  }
  EXPECT_EQ(monitor.Calls, 10);
}

TEST(Pulse, AsksAsOftenInManyShortLoopsAsInOneLongLoop)
{
  StoppingMonitor monitor(ManyCalls);
  Pulse pulse(monitor);
  for (int loop = 0; loop < 4096; ++loop)
  {
    pulse.ForEach(16, [](std::size_t) {});
  }
  EXPECT_EQ(monitor.Calls, 16);
  pulse.ForEach(16 * 4096, [](std::size_t) {});
  EXPECT_EQ(monitor.Calls, 32);
}

TEST(Pulse, DoesEachStepOnceInOrder)
{
  for (const std::size_t count : { 0u, 1u, 4095u, 4096u, 4097u, 20000u })
  {
    Pulse pulse(NoMonitor());
    std::size_t next = 0;
    EXPECT_TRUE(pulse.ForEach(count, [&next](std::size_t step) { EXPECT_EQ(step, next++); }));
    EXPECT_EQ(next, count);
  }
}

TEST(Pulse, DoesNothingAndAsksNobodyOnceItWasStopped)
{
  StoppingMonitor monitor(0);
  Pulse pulse(monitor);
  EXPECT_FALSE(pulse.ForEach(10000, [](std::size_t step) { EXPECT_LT(step, 4096u); }));
  EXPECT_FALSE(pulse.Beat());
  EXPECT_FALSE(pulse.Ask());
  EXPECT_FALSE(pulse.ForEach(10, [](std::size_t) { ADD_FAILURE(); }));
  EXPECT_TRUE(pulse.HasStopped());
  EXPECT_EQ(monitor.Calls, 1);
}

TEST(Pulse, TellsFractionsOfPartsOfParts)
{
  RecordingMonitor monitor;
  Pulse pulse(monitor);
  pulse.Ask();
  {
    const PulsePart half(pulse, 0.5, 1.0);
    const PulsePart quarter(pulse, 0.5, 0.75);
    pulse.Ask();
    pulse.SetFraction(1.0);
    pulse.Ask();
  }
  pulse.SetFraction(1.0);
  pulse.Ask();
  EXPECT_EQ(monitor.Fractions, (std::vector<double>{ 0.0, 0.75, 0.875, 1.0 }));
}

TEST(Pulse, NeverGoesBack)
{
  RecordingMonitor monitor;
  Pulse pulse(monitor);
  pulse.SetFraction(0.5);
  pulse.Ask();
  pulse.SetFraction(0.25);
  pulse.Ask();
  EXPECT_EQ(monitor.Fractions, (std::vector<double>{ 0.5, 0.5 }));
}

TEST(PartOfStage, ScalesFractionsAndAsksNobodyOnceItWasStopped)
{
  StoppingMonitor stopping(1);
  PartOfStage part(stopping, 0.5, 1.0);
  EXPECT_TRUE(part.Advance(0.5));
  EXPECT_EQ(stopping.Fraction, 0.75);
  EXPECT_FALSE(part.HasStopped());
  EXPECT_FALSE(part.Advance(1.0));
  EXPECT_FALSE(part.Advance(1.0));
  EXPECT_TRUE(part.HasStopped());
  EXPECT_EQ(stopping.Calls, 2);
}

} // namespace

} // namespace biting
