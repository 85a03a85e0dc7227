// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_BASE_COMPLEX_ARRAYS_H
#define CGAL_QUAD_MESHING_INTERNAL_BASE_COMPLEX_ARRAYS_H

#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The primal construction of the base complex (thesis, section 2.1): the edges of all straight lines
// that start at an irregular vertex, and the boundary.
inline std::vector<char> separatrix_halfedges(const Indexed_quad_mesh& m)
{
  const Vertex_regularity regularity(m);
  std::vector<char> is_separatrix(m.number_of_halfedges(), 0);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.is_border(h))
      is_separatrix[h] = 1;

  for(int start = 0; start < m.number_of_halfedges(); ++start)
  {
    if(!regularity.is_irregular[m.source(start)] || m.is_border(start))
      continue;
    // straight on: over an inner regular vertex the second edge counterclockwise
    for(int h = start; !is_separatrix[h];)
    {
      is_separatrix[h] = is_separatrix[m.opposite[h]] = 1;
      if(!regularity.is_inner_regular[m.target(h)])
        break;
      h = m.next(m.opposite[m.next(h)]);
    }
  }
  return is_separatrix;
}

// The number of faces of the base complex alone.
inline int number_of_base_complex_patches(const Indexed_quad_mesh& m)
{
  const std::vector<char> is_separatrix = separatrix_halfedges(m);
  std::vector<char> seen(m.number_of_faces(), 0);
  std::vector<int> stack;
  int patches = 0;
  for(int start = 0; start < m.number_of_faces(); ++start)
  {
    if(seen[start])
      continue;
    ++patches;
    seen[start] = 1;
    stack.push_back(start);
    while(!stack.empty())
    {
      const int f = stack.back();
      stack.pop_back();
      for(int h = 4 * f; h < 4 * f + 4; ++h)
        if(!is_separatrix[h] && !seen[m.opposite[h] / 4])
        {
          seen[m.opposite[h] / 4] = 1;
          stack.push_back(m.opposite[h] / 4);
        }
    }
  }
  return patches;
}

// The cell complex that the separatrices cut out of a quad mesh.
struct Base_complex_arrays
{
  std::vector<char> is_separatrix;   // per halfedge
  std::vector<char> is_node;         // per vertex: irregular, or a crossing or end of separatrices
  std::vector<int> patch;            // per face: its patch
  std::vector<int> corners_of_patch; // per patch: number of its corners, 4 of a rectangle
  int number_of_patches = 0;
  int number_of_nodes = 0;
  int number_of_arcs = 0;       // paths of separatrix edges between nodes, and loops without nodes
  int number_of_free_loops = 0; // arcs without a node: boundary loops with regular vertices only
  int number_of_separatrix_edges = 0;
};

inline Base_complex_arrays make_base_complex(const Indexed_quad_mesh& m)
{
  Base_complex_arrays bc;
  bc.is_separatrix = separatrix_halfedges(m);
  const int nh = m.number_of_halfedges(), nf = m.number_of_faces();

  std::vector<int> degree(m.number_of_vertices(), 0);
  for(int h = 0; h < nh; ++h)
    if(bc.is_separatrix[h] && m.edge(h) == h)
    {
      ++bc.number_of_separatrix_edges;
      ++degree[m.source(h)];
      ++degree[m.target(h)];
    }
  bc.is_node.resize(m.number_of_vertices());
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    bc.is_node[v] = degree[v] > 2 || is_irregular(m, v);
    bc.number_of_nodes += bc.is_node[v];
  }

  // patches: faces with no separatrix between them
  Disjoint_sets faces(nf);
  for(int h = 0; h < nh; ++h)
    if(m.opposite[h] > h && !bc.is_separatrix[h])
      faces.join(h / 4, m.opposite[h] / 4);
  bc.patch.resize(nf);
  for(int f = 0; f < nf; ++f)
    bc.patch[f] = faces.smallest(f) == f ? bc.number_of_patches++ : bc.patch[faces.smallest(f)];
  bc.corners_of_patch.assign(bc.number_of_patches, 0);
  for(int h = 0; h < nh; ++h)
    if(bc.is_separatrix[h] && bc.is_separatrix[m.prev(h)])
      ++bc.corners_of_patch[bc.patch[h / 4]];

  // arcs: separatrix edges joined at vertices that are not nodes
  Disjoint_sets arcs(nh);
  std::vector<int> edge_at(m.number_of_vertices(), -1);
  for(int h = 0; h < nh; ++h)
    if(bc.is_separatrix[h] && m.edge(h) == h)
      for(int v : { m.source(h), m.target(h) })
        if(!bc.is_node[v])
        {
          if(edge_at[v] != -1)
            arcs.join(edge_at[v], h);
          edge_at[v] = h;
        }
  std::vector<char> touches_node(nh, 0);
  for(int h = 0; h < nh; ++h)
    if(bc.is_separatrix[h] && m.edge(h) == h && (bc.is_node[m.source(h)] || bc.is_node[m.target(h)]))
      touches_node[arcs.smallest(h)] = 1;
  for(int h = 0; h < nh; ++h)
    if(bc.is_separatrix[h] && m.edge(h) == h && arcs.smallest(h) == h)
    {
      ++bc.number_of_arcs;
      bc.number_of_free_loops += !touches_node[h];
    }
  return bc;
}

// The dual side (thesis, section 2.1). Two dual curves are topologically parallel if no irregular
// vertex lies between them anywhere; `of_line` gives the class of parallel curves of each line.
struct Parallel_classes
{
  std::vector<int> of_line;
  int number_of_classes = 0;
};

inline Parallel_classes make_parallel_classes(const Indexed_quad_mesh& m, const Dual_lines& lines)
{
  // Neighbouring lines are separated by a chain of edges. Chains that meet no irregular vertex and
  // are not on the border join the lines on their two sides.
  const std::vector<char> inner_regular = inner_regular_vertices(m);
  const int nh = m.number_of_halfedges();
  Disjoint_sets chains(nh);
  std::vector<char> is_broken(nh, 0);
  for(int h = 0; h < nh; ++h)
  {
    if(m.is_border(h))
      continue;
    const int v = m.target(h);
    if(inner_regular[v])
      chains.join(m.edge(h), m.edge(m.next(m.opposite[m.next(h)])));
    else if(!m.is_border_vertex(v) || m.valence(v) != 3)
      is_broken[m.edge(h)] = 1;
  }
  for(int h = 0; h < nh; ++h)
    if(is_broken[h])
      is_broken[chains.smallest(h)] = 1;

  Disjoint_sets parallel(lines.number_of_lines());
  for(int l = 0; l < lines.number_of_lines(); ++l)
    parallel.join(l, lines.reverse[l]);
  for(int h = 0; h < nh; ++h)
    if(m.opposite[h] > h && !is_broken[chains.smallest(m.edge(h))])
      // the lines that run along the edge on both sides
      parallel.join(lines.line[m.next(h)], lines.line[m.next(m.opposite[h])]);

  Parallel_classes classes;
  classes.of_line.resize(lines.number_of_lines());
  for(int l = 0; l < lines.number_of_lines(); ++l)
    classes.of_line[l] =
      parallel.smallest(l) == l ? classes.number_of_classes++ : classes.of_line[parallel.smallest(l)];
  return classes;
}

// The dual construction of the base complex: one line of each class; each crossing of two of them is
// a patch.
inline int number_of_representative_crossings(const Indexed_quad_mesh& m, const Dual_lines& lines,
                                              const Parallel_classes& classes)
{
  std::vector<char> is_chosen(lines.number_of_lines(), 0), has_class(classes.number_of_classes, 0);
  for(int l = 0; l < lines.number_of_lines(); ++l)
    if(!has_class[classes.of_line[l]])
    {
      has_class[classes.of_line[l]] = 1;
      is_chosen[l] = is_chosen[lines.reverse[l]] = 1;
    }
  int crossings = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
    crossings += is_chosen[lines.line[4 * f]] && is_chosen[lines.line[4 * f + 1]];
  return crossings;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_BASE_COMPLEX_ARRAYS_H
