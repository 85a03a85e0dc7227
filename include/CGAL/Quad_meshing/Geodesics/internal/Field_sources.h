// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_SOURCES_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_SOURCES_H

#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A point on the mesh by what carries it: a vertex, the interior of an edge (the place t on
// halfedge h) or the interior of a face (in the frame of its first halfedge).
template <typename FT>
struct Surface_point
{
  enum Carrier
  {
    VERTEX,
    EDGE,
    FACE
  } carrier;
  int simplex; // vertex, halfedge or face
  FT x, y;     // on an edge: the place x
};

// A piece of a source: a point, or a segment within one face or along one edge.
template <typename FT>
struct Source_element
{
  Surface_point<FT> from, to;
  bool is_segment;
  int face; // of a segment: a face that contains it, -1 if it runs along `halfedge`
  int halfedge;
  FT offset;
  std::size_t source; // the user's source that it belongs to
};

// Weights below this (they sum to one) count as zero: the point lies on the edge or the vertex.
inline double barycentric_tolerance() { return 1e-12; }

// The place of a corner in the frame of the first halfedge of its face.
template <typename FT>
std::pair<FT, FT> corner_place(const Unfolded_mesh<FT>& m, int face, int k)
{
  if(k == 0)
    return std::make_pair(FT(0), FT(0));
  if(k == 1)
    return std::make_pair(m.length_of(3 * face), FT(0));
  return std::make_pair(m.apex[3 * face].x, m.apex[3 * face].y);
}

template <typename FT>
Surface_point<FT> surface_point(const Unfolded_mesh<FT>& m, int face, std::array<double, 3> w)
{
  typedef Surface_point<FT> Point;
  // An edge of length zero has no frame: its two corners are one point.
  for(int k = 0; k < 3; ++k)
    if(m.length_of(3 * face + k) == FT(0))
    {
      w[k] += w[(k + 1) % 3];
      w[(k + 1) % 3] = 0;
    }
  int zeros = 0;
  for(double& x : w)
    if(x <= barycentric_tolerance())
    {
      x = 0;
      ++zeros;
    }
  const FT sum = FT(w[0]) + FT(w[1]) + FT(w[2]);
  for(int k = 0; k < 3; ++k)
  {
    if(zeros >= 2 && w[k] > 0)
      return Point{ Point::VERTEX, m.corners[face][k], FT(0), FT(0) };
    if(zeros == 1 && w[k] == 0)
    {
      const int h = 3 * face + (k + 1) % 3; // runs from corner k+1 to corner k+2
      return Point{ Point::EDGE, h, FT(FT(w[(k + 2) % 3]) / sum * m.length_of(h)), FT(0) };
    }
  }
  const auto q = corner_place(m, face, 1), r = corner_place(m, face, 2);
  return Point{ Point::FACE, face, FT((FT(w[1]) * q.first + FT(w[2]) * r.first) / sum), FT(FT(w[2]) * r.second / sum) };
}

// The place of a point in the frame of the first halfedge of a face that contains it.
template <typename FT>
std::pair<FT, FT> place_in_face(const Unfolded_mesh<FT>& m, int face, const Surface_point<FT>& p)
{
  typedef Surface_point<FT> Point;
  if(p.carrier == Point::FACE)
    return std::make_pair(p.x, p.y);
  if(p.carrier == Point::VERTEX)
  {
    int k = 0;
    while(k < 2 && m.corners[face][k] != p.simplex)
      ++k;
    return corner_place(m, face, k);
  }
  int h = p.simplex;
  FT t = p.x;
  if(Unfolded_mesh<FT>::face(h) != face)
  {
    t = m.length_of(h) - t;
    h = m.opposite[h];
  }
  const auto a = corner_place(m, face, h % 3), b = corner_place(m, face, (h + 1) % 3);
  const FT f = t / m.length_of(h);
  return std::make_pair(FT(a.first + f * (b.first - a.first)), FT(a.second + f * (b.second - a.second)));
}

// All faces that contain a point, into `out`.
template <typename FT>
void faces_of_point(const Unfolded_mesh<FT>& m, const Surface_point<FT>& p, std::vector<int>& out)
{
  typedef Surface_point<FT> Point;
  out.clear();
  if(p.carrier == Point::FACE)
    out.push_back(p.simplex);
  else if(p.carrier == Point::EDGE)
  {
    out.push_back(m.face(p.simplex));
    if(m.opposite[p.simplex] != -1)
      out.push_back(m.face(m.opposite[p.simplex]));
  }
  else
  {
    int h = m.halfedge_of_vertex[p.simplex];
    for(const int first = h; h != -1;)
    {
      out.push_back(m.face(h));
      h = m.next_around_source(h);
      if(h == first)
        break;
    }
  }
}

// The elements of all sources, and which of them lie in which face.
template <typename FT>
class Field_sources
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Surface_point<FT> Point;
  typedef Source_element<FT> Element;

  const std::vector<Element>& elements() const { return m_elements; }

  void clear()
  {
    m_elements.clear();
    m_of_face.clear();
  }

  void add_point(const Mesh& m, const Point& p, const FT& offset, std::size_t source)
  {
    m_elements.push_back(Element{ p, p, false, -1, -1, offset, source });
    faces_of_point(m, p, m_faces);
    if(p.carrier != Point::VERTEX)
      for(int f : m_faces)
        m_of_face.push_back(std::make_pair(f, last()));
  }

  // Adds the segment between two points that lie in one face. Returns false if they do not.
  bool add_segment(const Mesh& m, const Point& p, const Point& q, const FT& offset, std::size_t source)
  {
    faces_of_point(m, p, m_faces);
    std::vector<int> others, common;
    faces_of_point(m, q, others);
    for(int f : m_faces)
      if(std::find(others.begin(), others.end(), f) != others.end())
        common.push_back(f);
    if(common.empty())
      return false;
    const int f = *std::min_element(common.begin(), common.end());
    for(int k = 0; k < 3; ++k)
      if(lies_on(m, 3 * f + k, p) && lies_on(m, 3 * f + k, q))
      {
        add_edge_part(m, 3 * f + k, p, q, offset, source);
        return true;
      }
    const auto a = place_in_face(m, f, p), b = place_in_face(m, f, q);
    if(a == b)
      return true;
    m_elements.push_back(Element{ p, q, true, f, -1, offset, source });
    m_of_face.push_back(std::make_pair(f, last()));
    return true;
  }

  // Adds the part of halfedge h between two points on it.
  void add_edge_part(const Mesh& m, int h, const Point& p, const Point& q, const FT& offset, std::size_t source)
  {
    if(place_on(m, h, p) == place_on(m, h, q))
      return;
    m_elements.push_back(Element{ p, q, true, -1, h, offset, source });
    m_of_face.push_back(std::make_pair(m.face(h), last()));
    if(m.opposite[h] != -1)
      m_of_face.push_back(std::make_pair(m.face(m.opposite[h]), last()));
  }

  // Adds the segments between consecutive points and the points; a closed curve repeats its first point at the end.
  // Returns false if two consecutive points do not lie in one face.
  bool add_polyline(const Mesh& m, const std::vector<Point>& points, const FT& offset, std::size_t source)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const bool is_last_of_closed = i > 0 && i + 1 == points.size() && is_same(m, points[0], points[i]);
      if(!is_last_of_closed)
        add_point(m, points[i], offset, source);
      if(i > 0 && !add_segment(m, points[i - 1], points[i], offset, source))
        return false;
    }
    return true;
  }

  // Adds whole edges, and their ends once.
  void add_edges(const Mesh& m, const std::vector<int>& halfedges, const FT& offset, std::size_t source)
  {
    std::vector<int> ends;
    for(int h : halfedges)
    {
      add_edge_part(m, h, vertex_point(m.source(h)), vertex_point(m.target(h)), offset, source);
      ends.push_back(m.source(h));
      ends.push_back(m.target(h));
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for(int v : ends)
      add_point(m, vertex_point(v), offset, source);
  }

  static Point vertex_point(int v) { return Point{ Point::VERTEX, v, FT(0), FT(0) }; }

  // To be called when all are there.
  void sort() { std::sort(m_of_face.begin(), m_of_face.end()); }

  // The elements that lie in a face or on its edges, as a range of pairs (face, element).
  typedef std::vector<std::pair<int, int>>::const_iterator Iterator;
  std::pair<Iterator, Iterator> elements_in_face(int face) const
  {
    const auto before = [](const std::pair<int, int>& a, const std::pair<int, int>& b) { return a.first < b.first; };
    return std::equal_range(m_of_face.begin(), m_of_face.end(), std::make_pair(face, 0), before);
  }

  static bool lies_on(const Mesh& m, int h, const Point& p)
  {
    if(p.carrier == Point::VERTEX)
      return m.source(h) == p.simplex || m.target(h) == p.simplex;
    return p.carrier == Point::EDGE && m.edge_of[h] == m.edge_of[p.simplex];
  }

  static FT place_on(const Mesh& m, int h, const Point& p)
  {
    if(p.carrier == Point::VERTEX)
      return p.simplex == m.source(h) ? FT(0) : m.length_of(h);
    return p.simplex == h ? p.x : FT(m.length_of(h) - p.x);
  }

  static bool is_same(const Mesh& m, const Point& p, const Point& q)
  {
    if(p.carrier != q.carrier)
      return false;
    if(p.carrier == Point::EDGE)
      return m.edge_of[p.simplex] == m.edge_of[q.simplex] && place_on(m, p.simplex, p) == place_on(m, p.simplex, q);
    return p.simplex == q.simplex && p.x == q.x && p.y == q.y;
  }

private:
  int last() const { return static_cast<int>(m_elements.size()) - 1; }

  std::vector<Element> m_elements;
  std::vector<std::pair<int, int>> m_of_face;
  std::vector<int> m_faces;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_SOURCES_H
