// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DrawingFile.h"

#include <cstdlib> // for the folder
#include <fstream> // for files
#include <utility> // for move

using namespace biting;

namespace
{

std::string PathOf(const std::string& name)
{
  const std::string inData = std::string(BITING_SOURCE_DIR) + "/Data/" + name;
  const char* shared = std::getenv("BITING_SHARED_INPUTS");
  const bool isInData = std::ifstream(inData).good();
  return isInData || shared == nullptr ? inData : std::string(shared) + "/" + name;
}

class DrawingReader
{
public:
  DrawingReader(const std::string& path, DrawingFile& drawing)
    : File(path)
    , Drawing(drawing)
  {
    std::string line;
    for (int k = 0; k < 3; ++k)
    {
      std::getline(this->File, line);
    }
  }

  void Read();

private:
  void ReadPoints();
  void ReadChains(ChainKind kind);
  void ReadTriangles();
  void ReadArrays(bool areOfPoints);
  void ReadArray(std::size_t numbers, bool isWanted);

  std::ifstream File;
  DrawingFile& Drawing;
};

void DrawingReader::Read()
{
  std::string word;
  bool isAtPoints = false;
  while (this->File >> word)
  {
    if (word == "POINTS")
    {
      this->ReadPoints();
    }
    else if (word == "LINES" || word == "VERTICES")
    {
      this->ReadChains(word == "LINES" ? ChainKind::Automatic : ChainKind::EmbeddedPoint);
    }
    else if (word == "CELLS")
    {
      this->ReadTriangles();
    }
    else if (word == "CELL_DATA" || word == "POINT_DATA")
    {
      isAtPoints = word == "POINT_DATA";
    }
    else if (word == "FIELD")
    {
      this->ReadArrays(isAtPoints);
    }
    else if (word == "LOOKUP_TABLE")
    {
      this->File >> word;
      this->ReadArray(this->Drawing.Lines.Points.size(), isAtPoints);
    }
  }
}

void DrawingReader::ReadPoints()
{
  std::size_t count = 0;
  std::string type;
  this->File >> count >> type;
  this->Drawing.Lines.Points.resize(count);
  double z = 0.0;
  for (Point2& p : this->Drawing.Lines.Points)
  {
    this->File >> p.X >> p.Y >> z;
  }
}

void DrawingReader::ReadChains(ChainKind kind)
{
  Polylines& lines = this->Drawing.Lines;
  Id count = 0;
  Id size = 0;
  this->File >> count >> size;
  for (Id cell = 0; cell < count; ++cell)
  {
    this->File >> size;
    for (Id k = 0; k < size; ++k)
    {
      Id point = 0;
      this->File >> point;
      lines.Connectivity.push_back(point);
    }
    lines.Offsets.push_back(static_cast<Id>(lines.Connectivity.size()));
    lines.Cells.push_back(lines.NumberOfChains());
    lines.Kinds.push_back(kind);
  }
}

void DrawingReader::ReadTriangles()
{
  std::size_t count = 0;
  Id size = 0;
  this->File >> count >> size;
  this->Drawing.Triangles.resize(3 * count);
  for (std::size_t corner = 0; corner < 3 * count; ++corner)
  {
    if (corner % 3 == 0)
    {
      this->File >> size;
    }
    this->File >> this->Drawing.Triangles[corner];
  }
}

void DrawingReader::ReadArrays(bool areOfPoints)
{
  std::string word;
  int count = 0;
  this->File >> word >> count;
  for (int array = 0; array < count; ++array)
  {
    std::size_t components = 0;
    std::size_t tuples = 0;
    this->File >> word >> components >> tuples >> word;
    this->ReadArray(components * tuples, areOfPoints && components == 1);
  }
}

void DrawingReader::ReadArray(std::size_t numbers, bool isWanted)
{
  std::vector<double> values(numbers);
  for (double& value : values)
  {
    this->File >> value;
  }
  if (isWanted && this->Drawing.Values.empty())
  {
    this->Drawing.Values = std::move(values);
  }
}

} // namespace

DrawingFile::DrawingFile(const std::string& name)
{
  DrawingReader(PathOf(name), *this).Read();
}
