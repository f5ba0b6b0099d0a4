// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What holds for the sources as texts: the arrows between rooms, and the width of lines.

#include <gtest/gtest.h>

#include <algorithm>  // for sort, count_if
#include <cstddef>    // for columns
#include <filesystem> // for the tree
#include <fstream>    // for the files
#include <map>        // for the rooms
#include <set>        // for their neighbors
#include <string>     // for lines
#include <vector>     // for lists

namespace biting
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t Width = 100;
constexpr std::size_t MostLines = 450;
constexpr std::size_t MostLinesOfAFunction = 60;

const fs::path Root = BITING_SOURCE_DIR;

bool HasSuffix(const fs::path& file, const std::set<std::string>& suffixes)
{
  return suffixes.count(file.extension().string()) > 0 || file.filename() == "CMakeLists.txt";
}

std::vector<fs::path> FilesBelow(const std::string& folder, const std::set<std::string>& suffixes)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(Root / folder))
  {
    if (entry.is_regular_file() && HasSuffix(entry.path(), suffixes))
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> LinesOf(const fs::path& file)
{
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

/// Characters of a text in UTF-8.
std::size_t NumberOfColumns(const std::string& line)
{
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(),
    [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; }));
}

/// The folder of a file, seen from Filters: "Kernel/Delaunay", "Bridge", "." for the filters.
std::string RoomOf(const fs::path& file)
{
  return file.parent_path().lexically_relative(Root / "Filters").generic_string();
}

/// What the line includes, from this tree; empty where it includes nothing, or another's header.
fs::path IncludedFile(const std::string& line, const fs::path& from)
{
  const std::string begin = "#include \"";
  if (line.compare(0, begin.size(), begin) != 0)
  {
    return {};
  }
  const std::string name = line.substr(begin.size(), line.find('"', begin.size()) - begin.size());
  const fs::path file = (from.parent_path() / name).lexically_normal();
  return fs::exists(file) ? file : fs::path();
}

/// Which rooms each room may include; each its own besides. A room that is not named here needs a
/// line, and a reason.
const std::map<std::string, std::set<std::string>> Arrows = {
  { "Kernel/Base", {} },
  { "Kernel/Predicates", { "Base" } },
  { "Kernel/Domain", { "Base", "Predicates" } },
  { "Kernel/Simplification", { "Base", "Predicates", "Domain" } },
  { "Kernel/Spacing", { "Base", "Predicates" } },
  { "Kernel/Hessian", { "Base" } },
  { "Kernel/Biting", { "Base", "Predicates", "Domain", "Spacing", "Delaunay" } },
  { "Kernel/Delaunay", { "Base", "Predicates" } },
  { "Kernel/Relaxation", { "Base", "Predicates", "Domain", "Spacing", "Delaunay" } },
  { "Kernel/Quality", { "Base", "Predicates" } },
  { "Kernel/Meshing",
    { "Base", "Predicates", "Domain", "Simplification", "Spacing", "Biting", "Delaunay",
      "Relaxation", "Quality" } },
  { "Kernel/Blocks",
    { "Base", "Predicates", "Domain", "Spacing", "Biting", "Delaunay", "Relaxation", "Meshing" } },
  { "Kernel/Remeshing",
    { "Base", "Predicates", "Domain", "Simplification", "Spacing", "Biting", "Delaunay",
      "Quality" } },
};

bool IsAllowed(const std::string& from, const std::string& to)
{
  // The mesh that these assemble and check is declared in the header of the facade.
  if ((from == "Kernel/Meshing" || from == "Kernel/Remeshing") && to == "Kernel")
  {
    return true;
  }
  const std::string kernel = "Kernel/";
  const bool isToKernel = to.compare(0, kernel.size(), kernel) == 0;
  const auto arrows = Arrows.find(from);
  if (from == to || arrows != Arrows.end())
  {
    return from == to || (isToKernel && arrows->second.count(to.substr(kernel.size())) > 0);
  }
  // The facade may include every room of the kernel, the outer ones the kernel too.
  return from == "Kernel" ? isToKernel : from.compare(0, kernel.size(), kernel) != 0;
}

/// The interface of a filter: one piece of documentation a parameter, and no code.
bool IsInterface(const fs::path& file)
{
  return file.extension() == ".h" && file.filename().string().compare(0, 3, "vtk") == 0;
}

/// Whether what begins with the brace at the first column of line k is a function.
bool IsFunctionAt(const std::vector<std::string>& lines, std::size_t k)
{
  while (k > 0 && (lines[k] == "{" || lines[k].empty() || lines[k].front() == ' '))
  {
    --k;
  }
  const std::string word = lines[k].substr(0, lines[k].find(' '));
  const std::set<std::string> others{ "class", "enum", "namespace", "struct" };
  return others.count(word) == 0;
}

/// The lines of each function, from brace to brace, by the line that it begins at.
std::map<std::size_t, std::size_t> LinesOfFunctions(const std::vector<std::string>& lines)
{
  std::map<std::size_t, std::size_t> functions;
  std::size_t begin = lines.size();
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    if (lines[k] == "{")
    {
      begin = IsFunctionAt(lines, k) ? k : lines.size();
    }
    else if (!lines[k].empty() && lines[k].front() == '}' && begin < k)
    {
      functions[begin + 1] = k - begin + 1;
      begin = lines.size();
    }
  }
  return functions;
}

} // namespace

TEST(Sources, IncludesFollowTheArrowsBetweenRooms)
{
  const std::vector<fs::path> files = FilesBelow("Filters/Kernel", { ".h", ".cxx" });
  ASSERT_GT(files.size(), 100u);
  std::size_t numberOfIncludes = 0;
  for (const fs::path& file : files)
  {
    for (const std::string& line : LinesOf(file))
    {
      const fs::path included = IncludedFile(line, file);
      if (!included.empty())
      {
        ++numberOfIncludes;
        EXPECT_TRUE(IsAllowed(RoomOf(file), RoomOf(included)))
          << file << " must not include " << included;
      }
    }
  }
  EXPECT_GT(numberOfIncludes, files.size());
}

TEST(Sources, AreAllOfARoomWithArrows)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(Root / "Filters" / "Kernel"))
  {
    if (entry.is_directory())
    {
      EXPECT_EQ(Arrows.count("Kernel/" + entry.path().filename().string()), 1u) << entry.path();
    }
  }
}

TEST(Sources, HaveLinesOfAtMost100Columns)
{
  std::size_t numberOfFiles = 0;
  for (const std::string folder : { "Filters", "Plugin", "Testing" })
  {
    for (const fs::path& file : FilesBelow(folder, { ".h", ".cxx" }))
    {
      ++numberOfFiles;
      const std::vector<std::string> lines = LinesOf(file);
      for (std::size_t k = 0; k < lines.size(); ++k)
      {
        EXPECT_LE(NumberOfColumns(lines[k]), Width) << file.string() << ":" << k + 1;
      }
    }
  }
  EXPECT_GT(numberOfFiles, 300u);
}

TEST(Sources, HaveAtMost450Lines)
{
  for (const std::string folder : { "Filters", "Plugin", "Testing" })
  {
    for (const fs::path& file : FilesBelow(folder, { ".h", ".cxx" }))
    {
      EXPECT_TRUE(LinesOf(file).size() <= MostLines || IsInterface(file)) << file;
    }
  }
}

TEST(Sources, HaveFunctionsOfAtMost60Lines)
{
  std::size_t numberOfFunctions = 0;
  for (const std::string folder : { "Filters", "Plugin", "Testing" })
  {
    for (const fs::path& file : FilesBelow(folder, { ".h", ".cxx" }))
    {
      for (const auto& [line, size] : LinesOfFunctions(LinesOf(file)))
      {
        EXPECT_LE(size, MostLinesOfAFunction) << file.string() << ":" << line;
        ++numberOfFunctions;
      }
    }
  }
  EXPECT_GT(numberOfFunctions, 3000u);
}

} // namespace biting
