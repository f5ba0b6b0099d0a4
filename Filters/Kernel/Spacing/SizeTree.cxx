// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SizeTree.h"

#include "CellGradation.h"

#include <algorithm> // for find
#include <utility>   // for move

namespace biting
{

/// Makes leaves of cells.
template <std::size_t D>
class SizeTree<D>::Leaves
{
public:
  Leaves(SizeTree& whole, const SizeCells<D>& cells, const std::vector<std::uint8_t>& areAsGiven)
    : Whole(whole)
    , Work(cells)
    , AreAsGiven(areAsGiven)
    , PlaceNumbers(cells.Places.size(), NoId)
    , CornerNumbers(cells.Corners.size(), NoId)
  {
  }

  void Make()
  {
    this->Whole.Tree = Orthtree<D>(this->Work.Low, this->Work.Size);
    this->Whole.Lists.push_back(0);
    this->MakeBelow(0, this->Whole.Tree.Root());
    this->Whole.Tree.Finish();
  }

private:
  void MakeBelow(Id id, const typename Orthtree<D>::Cube& cube)
  {
    const typename SizeCells<D>::Cell& cell = this->Work.CellAt(id);
    if (cell.FirstChild > 0)
    {
      this->Whole.Tree.Split(cube);
      for (int k = 0; k < Orthtree<D>::Children; ++k)
      {
        this->MakeBelow(cell.FirstChild + k, this->Whole.Tree.Child(cube, k));
      }
      return;
    }
    ++this->Whole.LeafCount;
    if (this->AreAsGiven[static_cast<std::size_t>(id)] != 0)
    {
      this->Whole.Tree.SetLeaf(cube, 0);
      return;
    }
    std::vector<Id>& lists = this->Whole.Lists;
    const std::size_t begin = lists.size();
    this->Whole.Tree.SetLeaf(cube, static_cast<Id>(begin));
    lists.push_back(0);
    for (const Id corner : cell.Corners)
    {
      this->AddOrigin(this->Work.CornerAt(corner).Origin, begin + 1);
    }
    if (cell.Lowest != NoId)
    {
      this->AddOrigin(cell.Lowest, begin + 1);
    }
    lists[begin] = static_cast<Id>(lists.size() - begin - 1);
  }

  /// To the list that starts at `begin`.
  void AddOrigin(Id origin, std::size_t begin)
  {
    Id& number = origin < 0 ? this->CornerNumbers[static_cast<std::size_t>(~origin)]
                            : this->PlaceNumbers[static_cast<std::size_t>(origin)];
    if (number == NoId)
    {
      number = static_cast<Id>(this->Whole.Origins.size());
      this->Whole.Origins.push_back(this->Work.OriginAt(origin));
    }
    std::vector<Id>& lists = this->Whole.Lists;
    const auto first = lists.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::find(first, lists.end(), number) == lists.end())
    {
      lists.push_back(number);
    }
  }

  SizeTree& Whole;
  const SizeCells<D>& Work;
  const std::vector<std::uint8_t>& AreAsGiven;
  std::vector<Id> PlaceNumbers;
  std::vector<Id> CornerNumbers;
};

template <std::size_t D>
SizeTree<D>::SizeTree(const GivenAt<D>& givenAt, bool hasGaps, std::vector<LowPlace<D>> places,
  const Box<D>& bounds, double gradation, Pulse& pulse)
  : Gradation(gradation)
{
  SizeCells<D> cells(bounds.Low, bounds.High, std::move(places), pulse);
  const std::vector<std::uint8_t> areAsGiven =
    GradeCells(cells, givenAt, hasGaps, bounds, gradation, pulse);
  if (!pulse.HasStopped())
  {
    Leaves(*this, cells, areAsGiven).Make();
  }
}

template class SizeTree<2>;
template class SizeTree<3>;

} // namespace biting
