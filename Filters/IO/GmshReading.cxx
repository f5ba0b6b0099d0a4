// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileBuilder.h"

#include <cstdlib> // for abs

namespace biting
{

namespace
{

MeshFileCell CellInGmsh(int type)
{
  static const std::vector<std::array<int, 4>> Types{ { 15, 1, 1, 0 }, { 1, 2, 2, 1 },
    { 2, 3, 3, 2 }, { 3, 4, 4, 2 }, { 4, 4, 4, 3 }, { 8, 2, 3, 1 }, { 9, 3, 6, 2 }, { 10, 4, 9, 2 },
    { 11, 4, 10, 3 }, { 16, 4, 8, 2 } };
  return CellOfType(Types, type);
}

class GmshReading
{
public:
  GmshReading(std::istream& file, MeshFile& mesh)
    : Out(file, MeshFileDialect::Gmsh, mesh)
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

  // From the line of its name on to that of its end.
  bool ReadSection(const std::string& section)
  {
    const bool isNew = this->Version == "4.1";
    const std::string end = "$End" + section.substr(1);
    bool isRead = section[0] == '$' || this->Out.Fail("the name of a section, as in $Nodes");
    if (isRead && section != "$MeshFormat" && this->Version.empty())
    {
      isRead = this->Out.Fail("$MeshFormat, the first section of a mesh of Gmsh");
    }
    else if (section == "$MeshFormat")
    {
      isRead = isRead && this->ReadFormat();
    }
    else if (section == "$PhysicalNames")
    {
      isRead = this->ReadNames();
    }
    else if (section == "$Entities" || section == "$PartitionedEntities")
    {
      isRead = this->ReadEntities(section == "$PartitionedEntities");
    }
    else if (section == "$Nodes" || section == "$ParametricNodes")
    {
      isRead =
        isNew ? this->ReadBlocks("nodes", &GmshReading::ReadBlockOfNodes) : this->ReadNodes();
    }
    else if (section == "$Elements")
    {
      isRead = isNew ? this->ReadBlocks("elements", &GmshReading::ReadBlockOfElements)
                     : this->ReadElements();
    }
    else
    {
      return isRead && this->PassSection(end); // we have no use for it
    }
    std::string word;
    return isRead && ((this->In.Read(word) && word == end) || this->Out.Fail(end));
  }

  bool PassSection(const std::string& end)
  {
    std::string word;
    while (word != end && this->In.Next())
    {
      this->In.More(word);
    }
    return word == end || this->Out.Fail(end);
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
      int dimension = 0;
      int number = 0;
      std::string name;
      isRead = this->In.Read(dimension, number) && this->In.Quoted(name) &&
        this->Names.emplace(Entity(dimension, number), name).second;
    }
    return isRead || this->Out.Fail("the name of a physical group");
  }

  bool ReadEntities(bool arePartitioned)
  {
    std::array<std::size_t, 4> counts{};
    bool isRead = !arePartitioned || this->PassPartitions();
    isRead = isRead && this->In.Read(counts[0], counts[1], counts[2], counts[3]);
    for (int dimension = 0; isRead && dimension < 4; ++dimension)
    {
      isRead = Repeat(counts[dimension],
        [this, dimension, arePartitioned] { return this->ReadEntity(dimension, arePartitioned); });
    }
    return isRead || this->Out.Fail("an entity");
  }

  // How many partitions there are, and ghost entities, each in a line.
  bool PassPartitions()
  {
    std::size_t count = 0;
    return this->In.Read(count) && this->In.Read(count) &&
      Repeat(count, [this] { return this->In.Next(); });
  }

  // Its number, its box (a point has one corner), and its physical groups; a sign there is the
  // orientation. A part of an entity is of its parent where both have one dimension.
  bool ReadEntity(int dimension, bool isPart)
  {
    int number = 0;
    bool isRead = this->In.Read(number);
    EntityGroups& entity = this->Entities[{ dimension, number }];
    entity.Number = number;
    if (isPart)
    {
      int parentDimension = 0;
      int parent = 0;
      std::size_t parts = 0;
      isRead = isRead && this->In.More(parentDimension, parent, parts);
      entity.Number = parentDimension == dimension ? parent : number;
      isRead = isRead && Repeat(parts, [this, &number] { return this->In.More(number); });
    }
    const auto readPhysical = [this, &entity]
    {
      int physical = 0;
      const bool isPhysical = this->In.More(physical);
      entity.Physical.push_back(std::abs(std::int64_t{ physical }));
      return isPhysical;
    };
    std::size_t count = 0;
    isRead = isRead && Repeat(dimension == 0 ? 3 : 6, [this] { return this->In.PassNumber(); }) &&
      this->In.More(count) && Repeat(count, readPhysical);
    // The entities around it.
    return isRead &&
      (dimension == 0 ||
        (this->In.More(count) &&
          Repeat(count, [this, &number] { return this->In.More(number); }))) &&
      this->In.IsRead();
  }

  bool ReadNodes()
  {
    std::size_t count = 0;
    return (this->In.Read(count) || this->Out.Fail("the number of nodes")) &&
      Repeat(count, [this] { return this->ReadNode(); });
  }

  bool ReadNode()
  {
    std::int64_t number = 0;
    std::array<double, 3> place{};
    return (this->In.Read(number, place[0], place[1], place[2]) || this->Out.Fail("a node")) &&
      this->Out.AddVertex(number, place);
  }

  // Each block adds the number of its things to `count`.
  bool ReadBlocks(const std::string& things, bool (GmshReading::*readBlock)(std::size_t& count))
  {
    std::size_t blocks = 0;
    std::size_t all = 0;
    std::size_t count = 0;
    return (this->In.Read(blocks, all) ||
             this->Out.Fail("the numbers of blocks and of " + things)) &&
      Repeat(blocks, [this, readBlock, &count] { return (this->*readBlock)(count); }) &&
      (count == all || this->Out.Fail("the last of " + std::to_string(all) + " " + things));
  }

  // All numbers, then all places, which parameters may follow.
  bool ReadBlockOfNodes(std::size_t& total)
  {
    int dimension = 0;
    int entity = 0;
    int isParametric = 0;
    std::size_t count = 0;
    bool isRead = this->In.Read(dimension, entity, isParametric, count);
    std::vector<std::int64_t> numbers;
    std::int64_t number = 0;
    while (isRead && numbers.size() < count)
    {
      isRead = this->In.Read(number) && this->In.IsRead();
      numbers.push_back(number);
    }
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::array<double, 3> place{};
      isRead =
        this->In.Read(place[0], place[1], place[2]) && (isParametric != 0 || this->In.IsRead());
      if (isRead && !this->Out.AddVertex(numbers[k], place))
      {
        return false;
      }
    }
    total += count;
    return isRead || this->Out.Fail("a block of nodes");
  }

  bool ReadElements()
  {
    std::size_t count = 0;
    return (this->In.Read(count) || this->Out.Fail("the number of elements")) &&
      Repeat(count, [this] { return this->ReadElement(); });
  }

  // Its number, type, and tags: the first is the physical group, the second the entity.
  bool ReadElement()
  {
    std::int64_t number = 0;
    int type = 0;
    std::size_t numberOfTags = 0;
    bool isRead = this->In.Read(number, type, numberOfTags);
    std::array<int, 2> tags{};
    for (std::size_t k = 0; isRead && k < numberOfTags; ++k)
    {
      isRead = k < 2 ? this->In.More(tags[k]) : this->In.More(number);
    }
    return (isRead || this->Out.Fail("an element")) &&
      this->ReadCorners(CellInGmsh(type), { tags[0], tags[1] });
  }

  bool ReadCorners(const MeshFileCell& cell, const MeshFileBuilder::Group& group)
  {
    return this->Out.ReadCell(cell, group) &&
      (cell.Corners == 0 || this->In.IsRead() || this->Out.Fail("no more nodes than belong there"));
  }

  bool ReadBlockOfElements(std::size_t& total)
  {
    int dimension = 0;
    int entity = 0;
    int type = 0;
    std::size_t count = 0;
    bool isRead =
      this->In.Read(dimension, entity, type, count) || this->Out.Fail("a block of elements");
    const MeshFileCell cell = CellInGmsh(type);
    isRead = isRead &&
      (cell.Corners == 0 || dimension == cell.Dimension ||
        this->Out.Fail("elements of the dimension of their entity"));
    const auto found = this->Entities.find({ dimension, entity });
    const bool isKnown = found != this->Entities.end();
    isRead =
      isRead && (isKnown || this->Entities.empty() || this->Out.Fail("an entity of the file"));
    const EntityGroups groups = isKnown ? found->second : EntityGroups{ entity, {} };
    for (std::size_t k = 0; isRead && k < count; ++k)
    {
      std::int64_t number = 0;
      isRead = (this->In.Read(number) || this->Out.Fail("an element")) &&
        this->ReadCorners(cell, { groups.First(), groups.Number });
    }
    for (std::size_t k = 1; cell.Corners > 1 && k < groups.Physical.size(); ++k)
    {
      this->Out.LeaveOut(dimension, groups.Physical[k], count);
    }
    total += count;
    return isRead;
  }

  struct EntityGroups
  {
    std::int64_t Number = 0;
    std::vector<std::int64_t> Physical;

    std::int64_t First() const { return this->Physical.empty() ? 0 : this->Physical.front(); }
  };

  MeshFileBuilder Out;
  MeshFileLines& In = this->Out.In;
  std::string Version;
  std::map<Entity, std::string> Names; // of physical groups
  std::map<Entity, EntityGroups> Entities;
};

} // namespace

ReadingResult ReadGmsh(std::istream& file, MeshFile& mesh)
{
  return GmshReading(file, mesh).Read();
}

} // namespace biting
