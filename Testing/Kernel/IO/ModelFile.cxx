// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ModelFile.h"

#include <numeric>
#include <sstream>

namespace biting
{

namespace
{

std::int64_t WholeOf(const std::string& text)
{
  return std::strtoll(text.c_str(), nullptr, 10);
}

// The vertex that a word names; -1: none.
std::int64_t VertexOf(const MeshModel& model, const std::string& text)
{
  const auto found = std::find(model.Numbers.begin(), model.Numbers.end(), WholeOf(text));
  return !IsWholeText(text) || found == model.Numbers.end() ? -1 : found - model.Numbers.begin();
}

template <typename Cells>
FileVerdict VerdictOf(const Cells& cells, std::size_t changed)
{
  auto own = cells[changed];
  std::sort(own.begin(), own.end());
  if (std::adjacent_find(own.begin(), own.end()) != own.end())
  {
    return FileVerdict::Error;
  }
  const auto isRepeated = [&own](auto cell)
  {
    std::sort(cell.begin(), cell.end());
    return cell == own;
  };
  return std::count_if(cells.begin(), cells.end(), isRepeated) > 1 ? FileVerdict::Unknown
                                                                   : FileVerdict::Mesh;
}

// By dimension.
constexpr std::size_t TypesInGmsh[] = { 15, 1, 2, 4 };
constexpr std::size_t TypesInSU2[] = { 1, 3, 5, 10 };

} // namespace

void ModelFiles::MakeFan(std::int64_t firstNumber)
{
  this->Model = MeshModel();
  const auto size = static_cast<std::int64_t>(3 + this->Below(5));
  const std::int64_t apex = size + 1;
  this->Model.Numbers.resize(static_cast<std::size_t>(size) + this->Dimension - 1);
  std::iota(this->Model.Numbers.begin(), this->Model.Numbers.end(), firstNumber);
  this->Model.Points.resize(this->Model.Numbers.size());
  this->Model.Depths.resize(this->Model.Numbers.size());
  for (std::int64_t k = 0; k < size; ++k)
  {
    const std::int64_t next = (k + 1) % size;
    this->Model.Cells.push_back({ 0, 1 + k, 1 + next });
    this->Model.Sides.push_back({ 1 + k, 1 + next });
    if (this->Dimension == 3)
    {
      this->Model.Cells.back().push_back(apex);
      this->Model.Sides.back().push_back(apex);
    }
    this->Model.Regions.push_back(2 * k < size - 1 ? 3 : 4);
    this->Model.Tags.push_back(2 * k < size - 1 ? 1 : 2);
  }
}

std::string ModelFiles::Real(bool isFortran)
{
  const char* forms[] = { "0.5", "-1.25", "17", "3e2", "+.125", "2.", "1.5e-3", "-0.0E+01" };
  std::string text = forms[this->Below(std::size(forms))];
  if (isFortran && this->Below(2) == 0)
  {
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'e' || c == 'E'; }, 'D');
  }
  return text;
}

FileWord ModelFiles::Any(std::size_t number, FileVerdict verdict)
{
  return { std::to_string(number), [verdict](MeshModel&, const std::string& text) {
            return IsWholeText(text) ? verdict : FileVerdict::Error;
          } };
}

std::vector<FileWord> ModelFiles::AllFree(const std::string& text)
{
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;)
  {
    words.push_back({ word, [](MeshModel&, const std::string&) { return FileVerdict::Mesh; } });
  }
  return words;
}

FileWord ModelFiles::Place(std::size_t point, std::size_t axis, bool isFortran)
{
  FileWord word{ this->Real(isFortran),
    [point, axis, isFortran](MeshModel& model, std::string text)
    {
      const auto isD = [isFortran](char c) { return isFortran && (c == 'D' || c == 'd'); };
      std::replace_if(text.begin(), text.end(), isD, 'e');
      (axis < 3 ? model.Points[point][axis] : model.Depths[point]) =
        std::strtod(text.c_str(), nullptr);
      return IsRealText(text) ? FileVerdict::Mesh : FileVerdict::Error;
    } };
  word.Change(this->Model, word.Text);
  return word;
}

FileWord ModelFiles::Number(std::size_t point) const
{
  return { std::to_string(this->Model.Numbers[point]), nullptr };
}

FileWord ModelFiles::Corner(std::size_t cell, std::size_t corner) const
{
  const auto vertex = static_cast<std::size_t>(this->Model.Cells[cell][corner]);
  return { this->Number(vertex).Text,
    [cell, corner](MeshModel& model, const std::string& text)
    {
      const std::int64_t other = VertexOf(model, text);
      model.Cells[cell][corner] = other;
      return other < 0 ? FileVerdict::Error : VerdictOf(model.Cells, cell);
    } };
}

void ModelFiles::AddCorners(std::size_t cell, Words& words) const
{
  for (std::size_t corner = 0; corner <= this->Dimension; ++corner)
  {
    words.push_back(this->Corner(cell, corner));
  }
}

void ModelFiles::AddEnds(std::size_t side, Words& words) const
{
  for (std::size_t end = 0; end < this->Dimension; ++end)
  {
    words.push_back(this->End(this->Model.Sides[side][end], { { side, end } }));
  }
}

FileWord ModelFiles::End(std::int64_t vertex, std::vector<std::array<std::size_t, 2>> places) const
{
  return { this->Number(static_cast<std::size_t>(vertex)).Text,
    [places](MeshModel& model, const std::string& text)
    {
      const std::int64_t other = VertexOf(model, text);
      FileVerdict verdict = other < 0 ? FileVerdict::Error : FileVerdict::Mesh;
      for (const auto& place : places)
      {
        model.Sides[place[0]][place[1]] = other;
      }
      for (const auto& place : places)
      {
        const FileVerdict own = VerdictOf(model.Sides, place[0]);
        verdict = verdict == FileVerdict::Mesh || own == FileVerdict::Error ? own : verdict;
      }
      return verdict;
    } };
}

FileWord ModelFiles::Group(
  std::vector<std::int64_t> MeshModel::*groups, std::size_t first, std::size_t end) const
{
  return { std::to_string((this->Model.*groups)[first]),
    [groups, first, end](MeshModel& model, const std::string& text)
    {
      std::fill((model.*groups).begin() + static_cast<std::ptrdiff_t>(first),
        (model.*groups).begin() + static_cast<std::ptrdiff_t>(end), WholeOf(text));
      return IsWholeText(text) ? FileVerdict::Mesh : FileVerdict::Error;
    } };
}

ModelFile ModelFiles::Gmsh2()
{
  this->MakeFan(1);
  std::shuffle(this->Model.Numbers.begin(), this->Model.Numbers.end(), this->Random);
  ModelFile file{ "Gmsh 2.2", ReadGmsh, {}, {}, 0, 0, FileVerdict::Error };
  auto& lines = file.Lines;
  const std::size_t size = this->Model.Points.size();
  const std::size_t cells = this->Model.Cells.size();
  lines = { AllFixed("$MeshFormat"), { { "2.2", nullptr }, Fixed(0), AllFree("8")[0] },
    AllFixed("$EndMeshFormat"), AllFixed("$Nodes"), { Fixed(size) } };
  for (std::size_t k = 0; k < size; ++k)
  {
    lines.push_back({ this->Number(k), this->Place(k, 0), this->Place(k, 1), this->Place(k, 2) });
  }
  lines.insert(lines.end(), { AllFixed("$EndNodes"), AllFixed("$Elements"), { Fixed(2 * cells) } });
  for (std::size_t k = 0; k < cells; ++k)
  {
    lines.push_back({ Any(k + 1), Any(TypesInGmsh[this->Dimension - 1], FileVerdict::Said),
      Fixed(2), this->Group(&MeshModel::Tags, k, k + 1), Any(9) });
    this->AddEnds(k, lines.back());
    lines.push_back({ Any(k + 1), Any(TypesInGmsh[this->Dimension], FileVerdict::Said), Fixed(2),
      this->Group(&MeshModel::Regions, k, k + 1), Any(9) });
    this->AddCorners(k, lines.back());
  }
  lines.push_back(AllFixed("$EndElements"));
  this->Model.Depths.clear();
  file.Model = this->Model;
  return file;
}

ModelFile ModelFiles::Gmsh4()
{
  this->MakeFan(1);
  std::shuffle(this->Model.Numbers.begin(), this->Model.Numbers.end(), this->Random);
  ModelFile file{ "Gmsh 4.1", ReadGmsh, {}, {}, 0, 0, FileVerdict::Error };
  auto& lines = file.Lines;
  const std::size_t size = this->Model.Points.size();
  const std::size_t cells = this->Model.Cells.size();
  const std::size_t ends[] = { 0, cells / 2, cells };
  lines = { AllFixed("$MeshFormat"), { { "4.1", nullptr }, Fixed(0), AllFree("8")[0] },
    AllFixed("$EndMeshFormat"), AllFixed("$Entities"),
    this->Dimension == 2 ? Words{ Fixed(0), Fixed(2), Fixed(2), Fixed(0) }
                         : Words{ Fixed(0), Fixed(0), Fixed(2), Fixed(2) } };
  for (const std::size_t dimension : { this->Dimension - 1, this->Dimension })
  {
    for (std::size_t part = 0; part < 2; ++part)
    {
      const Words words{ Fixed(part + 5), Any(0), Any(0), Any(0), Any(1), Any(1), Any(0),
        Any(1, FileVerdict::Unknown),
        this->Group(dimension < this->Dimension ? &MeshModel::Tags : &MeshModel::Regions,
          ends[part], ends[part + 1]),
        Fixed(0) };
      lines.push_back(words);
    }
  }
  lines.insert(lines.end(),
    { AllFixed("$EndEntities"), AllFixed("$Nodes"),
      { Fixed(1), Fixed(size), AllFree("1")[0], AllFree("9")[0] },
      { Any(2), Any(5), Any(0), Fixed(size) } });
  for (std::size_t k = 0; k < size; ++k)
  {
    lines.push_back({ this->Number(k) });
  }
  for (std::size_t k = 0; k < size; ++k)
  {
    lines.push_back({ this->Place(k, 0), this->Place(k, 1), this->Place(k, 2) });
  }
  lines.insert(lines.end(),
    { AllFixed("$EndNodes"), AllFixed("$Elements"),
      { Fixed(4), Fixed(2 * cells), AllFree("1")[0], AllFree("99")[0] } });
  for (const std::size_t dimension : { this->Dimension - 1, this->Dimension })
  {
    for (std::size_t part = 0; part < 2; ++part)
    {
      lines.push_back({ Fixed(dimension), Any(part + 5, FileVerdict::Unknown),
        Any(TypesInGmsh[dimension], FileVerdict::Said), Fixed(ends[part + 1] - ends[part]) });
      for (std::size_t k = ends[part]; k < ends[part + 1]; ++k)
      {
        lines.push_back({ Any(k) });
        dimension < this->Dimension ? this->AddEnds(k, lines.back())
                                    : this->AddCorners(k, lines.back());
      }
    }
  }
  lines.push_back(AllFixed("$EndElements"));
  this->Model.Depths.clear();
  file.Model = this->Model;
  return file;
}

ModelFile ModelFiles::SU2()
{
  this->MakeFan(0);
  ModelFile file{ "SU2", ReadSU2, {}, {}, 0, 0, FileVerdict::Error };
  auto& lines = file.Lines;
  const std::size_t size = this->Model.Points.size();
  const std::size_t cells = this->Model.Cells.size();
  const bool haveNumbers = this->Below(2) == 0;
  const auto addNumber = [haveNumbers, &lines](std::size_t number)
  {
    if (haveNumbers)
    {
      lines.back().push_back(Any(number));
    }
  };
  lines = { { { "NDIME=", nullptr }, Fixed(this->Dimension) },
    { { "NELEM=", nullptr }, Fixed(cells) } };
  for (std::size_t k = 0; k < cells; ++k)
  {
    lines.push_back({ Any(TypesInSU2[this->Dimension], FileVerdict::Unknown) });
    this->AddCorners(k, lines.back());
    addNumber(k);
  }
  lines.push_back({ { "NPOIN=", nullptr }, Fixed(size) });
  for (std::size_t k = 0; k < size; ++k)
  {
    lines.push_back({ this->Place(k, 0), this->Place(k, 1) });
    if (this->Dimension == 3)
    {
      lines.back().push_back(this->Place(k, 2));
    }
    addNumber(k);
  }
  file.FirstOptional = lines.size();
  lines.push_back({ { "NMARK=", nullptr }, Fixed(2) });
  const std::size_t ends[] = { 0, cells / 2, cells };
  for (std::size_t part = 0; part < 2; ++part)
  {
    lines.push_back({ { "MARKER_TAG=", nullptr }, AllFree(part == 0 ? "inlet" : "wall")[0] });
    lines.push_back({ { "MARKER_ELEMS=", nullptr }, Fixed(ends[part + 1] - ends[part]) });
    for (std::size_t k = ends[part]; k < ends[part + 1]; ++k)
    {
      lines.push_back({ Any(TypesInSU2[this->Dimension - 1], FileVerdict::Unknown) });
      this->AddEnds(k, lines.back());
      addNumber(k);
    }
  }
  file.Rest = haveNumbers ? 1 : 0;
  std::fill(this->Model.Regions.begin(), this->Model.Regions.end(), 0);
  this->Model.Depths.clear();
  file.Model = this->Model;
  return file;
}

// The first part of the ring is open, the rest land.
ModelFile ModelFiles::ADCIRC()
{
  this->MakeFan(1);
  std::shuffle(this->Model.Numbers.begin(), this->Model.Numbers.end(), this->Random);
  ModelFile file{ "ADCIRC", ReadADCIRC, {}, {}, 0, 0, FileVerdict::Said };
  auto& lines = file.Lines;
  const std::size_t size = this->Model.Points.size();
  const std::size_t cells = this->Model.Cells.size();
  const FileVerdict said = FileVerdict::Said;
  lines = { AllFree("a grid"), { Any(cells, said), Any(size, said) } };
  for (std::size_t k = 0; k < size; ++k)
  {
    lines.push_back({ this->Number(k), this->Place(k, 0, true), this->Place(k, 1, true),
      this->Place(k, 3, true) });
  }
  for (std::size_t k = 0; k < cells; ++k)
  {
    lines.push_back(
      { Any(k + 1), Fixed(3), this->Corner(k, 0), this->Corner(k, 1), this->Corner(k, 2) });
  }
  file.FirstOptional = lines.size();
  const std::size_t ends[] = { 0, cells / 2, cells };
  for (std::size_t part = 0; part < 2; ++part)
  {
    const std::size_t nodes = ends[part + 1] - ends[part] + 1;
    lines.push_back({ Any(1, said) });
    lines.push_back({ Any(nodes, said) });
    const Words text = AllFree("= number of something");
    lines.back().insert(lines.back().end(), text.begin(), text.end());
    lines.push_back({ Any(nodes, said) });
    if (part == 1)
    {
      lines.back().push_back(Any(0, FileVerdict::Unknown));
    }
    for (std::size_t k = ends[part]; k <= ends[part + 1]; ++k)
    {
      std::vector<std::array<std::size_t, 2>> places;
      if (k > ends[part])
      {
        places.push_back({ k - 1, 1 });
      }
      if (k < ends[part + 1])
      {
        places.push_back({ k, 0 });
      }
      lines.push_back({ this->End(this->Model.Sides[places[0][0]][places[0][1]], places) });
    }
  }
  std::fill(this->Model.Regions.begin(), this->Model.Regions.end(), 0);
  file.Model = this->Model;
  return file;
}

} // namespace biting
