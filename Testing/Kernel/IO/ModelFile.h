// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingModelFile_h
#define BitingModelFile_h

#include "IO/MeshFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

/** Files of which each word is known: what the mesh is, and what another word makes of it. */
namespace biting
{

/// A mesh as the reader should give it. Regions and tags are numbers of groups.
struct MeshModel
{
  std::vector<std::array<double, 3>> Points;
  std::vector<double> Depths;
  std::vector<std::vector<std::int64_t>> Cells; // triangles or tetrahedra
  std::vector<std::int64_t> Regions;
  std::vector<std::vector<std::int64_t>> Sides; // edges or triangles
  std::vector<std::int64_t> Tags;
  std::vector<std::int64_t> Numbers; // of the points, in the file
};

/// What is to come of a file.
enum class FileVerdict
{
  Mesh,   ///< the model
  Error,  ///< no mesh
  Said,   ///< the model, an error or a remark
  Unknown ///< whatever keeps the laws of a mesh
};

/// A word of a file. `Change` gives the model what another word means there.
struct FileWord
{
  std::string Text;
  std::function<FileVerdict(MeshModel&, const std::string&)> Change; // null: Error
};

struct ModelFile
{
  std::string Name;
  std::function<ReadingResult(std::istream&, MeshFile&)> Read;
  MeshModel Model;
  std::vector<std::vector<FileWord>> Lines;
  std::size_t FirstOptional = 0;            // from this line on all may be missing; 0: none may
  std::size_t Rest = 0;                     // words after the last one that is needed
  FileVerdict Shifted = FileVerdict::Error; // of a line that is missing, or there twice

  /// The text to a word of a line, or to the end of the line.
  std::string TextTo(std::size_t line, std::size_t word) const
  {
    std::string text;
    for (std::size_t k = 0; k <= line && k < this->Lines.size(); ++k)
    {
      const std::size_t end = k == line ? std::min(word, this->Lines[k].size()) : SIZE_MAX;
      for (std::size_t w = 0; w < std::min(end, this->Lines[k].size()); ++w)
      {
        text += (w > 0 ? " " : "") + this->Lines[k][w].Text;
      }
      text += k < line ? "\n" : "";
    }
    return text;
  }
  std::string Text() const { return this->TextTo(this->Lines.size(), 0); }
};

inline bool IsWholeText(const std::string& text)
{
  const std::size_t begin = text.find_first_of("+-") == 0 ? 1 : 0;
  return begin < text.size() && text.find_first_not_of("0123456789", begin) == std::string::npos;
}

/// A real number in the grammar of C.
inline bool IsRealText(const std::string& text)
{
  const std::size_t exponent = text.find_first_of("eE");
  std::string digits = text.substr(0, exponent);
  digits.erase(0, digits.find_first_of("+-") == 0 ? 1 : 0);
  digits.erase(std::min(digits.find('.'), digits.size()), 1);
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos &&
    (exponent == std::string::npos || IsWholeText(text.substr(exponent + 1)));
}

/// Makes files of a fan of three to seven triangles in two regions, around which edges have two
/// tags; in three dimensions of the tetrahedra and triangles between these and one more vertex.
class ModelFiles
{
public:
  ModelFiles(unsigned seed, std::size_t dimension)
    : Random(seed)
    , Dimension(dimension)
  {
  }

  ModelFile Gmsh2();
  ModelFile Gmsh4();
  ModelFile SU2();
  ModelFile ADCIRC();

private:
  using Words = std::vector<FileWord>;

  void MakeFan(std::int64_t firstNumber);
  int Below(std::size_t count) { return static_cast<int>(this->Random() % count); }
  std::string Real(bool isFortran);

  // Numbers that nothing depends on, and counts that a sum or a remark guards.
  static FileWord Any(std::size_t number, FileVerdict verdict = FileVerdict::Mesh);
  static FileWord Fixed(std::size_t number) { return { std::to_string(number), nullptr }; }
  static Words AllFixed(const std::string& text) { return { { text, nullptr } }; }
  static Words AllFree(const std::string& text);
  FileWord Place(std::size_t point, std::size_t axis, bool isFortran = false);
  FileWord Number(std::size_t point) const;
  FileWord Corner(std::size_t cell, std::size_t corner) const;
  void AddCorners(std::size_t cell, Words& words) const;
  void AddEnds(std::size_t side, Words& words) const;
  FileWord End(std::int64_t vertex, std::vector<std::array<std::size_t, 2>> places) const;
  FileWord Group(
    std::vector<std::int64_t> MeshModel::*groups, std::size_t first, std::size_t end) const;

  std::mt19937 Random;
  std::size_t Dimension;
  MeshModel Model;
};

} // namespace biting

#endif
