// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Files that are cut, or of which a byte, a word or a line is another: what is read is what the
// file says, or there is an error or a remark.

#include "ModelFile.h"

#include <gtest/gtest.h>

#include <sstream>

namespace biting
{

namespace
{

constexpr unsigned NumberOfFiles = 12; // of each format and dimension: 150,000 cases

struct ReadFile
{
  MeshFile Mesh;
  ReadingResult Result;
};

ReadFile ReadText(const ModelFile& file, const std::string& text)
{
  ReadFile read;
  std::istringstream stream(text);
  read.Result = file.Read(stream, read.Mesh);
  return read;
}

std::vector<std::int64_t> NumbersOf(
  const std::vector<std::size_t>& ofCells, const std::vector<MeshGroup>& groups)
{
  std::vector<std::int64_t> numbers;
  for (const std::size_t group : ofCells)
  {
    numbers.push_back(groups.at(group).Number);
  }
  return numbers;
}

template <typename Cells>
bool AreAlike(const Cells& cells, const std::vector<std::vector<std::int64_t>>& others)
{
  return std::equal(cells.begin(), cells.end(), others.begin(), others.end(),
    [](const auto& cell, const auto& other)
    { return std::equal(cell.begin(), cell.end(), other.begin(), other.end()); });
}

bool IsModel(const MeshFile& mesh, const MeshModel& model)
{
  return mesh.Points == model.Points && mesh.Depths == model.Depths &&
    WithCells(mesh,
      [&model](const auto& sides, const auto& cells)
      { return AreAlike(cells, model.Cells) && AreAlike(sides, model.Sides); }) &&
    NumbersOf(mesh.RegionOfCell, mesh.Regions) == model.Regions &&
    NumbersOf(mesh.TagOfSide, mesh.Tags) == model.Tags;
}

template <typename Cells>
bool AreCells(const Cells& cells, const MeshFile& mesh)
{
  const auto size = static_cast<std::int64_t>(mesh.Points.size());
  return std::all_of(cells.begin(), cells.end(),
    [size](auto cell)
    {
      std::sort(cell.begin(), cell.end());
      return cell.front() >= 0 && cell.back() < size &&
        std::adjacent_find(cell.begin(), cell.end()) == cell.end();
    });
}

bool IsMesh(const MeshFile& mesh)
{
  return WithCells(mesh,
           [&mesh](const auto& sides, const auto& cells)
           {
             return !cells.empty() && AreCells(cells, mesh) && AreCells(sides, mesh) &&
               mesh.RegionOfCell.size() == cells.size() && mesh.TagOfSide.size() == sides.size();
           }) &&
    NumbersOf(mesh.RegionOfCell, mesh.Regions).size() == mesh.NumberOfCells() &&
    NumbersOf(mesh.TagOfSide, mesh.Tags).size() == mesh.TagOfSide.size() &&
    (mesh.Depths.empty() || mesh.Depths.size() == mesh.Points.size());
}

/// Whether reading gives what it is to give.
bool IsAs(const ReadFile& read, FileVerdict verdict, const MeshModel& model)
{
  const bool isRead = read.Result.Reason.empty();
  const bool isSaid = !isRead || !read.Result.Remarks.empty();
  switch (verdict)
  {
    case FileVerdict::Error:
      return !isRead;
    case FileVerdict::Mesh:
      return isRead && IsModel(read.Mesh, model);
    case FileVerdict::Said:
      return isSaid || IsModel(read.Mesh, model);
    default:
      return !isRead || IsMesh(read.Mesh);
  }
}

void Expect(
  const ModelFile& file, const std::string& text, FileVerdict verdict, const MeshModel& model)
{
  const ReadFile read = ReadText(file, text);
  EXPECT_TRUE(IsAs(read, verdict, model))
    << file.Name << ", to be " << static_cast<int>(verdict) << ": " << read.Result.Reason << "\n"
    << text;
}

/// Calls `test` for files of all formats.
template <typename Test>
void ForFiles(const Test& test)
{
  for (unsigned seed = 1; seed <= NumberOfFiles && !::testing::Test::HasFailure(); ++seed)
  {
    ModelFiles files(seed, 2);
    ModelFiles solids(seed, 3);
    for (const ModelFile& file : { files.Gmsh2(), files.Gmsh4(), files.SU2(), files.ADCIRC(),
           solids.Gmsh2(), solids.Gmsh4(), solids.SU2() })
    {
      test(file, seed);
    }
  }
}

} // namespace

TEST(MeshFileFuzz, WholeFilesAreRead)
{
  ForFiles(
    [](const ModelFile& file, unsigned)
    {
      const std::string text = file.Text();
      Expect(file, text, FileVerdict::Mesh, file.Model);
      for (const char* ends : { "\r\n", " \t\n", "\n\n" })
      {
        std::string other;
        for (const char c : text)
        {
          other += c == '\n' ? ends : std::string(1, c == ' ' ? '\t' : c);
        }
        Expect(file, other, FileVerdict::Mesh, file.Model);
      }
    });
}

TEST(MeshFileFuzz, FilesThatAreCutAnywhereAreErrors)
{
  ForFiles(
    [](const ModelFile& file, unsigned)
    {
      const std::string text = file.Text();
      const std::size_t last = file.Lines.size() - 1;
      const std::size_t end = file.TextTo(last, file.Lines.back().size() - file.Rest).size();
      MeshModel cut = file.Model;
      cut.Sides.clear();
      cut.Tags.clear();
      const std::size_t optional = file.FirstOptional;
      const std::size_t begin = optional > 0 ? file.TextTo(optional, 0).size() : text.size();
      for (std::size_t size = 0; size < text.size(); ++size)
      {
        const bool isWithout = optional > 0 && size + 1 >= begin && size <= begin;
        Expect(file, text.substr(0, size),
          size >= end   ? FileVerdict::Mesh
            : isWithout ? FileVerdict::Said
                        : FileVerdict::Error,
          file.Model);
        // The last number of a line that does not end may be cut.
        const ReadFile read = ReadText(file, text.substr(0, size));
        if (isWithout && (size == begin || read.Result.Reason.empty()))
        {
          EXPECT_TRUE(IsModel(read.Mesh, cut));
        }
      }
    });
}

TEST(MeshFileFuzz, AnotherWordIsReadAsWhatItSaysOrIsAnError)
{
  const std::string signs = "0123456789.-+eEDx$\"";
  ForFiles(
    [&signs](const ModelFile& file, unsigned seed)
    {
      std::mt19937 random(seed);
      ModelFile changed = file;
      for (auto& line : changed.Lines)
      {
        for (FileWord& word : line)
        {
          for (std::size_t k = 0; k < 2 * word.Text.size(); ++k)
          {
            const FileWord before = word;
            word.Text[k / 2] = signs[random() % signs.size()];
            SCOPED_TRACE(before.Text + " is " + word.Text);
            MeshModel model = file.Model;
            if (word.Text != before.Text)
            {
              const FileVerdict verdict =
                word.Change ? word.Change(model, word.Text) : FileVerdict::Error;
              Expect(file, changed.Text(), verdict, model);
            }
            word = before;
          }
        }
      }
    });
}

TEST(MeshFileFuzz, LinesThatAreMissingOrTwiceAreErrors)
{
  ForFiles(
    [](const ModelFile& file, unsigned)
    {
      for (std::size_t line = 0; line < file.Lines.size(); ++line)
      {
        ModelFile changed = file;
        changed.Lines.insert(
          changed.Lines.begin() + static_cast<std::ptrdiff_t>(line), file.Lines[line]);
        Expect(file, changed.Text(), file.Shifted, file.Model);
        changed = file;
        changed.Lines.erase(changed.Lines.begin() + static_cast<std::ptrdiff_t>(line));
        Expect(file, changed.Text(), file.Shifted, file.Model);
      }
    });
}

TEST(MeshFileFuzz, AnyOtherByteGivesAMeshOrAnError)
{
  ForFiles(
    [](const ModelFile& file, unsigned seed)
    {
      std::mt19937 random(seed);
      std::string text = file.Text();
      for (char& byte : text)
      {
        const char before = byte;
        byte = random() % 4 == 0 ? " \n,%=\0"[random() % 6] : static_cast<char>(random() % 256);
        Expect(file, text, FileVerdict::Unknown, file.Model);
        byte = before;
      }
    });
}

} // namespace biting
