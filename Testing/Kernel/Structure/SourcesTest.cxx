// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What holds for the sources as texts: the arrows between rooms, the width of lines, the sizes of
// rooms, functions and classes.

#include <gtest/gtest.h>

#include <algorithm>  // for sort, count_if
#include <cctype>     // for letters
#include <cstddef>    // for columns
#include <filesystem> // for the tree
#include <fstream>    // for the files
#include <map>        // for the rooms
#include <regex>      // for declarations
#include <set>        // for their neighbors
#include <string>     // for lines
#include <vector>     // for lists

namespace biting
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t Width = 100;
constexpr std::size_t MostLinesOfAFunction = 60;
constexpr std::size_t MostMethods = 20;

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

/// The folder of a file, seen from Filters: "Kernel/Delaunay", "." for the filters. The folders of
/// the bridge are one room.
std::string RoomOf(const fs::path& file)
{
  const fs::path folder = file.parent_path().lexically_relative(Root / "Filters");
  return *folder.begin() == "Bridge" ? "Bridge" : folder.generic_string();
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
  { "Kernel/Space", {} },
  { "Kernel/Space/Delaunay", { "Base", "Predicates", "Delaunay" } },
  { "Kernel/Quality", { "Base", "Predicates" } },
  { "Kernel/Space/Quality", { "Base" } },
  { "Kernel/Space/Surface", { "Base", "Predicates" } },
  { "Kernel/Space/Union", { "Base", "Predicates", "Delaunay", "Space/Surface" } },
  { "Kernel/Space/Features", { "Base", "Predicates", "Space/Surface" } },
  { "Kernel/Space/Biting", { "Base", "Space/Surface", "Space/Features" } },
  { "Kernel/Space/Boundary",
    { "Base", "Predicates", "Delaunay", "Space/Delaunay", "Space/Surface", "Space/Features",
      "Space/Biting" } },
  { "Kernel/Space/Relaxation", { "Base", "Space/Surface", "Space/Features" } },
  { "Kernel/Space/Interior", { "Base", "Predicates", "Spacing" } },
  { "Kernel/Space/Finishing",
    { "Base", "Predicates", "Space/Surface", "Space/Features", "Space/Delaunay",
      "Space/Relaxation" } },
  { "Kernel/Space/Meshing",
    { "Base", "Predicates", "Spacing", "Space/Delaunay", "Space/Surface", "Space/Features",
      "Space/Biting", "Space/Boundary", "Space/Interior", "Space/Relaxation", "Space/Finishing" } },
  { "Kernel/Mesh", { "Base", "Domain", "Simplification", "Spacing", "Biting", "Quality" } },
  { "Kernel/Stages",
    { "Base", "Predicates", "Domain", "Simplification", "Spacing", "Biting", "Delaunay",
      "Relaxation", "Quality", "Mesh" } },
  { "Kernel/Blocks",
    { "Base", "Predicates", "Domain", "Spacing", "Biting", "Delaunay", "Relaxation", "Stages" } },
  { "Kernel/Pieces",
    { "Base", "Predicates", "Domain", "Simplification", "Spacing", "Biting", "Delaunay", "Quality",
      "Mesh", "Stages", "Blocks" } },
  { "Kernel/Remeshing",
    { "Base", "Predicates", "Domain", "Simplification", "Spacing", "Biting", "Delaunay", "Quality",
      "Mesh" } },
};

/// How large a room may be. One that needs more says what it gives up first.
struct Budget
{
  std::size_t Lines = 0; ///< of headers and sources
  std::size_t Types = 0; ///< classes and structures
};

const std::map<std::string, Budget> Budgets = {
  { ".", { 5860, 11 } },
  { "Bridge", { 13400, 73 } },
  { "IO", { 2890, 16 } },
  { "Kernel", { 900, 3 } },
  { "Kernel/Base", { 2060, 28 } },
  { "Kernel/Biting", { 5520, 49 } },
  { "Kernel/Blocks", { 5630, 60 } },
  { "Kernel/Delaunay", { 2390, 27 } },
  { "Kernel/Domain", { 6600, 58 } },
  { "Kernel/Hessian", { 460, 4 } },
  { "Kernel/Mesh", { 180, 3 } },
  { "Kernel/Pieces", { 1520, 14 } },
  { "Kernel/Predicates", { 1380, 9 } },
  { "Kernel/Quality", { 1430, 15 } },
  { "Kernel/Relaxation", { 4590, 32 } },
  { "Kernel/Remeshing", { 4910, 40 } },
  { "Kernel/Simplification", { 1750, 19 } },
  { "Kernel/Spacing", { 3660, 43 } },
  { "Kernel/Stages", { 3430, 25 } },
  { "Kernel/Space/Delaunay", { 1450, 10 } },
  { "Kernel/Space/Features", { 1720, 14 } },
  { "Kernel/Space/Biting", { 1000, 11 } },
  { "Kernel/Space/Boundary", { 1670, 16 } },
  { "Kernel/Space/Relaxation", { 950, 7 } },
  { "Kernel/Space/Interior", { 1250, 17 } },
  { "Kernel/Space/Finishing", { 2750, 16 } },
  { "Kernel/Space/Meshing", { 2165, 14 } },
  { "Kernel/Space/Quality", { 400, 2 } },
  { "Kernel/Space/Surface", { 3400, 20 } },
  { "Kernel/Space/Union", { 1170, 5 } },
};

bool IsAllowed(const std::string& from, const std::string& to)
{
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

/// The text without comments, preprocessor lines, and what stands in quotes.
std::string CodeOf(const std::vector<std::string>& lines)
{
  std::string code;
  for (const std::string& line : lines)
  {
    const std::size_t begin = line.find_first_not_of(' ');
    const bool isCode = begin != std::string::npos && line[begin] != '#';
    char quote = ' ';
    for (std::size_t k = isCode ? begin : line.size(); k < line.size(); ++k)
    {
      const bool isDigitMark = k > 0 && line[k] == '\'' && std::isalnum(line[k - 1]) != 0;
      if (quote != ' ')
      {
        quote = line[k] == quote ? ' ' : quote;
        k += line[k] == '\\' ? 1 : 0;
      }
      else if (line.compare(k, 2, "//") == 0)
      {
        break;
      }
      else if (line[k] == '"' || (line[k] == '\'' && !isDigitMark))
      {
        quote = line[k];
      }
      else
      {
        code += line[k];
      }
    }
    code += ' ';
  }
  return code;
}

/// Without template arguments, which may have brackets of their own, and words for access.
std::string Plain(const std::string& head)
{
  static const std::regex arguments("->|<[^<>]*>|\\b(public|private|protected) *:");
  std::string plain = head;
  for (std::string before; before != plain && plain.find_first_of("<>:") != std::string::npos;)
  {
    before = plain;
    plain = std::regex_replace(plain, arguments, " ");
  }
  const std::size_t begin = plain.find_first_not_of(' ');
  return begin == std::string::npos ? std::string() : plain.substr(begin);
}

/// Whether a member that is declared so is a method: constructors and accessors are, too; not what
/// is defaulted or deleted.
bool IsMethod(const std::string& head)
{
  static const std::regex noMember(
    "^(using|friend|static_assert|typedef)\\b|= *(default|delete) *$");
  const std::size_t bracket = head.find('(');
  return !std::regex_search(head, noMember) &&
    (head.find("operator") != std::string::npos || bracket < head.find('='));
}

/// The name of the class whose definition begins so, empty where none does.
std::string ClassOf(const std::string& head)
{
  static const std::regex isClass(
    "^(template *)?(class|struct|union) ([\\w ]*?)([\\w:]+) *(final *)?(:[^:].*)?$");
  std::smatch match;
  const bool mayBe = head.find("class ") != std::string::npos ||
    head.find("struct ") != std::string::npos || head.find("union ") != std::string::npos;
  return mayBe && std::regex_match(head, match, isClass) ? match[4].str() : std::string();
}

/// How many methods each class of the text has, also those with none.
std::map<std::string, std::size_t> MethodsOfClasses(const std::string& code)
{
  std::map<std::string, std::size_t> methods;
  std::vector<std::string> scopes; // the class whose members stand there, or nothing
  std::string head;
  bool isInitializer = false; // of a constructor: its head was counted
  for (std::size_t k = 0; k < code.size(); ++k)
  {
    if (code[k] != '{' && code[k] != '}' && code[k] != ';')
    {
      head += code[k];
      continue;
    }
    const bool isMember = code[k] != '}' && !scopes.empty() && !scopes.back().empty();
    const std::string plain = isMember || code[k] == '{' ? Plain(head) : std::string();
    const std::string opened = code[k] == '{' ? ClassOf(plain) : std::string();
    methods[opened] += 0;
    if (isMember && opened.empty())
    {
      methods[scopes.back()] += !isInitializer && IsMethod(plain) ? 1 : 0;
    }
    head.clear();
    isInitializer = false;
    if (code[k] == '{')
    {
      scopes.push_back(opened);
    }
    else if (code[k] == '}' && !scopes.empty())
    {
      scopes.pop_back();
      const std::size_t next = code.find_first_not_of(' ', k + 1);
      isInitializer = next != std::string::npos && (code[next] == ',' || code[next] == '{');
    }
  }
  methods.erase("");
  return methods;
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
  for (const fs::path& file : FilesBelow("Filters/Kernel", { ".h", ".cxx" }))
  {
    const std::string room = RoomOf(file);
    EXPECT_TRUE(room == "Kernel" || Arrows.count(room) == 1u) << file;
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

TEST(Sources, KeepTheBudgetsOfTheirRooms)
{
  std::map<std::string, Budget> rooms;
  for (const fs::path& file : FilesBelow("Filters", { ".h", ".cxx" }))
  {
    const std::vector<std::string> lines = LinesOf(file);
    Budget& room = rooms[RoomOf(file)];
    room.Lines += lines.size();
    room.Types += MethodsOfClasses(CodeOf(lines)).size();
  }
  EXPECT_EQ(rooms.size(), Budgets.size());
  for (const auto& [name, used] : rooms)
  {
    const auto budget = Budgets.find(name);
    ASSERT_NE(budget, Budgets.end()) << name << " has no budget";
    EXPECT_LE(used.Lines, budget->second.Lines) << "lines of " << name;
    EXPECT_LE(used.Types, budget->second.Types) << "types of " << name;
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

TEST(Methods, AreCounted)
{
  const std::string code = "namespace a { class A final : public B { public: A(int x) : X{ x }, "
                           "Y{ 1 } { } A() = default; template <typename T> T Get(T t) const; "
                           "bool operator<(const A& a) const { if (a()) { } return b(c); } "
                           "using F = int(int); std::function<int(int)> G; int H = f(1); "
                           "struct D { int X{ 3 }; void M(); }; enum class E { One, Two }; "
                           "~A(); private: int X{ 0 }; friend void f(); }; void A::Out() { } }";
  const std::map<std::string, std::size_t> expected{ { "A", 4 }, { "D", 1 } };
  EXPECT_EQ(MethodsOfClasses(code), expected);
}

// Those of VTK have what its macros ask for: two methods a parameter, and more.
TEST(Sources, HaveClassesOfAtMost20Methods)
{
  std::size_t numberOfClasses = 0;
  for (const fs::path& file : FilesBelow("Filters", { ".h", ".cxx" }))
  {
    for (const auto& [name, count] : MethodsOfClasses(CodeOf(LinesOf(file))))
    {
      EXPECT_TRUE(count <= MostMethods || IsInterface(file))
        << file.string() << ": " << name << " has " << count;
      ++numberOfClasses;
    }
  }
  EXPECT_GT(numberOfClasses, 150u);
}

} // namespace biting
