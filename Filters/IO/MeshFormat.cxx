// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFormat.h"

#include <algorithm> // for find_if
#include <iterator>  // for begin, end

namespace biting
{

namespace
{

using Flags = std::vector<bool>;

const MeshFormat Formats[] = {
  { ".msh", false, true, false, false, true, false, ReadGmsh,
    [](const MeshFile& mesh, const Flags&, std::ostream& file) { WriteGmsh(mesh, file); } },
  { ".su2", true, true, false, false, false, true, ReadSU2,
    [](const MeshFile& mesh, const Flags&, std::ostream& file) { WriteSU2(mesh, file); } },
  { ".14", true, false, true, true, false, false, ReadADCIRC, WriteADCIRC },
  { ".gr3", true, false, true, true, false, false, ReadADCIRC, WriteADCIRC },
  { ".2dm", true, false, true, false, true, false, ReadSMS,
    [](const MeshFile& mesh, const Flags&, std::ostream& file) { WriteSMS(mesh, file); } },
  { ".nc", true, false, true, false, true, false, nullptr,
    [](const MeshFile& mesh, const Flags&, std::ostream& file) { WriteUGRID(mesh, file); } },
};

bool EndsWith(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

} // namespace

const MeshFormat* FormatOf(const std::string& name)
{
  const MeshFormat* const format = std::find_if(std::begin(Formats), std::end(Formats),
    [&name](const MeshFormat& one) { return EndsWith(name, one.End); });
  return format == std::end(Formats) ? nullptr : format;
}

std::string SentenceOfEnds(bool areRead)
{
  std::string ends;
  std::string last;
  for (const MeshFormat& format : Formats)
  {
    if (format.Read || !areRead)
    {
      ends += (ends.empty() ? "" : ", ") + last;
      last = format.End;
    }
  }
  return "The name of the file must end with " + ends + " or " + last + ".";
}

} // namespace biting
