// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingArrays_h
#define BitingArrays_h

#include "../../vtkBitingCompat.h" // for the ABI namespace

#include "vtkDoubleArray.h"  // for the return value
#include "vtkFieldData.h"    // for arrays
#include "vtkSmartPointer.h" // for the return value

#include <charconv> // for numbers
#include <cmath>    // for isnan
#include <string>   // for names
#include <vector>   // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// `array` itself where it holds doubles, otherwise a copy of it that does. Values are not rounded.
vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array);

/// The first `count` values of an array of one component.
std::vector<double> ReadDoubles(vtkDataArray* array, vtkIdType count);

/// The coordinates of all points of `data`; not copied where they are doubles of a point set.
vtkSmartPointer<vtkDoubleArray> CoordinatesOf(vtkDataSet* data);

/// The VTK type of the coordinates.
int TypeOfCoordinates(vtkDataSet* data);

/// Whether all three coordinates at `place` are finite.
bool AreFinite(const double* place);

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

/// Gives each piece of a dataset every named array of any piece. Arrays of one name get one type
/// and one number of components, so that they can be appended. Returns the names in the order of
/// the pieces. Arrays of pieces without elements count only where no other piece has the array.
///
/// The type: that of all arrays where they have one. Else a string where some are strings (numbers
/// by ShortText), double where some are real, long long of whole numbers. The number of components:
/// the largest.
///
/// A missing array or component is NaN where values are real, else 0 or an empty text. An array
/// with fewer values than the piece has elements is missing, as is a ghost array that is not of
/// unsigned char. Active ids are not added to a piece that has none.
std::vector<std::string> MakeArraysAlike(std::vector<PieceArrays>& pieces);

/// The same of the points and of the cells of datasets.
void MakeArraysAlike(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces);

} // namespace biting

#endif
