// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <algorithm> // for all_of, max
#include <cstdlib>   // for atoll

namespace biting
{

namespace
{

// The types of VTK.
MeshFileCell CellInSU2(int type)
{
  constexpr int edge = 3;
  constexpr int triangle = 5;
  return type == triangle ? MeshFileCell::Triangle
    : type == edge        ? MeshFileCell::Edge
                          : MeshFileCell::Other;
}

// NPOIN may have a second number, which does not count.
std::size_t Count(const std::string& text)
{
  return static_cast<std::size_t>(std::max(0LL, std::atoll(text.c_str())));
}

// Markers that are called by numbers keep these.
void NumberByNames(std::vector<MeshGroup>& tags)
{
  const bool areNumbers = std::all_of(tags.begin(), tags.end(),
    [](const MeshGroup& tag)
    {
      return std::atoll(tag.Name.c_str()) > 0 &&
        tag.Name.find_first_not_of("0123456789") == std::string::npos;
    });
  for (MeshGroup& tag : tags)
  {
    tag.Number = areNumbers ? std::atoll(tag.Name.c_str()) : tag.Number;
  }
}

class SU2Reading
{
public:
  SU2Reading(MeshFileLines& lines, MeshFile& mesh)
    : In(lines)
    , Out(lines, mesh)
  {
  }

  ReadingResult Read()
  {
    bool isRead = true;
    while (isRead && this->In.Next())
    {
      isRead = this->ReadSection();
    }
    return this->Out.Finish([this](int dimension, std::int64_t number)
      { return dimension == 1 ? this->NameOf(number) : std::string(); });
  }

private:
  // Edges among the elements have no marker.
  std::string NameOf(std::int64_t marker) const
  {
    return marker > 0 ? this->Markers[static_cast<std::size_t>(marker) - 1] : std::string();
  }

  bool ReadSection()
  {
    std::string key;
    std::string value;
    if (!this->In.Assignment(key, value))
    {
      return this->IsPassing || this->Out.Fail("NDIME=, NELEM=, NPOIN=, NMARK= or MARKER_TAG=");
    }
    this->IsPassing = false;
    if (key == "NDIME")
    {
      return value == "2" || this->Out.Fail("NDIME= 2");
    }
    if (key == "NELEM")
    {
      return this->ReadCells(Count(value), 0);
    }
    if (key == "NPOIN")
    {
      return this->ReadPoints(Count(value));
    }
    if (key == "MARKER_TAG")
    {
      return this->ReadMarker(value);
    }
    this->IsPassing = key.rfind("FFD_", 0) == 0 || key.rfind("PERIODIC_", 0) == 0;
    return true;
  }

  bool ReadCells(std::size_t count, std::int64_t group)
  {
    bool isRead = true;
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      int type = 0;
      isRead = (this->In.Read(type) || this->Out.Fail("an element")) &&
        this->Out.ReadCell(CellInSU2(type), { group, 0 });
    }
    return isRead;
  }

  bool ReadPoints(std::size_t count)
  {
    bool isRead = true;
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::array<double, 3> place{};
      isRead = (this->In.Read(place[0], place[1]) || this->Out.Fail("a point")) &&
        this->Out.AddVertex(static_cast<std::int64_t>(k), place);
    }
    return isRead;
  }

  bool ReadMarker(const std::string& name)
  {
    std::string key;
    std::string count;
    this->Markers.push_back(name);
    return ((this->In.Next() && this->In.Assignment(key, count) && key == "MARKER_ELEMS") ||
             this->Out.Fail("MARKER_ELEMS=")) &&
      this->ReadCells(Count(count), static_cast<std::int64_t>(this->Markers.size()));
  }

  MeshFileLines& In;
  MeshFileBuilder Out;
  std::vector<std::string> Markers;
  bool IsPassing = false; // over the lines of what we have no use for
};

} // namespace

ReadingResult ReadSU2(std::istream& file, MeshFile& mesh)
{
  MeshFileLines lines(file, '%');
  const ReadingResult result = SU2Reading(lines, mesh).Read();
  NumberByNames(mesh.Tags);
  return result;
}

} // namespace biting
