// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_INDEX_PRESCRIPTIONS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_INDEX_PRESCRIPTIONS_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The indices that the vertices of a component must have, put together from several wishes.
class Index_prescriptions
{
  typedef Quadrangulation_mesh Mesh;
  typedef Mesh::Vertex_index Vertex;

public:
  // `is_loose`: feature edges that leave the index free, per edge; or empty.
  Index_prescriptions(const Quadrangulation_surface& surface, const std::vector<char>& is_loose)
    : m_surface(surface)
    , m_index(surface.mesh.number_of_vertices())
    , m_by(surface.mesh.number_of_vertices())
    , m_is_on_feature(surface.mesh.number_of_vertices(), 0)
  {
    const Mesh& mesh = surface.mesh;
    for(Mesh::Edge_index e : mesh.edges())
      if((surface.is_feature[e] && (is_loose.empty() || !is_loose[e])) || mesh.is_border(e))
        m_is_on_feature[mesh.vertex(e, 0)] = m_is_on_feature[mesh.vertex(e, 1)] = 1;
  }

  std::vector<std::string> unmet; // wishes that contradict others, as sentences without a period
  std::string refusal;            // why no field can meet all wishes, as a sentence

  const std::vector<std::optional<int>>& index() const { return m_index; }

  // There the index follows from the number of quads between the edges.
  bool is_on_feature(Vertex v) const { return m_is_on_feature[v] != 0; }

  // One index for some vertices.
  void add(int index, const std::string& name, const std::vector<Vertex>& vertices)
  {
    bool is_anywhere = false;
    for(Vertex v : vertices)
      if(!is_on_feature(v))
      {
        is_anywhere = true;
        prescribe(v, index, name);
      }
    if(!is_anywhere)
      unmet.push_back(name + " lies on a feature edge or the border, where the index follows from the edges");
  }

  // All vertices that have no index yet are regular.
  void forbid_others(const std::string& name)
  {
    for(Vertex v : m_surface.mesh.vertices())
      if(!is_on_feature(v) && !m_index[v])
        prescribe(v, 0, name);
  }

  // The sum of the indices in a region. `guarded` is the region and what is next to it, `index` that of a field that
  // has what is prescribed so far.
  void add_sum(int sum, const std::string& name, const std::vector<Vertex>& region, const std::vector<Vertex>& guarded,
               const std::vector<int>& index)
  {
    int missing = sum;
    std::vector<int> wanted(m_index.size(), 0);
    std::vector<Vertex> free; // to be chosen from
    for(Vertex v : region)
    {
      wanted[v] = m_index[v] ? *m_index[v] : index[v];
      missing -= wanted[v];
      if(!is_on_feature(v) && !m_index[v])
        free.push_back(v);
    }
    if(missing != 0 && free.empty())
    {
      unmet.push_back("the region of " + name + " has no vertex whose index could be chosen");
      return;
    }
    // First those are taken away that are too many, then new ones are put where most room is.
    const int step = missing > 0 ? 1 : -1;
    for(Vertex v : free)
      while(missing != 0 && wanted[v] * step < 0)
      {
        wanted[v] += step;
        missing -= step;
      }
    if(!place(missing, free, guarded, wanted))
    {
      unmet.push_back("the region of " + name + " has no room for irregular vertices that sum up to " +
                      std::to_string(sum));
      return;
    }
    for(Vertex v : guarded)
      if(!is_on_feature(v) && !m_index[v])
        prescribe(v, wanted[v], name);
  }

  // If every vertex has an index, the sum is known before any field is.
  void check_total()
  {
    const Mesh& mesh = m_surface.mesh;
    int total = 0, irregular = 0, largest = 0;
    for(Vertex v : mesh.vertices())
    {
      if(!m_index[v])
        return;
      total += *m_index[v];
      irregular += *m_index[v] != 0;
      largest = (std::max)(largest, *m_index[v]);
    }
    const int needed = 4 * (static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
                            static_cast<int>(mesh.number_of_faces()));
    // Izmestiev, Kusner, Rote, Springborn and Sullivan 2013, "There is no triangulation of the torus with vertex
    // degrees 5, 6, ..., 6, 7 and related results", which has the same for quads and 3, 4, ..., 4, 5.
    if(total == 0 && needed == 0 && irregular == 2 && largest == 1)
      refusal = "No quad mesh of a torus has one vertex of three quads, one of five, and else regular vertices only.";
    if(total == needed || mesh.is_empty())
      return;
    const int missing = needed - total;
    refusal = "The indices that are prescribed sum up to " + std::to_string(total) +
              ", those of any quad mesh of this " + "surface to " + std::to_string(needed) + ": " +
              std::to_string(std::abs(missing)) + (missing > 0 ? " are missing" : " are too many") +
              ", and no vertex is left to make up for it.";
  }

private:
  static constexpr int largest_index = 1, smallest_index = -2; // of vertices that are chosen here: three to six quads
  static constexpr int most_new = 200;                         // a search over the mesh is done for each of them

  // Puts irregular vertices where most room is, each for itself, and then each once more for what the others are: that
  // drives them apart. Returns false if there are too many.
  bool place(int missing, const std::vector<Vertex>& free, const std::vector<Vertex>& guarded,
             std::vector<int>& wanted) const
  {
    const int rounds = 3; // after which two in a disk are as far apart as they may be
    const int step = missing > 0 ? 1 : -1;
    if(std::abs(missing) > most_new)
      return false;
    std::vector<Vertex> placed;
    for(int i = 0; i < std::abs(missing); ++i)
    {
      placed.push_back(with_most_room(free, guarded, wanted));
      wanted[placed.back()] += step;
    }
    for(int round = 0; round < rounds; ++round)
      for(Vertex& v : placed)
      {
        wanted[v] -= step;
        v = with_most_room(free, guarded, wanted);
        wanted[v] += step;
      }
    return std::all_of(placed.begin(), placed.end(),
                       [&](Vertex v) { return wanted[v] <= largest_index && wanted[v] >= smallest_index; });
  }

  void prescribe(Vertex v, int index, const std::string& name)
  {
    if(m_index[v] && *m_index[v] != index)
    {
      const std::string sentence = m_by[v] + " and " + name + " want different indices at one vertex";
      if(std::find(unmet.begin(), unmet.end(), sentence) == unmet.end())
        unmet.push_back(sentence);
      return;
    }
    m_index[v] = index;
    m_by[v] = name;
  }

  // The vertex that is farthest, along edges, from irregular vertices, features and what is not guarded.
  Vertex with_most_room(const std::vector<Vertex>& free, const std::vector<Vertex>& guarded,
                        const std::vector<int>& wanted) const
  {
    const Mesh& mesh = m_surface.mesh;
    std::vector<char> is_guarded(mesh.number_of_vertices(), 0);
    for(Vertex v : guarded)
      is_guarded[v] = 1;
    Distance_front front(static_cast<int>(mesh.number_of_vertices()));
    bool has_source = false;
    for(Vertex v : mesh.vertices())
      if(!is_guarded[v] || is_on_feature(v) || wanted[v] != 0)
      {
        front.reach(static_cast<int>(v), 0);
        has_source = true;
      }
    if(!has_source)
      return free.front();
    std::vector<double> distance(mesh.number_of_vertices(), 0);
    int i;
    for(double d; front.pop(i, d);)
    {
      const Vertex v(static_cast<Mesh::size_type>(i));
      distance[v] = d;
      for(Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      {
        const Vertex w = mesh.source(h);
        front.reach(static_cast<int>(w), d + std::sqrt((mesh.point(w) - mesh.point(v)).squared_length()));
      }
    }
    return *std::max_element(free.begin(), free.end(), [&](Vertex a, Vertex b) { return distance[a] < distance[b]; });
  }

  const Quadrangulation_surface& m_surface;
  std::vector<std::optional<int>> m_index; // per vertex
  std::vector<std::string> m_by;           // per vertex: the wish that its index comes from
  std::vector<char> m_is_on_feature;       // per vertex
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_INDEX_PRESCRIPTIONS_H
