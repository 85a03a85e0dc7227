// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_GROUP_WINDOWS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_GROUP_WINDOWS_H

#include <CGAL/Quad_meshing/Geodesics/internal/Face_crossing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Source_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Vertex_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_envelope.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_landing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_lists.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_merging.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Receives the windows at the open edges of one group of faces, after the propagation. What leaves the group is
// dropped.
template <typename Number>
class Group_front
{
public:
  typedef Number FT;
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_landing<FT> Landing;

  static constexpr bool asks_at_open_edges = true;

  Group_front(const Wavefront<FT>& front, const std::vector<int>& faces)
    : m_front(front)
    , m_mesh(front.mesh())
    , m_group(front.open_edges().group_number(faces.front()))
    , m_edges(open_edges(front, faces))
    , m_lists(m_edges.size())
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  const Vertex_label<FT>& label(int v) const { return m_front.label(v); }
  int behind(int h) const
  {
    return m_front.open_edges().group_number(Mesh::face(h)) == m_group ? m_front.behind(h) : -1;
  }
  const std::vector<int>& edges() const { return m_edges; }
  Window_lists<FT>& lists() { return m_lists; }

  template <typename Angle>
  void reach(int, const FT&, int, float, const Angle&)
  {
  }

  Landing landing(int h) const
  {
    const int i = number_of_edge(h), e = m_mesh.edge_of[h];
    return Landing{ i,
                    m_mesh.is_canonical(h),
                    i == -1,
                    m_mesh.length[e],
                    label(m_mesh.source(h)).distance,
                    label(m_mesh.target(h)).distance,
                    i == -1 ? 0 : m_lists[i].size };
  }

  void arrive(Landing& at, W w)
  {
    if(at.admits(w))
      m_envelope.insert(m_lists, m_lists[at.edge], at.hint, w, at.length);
  }

  void finish(const Landing&) {}

  void arrive(int h, const W& w)
  {
    Landing at = landing(h);
    if(!at.is_closed)
      arrive(at, w);
  }

  void store(int h, W w)
  {
    const int i = number_of_edge(h), e = m_mesh.edge_of[h];
    if(i == -1)
      return;
    if(!m_mesh.is_canonical(h))
      w.reverse(m_mesh.length[e]);
    int hint = 0;
    m_envelope.insert(m_lists, m_lists[i], hint, w, m_mesh.length[e]);
  }

private:
  static std::vector<int> open_edges(const Wavefront<FT>& front, const std::vector<int>& faces)
  {
    std::vector<int> edges;
    for(int f : faces)
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(front.behind(h) != -1 && front.mesh().is_canonical(h))
          edges.push_back(front.mesh().edge_of[h]);
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // The number of the edge of a halfedge among the open ones of the group, -1 if it is none of them.
  int number_of_edge(int h) const
  {
    if(behind(h) == -1)
      return -1;
    return static_cast<int>(std::lower_bound(m_edges.begin(), m_edges.end(), m_mesh.edge_of[h]) - m_edges.begin());
  }

  const Wavefront<FT>& m_front;
  const Mesh& m_mesh;
  int m_group;
  std::vector<int> m_edges; // the open ones, sorted
  Window_lists<FT> m_lists;
  Window_envelope<FT> m_envelope;
};

// The windows on the open edges of a group of faces.
//
// Every shortest path to a point of them enters the group through a window on an edge that has a list, or begins inside
// at a source or at a vertex where it bends. So these are sent on once more, and what is nearest remains.
template <typename FT>
class Group_windows
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_list<FT> List;

  Group_windows(const Wavefront<FT>& front, const Field_sources<FT>& sources, double allowed_error, int face)
  {
    const std::vector<int> faces = front.open_edges().group(face);
    m_first_face = faces.front();
    Group_front<FT> group(front, faces);
    Face_crossing<Group_front<FT>> cross(group);
    Vertex_departure<Group_front<FT>> departure(group, cross);
    Source_departure<Group_front<FT>> start(group, cross, departure);
    enter(front, faces, cross);
    for(int f : faces)
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(front.label(front.mesh().source(h)).distance < Wavefront<FT>::unreached())
          departure.leave_into_face(h);
    for(int i : elements(sources, faces))
      start(sources, i);
    take(group, allowed_error);
  }

  int first_face() const { return m_first_face; }
  const std::vector<int>& edges() const { return m_edges; }
  std::size_t number_of_windows() const { return static_cast<std::size_t>(m_begin.back()); }

  // The windows of one of the edges.
  List windows(int e) const
  {
    const std::size_t i = std::lower_bound(m_edges.begin(), m_edges.end(), e) - m_edges.begin();
    List list;
    list.first = m_windows.get() + m_begin[i];
    list.size = m_begin[i + 1] - m_begin[i];
    return list;
  }

private:
  static void enter(const Wavefront<FT>& front, const std::vector<int>& faces, Face_crossing<Group_front<FT>>& cross)
  {
    const Mesh& mesh = front.mesh();
    std::vector<W> windows;
    for(int f : faces)
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if(front.behind(h) != -1)
          continue;
        const bool is_canonical = mesh.is_canonical(h);
        windows.clear();
        for(const W& w : front.lists()[mesh.edge_of[h]])
          if(w.from_left != is_canonical && w.y > FT(0))
            windows.push_back(w);
        if(!is_canonical)
        {
          std::reverse(windows.begin(), windows.end());
          for(W& w : windows)
            w.reverse(mesh.length_of(h));
        }
        cross(h, windows);
      }
  }

  static std::vector<int> elements(const Field_sources<FT>& sources, const std::vector<int>& faces)
  {
    std::vector<int> found;
    for(int f : faces)
    {
      const auto range = sources.elements_in_face(f);
      for(auto it = range.first; it != range.second; ++it)
        found.push_back(it->second);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  void take(Group_front<FT>& group, double allowed_error)
  {
    m_edges = group.edges();
    m_begin.push_back(0);
    for(int i = 0; i < static_cast<int>(m_edges.size()); ++i)
    {
      if(allowed_error > 0)
        merge_neighbours(group.lists(), group.lists()[i], allowed_error);
      m_begin.push_back(m_begin.back() + group.lists()[i].size);
    }
    m_windows.reset(new W[m_begin.back()]);
    for(int i = 0; i < static_cast<int>(m_edges.size()); ++i)
      std::copy(group.lists()[i].begin(), group.lists()[i].end(), m_windows.get() + m_begin[i]);
  }

  int m_first_face;
  std::vector<int> m_edges;
  std::vector<int> m_begin; // per edge: where its windows begin
  std::unique_ptr<W[]> m_windows;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_GROUP_WINDOWS_H
