// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CorpusIndex_h
#define CorpusIndex_h

#include <algorithm>  // for sort
#include <cmath>      // for NaN
#include <cstdlib>    // for getenv
#include <filesystem> // for folders
#include <fstream>    // for the index
#include <sstream>    // for the index
#include <string>     // for names
#include <vector>     // for lists

/// Which inputs there are, and what is expected of them.
namespace testing_filters
{

/// One input of the shared corpus, as its index describes it.
struct CorpusEntry
{
  std::string File;
  std::string Class; ///< V valid, W valid with touches, R to repair or refuse, E to refuse
  double Area = 0.0; ///< not a number where none is listed
  double Spacing = 0.0;
};

/// The text after `"key": ` in one record of the index, up to the end of the line; without quotes.
inline std::string FieldOf(const std::string& record, const std::string& key)
{
  const std::string mark = "\"" + key + "\": ";
  const std::size_t start = record.find(mark);
  if (start == std::string::npos)
  {
    return "";
  }
  const std::size_t value = start + mark.size();
  std::string text = record.substr(value, record.find('\n', value) - value);
  text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
  return text.substr(0, text.find_last_not_of(",\r ") + 1);
}

inline double NumberOf(const std::string& record, const std::string& key)
{
  const std::string text = FieldOf(record, key);
  return text.empty() || text == "null" ? std::nan("") : std::stod(text);
}

/// The folder of the shared corpus, empty where there is none.
inline std::string SharedInputs()
{
  const char* given = std::getenv("BITING_SHARED_INPUTS");
  const std::string folder =
    given && *given ? given : std::string(BITING_SOURCE_DIR) + "/../shared/inputs";
  return std::filesystem::exists(folder + "/index.json") ? folder : "";
}

/// The entries of the shared corpus whose class is one of `classes` and whose file is there.
inline std::vector<CorpusEntry> SharedEntries(const std::vector<std::string>& classes)
{
  std::vector<CorpusEntry> entries;
  const std::string folder = SharedInputs();
  std::ifstream file(folder + "/index.json");
  std::stringstream stream;
  stream << file.rdbuf();
  const std::string text = stream.str();
  std::size_t start = folder.empty() ? std::string::npos : text.find("\"file\": ");
  while (start != std::string::npos)
  {
    const std::size_t next = text.find("\"file\": ", start + 1);
    const std::string record = text.substr(start, next - start);
    const CorpusEntry entry{ FieldOf(record, "file"), FieldOf(record, "cls"),
      NumberOf(record, "expected_area"), NumberOf(record, "h") };
    const bool isWanted = std::find(classes.begin(), classes.end(), entry.Class) != classes.end();
    if (isWanted && std::filesystem::exists(folder + "/" + entry.File))
    {
      entries.push_back(entry);
    }
    start = next;
  }
  return entries;
}

/// The names of all .vtk files of a folder, sorted.
inline std::vector<std::string> DataFiles(const std::string& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".vtk")
    {
      files.push_back(entry.path().filename().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace testing_filters

#endif
