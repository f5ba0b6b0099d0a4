// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <cstdlib> // for abs

namespace biting
{

namespace
{

//------------------------------------------------------------------------------
MeshFileCell CellInGmsh(int type)
{
  constexpr int edge = 1;
  constexpr int triangle = 2;
  constexpr int point = 15;
  return type == triangle ? MeshFileCell::Triangle
    : type == edge        ? MeshFileCell::Edge
    : type == point       ? MeshFileCell::Point
                          : MeshFileCell::Other;
}

class GmshReading
{
public:
  GmshReading(MeshFileLines& lines, MeshFile& mesh)
    : In(lines)
    , Out(lines, mesh)
  {
  }

  ReadingResult Read()
  {
    bool isRead = true;
    std::string section;
    while (isRead && this->In.Read(section))
    {
      isRead = this->ReadSection(section);
    }
    if (isRead && this->Version.empty())
    {
      this->Out.Fail("a mesh of Gmsh");
    }
    return this->Out.Finish(
      [this](int dimension, std::int64_t number)
      {
        const auto found = this->Names.find({ dimension, number });
        return found != this->Names.end() ? found->second : std::string();
      });
  }

private:
  using Entity = std::pair<int, std::int64_t>; // dimension and number

  bool ReadSection(const std::string& section)
  {
    const bool isNew = this->Version == "4.1";
    if (section == "$MeshFormat")
    {
      return this->ReadFormat();
    }
    if (section == "$PhysicalNames")
    {
      return this->ReadNames();
    }
    if (section == "$Entities")
    {
      return this->ReadEntities();
    }
    if (section == "$Nodes")
    {
      return isNew ? this->ReadBlocksOfNodes() : this->ReadNodes();
    }
    if (section == "$Elements")
    {
      return isNew ? this->ReadBlocksOfElements() : this->ReadElements();
    }
    return true; // what we have no use for, line by line
  }

  bool ReadFormat()
  {
    int isBinary = 1;
    return (this->In.Read(this->Version, isBinary) && isBinary == 0 &&
             (this->Version == "2.2" || this->Version == "4.1")) ||
      this->Out.Fail("the format of Gmsh 2.2 or 4.1 in ASCII");
  }

  bool ReadNames()
  {
    std::size_t count = 0;
    bool isRead = this->In.Read(count);
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      Entity group;
      std::string name;
      isRead = this->In.Read(group.first, group.second) && this->In.Quoted(name);
      this->Names[group] = name;
    }
    return isRead || this->Out.Fail("the name of a physical group");
  }

  bool ReadEntities()
  {
    std::array<std::size_t, 4> counts{};
    bool isRead = this->In.Read(counts[0], counts[1], counts[2], counts[3]);
    for (int dimension = 0; isRead && dimension < 3; ++dimension)
    {
      for (std::size_t k = 0; isRead && k < counts[static_cast<std::size_t>(dimension)]; ++k)
      {
        isRead = this->ReadEntity(dimension);
      }
    }
    return isRead || this->Out.Fail("an entity");
  }

  // Its number, its box (a point has one corner), and its physical groups: the first one counts. A
  // sign there is the orientation.
  bool ReadEntity(int dimension)
  {
    std::int64_t number = 0;
    bool isRead = this->In.Read(number);
    for (int k = 0; isRead && k < (dimension == 0 ? 3 : 6); ++k)
    {
      double coordinate = 0.0;
      isRead = this->In.More(coordinate);
    }
    std::size_t count = 0;
    isRead = isRead && this->In.More(count);
    if (isRead && count > 0)
    {
      std::int64_t physical = 0;
      isRead = this->In.More(physical);
      this->Physical[{ dimension, number }] = std::abs(physical);
    }
    return isRead;
  }

  bool ReadNodes()
  {
    std::size_t count = 0;
    bool isRead = this->In.Read(count) || this->Out.Fail("the number of nodes");
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::int64_t number = 0;
      std::array<double, 3> place{};
      isRead = (this->In.Read(number, place[0], place[1], place[2]) || this->Out.Fail("a node")) &&
        this->Out.AddVertex(number, place);
    }
    return isRead;
  }

  bool ReadBlocksOfNodes()
  {
    std::size_t blocks = 0;
    bool isRead = this->In.Read(blocks) || this->Out.Fail("the number of blocks of nodes");
    for (std::size_t block = 0; isRead && block < blocks; ++block)
    {
      isRead = this->ReadBlockOfNodes();
    }
    return isRead;
  }

  // All numbers, then all places.
  bool ReadBlockOfNodes()
  {
    Entity entity;
    int isParametric = 0;
    std::size_t count = 0;
    bool isRead = this->In.Read(entity.first, entity.second, isParametric, count);
    std::vector<std::int64_t> numbers;
    std::int64_t number = 0;
    while (isRead && numbers.size() < count)
    {
      isRead = this->In.Read(number);
      numbers.push_back(number);
    }
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::array<double, 3> place{};
      isRead = this->In.Read(place[0], place[1], place[2]);
      if (isRead && !this->Out.AddVertex(numbers[k], place))
      {
        return false;
      }
    }
    return isRead || this->Out.Fail("a block of nodes");
  }

  bool ReadElements()
  {
    std::size_t count = 0;
    bool isRead = this->In.Read(count) || this->Out.Fail("the number of elements");
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      isRead = this->ReadElement();
    }
    return isRead;
  }

  // Its number, type, and tags: the first is the physical group, the second the entity.
  bool ReadElement()
  {
    std::int64_t number = 0;
    int type = 0;
    std::size_t numberOfTags = 0;
    bool isRead = this->In.Read(number, type, numberOfTags);
    std::array<std::int64_t, 2> tags{};
    for (std::size_t k = 0; isRead && k < numberOfTags; ++k)
    {
      isRead = this->In.More(k < 2 ? tags[k] : number);
    }
    return (isRead || this->Out.Fail("an element")) &&
      this->Out.ReadCell(CellInGmsh(type), { tags[0], tags[1] });
  }

  bool ReadBlocksOfElements()
  {
    std::size_t blocks = 0;
    bool isRead = this->In.Read(blocks) || this->Out.Fail("the number of blocks of elements");
    for (std::size_t block = 0; isRead && block < blocks; ++block)
    {
      isRead = this->ReadBlockOfElements();
    }
    return isRead;
  }

  bool ReadBlockOfElements()
  {
    Entity entity;
    int type = 0;
    std::size_t count = 0;
    bool isRead = this->In.Read(entity.first, entity.second, type, count) ||
      this->Out.Fail("a block of elements");
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::int64_t number = 0;
      isRead = (this->In.Read(number) || this->Out.Fail("an element")) &&
        this->Out.ReadCell(CellInGmsh(type), this->GroupOf(entity));
    }
    return isRead;
  }

  MeshFileBuilder::Group GroupOf(const Entity& entity) const
  {
    const auto found = this->Physical.find(entity);
    return { found != this->Physical.end() ? found->second : 0, entity.second };
  }

  MeshFileLines& In;
  MeshFileBuilder Out;
  std::string Version;
  std::map<Entity, std::string> Names; // of physical groups
  std::map<Entity, std::int64_t> Physical;
};

} // namespace

ReadingResult ReadGmsh(std::istream& file, MeshFile& mesh)
{
  MeshFileLines lines(file);
  return GmshReading(lines, mesh).Read();
}

} // namespace biting
