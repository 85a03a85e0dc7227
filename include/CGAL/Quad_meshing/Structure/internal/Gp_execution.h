// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_EXECUTION_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_EXECUTION_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Executes a grid-preserving operator on flat arrays, all its steps at once.
//
// Which faces vanish, which corners change and which sides meet afterwards is decided face by face:
//
// - a face that is passed straight by a collapse vanishes, its left and right sides become one edge;
// - a face in which a shift turns into a collapse vanishes, the side by which it is entered and the
//   one across become one edge;
// - in a run of shifts to the left, each left corner moves on to the next one. So the left side of
//   each face now is the left side of the next face, and takes over the neighbour there; the run
//   begins in the face in which a collapse turned into the shift, whose entered side, being
//   collapsed, gets the left side of the first face behind it. To the right likewise.
//
// A collapsed row that a run of shifts crosses is not there any more for the run: the face of the
// crossing is skipped.
class Gp_execution
{
  const Indexed_quad_mesh& m_mesh;
  const Gp_path& m_path;

  std::vector<int> m_bearer;    // per halfedge: the halfedge that is this side afterwards, or -1
  std::vector<int> m_passage;   // per halfedge without bearer: the other side it becomes one with, or -1
  std::vector<char> m_vanishes; // per face

  int next_step(int i) const { return i + 1 == static_cast<int>(m_path.size()) ? 0 : i + 1; }

  bool enters(int i) const { return m_path[i].in != -1; }

  // For a shift step: the one further on its run whose face does not lie in a collapsed row.
  int skip_collapsed_rows(int i, const std::vector<char>& in_collapsed_row) const
  {
    while(in_collapsed_row[m_path[i].in / 4])
      i = next_step(i);
    return i;
  }

public:
  // Vertices of the result are those of the input without the ones merged into others.
  std::vector<int> vertex_of;   // per vertex of the input: its vertex in the result
  std::vector<int> face_of;     // per face of the input: its face in the result, -1 if it has vanished
  std::vector<int> vertex_from; // per vertex of the result: the vertex of the input that has become it

  Gp_execution(const Indexed_quad_mesh& mesh, const Gp_path& steps) : m_mesh(mesh), m_path(steps) {}

  // `weight` tells, per vertex, which of the merged vertices gives the position: the mean of those of
  // largest weight.
  Indexed_quad_mesh execute(const std::vector<char>& weight)
  {
    const int nh = m_mesh.number_of_halfedges(), nf = m_mesh.number_of_faces(), steps = static_cast<int>(m_path.size());
    Disjoint_sets merged(m_mesh.number_of_vertices());
    std::vector<int> merged_vertices;
    for(const Gp_step& s : m_path)
      if(s.kind == gp_collapse)
      {
        merged.join(s.left(m_mesh), s.right(m_mesh));
        merged_vertices.push_back(s.left(m_mesh));
        merged_vertices.push_back(s.right(m_mesh));
      }

    std::vector<char> in_collapsed_row(nf, 0);
    m_vanishes.assign(nf, 0);
    m_bearer.resize(nh);
    std::iota(m_bearer.begin(), m_bearer.end(), 0);
    m_passage.assign(nh, -1);
    for(int i = 0; i < steps; ++i)
      if(enters(i) && gp_passage(m_path[i], m_path[next_step(i)]) == gp_straight_collapse)
      {
        const int in = m_path[i].in;
        m_vanishes[in / 4] = 1;
        m_passage[m_mesh.prev(in)] = m_mesh.next(in);
        m_passage[m_mesh.next(in)] = m_mesh.prev(in);
        for(int h : { in, m_mesh.next(in), m_mesh.across(in), m_mesh.prev(in) })
          m_bearer[h] = -1;
        in_collapsed_row[in / 4] = 1;
      }
    // sides that are crossed by a collapse have no side to become one with
    for(const Gp_step& s : m_path)
      if(s.kind == gp_collapse)
        for(int h : { s.in, s.out })
          if(h != -1)
            m_passage[h] = -1;

    // corners that move, one shift step after the other
    std::vector<std::array<int, 4>> corners = m_mesh.corners;
    auto moved_to = [&](int i)
    {
      const int in = m_path[skip_collapsed_rows(i, in_collapsed_row)].in;
      return m_path[i].kind == gp_shift_left ? m_mesh.source(m_mesh.prev(in)) : m_mesh.target(m_mesh.next(in));
    };
    // the left (right) side of the face that is entered by a shift to the left (right)
    auto outer_side = [&](int i)
    {
      const int in = m_path[skip_collapsed_rows(i, in_collapsed_row)].in;
      return m_path[i].kind == gp_shift_left ? m_mesh.prev(in) : m_mesh.next(in);
    };
    for(int i = 0; i < steps; ++i)
    {
      if(!enters(i) || in_collapsed_row[m_path[i].in / 4])
        continue;
      const Gp_step &enter = m_path[i], &leave = m_path[next_step(i)];
      const int in = enter.in, f = in / 4;
      if(enter.kind != gp_collapse && leave.kind == gp_collapse)
      {
        m_vanishes[f] = 1;
        m_bearer[in] = m_bearer[m_mesh.across(in)] = m_bearer[leave.out] = -1;
        m_passage[in] = m_mesh.across(in);
        m_passage[m_mesh.across(in)] = in;
      }
      else if(enter.kind != gp_collapse)
      {
        const bool to_left = enter.kind == gp_shift_left;
        const int a = in & 3, b = (in + 1) & 3, c = (in + 2) & 3, d = (in + 3) & 3;
        corners[f][to_left ? a : b] = moved_to(i);
        corners[f][to_left ? d : c] = moved_to(next_step(i));
        m_bearer[outer_side(next_step(i))] = to_left ? m_mesh.prev(in) : m_mesh.next(in);
      }
      else
      {
        corners[f][leave.kind == gp_shift_left ? in & 3 : (in + 1) & 3] = moved_to(next_step(i));
        m_bearer[in] = -1;
        m_bearer[outer_side(next_step(i))] = in;
      }
    }

    // the sides that meet afterwards
    std::vector<int> opposite(nh, -1);
    std::vector<char> is_feature(nh, 0);
    for(int h = 0; h < nh; ++h)
    {
      if(m_bearer[h] == -1)
        continue;
      char feature = m_mesh.is_feature[h];
      int o = m_mesh.opposite[h];
      while(o != -1 && m_bearer[o] == -1 && m_passage[o] != -1)
      {
        feature |= m_mesh.is_feature[m_passage[o]];
        o = m_mesh.opposite[m_passage[o]];
      }
      opposite[m_bearer[h]] = o == -1 ? -1 : m_bearer[o];
      is_feature[m_bearer[h]] = feature;
    }
    return compact(corners, opposite, is_feature, merged, merged_vertices, weight);
  }

private:
  // Drops the faces that have vanished and the vertices that are no longer there.
  Indexed_quad_mesh compact(const std::vector<std::array<int, 4>>& corners, const std::vector<int>& opposite,
                            const std::vector<char>& is_feature, Disjoint_sets& merged,
                            std::vector<int>& merged_vertices, const std::vector<char>& weight)
  {
    Indexed_quad_mesh r;
    const int nf = m_mesh.number_of_faces(), nv = m_mesh.number_of_vertices();
    vertex_of.assign(nv, -1);
    vertex_from.clear();
    for(int v = 0; v < nv; ++v)
      if(merged.smallest(v) == v)
      {
        vertex_of[v] = r.number_of_vertices();
        r.points.push_back(m_mesh.points[v]);
        vertex_from.push_back(v);
      }
    for(int v = 0; v < nv; ++v)
      vertex_of[v] = vertex_of[merged.smallest(v)];

    std::sort(merged_vertices.begin(), merged_vertices.end());
    merged_vertices.erase(std::unique(merged_vertices.begin(), merged_vertices.end()), merged_vertices.end());
    std::stable_sort(merged_vertices.begin(), merged_vertices.end(),
                     [&](int a, int b)
                     { return vertex_of[a] != vertex_of[b] ? vertex_of[a] < vertex_of[b] : weight[a] > weight[b]; });
    for(std::size_t i = 0, j; i < merged_vertices.size(); i = j)
    {
      const int v = vertex_of[merged_vertices[i]], w = weight[merged_vertices[i]];
      Indexed_quad_mesh::Vector_3 sum(0, 0, 0);
      int number = 0;
      for(j = i; j < merged_vertices.size() && vertex_of[merged_vertices[j]] == v; ++j)
        if(weight[merged_vertices[j]] == w)
        {
          sum = sum + (m_mesh.points[merged_vertices[j]] - ORIGIN);
          ++number;
        }
      r.points[v] = ORIGIN + sum / number;
    }

    face_of.assign(nf, -1);
    for(int f = 0, n = 0; f < nf; ++f)
      if(!m_vanishes[f])
        face_of[f] = n++;
    for(int f = 0; f < nf; ++f)
    {
      if(m_vanishes[f])
        continue;
      std::array<int, 4> c;
      for(int k = 0; k < 4; ++k)
      {
        c[k] = vertex_of[corners[f][k]];
        const int o = opposite[4 * f + k];
        // a side that has lost its neighbour in a vanished face is an error that is found later
        r.opposite.push_back(o == -1 || face_of[o / 4] == -1 ? -1 : 4 * face_of[o / 4] + (o & 3));
        r.is_feature.push_back(is_feature[4 * f + k]);
      }
      r.corners.push_back(c);
    }
    r.find_halfedges_of_vertices();
    return r;
  }
};

// Whether flat arrays are a manifold pure quad mesh: sides that meet have the same ends, the corners
// of each quad are distinct, the quads of a vertex form one fan, and no two edges have the same ends.
inline bool is_valid_quad_mesh(const Indexed_quad_mesh& m)
{
  const int nh = m.number_of_halfedges(), nv = m.number_of_vertices();
  std::vector<int> corners_at(nv, 0), last_seen(nv, -1);
  for(const std::array<int, 4>& c : m.corners)
    for(int k = 0; k < 4; ++k)
    {
      ++corners_at[c[k]];
      if(c[k] == c[(k + 1) & 3] || c[k] == c[(k + 2) & 3])
        return false;
    }
  for(int h = 0; h < nh; ++h)
  {
    const int o = m.opposite[h];
    if(o != -1 && (m.opposite[o] != h || m.source(o) != m.target(h) || m.target(o) != m.source(h) ||
                   m.is_feature[o] != m.is_feature[h]))
      return false;
  }
  for(int v = 0; v < nv; ++v)
  {
    const int first = m.halfedge_of_vertex[v];
    if(first == -1)
      continue; // isolated
    int h = first, n = 0;
    bool closed = false;
    for(; h != -1 && !closed; h = m.next_around_source(h), closed = h == first)
    {
      ++n;
      if(last_seen[m.target(h)] == v || n > corners_at[v])
        return false;
      last_seen[m.target(h)] = v;
      if(m.next_around_source(h) == -1 && last_seen[m.source(m.prev(h))] == v)
        return false;
    }
    if(n != corners_at[v])
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_EXECUTION_H
