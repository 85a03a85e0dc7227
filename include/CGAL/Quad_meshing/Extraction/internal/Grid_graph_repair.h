// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_REPAIR_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_REPAIR_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Repairs the grid graph of a map with fold-overs. All steps keep the graph a halfedge data
// structure; an exact map needs none of them.
//
// A fold-over lets a grid line run back, so that two grid lines may cross three times instead of
// once, with orientations +, -, +. Two consecutive crossings bound a 2-gon, and the neighboring faces have more than
// four sides [Bom12, Fig. 6.1]. To pull the lines apart over the 2-gon removes both crossings and leaves the quads
// there should be.
//
// Where several singular vertices have the same image, there is no such 2-gon, but the copies of that grid point are
// joined by edges of length 0. If as many rays leave the whole cluster as the map covers quarters there, counted with
// orientation, it stands for one vertex and is contracted.
class Grid_graph_repair
{
public:
  explicit Grid_graph_repair(Grid_graph& g)
    : m_graph(g), m_sign(g.number_of_nodes(), 0), m_lost(g.number_of_nodes(), false)
  {
    for(int n = 0; n < g.number_of_nodes(); ++n)
      if(g.first[n] != Grid_graph::NONE)
        m_sign[n] = g.sign[g.first[n]];
  }

  std::size_t cancelled_crossings = 0;
  std::size_t merged_nodes = 0;
  std::size_t removed_edges = 0;

  // If the visitor stops it, the graph is left as it is then.
  void operator()(Stage_progress& progress)
  {
    remove_failed_rays();
    // Each round removes edges, so this ends; the bound keeps it linear in hopeless maps.
    const int most_rounds = 64;
    bool changed = true;
    for(int round = 0; changed && round < most_rounds && progress.go_further(); ++round)
    {
      changed = cancel_crossings();
      changed |= contract_clusters();
      changed |= glue_degenerate_faces();
      changed |= simplify_nodes();
    }
  }

private:
  Grid_graph& m_graph;
  std::vector<signed char> m_sign; // per node: orientation of the map there, 0 for contracted clusters
  std::vector<char> m_lost;        // per node: has lost a ray

  void remove_edge(int r)
  {
    m_lost[m_graph.node[r]] = true;
    if(m_graph.opposite[r] >= 0)
      m_lost[m_graph.node[m_graph.opposite[r]]] = true;
    m_graph.remove_edge(r);
    ++removed_edges;
  }

  void remove_failed_rays()
  {
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
      if(m_graph.opposite[r] == Grid_graph::FAILED)
        remove_edge(r);
  }

  // The number of rays of a node, or 0 if it lies on the border.
  int inner_degree(int n) const
  {
    const int start = m_graph.first[n];
    int d = 0, r = start;
    if(start == Grid_graph::NONE)
      return 0;
    do
    {
      ++d;
      r = m_graph.ccw[r];
    }
    while(r != start && r != Grid_graph::NONE);
    return r == start ? d : 0;
  }

  void add_length(int r, int more) { m_graph.length[r] = static_cast<signed char>(m_graph.length[r] + more); }

  // Joins the edges of a and b, two rays of one node, to one edge that passes by the node.
  void join_over(int a, int b)
  {
    const int x = m_graph.opposite[a], y = m_graph.opposite[b];
    if(x != b)
    {
      // A length counts in the direction of its ray. The line runs on in that direction if it comes from where the
      // orientation is the same, else against it.
      const int over_a = m_graph.length[a], over_b = m_graph.length[b];
      if(x >= 0)
        add_length(x, m_graph.sign[x] * m_graph.sign[a] * over_b);
      if(y >= 0)
        add_length(y, m_graph.sign[y] * m_graph.sign[b] * over_a);
      if(x >= 0)
        m_graph.opposite[x] = y;
      if(y >= 0)
        m_graph.opposite[y] = x;
    }
    m_graph.unlink(a);
    m_graph.unlink(b);
  }

  // The other side of the face of a ray if the face has two sides or one, NONE if it has more.
  int other_of_two_sides(int r) const
  {
    if(m_graph.opposite[r] < 0)
      return Grid_graph::NONE;
    const int s = m_graph.next(r);
    return s != Grid_graph::NONE && m_graph.next(s) == r ? s : int(Grid_graph::NONE);
  }

  bool cancel_crossings()
  {
    bool changed = false;
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
    {
      const int s = other_of_two_sides(r);
      if(s == Grid_graph::NONE)
        continue;
      const int p = m_graph.node[r], q = m_graph.node[s];
      if(m_sign[p] * m_sign[q] != -1 || inner_degree(p) != 4 || inner_degree(q) != 4)
        continue;
      for(int n : { p, q })
      {
        const int a = m_graph.first[n], b = m_graph.ccw[a], c = m_graph.ccw[b], d = m_graph.ccw[c];
        join_over(a, c);
        join_over(b, d);
      }
      ++cancelled_crossings;
      changed = true;
    }
    return changed;
  }

  bool contract_clusters()
  {
    // The clusters are the components of the graph of the edges of length 0; nearly all nodes are alone.
    std::vector<int> edges;
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
      if(m_graph.opposite[r] > r && m_graph.length[r] == 0)
        edges.push_back(r);
    if(edges.empty())
      return false;
    Disjoint_sets clusters(m_graph.number_of_nodes());
    for(int r : edges)
      clusters.join(m_graph.node[r], m_graph.node[m_graph.opposite[r]]);

    // Per cluster: the rays that leave it, and the quarters it covers.
    std::vector<int> leaving(m_graph.number_of_nodes(), 0), quarters(m_graph.number_of_nodes(), 0);
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
      if(m_graph.is_alive(r))
      {
        const int c = clusters.find(m_graph.node[r]);
        quarters[c] += m_sign[m_graph.node[r]] == 0 ? 1 : m_graph.sign[r];
        leaving[c] += m_graph.opposite[r] < 0 || m_graph.length[r] != 0;
      }

    bool changed = false;
    for(int r : edges)
    {
      if(!m_graph.is_alive(r))
        continue;
      const int c = clusters.find(m_graph.node[r]);
      if(leaving[c] != quarters[c] || leaving[c] == 0)
        continue;
      const int p = m_graph.node[r], q = m_graph.node[m_graph.opposite[r]];
      if(p == q)
        m_graph.remove_edge(r);
      else if(m_graph.contract(r))
      {
        m_sign[p] = m_sign[q] = 0;
        ++merged_nodes;
      }
      else
        continue;
      changed = true;
    }
    return changed;
  }

  // Removes one side of each face of one or two sides, which closes it.
  bool glue_degenerate_faces()
  {
    bool changed = false;
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
    {
      const int s = other_of_two_sides(r);
      if(s == Grid_graph::NONE)
        continue;
      // A valid map may contain such a face as the outside of a single edge only; one side must stay.
      if(s == m_graph.opposite[r])
        continue;
      remove_edge(r);
      changed = true;
    }
    return changed;
  }

  // Removes what lost rays leave behind: dead ends, and nodes in the middle of an edge.
  bool simplify_nodes()
  {
    bool changed = false;
    for(int n = 0; n < m_graph.number_of_nodes(); ++n)
      for(int m = n; m_lost[m];)
      {
        const int d = inner_degree(m), r = m_graph.first[m];
        if(d != 1 && d != 2)
          break;
        int other = m;
        if(d == 1)
        {
          if(m_graph.opposite[r] >= 0)
            other = m_graph.node[m_graph.opposite[r]];
          remove_edge(r);
        }
        else
          join_over(r, m_graph.ccw[r]);
        changed = true;
        m = other;
      }
    return changed;
  }
};

// Cuts faces of 6, 8, ... sides into quads, after joining neighboring faces of odd degree where that helps.
class Grid_face_splitter
{
public:
  // `distance(m, n)` is the squared distance of two nodes.
  template <typename Distance>
  Grid_face_splitter(Grid_graph& g, int largest_degree, const Distance& distance)
    : m_graph(g), m_largest_degree(largest_degree)
  {
    join_odd_faces();
    split_even_faces(distance);
  }

  std::size_t split_faces = 0;
  std::size_t joined_faces = 0;

private:
  Grid_graph& m_graph;
  const int m_largest_degree;
  std::vector<int> m_loop;

  // The rays around the face of r; whether no node is met twice.
  bool collect(int r, std::vector<int>& loop) const
  {
    loop.clear();
    int s = r;
    do
    {
      loop.push_back(s);
      s = m_graph.next(s);
    }
    while(s != r);
    std::vector<int> nodes;
    for(int t : loop)
      nodes.push_back(m_graph.node[t]);
    std::sort(nodes.begin(), nodes.end());
    return std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end();
  }

  bool is_odd(int r) const { return m_graph.face[r] >= 0 && m_graph.degree[m_graph.face[r]] % 2 == 1; }

  void join_odd_faces()
  {
    m_graph.find_faces();
    std::vector<char> done(m_graph.number_of_faces(), false);
    std::vector<int> a, b, nodes;
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
    {
      const int o = m_graph.opposite[r];
      if(o < r || !is_odd(r) || !is_odd(o) || m_graph.face[r] == m_graph.face[o] || done[m_graph.face[r]] ||
         done[m_graph.face[o]] ||
         m_graph.degree[m_graph.face[r]] + m_graph.degree[m_graph.face[o]] - 2 > m_largest_degree)
        continue;
      // The joined polygon must be simple: the two faces share the nodes of this edge and no other.
      if(!collect(r, a) || !collect(o, b))
        continue;
      nodes.clear();
      for(int s : a)
        nodes.push_back(m_graph.node[s]);
      for(int s : b)
        nodes.push_back(m_graph.node[s]);
      std::sort(nodes.begin(), nodes.end());
      if(std::unique(nodes.begin(), nodes.end()) - nodes.begin() !=
         static_cast<std::ptrdiff_t>(a.size() + b.size() - 2))
        continue;
      done[m_graph.face[r]] = done[m_graph.face[o]] = true;
      m_graph.remove_edge(r);
      ++joined_faces;
    }
  }

  bool are_joined(int m, int n) const
  {
    const int start = m_graph.first[m];
    int r = start;
    do
    {
      if(m_graph.opposite[r] >= 0 && m_graph.node[m_graph.opposite[r]] == n)
        return true;
      r = m_graph.ccw[r];
    }
    while(r != Grid_graph::NONE && r != start);
    return false;
  }

  // Adds an edge through the face on the left of rays r and s, from the start of r to that of s.
  void add_diagonal(int r, int s)
  {
    const int a = m_graph.number_of_rays(), b = a + 1;
    for(int i : { a, b })
    {
      const int before = (i == a) ? r : s, after = m_graph.ccw[before];
      m_graph.node.push_back(m_graph.node[before]);
      m_graph.opposite.push_back(i == a ? b : a);
      m_graph.ccw.push_back(after);
      m_graph.cw.push_back(before);
      m_graph.face.push_back(Grid_graph::NONE);
      m_graph.sign.push_back(1);
      m_graph.length.push_back(1);
      m_graph.open_on_left.push_back(false);
      m_graph.ccw[before] = i;
      if(after != Grid_graph::NONE)
        m_graph.cw[after] = i;
    }
  }

  template <typename Distance>
  void split_even_faces(const Distance& distance)
  {
    m_graph.find_faces();
    std::vector<char> done(m_graph.number_of_faces(), false);
    const int n = m_graph.number_of_rays();
    std::vector<int> loop;
    for(int r = 0; r < n; ++r)
    {
      const int f = m_graph.face[r];
      if(f < 0 || done[f])
        continue;
      done[f] = true;
      const int d = m_graph.degree[f];
      if(d < 6 || d % 2 == 1 || d > m_largest_degree || !collect(r, loop))
        continue;
      bool split = false;
      while(loop.size() > 4)
      {
        // Cut off the quad with the shortest diagonal.
        const std::size_t size = loop.size();
        std::size_t best = size;
        double best_distance = 0;
        for(std::size_t i = 0; i < size; ++i)
        {
          const int p = m_graph.node[loop[i]], q = m_graph.node[loop[(i + 3) % size]];
          const double l = distance(p, q);
          if((best == size || l < best_distance) && !are_joined(p, q))
          {
            best = i;
            best_distance = l;
          }
        }
        if(best == size)
          break;
        std::rotate(loop.begin(), loop.begin() + best, loop.end());
        // The diagonal runs from the start of loop[0] to that of loop[3]; it takes their place in the rest of the face.
        add_diagonal(loop[0], loop[3]);
        loop.erase(loop.begin(), loop.begin() + 3);
        loop.push_back(m_graph.number_of_rays() - 2);
        split = true;
      }
      split_faces += split;
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_REPAIR_H
