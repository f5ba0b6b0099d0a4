// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <algorithm> // for all_of, find
#include <set>       // for keys

namespace biting
{

namespace
{

// The types of VTK.
MeshFileCell CellInSU2(int type)
{
  static const std::vector<std::array<int, 4>> Types{ { 1, 1, 1, 0 }, { 3, 2, 2, 1 },
    { 5, 3, 3, 2 }, { 9, 4, 4, 2 }, { 10, 4, 4, 3 }, { 21, 2, 3, 1 }, { 22, 3, 6, 2 },
    { 23, 4, 8, 2 }, { 24, 4, 10, 3 } };
  return CellOfType(Types, type);
}

// The first word counts: NPOIN may have a second number.
bool ReadCount(const std::string& text, std::size_t& count)
{
  return ReadWhole(text.substr(0, text.find_first_of(" \t")), count);
}

// Markers that are called by numbers keep these.
void NumberByNames(std::vector<MeshGroup>& tags)
{
  const auto numberOf = [](const MeshGroup& tag)
  {
    int number = 0;
    return ReadWhole(tag.Name, number) && std::to_string(number) == tag.Name ? number : 0;
  };
  if (std::all_of(
        tags.begin(), tags.end(), [&numberOf](const MeshGroup& tag) { return numberOf(tag) > 0; }))
  {
    for (MeshGroup& tag : tags)
    {
      tag.Number = numberOf(tag);
    }
  }
}

class SU2Reading
{
public:
  SU2Reading(std::istream& file, MeshFile& mesh)
    : Out(file, MeshFileDialect::SU2, mesh)
  {
  }

  ReadingResult Read()
  {
    bool isRead = true;
    while (isRead && this->In.Next())
    {
      isRead = this->ReadSection();
    }
    for (const char* key : { "NDIME", "NELEM", "NPOIN" })
    {
      isRead = isRead &&
        (this->Keys.count(key) > 0 || this->Out.Fail("the line " + std::string(key) + "="));
    }
    if (isRead && this->Keys.count("NMARK") == 0) // as Gmsh writes it where there is no group
    {
      this->Out.Remark("The file has no line NMARK=, and so no tags.");
      isRead = this->In.IsWholeLine() || this->Out.Fail("the line NMARK=");
    }
    if (isRead && this->ReadMarkers != this->NumberOfMarkers)
    {
      this->Out.Fail(std::to_string(this->NumberOfMarkers) + " markers in place of " +
        std::to_string(this->ReadMarkers));
    }
    return this->Out.Finish([this](int dimension, std::int64_t number)
      { return dimension < this->Dimension ? this->NameOf(number) : std::string(); });
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
    if (key == "MARKER_TAG")
    {
      return this->ReadMarker(value);
    }
    if (key == "NDIME" || key == "NELEM" || key == "NPOIN" || key == "NMARK" || key == "NZONE")
    {
      return (this->Keys.insert(key).second || this->Out.Fail("no second " + key + "=")) &&
        this->ReadCounted(key, value);
    }
    this->IsPassing = key.rfind("FFD_", 0) == 0 || key.rfind("PERIODIC_", 0) == 0;
    return true;
  }

  bool ReadCounted(const std::string& key, const std::string& value)
  {
    std::size_t count = 0;
    if (!ReadCount(value, count))
    {
      return this->Out.Fail("a number after " + key + "=");
    }
    if (key == "NZONE")
    {
      return count == 1 || this->Out.Fail("NZONE= 1");
    }
    if (key == "NDIME")
    {
      this->Dimension = count == 3 ? 3 : 2;
      return count == 2 || (count == 3 && this->Keys.count("NPOIN") == 0) ||
        this->Out.Fail("NDIME= 2, or, before NPOIN=, NDIME= 3");
    }
    if (key == "NMARK")
    {
      this->NumberOfMarkers = count;
      return true;
    }
    return key == "NELEM" ? this->ReadCells(count, 0) : this->ReadPoints(count);
  }

  // The number of the element, or of the point, may end a line.
  bool EndLine()
  {
    return this->In.IsRead() || (this->In.PassNumber() && this->In.IsRead()) ||
      this->Out.Fail("no more numbers than belong there");
  }

  bool ReadCells(std::size_t count, std::int64_t group)
  {
    bool isRead = true;
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      int type = 0;
      isRead = this->In.Read(type) || this->Out.Fail("an element");
      const MeshFileCell cell = CellInSU2(type);
      isRead = isRead &&
        (cell.Corners < 2 || cell.Dimension == this->Dimension - 1 ||
          (group == 0 && cell.Dimension <= this->Dimension) ||
          this->Out.Fail(group == 0 ? "an element of NDIME=" : "an edge or face of a marker"));
      // Of other cells, and points with what turns them, nothing is known of the rest.
      isRead =
        isRead && this->Out.ReadCell(cell, { group, 0 }) && (cell.Corners < 2 || this->EndLine());
    }
    return isRead;
  }

  bool ReadPoints(std::size_t count)
  {
    bool isRead = true;
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::array<double, 3> place{};
      isRead =
        ((this->In.Read(place[0], place[1]) && (this->Dimension == 2 || this->In.More(place[2]))) ||
          this->Out.Fail("a point")) &&
        this->EndLine() && this->Out.AddVertex(static_cast<std::int64_t>(k), place);
    }
    return isRead;
  }

  // A name that is there again is the same marker.
  bool ReadMarker(const std::string& name)
  {
    std::string key;
    std::string text;
    std::size_t count = 0;
    ++this->ReadMarkers;
    auto marker = std::find(this->Markers.begin(), this->Markers.end(), name);
    if (marker == this->Markers.end())
    {
      marker = this->Markers.insert(marker, name);
    }
    return ((!name.empty() && this->In.Next() && this->In.Assignment(key, text) &&
              key == "MARKER_ELEMS" && ReadCount(text, count)) ||
             this->Out.Fail("the name of a marker, and MARKER_ELEMS=")) &&
      this->ReadCells(count, marker - this->Markers.begin() + 1);
  }

  MeshFileBuilder Out;
  MeshFileLines& In = this->Out.In;
  std::set<std::string> Keys;
  std::vector<std::string> Markers;
  int Dimension = 2;
  std::size_t NumberOfMarkers = 0;
  std::size_t ReadMarkers = 0;
  bool IsPassing = false; // over the lines of what we have no use for
};

} // namespace

ReadingResult ReadSU2(std::istream& file, MeshFile& mesh)
{
  const ReadingResult result = SU2Reading(file, mesh).Read();
  NumberByNames(mesh.Tags);
  return result;
}

} // namespace biting
