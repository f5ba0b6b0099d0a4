// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <algorithm> // for find

namespace biting
{

namespace
{

constexpr std::int64_t OpenTag = 1;
constexpr std::int64_t FirstLandTag = 2;

// Types of land by what follows a node in its line: nothing; heights; the node on the other side,
// and heights. Islands are loops whose first node is not repeated.
constexpr int PlainTypes[] = { 0, 1, 2, 10, 11, 12, 20, 21, 22, 30, 32, 40, 41, 52, 102, 112, 122 };
constexpr int Islands[] = { 1, 11, 21 };
constexpr int Barriers[] = { 3, 13, 23 };
constexpr int PairedTypes[] = { 4, 24, 5, 25, 64 };

template <std::size_t Size>
bool IsOneOf(const int (&types)[Size], int type)
{
  return std::find(types, types + Size, type) != types + Size;
}

class ADCIRCReading
{
public:
  ADCIRCReading(std::istream& file, MeshFile& mesh)
    : Out(file, MeshFileDialect::Fortran, mesh)
    , Mesh(mesh)
  {
  }

  ReadingResult Read()
  {
    if (this->ReadGrid() && this->ReadBoundary() && this->In.Next())
    {
      this->Out.Remark("What follows the boundaries, from line " +
        std::to_string(this->In.LineNumber()) + " on, is left out.");
    }
    return this->Out.Finish([](int dimension, std::int64_t number)
      { return dimension == 1 ? NameOf(number) : std::string(); });
  }

private:
  static std::string NameOf(std::int64_t tag)
  {
    return tag == OpenTag ? "open" : "land, type " + std::to_string(tag - FirstLandTag);
  }

  bool ReadGrid()
  {
    std::size_t elements = 0;
    std::size_t nodes = 0;
    return ((this->In.PassTitle() && this->In.Read(elements, nodes)) ||
             this->Out.Fail("the numbers of elements and nodes")) &&
      Repeat(nodes, [this] { return this->ReadNode(); }) &&
      Repeat(elements, [this] { return this->ReadElement(); });
  }

  bool ReadNode()
  {
    std::int64_t number = 0;
    std::array<double, 3> place{};
    const bool isRead = this->In.Read(number, place[0], place[1], place[2]);
    this->Mesh.Depths.push_back(place[2]);
    return (isRead || this->Out.Fail("a node")) &&
      this->Out.AddVertex(number, { place[0], place[1], 0.0 });
  }

  bool ReadElement()
  {
    std::int64_t number = 0;
    std::size_t corners = 0;
    return ((this->In.Read(number, corners) && (corners == 3 || corners == 4)) ||
             this->Out.Fail("an element of 3 or 4 nodes")) &&
      this->Out.ReadCell({ corners, corners, 2 }, { 0, 0 }) &&
      (!this->In.PassNumber() || this->Out.Fail("no more nodes than the element has"));
  }

  // Open boundaries, then land: none of both, or both.
  bool ReadBoundary()
  {
    if (!this->In.Next())
    {
      this->Out.Remark("The file ends after the elements: it has no boundaries.");
      return true;
    }
    const bool isRead = this->ReadStrings(true) &&
      (this->In.Next() || this->Out.Fail("the number of land boundaries")) &&
      this->ReadStrings(false);
    if (this->Weirs > 0)
    {
      this->Out.Remark("Boundaries of weirs and barriers (types 3, 4, 5, 13, 23, 24, 25, 64): " +
        std::to_string(this->Weirs) +
        ". Their edges are read; pairs of nodes, heights and coefficients are left out.");
    }
    return isRead;
  }

  // Expects the line of their number; that of all their nodes follows, then each.
  bool ReadStrings(bool areOpen)
  {
    std::size_t count = 0;
    std::size_t total = 0;
    this->Nodes = 0;
    this->NodesBehind = 0;
    const bool isRead = (this->In.More(count) || this->Out.Fail("the number of boundaries")) &&
      (this->In.Read(total) || this->Out.Fail("the number of nodes of boundaries")) &&
      Repeat(count, [this, areOpen] { return this->ReadString(areOpen); });
    if (isRead && total != this->Nodes && total != this->Nodes + this->NodesBehind)
    {
      this->Out.Remark(std::string(areOpen ? "Open" : "Land") + " boundaries have " +
        std::to_string(this->Nodes + this->NodesBehind) + " nodes; the file says " +
        std::to_string(total) + ".");
    }
    return isRead;
  }

  bool ReadString(bool isOpen)
  {
    std::size_t size = 0;
    int type = 0;
    const bool isKnown = this->In.Read(size) &&
      (isOpen ||
        (this->In.More(type) &&
          (IsOneOf(PlainTypes, type) || IsOneOf(Barriers, type) || IsOneOf(PairedTypes, type))));
    const bool arePairs = !isOpen && IsOneOf(PairedTypes, type);
    const MeshFileBuilder::Group group{ isOpen ? OpenTag : FirstLandTag + type, 0 };
    bool isRead = isKnown || this->Out.Fail("the nodes and the type of a boundary");
    std::array<std::int64_t, 2> first{};
    std::array<std::int64_t, 2> last{};
    for (std::size_t k = 0; isRead && k < size; ++k)
    {
      std::array<std::int64_t, 2> nodes{};
      isRead = (this->In.Read(nodes[0]) && (!arePairs || this->In.More(nodes[1]))) ||
        this->Out.Fail("a node of a boundary");
      isRead = isRead && (k == 0 || this->Out.AddEdge({ last[0], nodes[0] }, group)) &&
        (k == 0 || !arePairs || this->Out.AddEdge({ last[1], nodes[1] }, group));
      first = k == 0 ? nodes : first;
      last = nodes;
    }
    this->Nodes += size;
    this->NodesBehind += arePairs ? size : 0;
    this->Weirs += arePairs || IsOneOf(Barriers, isOpen ? 0 : type) ? 1 : 0;
    const bool isLoop = !isOpen && IsOneOf(Islands, type) && size > 2 && first != last;
    return isRead && (!isLoop || this->Out.AddEdge({ last[0], first[0] }, group));
  }

  MeshFileBuilder Out;
  MeshFileLines& In = this->Out.In;
  MeshFile& Mesh;
  std::size_t Nodes = 0;       // of the boundaries that are open, or land
  std::size_t NodesBehind = 0; // on the other side of weirs
  std::size_t Weirs = 0;
};

} // namespace

ReadingResult ReadADCIRC(std::istream& file, MeshFile& mesh)
{
  return ADCIRCReading(file, mesh).Read();
}

} // namespace biting
