// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H

#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Edges that windows pass without being listed there: those between the faces of a group. Groups are about as wide as
// long, so that few edges are left between them.
template <typename FT>
class Open_edges
{
public:
  typedef Unfolded_mesh<FT> Mesh;

  // The groups have about so many faces; none are open if it is 1.
  Open_edges(const Mesh& mesh, int faces_of_group)
    : m_behind(mesh.number_of_halfedges(), -1), m_group(mesh.number_of_faces(), Groups::alone())
  {
    if(faces_of_group == 1)
      return;
    m_group = Groups(mesh, faces_of_group).of_faces();
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const int o = mesh.opposite[h];
      const int f = Mesh::face(h), g = o == -1 ? f : Mesh::face(o);
      if(f != g && m_group[f] == m_group[g] && m_group[f] != Groups::alone())
        m_behind[h] = o;
    }
  }

  // The halfedge on the other side of an open edge, -1 if the edge is not open.
  int behind(int h) const { return m_behind[h]; }

  // The number of the group of a face; faces that are alone have the same one.
  int group_number(int f) const { return m_group[f]; }

  // The faces of the group of a face, in increasing order.
  std::vector<int> group(int f) const
  {
    std::vector<int> faces(1, f);
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h)
        if(m_behind[h] != -1 && std::find(faces.begin(), faces.end(), Mesh::face(m_behind[h])) == faces.end())
          faces.push_back(Mesh::face(m_behind[h]));
    std::sort(faces.begin(), faces.end());
    return faces;
  }

private:
  // Groups grow one after the other, face by face: first come faces with two neighbours in the group, then those that
  // have waited longest beside it, which makes discs. What remains between groups too small for one is joined to a
  // neighbour.
  class Groups
  {
  public:
    Groups(const Mesh& mesh, int faces_of_group)
      : m_mesh(mesh)
      , m_faces_of_group(faces_of_group)
      , m_group(mesh.number_of_faces(), none())
      , m_candidate_of(mesh.number_of_faces(), -1)
    {
      for(int f = 0; f < mesh.number_of_faces(); ++f)
        examine(f);
      for(int f = 0; f < mesh.number_of_faces(); ++f)
        if(m_group[f] == none())
        {
          grow(f);
          if(m_members.size() < m_faces_of_group / 3)
            join();
        }
    }

    // Takes the numbers of the groups of all faces out.
    std::vector<int> of_faces() && { return std::move(m_group); }

    static int alone() { return -2; }

  private:
    static int none() { return -1; }

    // Flat faces stay alone: their corners are not unfolded far from their frame. Paths from a vertex that lies on the
    // opposite edge pass it at once: so faces beside one of no area stay alone too, and windows from vertices enter
    // groups at their edges or begin in them.
    void examine(int f)
    {
      if(!m_mesh.shape[f].is_flat)
        return;
      m_group[f] = alone();
      for(int g = 3 * f; g < 3 * f + 3; ++g)
        if(!m_mesh.shape[f].has_area && m_mesh.opposite[g] != -1)
          m_group[Mesh::face(m_mesh.opposite[g])] = alone();
    }

    // Begins a group with a face.
    void grow(int f)
    {
      const int group = static_cast<int>(m_sizes.size());
      m_members.clear();
      m_notches.clear();
      m_candidates.clear();
      std::size_t next_notch = 0, next_candidate = 0;
      while(f != -1)
      {
        m_group[f] = group;
        m_members.push_back(f);
        if(m_members.size() == m_faces_of_group)
          break;
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int o = m_mesh.opposite[h], g = o == -1 ? f : Mesh::face(o);
          if(m_group[g] != none())
            continue;
          (m_candidate_of[g] == group ? m_notches : m_candidates).push_back(g);
          m_candidate_of[g] = group;
        }
        f = next(m_notches, next_notch);
        if(f == -1)
          f = next(m_candidates, next_candidate);
      }
      m_sizes.push_back(m_members.size());
    }

    // The next face of a list from i on that has no group yet, -1 if there is none.
    int next(const std::vector<int>& faces, std::size_t& i) const
    {
      while(i < faces.size())
      {
        const int f = faces[i++];
        if(m_group[f] == none())
          return f;
      }
      return -1;
    }

    // Joins the last group to the one with which it has the most edges in common.
    void join()
    {
      const int last = static_cast<int>(m_sizes.size()) - 1;
      m_neighbours.clear();
      for(int f : m_members)
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int o = m_mesh.opposite[h], g = o == -1 ? last : m_group[Mesh::face(o)];
          if(g >= 0 && g != last && m_sizes[g] + m_members.size() <= m_faces_of_group + m_faces_of_group / 2)
            m_neighbours.push_back(g);
        }
      if(m_neighbours.empty())
        return;
      const int g = most_frequent(m_neighbours);
      for(int f : m_members)
        m_group[f] = g;
      m_sizes[g] += m_members.size();
      m_sizes.pop_back();
    }

    static int most_frequent(std::vector<int>& numbers)
    {
      std::sort(numbers.begin(), numbers.end());
      auto best = numbers.begin();
      std::ptrdiff_t most = 0;
      for(auto it = numbers.begin(); it != numbers.end();)
      {
        const auto end = std::upper_bound(it, numbers.end(), *it);
        if(end - it > most)
        {
          most = end - it;
          best = it;
        }
        it = end;
      }
      return *best;
    }

    const Mesh& m_mesh;
    std::size_t m_faces_of_group;
    std::vector<int> m_group;         // per face
    std::vector<int> m_candidate_of;  // per face: the last group beside which it was found
    std::vector<std::size_t> m_sizes; // per group
    std::vector<int> m_members, m_candidates, m_notches, m_neighbours;
  };

  std::vector<int> m_behind; // per halfedge
  std::vector<int> m_group;  // per face
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H
