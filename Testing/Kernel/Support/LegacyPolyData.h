// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLegacyPolyData_h
#define BitingLegacyPolyData_h

#include <algorithm> // for min
#include <array>     // for points
#include <cstdint>   // for bytes
#include <cstring>   // for memcpy
#include <fstream>   // for the file
#include <iterator>  // for istreambuf_iterator
#include <sstream>   // for tokens
#include <string>    // for names
#include <vector>    // for the arrays

namespace biting
{

/// What a legacy VTK file of polygonal data holds, as far as tests need it. Reads ASCII and binary
/// (big-endian) files of version 3 and before.
struct LegacyPolyData
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<int>> Vertices;
  std::vector<std::vector<int>> Lines;
  std::vector<std::vector<int>> Polygons;
  std::vector<int> Kinds; ///< one a cell, in the order vertices, lines, polygons; may be empty

  bool IsFlat() const
  {
    for (const std::array<double, 3>& point : this->Points)
    {
      if (point[2] != this->Points.front()[2])
      {
        return false;
      }
    }
    return true;
  }
};

/// Reads tokens and numbers from the text of a legacy file.
class LegacyReader
{
public:
  explicit LegacyReader(const std::string& path)
  {
    std::ifstream file(path, std::ios::binary);
    this->Text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }

  LegacyPolyData Read()
  {
    LegacyPolyData data;
    this->SkipLine();
    this->SkipLine();
    this->IsBinary = this->Token() == "BINARY";
    for (std::string word = this->Token(); !word.empty(); word = this->Token())
    {
      if (word == "POINTS")
      {
        this->ReadPoints(data);
      }
      else if (std::vector<std::vector<int>>* cells = CellsNamed(word, data))
      {
        this->ReadCells(*cells);
      }
      else if (word == "Kind")
      {
        this->ReadKinds(data);
      }
      else if (word == "POINT_DATA")
      {
        break;
      }
    }
    return data;
  }

private:
  static std::vector<std::vector<int>>* CellsNamed(const std::string& word, LegacyPolyData& data)
  {
    return word == "VERTICES" ? &data.Vertices
      : word == "LINES"       ? &data.Lines
      : word == "POLYGONS"    ? &data.Polygons
                              : nullptr;
  }

  void ReadPoints(LegacyPolyData& data)
  {
    data.Points.resize(static_cast<std::size_t>(std::stol(this->Token())));
    const bool isFloat = this->Token() == "float";
    this->BeginNumbers();
    for (std::array<double, 3>& point : data.Points)
    {
      for (double& coordinate : point)
      {
        coordinate = isFloat ? this->Number<float>() : this->Number<double>();
      }
    }
  }

  void ReadCells(std::vector<std::vector<int>>& cells)
  {
    cells.resize(static_cast<std::size_t>(std::stol(this->Token())));
    this->Token();
    this->BeginNumbers();
    for (std::vector<int>& cell : cells)
    {
      cell.resize(static_cast<std::size_t>(this->Number<int>()));
      for (int& point : cell)
      {
        point = this->Number<int>();
      }
    }
  }

  void ReadKinds(LegacyPolyData& data)
  {
    this->Token();
    data.Kinds.resize(static_cast<std::size_t>(std::stol(this->Token())));
    this->Token();
    this->BeginNumbers();
    for (int& kind : data.Kinds)
    {
      kind = this->Number<int>();
    }
  }

  void SkipLine() { this->Place = this->Text.find('\n', this->Place) + 1; }

  std::string Token()
  {
    const char* blanks = " \t\r\n";
    const std::size_t first = this->Text.find_first_not_of(blanks, this->Place);
    if (first == std::string::npos)
    {
      return "";
    }
    this->Place = std::min(this->Text.find_first_of(blanks, first), this->Text.size());
    return this->Text.substr(first, this->Place - first);
  }

  void BeginNumbers()
  {
    if (this->IsBinary)
    {
      this->SkipLine();
    }
  }

  template <typename Value>
  Value Number()
  {
    return this->IsBinary ? this->BinaryNumber<Value>()
                          : static_cast<Value>(std::stod(this->Token()));
  }

  template <typename Value>
  Value BinaryNumber()
  {
    std::uint64_t bits = 0;
    for (std::size_t byte = 0; byte < sizeof(Value); ++byte)
    {
      bits = bits << 8 | static_cast<unsigned char>(this->Text.at(this->Place++));
    }
    const auto narrow = static_cast<std::uint32_t>(bits);
    Value value;
    std::memcpy(&value,
      sizeof(Value) == 8 ? static_cast<const void*>(&bits) : static_cast<const void*>(&narrow),
      sizeof(Value));
    return value;
  }

  std::string Text;
  std::size_t Place = 0;
  bool IsBinary = false;
};

} // namespace biting

#endif
