// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileLines.h"

#include <algorithm> // for min, replace_if
#include <charconv>  // for whole numbers
#include <cstdint>   // for whole numbers
#include <locale>    // for numbers with a point

namespace biting
{

namespace
{

constexpr const char* Blanks = " \t\r";
constexpr const char* BlanksAndComma = " \t\r,";

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(Blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(Blanks) + 1 - begin);
}

} // namespace

template <typename Whole>
bool ReadWhole(const std::string& word, Whole& value)
{
  const bool hasPlus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* const end = word.data() + word.size();
  const std::from_chars_result result =
    std::from_chars(word.data() + (hasPlus ? 1 : 0), end, value);
  return result.ec == std::errc() && result.ptr == end;
}
template bool ReadWhole(const std::string& word, int& value);
template bool ReadWhole(const std::string& word, std::int64_t& value);
template bool ReadWhole(const std::string& word, std::size_t& value);

MeshFileLines::MeshFileLines(std::istream& file, MeshFileDialect dialect)
  : File(file)
  , Dialect(dialect)
{
  this->Real.imbue(std::locale::classic());
}

bool MeshFileLines::Next()
{
  while (this->PassTitle())
  {
    if (this->Dialect == MeshFileDialect::SU2)
    {
      this->Text.erase(std::min(this->Text.find('%'), this->Text.size()));
    }
    if (this->Text.find_first_not_of(Blanks) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

bool MeshFileLines::PassTitle()
{
  this->Position = 0;
  this->IsAtEnd = !std::getline(this->File, this->Text);
  this->Number += this->IsAtEnd ? 0 : 1;
  return !this->IsAtEnd;
}

bool MeshFileLines::IsRead() const
{
  return this->Text.find_first_not_of(Blanks, this->Position) == std::string::npos;
}

bool MeshFileLines::PassNumber()
{
  double number = 0.0;
  return this->Take(number);
}

// An empty word, as between two commas, is none.
bool MeshFileLines::Take(std::string& word)
{
  const bool isFortran = this->Dialect == MeshFileDialect::Fortran;
  const std::size_t size = this->Text.size();
  const std::size_t begin = std::min(this->Text.find_first_not_of(Blanks, this->Position), size);
  this->Position =
    std::min(this->Text.find_first_of(isFortran ? BlanksAndComma : Blanks, begin), size);
  word.assign(this->Text, begin, this->Position - begin);
  const std::size_t next = this->Text.find_first_not_of(Blanks, this->Position);
  if (isFortran && next < size && this->Text[next] == ',')
  {
    this->Position = next + 1;
  }
  return !word.empty();
}

bool MeshFileLines::Take(double& value)
{
  if (!this->Take(this->Word))
  {
    return false;
  }
  if (this->Dialect == MeshFileDialect::Fortran)
  {
    std::replace_if(
      this->Word.begin(), this->Word.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  }
  this->Real.clear();
  this->Real.str(this->Word);
  return (this->Real >> value) && this->Real.peek() == std::istringstream::traits_type::eof();
}

bool MeshFileLines::Quoted(std::string& text) const
{
  const std::size_t begin = this->Text.find('"');
  const std::size_t end = this->Text.rfind('"');
  const bool isQuoted = begin != std::string::npos && begin < end;
  text = isQuoted ? this->Text.substr(begin + 1, end - begin - 1) : std::string();
  return isQuoted;
}

bool MeshFileLines::Assignment(std::string& key, std::string& value) const
{
  const std::size_t sign = this->Text.find('=');
  key = Trimmed(this->Text.substr(0, sign));
  value = sign == std::string::npos ? std::string() : Trimmed(this->Text.substr(sign + 1));
  return sign != std::string::npos;
}

std::string MeshFileLines::Expected(const std::string& what) const
{
  return this->IsAtEnd
    ? "The file ends where there should be " + what + "."
    : "Line " + std::to_string(this->Number) + " is not what it should be: " + what + ".";
}

} // namespace biting
