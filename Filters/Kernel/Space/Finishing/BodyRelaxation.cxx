// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyRelaxation.h"

#include "BodyTets.h"
#include "EdgeRemoval.h"
#include "VertexMoves.h"

namespace biting
{

namespace
{

/// Badness (TetShape): the square of the cosine of the smallest angle.
constexpr double At35 = 0.6710100716628343;
constexpr double At38 = 0.6209609477998338;

class BodyRelaxer
{
public:
  BodyRelaxer(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
    RelaxedBody& body, Pulse& pulse)
    : Tets(body, pulse)
    , Normals(ground, body)
    , Moves(this->Tets, this->Normals, f)
    , Edges(this->Tets, this->Normals)
    , Beats(pulse)
  {
  }

  void Run()
  {
    constexpr int Sweeps = 4;
    for (int sweep = 0; sweep < Sweeps && this->Beats.Ask(); ++sweep)
    {
      this->SmoothAll();
      this->ChangeBad(At35);
    }
    constexpr int Rounds = 8;
    for (int round = 0; round < Rounds && this->Beats.Ask(); ++round)
    {
      const bool isMoved = this->MoveBad(At35);
      const bool isChanged = this->ChangeBad(At38);
      if (!isMoved && !isChanged)
      {
        break;
      }
    }
    this->Tets.GiveBack();
  }

private:
  void SmoothAll()
  {
    for (Id vertex = this->Tets.Body.NumberOnBoundary;
         vertex < this->Tets.Mesh.NumberOfVertices() && this->Beats.Beat(64); ++vertex)
    {
      this->Moves.Smooth(vertex, At35);
    }
  }

  bool IsBad(Id cell, double limit) const
  {
    return !this->Tets.Mesh.IsFree(cell) && this->Tets.Badness[At(cell)] > limit;
  }

  bool ChangeBad(double limit)
  {
    bool isChanged = false;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots() && !this->Beats.HasStopped(); ++cell)
    {
      if (this->IsBad(cell, limit) && this->Beats.Beat(128))
      {
        isChanged = this->Edges.Improve(cell) || isChanged;
      }
    }
    return isChanged;
  }

  bool MoveBad(double limit)
  {
    bool isMoved = false;
    for (Id cell = 0; cell < this->Tets.Mesh.NumberOfSlots() && !this->Beats.HasStopped(); ++cell)
    {
      for (Id slot = 4 * cell; slot < 4 * cell + 4 && this->IsBad(cell, limit); ++slot)
      {
        this->Beats.Beat(256);
        isMoved = this->Moves.Improve(this->Tets.VertexAt(slot), limit) || isMoved;
      }
    }
    return isMoved;
  }

  BodyTets Tets;
  GroundNormals Normals;
  VertexMoves Moves;
  EdgeRemoval Edges;
  Pulse& Beats;
};

} // namespace

void RelaxBody(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
  RelaxedBody& body, Pulse& pulse)
{
  BodyRelaxer(ground, f, body, pulse).Run();
}

} // namespace biting
