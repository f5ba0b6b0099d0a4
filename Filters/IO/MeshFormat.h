// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshFormat_h
#define BitingMeshFormat_h

#include "MeshFile.h"

#include <istream> // for files
#include <ostream> // for files
#include <string>  // for names
#include <vector>  // for tags

namespace biting
{

/// A format of files, by the end of their names.
struct MeshFormat
{
  const char* End;
  bool IsPlanar;      ///< x and y only of triangles: WriteMesh expects IsBoundaryClosed
  bool HasTetrahedra; ///< in space
  bool HasDepths;     ///< of points
  bool HasOpenTags;   ///< of the boundary, other tags are land
  bool HasRegions;
  bool HasPlainNames; ///< of tags: without blanks and other signs that end names in SU2
  ReadingResult (*Read)(std::istream& file, MeshFile& mesh); ///< null: not read
  void (*Write)(const MeshFile& mesh, const std::vector<bool>& areOpen, std::ostream& file);
};

/// Null where the name has another end.
const MeshFormat* FormatOf(const std::string& name);

/// The sentence that names the ends of files that are read, or of all: those are written.
std::string SentenceOfEnds(bool areRead);

} // namespace biting

#endif
