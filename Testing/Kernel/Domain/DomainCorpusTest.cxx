// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/LegacyPolyData.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <cmath>   // for abs
#include <cstdlib> // for getenv
#include <map>     // for the areas

namespace biting
{

namespace
{

/// One file of the shared inputs with the outcome that it must have.
struct CorpusFile
{
  std::string Name;
  std::string Class;
  double Area = 0.0;
  bool HasArea = false;
};

std::string Folder()
{
  const char* given = std::getenv("BITING_SHARED_INPUTS");
  return given ? given : std::string(BITING_SOURCE_DIR) + "/../shared/inputs";
}

/// The string or number after `"key": ` within one entry of the index.
std::string ValueOf(const std::string& entry, const std::string& key)
{
  const std::string mark = "\"" + key + "\": ";
  const std::size_t place = entry.find(mark);
  if (place == std::string::npos)
  {
    return "";
  }
  const std::size_t first = place + mark.size();
  const bool isText = entry[first] == '"';
  const std::size_t last = entry.find_first_of(isText ? "\"" : ",\n}", first + 1);
  return entry.substr(first + (isText ? 1 : 0), last - first - (isText ? 1 : 0));
}

std::vector<CorpusFile> ReadIndex()
{
  std::ifstream stream(Folder() + "/index.json");
  const std::string text{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  std::vector<CorpusFile> files;
  std::size_t place = text.find("\"file\": ");
  while (place != std::string::npos)
  {
    const std::size_t next = text.find("\"file\": ", place + 1);
    const std::string entry = text.substr(place, next - place);
    const std::string area = ValueOf(entry, "expected_area");
    const bool hasArea = !area.empty() && area != "null";
    const bool isStored = ValueOf(entry, "stored") != "false";
    if (isStored)
    {
      files.push_back({ ValueOf(entry, "file"), ValueOf(entry, "cls"),
        hasArea ? std::stod(area) : 0.0, hasArea });
    }
    place = next;
  }
  return files;
}

ChainKind KindOf(const LegacyPolyData& data, std::size_t cell, ChainKind otherwise)
{
  return cell < data.Kinds.size() ? static_cast<ChainKind>(data.Kinds[cell]) : otherwise;
}

Polylines ToPolylines(const LegacyPolyData& data)
{
  Polylines input;
  for (const std::array<double, 3>& point : data.Points)
  {
    input.Points.push_back({ point[0], point[1] });
  }
  const auto append = [&input, &data](
                        const std::vector<int>& cell, ChainKind otherwise, bool closes)
  {
    input.Connectivity.insert(input.Connectivity.end(), cell.begin(), cell.end());
    if (closes)
    {
      input.Connectivity.push_back(cell.front());
    }
    input.Offsets.push_back(static_cast<Id>(input.Connectivity.size()));
    input.Cells.push_back(input.NumberOfChains());
    input.Kinds.push_back(KindOf(data, input.Kinds.size(), otherwise));
  };
  for (const std::vector<int>& cell : data.Vertices)
  {
    append(cell, ChainKind::EmbeddedPoint, false);
  }
  for (const std::vector<int>& cell : data.Lines)
  {
    append(cell, ChainKind::Automatic, false);
  }
  for (const std::vector<int>& cell : data.Polygons)
  {
    append(cell, ChainKind::Automatic, true);
  }
  return input;
}

double TotalLength(const Domain& domain)
{
  double sum = 0.0;
  for (std::size_t s = 0; s < domain.Starts.size(); ++s)
  {
    sum += Distance(domain.Vertices[static_cast<std::size_t>(domain.Starts[s])],
      domain.Vertices[static_cast<std::size_t>(domain.Ends[s])]);
  }
  return sum;
}

/// Calls test(file, polylines) for every file whose area is known and that lies in the plane.
template <typename Test>
void ForEachFile(Test test, std::size_t mostPoints)
{
  for (const CorpusFile& file : ReadIndex())
  {
    const LegacyPolyData data = LegacyReader(Folder() + "/" + file.Name).Read();
    if (file.HasArea && data.IsFlat() && data.Points.size() <= mostPoints)
    {
      SCOPED_TRACE(file.Name);
      test(file, ToPolylines(data));
    }
  }
}

/// Area `expected`, but for `slack` times the length of all segments.
void ExpectArea(const MadeDomain& made, double expected, double slack)
{
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Problems.HasErrors(), expected == 0.0);
  EXPECT_NEAR(made.Domain.Area, expected, 1e-9 * expected + slack * TotalLength(made.Domain));
}

double LargestCoordinate(const Polylines& input)
{
  double largest = 0.0;
  for (const Point2& point : input.Points)
  {
    largest = std::max({ largest, std::abs(point.X), std::abs(point.Y) });
  }
  return largest;
}

bool IsClosed(const Polylines& input, std::size_t chain)
{
  const auto first = static_cast<std::size_t>(input.Offsets[chain]);
  const auto last = static_cast<std::size_t>(input.Offsets[chain + 1]) - 1;
  return input.Connectivity[first] == input.Connectivity[last];
}

/// Crossings are rounded, and so are the areas between them; elsewhere areas are exact.
double CrossingSlack(const CorpusFile& file, const Polylines& input)
{
  return file.Class == "R" ? 1e-15 * LargestCoordinate(input) : 0.0;
}

class DomainCorpus : public testing::Test
{
protected:
  void SetUp() override
  {
    if (ReadIndex().empty())
    {
      GTEST_SKIP() << "shared inputs are absent: " << Folder();
    }
  }
};

constexpr std::size_t Everything = 1000000;
constexpr std::size_t MediumSized = 8000;

TEST_F(DomainCorpus, AreasAreThoseOfTheIndex)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  { ExpectArea(Make(input), file.Area, CrossingSlack(file, input)); };
  ForEachFile(test, Everything);
}

TEST_F(DomainCorpus, ValidInputIsNotRefusedWithoutRepair)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  {
    if (file.Class == "V" || file.Class == "W")
    {
      ExpectArea(Make(input, false), file.Area, 0.0);
    }
  };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, UnmergedSegmentsGiveTheSameArea)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  { ExpectArea(Make(Unmerge(input)), file.Area, CrossingSlack(file, input)); };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, BoundaryIsFoundWhereItIsNotGiven)
{
  const auto test = [](const CorpusFile& file, Polylines input)
  {
    for (ChainKind& kind : input.Kinds)
    {
      kind = kind == ChainKind::Boundary ? ChainKind::Automatic : kind;
    }
    ExpectArea(Make(input), file.Area, CrossingSlack(file, input));
  };
  ForEachFile(test, Everything);
}

/// Open chains that close together within a coast are lakes or lands: only the kind can tell.
TEST_F(DomainCorpus, BordersOfCountriesAreInterfacesWithoutKinds)
{
  const auto test = [](const CorpusFile& file, Polylines input)
  {
    if (file.Name != "ne110m_countries.vtk")
    {
      return;
    }
    for (std::size_t c = 0; c < input.Kinds.size(); ++c)
    {
      const bool isRing = input.Kinds[c] == ChainKind::Interface && IsClosed(input, c);
      input.Kinds[c] = isRing ? ChainKind::Interface : ChainKind::Automatic;
    }
    ExpectArea(Make(input), file.Area, CrossingSlack(file, input));
  };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, ReversedChainsGiveTheSameArea)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  { ExpectArea(Make(Reverse(input)), file.Area, CrossingSlack(file, input)); };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, TurnedByThirtyDegreesTheAreaStays)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  {
    const double cosine = std::sqrt(0.75);
    const auto turn = [cosine](const Point2& p) {
      return Point2{ cosine * p.X - 0.5 * p.Y, 0.5 * p.X + cosine * p.Y };
    };
    ExpectArea(Make(Move(input, turn)), file.Area, 1e-15 * LargestCoordinate(input));
  };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, MovedFarAwayTheAreaIsRightToTheRoundingOfCoordinates)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  {
    const double far = 1e6 * LargestCoordinate(input);
    const auto move = [far](const Point2& p) { return Point2{ p.X + far, p.Y - far }; };
    ExpectArea(Make(Move(input, move)), file.Area, 1e-15 * far);
  };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, ScaledByPowersOfTenTheAreaScales)
{
  const auto test = [](const CorpusFile& file, const Polylines& input)
  {
    for (const double factor : { 1e-9, 1e9 })
    {
      const auto scale = [factor](const Point2& p) { return factor * p; };
      const double slack = 1e-15 * LargestCoordinate(input) * factor;
      ExpectArea(Make(Move(input, scale)), file.Area * factor * factor, slack);
    }
  };
  ForEachFile(test, MediumSized);
}

TEST_F(DomainCorpus, WhatHasNoDomainIsRefused)
{
  for (const CorpusFile& file : ReadIndex())
  {
    const LegacyPolyData data = LegacyReader(Folder() + "/" + file.Name).Read();
    const bool isAboutSpacing = file.Name.find("spacing") != std::string::npos;
    if (file.HasArea || isAboutSpacing || data.Points.empty())
    {
      continue;
    }
    SCOPED_TRACE(file.Name);
    const MadeDomain made = Make(ToPolylines(data));
    EXPECT_TRUE(made.Problems.HasErrors());
    EXPECT_EQ(made.Domain.NumberOfVertices(), 0);
  }
}

} // namespace

} // namespace biting
