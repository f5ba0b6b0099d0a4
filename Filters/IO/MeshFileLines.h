// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFileLines_h
#define BitingMeshFileLines_h

#include <cstddef> // for counts
#include <istream> // for files
#include <sstream> // for numbers
#include <string>  // for words

namespace biting
{

/// What ends a word of a file, and a line.
enum class MeshFileDialect
{
  Gmsh,   ///< blanks
  SU2,    ///< blanks; the sign of percent begins a comment
  Fortran ///< blanks or one comma; exponents may have a D
};

/// Reads the whole of `word` as a whole number that the type holds; false where it is none.
template <typename Whole>
bool ReadWhole(const std::string& word, Whole& value);

/// Reads `count` things, until one cannot be read; returns whether all were.
template <typename Read>
bool Repeat(std::size_t count, Read read)
{
  bool isRead = true;
  for (std::size_t k = 0; isRead && k < count; ++k)
  {
    isRead = read();
  }
  return isRead;
}

/// The lines of a file that are not empty, each as words. A number is the whole of a word.
class MeshFileLines
{
public:
  MeshFileLines(std::istream& file, MeshFileDialect dialect);

  /// Goes to the next line; false at the end of the file.
  bool Next();

  /// Passes over a line, empty or not; false at the end of the file.
  bool PassTitle();

  /// Goes to the next line and reads values from its beginning.
  template <typename... Values>
  bool Read(Values&... values)
  {
    return this->Next() && this->More(values...);
  }

  /// Reads further values of this line.
  template <typename... Values>
  bool More(Values&... values)
  {
    return (this->Take(values) && ...);
  }

  /// Whether this line has no further word.
  bool IsRead() const;

  /// Whether the next word of this line is a number; takes it.
  bool PassNumber();

  /// What stands between the first and the last quotation mark of this line.
  bool Quoted(std::string& text) const;

  /// The words before and after the first equals sign; false where there is none.
  bool Assignment(std::string& key, std::string& value) const;

  std::size_t LineNumber() const { return this->Number; }

  /// That something else than this line was expected.
  std::string Expected(const std::string& what) const;

private:
  bool Take(std::string& word);
  bool Take(double& value);

  template <typename Whole>
  bool Take(Whole& value)
  {
    return this->Take(this->Word) && ReadWhole(this->Word, value);
  }

  std::istream& File;
  MeshFileDialect Dialect;
  std::string Text;
  std::string Word;
  std::size_t Position = 0; // in the text, of the next word
  std::istringstream Real;
  std::size_t Number = 0;
  bool IsAtEnd = false;
};

} // namespace biting

#endif
