// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceCrossings.h"

#include "../../Base/Tasks.h"
#include "TriangleContact.h"

#include <algorithm> // for rotate, min, max
#include <utility>   // for move

namespace biting
{

namespace
{

// How many vertices two triangles share; where it is one, each is turned so that it comes first.
std::size_t JoinedCorners(const SurfaceMesh& mesh, std::size_t& slotA, std::size_t& slotB)
{
  const std::size_t firstA = slotA;
  const std::size_t firstB = slotB;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = CornerOf(&mesh.Corners[firstB], mesh.Corners[firstA + i]);
    if (mesh.Corners[firstB + j] == mesh.Corners[firstA + i])
    {
      ++shared;
      slotA = firstA + i;
      slotB = firstB + j;
    }
  }
  return shared;
}

Triangle3 FromCorner(const SurfaceMesh& mesh, std::size_t slot)
{
  return { mesh.At(slot), mesh.At(NextSlotOf(slot)), mesh.At(PreviousSlotOf(slot)) };
}

bool HaveContact(const SurfaceMesh& mesh, Id first, Id second, SurfaceContact& contact)
{
  std::size_t slotA = 3 * At(first);
  std::size_t slotB = 3 * At(second);
  const std::size_t shared = JoinedCorners(mesh, slotA, slotB);
  if (shared > 1)
  {
    return false;
  }
  const Triangle3 a = FromCorner(mesh, slotA);
  const Triangle3 b = FromCorner(mesh, slotB);
  if (!Meet(a, b, shared, contact.Place))
  {
    return false;
  }
  contact = { first, second, contact.Place, DepthOfMeeting(a, b) };
  return true;
}

// Adds the contacts of the items from `begin` to `end` with those of higher numbers.
void SearchAround(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree, std::size_t begin,
  std::size_t end, Pulse& pulse, std::vector<SurfaceContact>& contacts)
{
  const SurfaceItem* const first = tree.Items().data() + begin;
  const SurfaceItem* const last = tree.Items().data() + end;
  Box3 box;
  for (const SurfaceItem* item = first; item != last; ++item)
  {
    box.Add(item->Bounds.Low);
    box.Add(item->Bounds.High);
  }
  tree.AllOf(box,
    [&mesh, &pulse, &contacts, first, last](const SurfaceItem& other)
    {
      for (const SurfaceItem* item = first; item != last; ++item)
      {
        SurfaceContact contact;
        if (item->Triangle < other.Triangle && item->Bounds.Meets(other.Bounds) &&
          HaveContact(mesh, item->Triangle, other.Triangle, contact))
        {
          contacts.push_back(contact);
        }
      }
      return pulse.Beat(2);
    });
}

// The part of a vector from an edge that is across the edge.
Point3 Across(const Point3& vector, const Point3& edge)
{
  return vector - (Dot(vector, edge) / Dot(edge, edge)) * edge;
}

} // namespace

BoxTree<SurfaceItem, 3> MakeSurfaceTree(const SurfaceMesh& mesh, Pulse& pulse)
{
  std::vector<SurfaceItem> items(mesh.NumberOfTriangles());
  ForEachAtOnce(pulse, items.size(),
    [&mesh, &items](std::size_t t) {
      items[t] = { mesh.BoxOf(t), static_cast<Id>(t) };
    });
  return BoxTree<SurfaceItem, 3>(std::move(items), pulse);
}

std::vector<SurfaceContact> FindContacts(
  const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse)
{
  // Items that follow each other in the tree are near: one search serves several.
  constexpr std::size_t ItemsPerSearch = 8;
  constexpr std::size_t ItemsPerTask = ItemsPerSearch << 9;
  const std::vector<SurfaceItem>& items = tree.Items();
  std::vector<std::vector<SurfaceContact>> parts((items.size() + ItemsPerTask - 1) / ItemsPerTask);
  DoTasks(pulse, parts.size(),
    [&mesh, &tree, &items, &parts](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      const std::size_t end = std::min(items.size(), (k + 1) * ItemsPerTask);
      for (std::size_t i = k * ItemsPerTask; i < end && !own.HasStopped(); i += ItemsPerSearch)
      {
        SearchAround(mesh, tree, i, std::min(end, i + ItemsPerSearch), own, parts[k]);
      }
    });
  std::vector<SurfaceContact> contacts;
  for (const std::vector<SurfaceContact>& part : parts)
  {
    contacts.insert(contacts.end(), part.begin(), part.end());
  }
  return contacts;
}

std::vector<SurfaceContact> FindFolds(
  const SurfaceMesh& mesh, const SurfaceLinks& links, double rounding, Pulse& pulse)
{
  std::vector<SurfaceContact> folds;
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &links, rounding, &folds](std::size_t slot)
    {
      const Id across = links.Across[slot];
      if (across < static_cast<Id>(slot))
      {
        return;
      }
      const auto other = static_cast<std::size_t>(across);
      const Point3& begin = mesh.At(NextSlotOf(slot));
      const Point3 edge = mesh.At(PreviousSlotOf(slot)) - begin;
      const Point3 a = Across(mesh.At(slot) - begin, edge);
      const Point3 b = Across(mesh.At(other) - begin, edge);
      if (Dot(a, b) <= 0.0)
      {
        return;
      }
      const double low = std::min(Length(a), Length(b));
      const double high = std::max(Length(a), Length(b));
      if (low > rounding && Length(biting::Cross(a, b)) <= rounding * high)
      {
        folds.push_back({ static_cast<Id>(slot / 3), static_cast<Id>(other / 3),
          begin + 0.5 * edge + 0.25 * (a + b), low });
      }
    });
  return folds;
}

} // namespace biting
