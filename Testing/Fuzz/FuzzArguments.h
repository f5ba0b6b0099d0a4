// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFuzzArguments_h
#define BitingFuzzArguments_h

#include <cstdint> // for seeds
#include <cstdlib> // for numbers
#include <map>     // for values
#include <string>  // for arguments
#include <utility> // for move

namespace biting
{

/// The arguments of a program: names, each with its value. Those with a default may be given.
class FuzzArguments
{
public:
  FuzzArguments(int count, char** texts, std::map<std::string, std::string> defaults)
    : Values(std::move(defaults))
    , AreValid(count % 2 == 1)
  {
    for (int k = 1; k + 1 < count; k += 2)
    {
      this->AreValid = this->AreValid && this->Values.count(texts[k]) > 0;
      this->Values[texts[k]] = texts[k + 1];
    }
  }

  bool Valid() const { return this->AreValid; }
  const std::string& Text(const char* name) const { return this->Values.at(name); }
  double Number(const char* name) const { return std::strtod(this->Text(name).c_str(), nullptr); }
  std::uint64_t Count(const char* name) const
  {
    return std::strtoull(this->Text(name).c_str(), nullptr, 10);
  }

private:
  std::map<std::string, std::string> Values;
  bool AreValid;
};

} // namespace biting

#endif
