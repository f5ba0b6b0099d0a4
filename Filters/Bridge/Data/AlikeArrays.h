// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingAlikeArrays_h
#define BitingAlikeArrays_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkFieldData.h"    // for arrays
#include "vtkSmartPointer.h" // for datasets

#include <charconv> // for numbers
#include <cmath>    // for isnan
#include <string>   // for names
#include <vector>   // for pieces

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// A real number with the fewest digits that give its value.
template <typename Real>
std::string ShortText(Real value)
{
  constexpr std::size_t MostCharacters = 32;
  char text[MostCharacters];
  const auto end = std::to_chars(text, text + MostCharacters, value, std::chars_format::general);
  return std::isnan(value) ? "nan" : std::string(text, end.ptr);
}

/// The arrays of the points or of the cells of a piece, and the number of these.
struct PieceArrays
{
  vtkSmartPointer<vtkFieldData> Arrays;
  vtkIdType Size = 0;
};

/// Gives all pieces of a dataset all named arrays, those of one name with one type and one number
/// of components, so that they can be put one after the other. Returns their names in the order of
/// the pieces. Arrays of pieces without elements count only where others have none.
///
/// Arrays of one type keep it. Of several types: whole numbers are of 64 bits with a sign; where some
/// numbers are real, all are double; where some values are texts, all are, numbers with the fewest
/// digits that give their value. The number of components is the largest.
///
/// What a piece lacks, arrays or components, is NaN where values are real, else 0, or empty. An
/// array that has fewer values than its piece has elements is lacked, as is a ghost array that is
/// not of unsigned char. Active ids that a piece lacks are left out of it.
std::vector<std::string> MakeArraysAlike(std::vector<PieceArrays>& pieces);

/// The same of the points and of the cells of datasets.
void MakeArraysAlike(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces);

} // namespace biting

#endif
