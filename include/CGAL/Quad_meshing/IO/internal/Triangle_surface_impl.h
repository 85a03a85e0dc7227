// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/Border_junctions.h>
#include <CGAL/Quad_meshing/IO/internal/Copied_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/Sheets.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_places.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/Surface_vertices.h>
#include <CGAL/Quad_meshing/IO/internal/Triangle_surface.h>
#include <CGAL/Quad_meshing/IO/internal/find_cracks.h>
#include <CGAL/Quad_meshing/IO/internal/flatten_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/read_soup_file.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>
#include <CGAL/Quad_meshing/IO/internal/triangulate_polygon.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes a surface of the polygons of a file: each repair that is switched on, in the order of Mesh_repairs.
class Surface_maker
{
  Polygon_soup& m_soup;
  const Mesh_repairs& m_repairs;
  Triangle_surface& m_surface;
  Mesh_reading_result& m_result;
  Soup_size m_size;
  Flatness m_is_flat;
  Soup_triangles m_triangles;
  std::vector<std::array<Soup_index, 2>> m_diagonals; // pairs of sides that cut a polygon
  std::vector<Soup_index> m_partner;
  std::vector<Soup_index> m_copies;    // pairs of polygons of the file: a copy, and the one that stays for it
  std::vector<char> m_is_named;        // per vertex of the file: whether a face names it
  std::vector<Soup_index> m_vertex_of; // per vertex of the file: the one that stands for it
  std::vector<Soup_index> m_origin;    // of vertices that were added
  std::optional<Side_groups> m_groups; // the sides of the triangles
  std::size_t m_number_of_file_vertices, m_number_of_file_faces, m_number_of_lines, m_number_of_points;

public:
  Surface_maker(Polygon_soup& soup, const Mesh_repairs& repairs, Triangle_surface& surface, Mesh_reading_result& result)
    : m_soup(soup)
    , m_repairs(repairs)
    , m_surface(surface)
    , m_result(result)
    , m_size(soup.points)
    , m_is_flat(m_size, soup.rounding_unit)
    , m_number_of_file_vertices(soup.points.size())
    , m_number_of_file_faces(soup.size())
    , m_number_of_lines(soup.number_of_lines)
    , m_number_of_points(soup.number_of_points)
  {
  }

  bool operator()()
  {
    find_places();
    if(!make_triangles() || !flatten())
      return false;
    group_sides();
    if(m_repairs.drop_copies && may_have_copies())
      drop_copies();
    if(m_repairs.merge_vertices)
      split_border_sides();
    Sheets sheets(m_triangles, m_repairs);
    if(!sheets(m_diagonals, *m_groups, m_result))
      return false;
    m_groups.reset();
    m_partner.swap(sheets.partners());
    m_result.counts.reversed_faces = sheets.reversed_faces;
    m_result.counts.separated_edges = sheets.number_of_fans();
    if(!make_vertices(sheets.joins_places))
      return false;
    number_vertices();
    number_faces();
    count_defects();
    describe();
    return true;
  }

private:
  bool refuse(Mesh_reading_status status, const std::string& message)
  {
    m_result.status = status;
    m_result.message = message;
    return false;
  }

  void find_places()
  {
    if(!m_repairs.merge_vertices)
      return;
    Soup_places places(m_soup, m_repairs.merging_distance);
    if(!places.is_trivial())
      m_triangles.place = std::move(places.numbers());
  }

  Soup_index place(Soup_index v) const { return m_triangles.place.empty() ? v : m_triangles.place[v]; }

  // Leaves out what a cycle of corners says twice: neighbors at one place, and antennas (a b a becomes a).
  void simplify(std::vector<Soup_index>& cycle) const
  {
    auto is_same = [&](std::size_t i, std::size_t j) { return place(cycle[i]) == place(cycle[j]); };
    std::size_t n = 0; // what is left, as a path
    for(std::size_t i = 0; i < cycle.size(); ++i)
    {
      if(n >= 2 && is_same(n - 2, i))
        --n;
      else if(n == 0 || !is_same(n - 1, i))
        cycle[n++] = cycle[i];
    }
    // and across its ends
    std::size_t first = 0;
    while(n >= first + 2)
    {
      if(is_same(first, n - 1))
        --n;
      else if(n >= first + 3 && is_same(first + 1, n - 1))
        ++first;
      else if(n >= first + 3 && is_same(first, n - 2))
        --n;
      else
        break;
    }
    cycle.resize(n);
    cycle.erase(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(first));
  }

  bool has_distinct_corners(std::size_t f) const
  {
    const Soup_index* v = m_soup.begin(f);
    return m_soup.size(f) == 3 && place(v[0]) != place(v[1]) && place(v[1]) != place(v[2]) &&
           place(v[2]) != place(v[0]);
  }

  // The polygons of the soup become triangles; shapeless ones and copies are left out.
  bool make_triangles()
  {
    const std::size_t n = m_soup.size();
    m_is_named.assign(m_soup.points.size(), 0);
    for(Soup_index v : m_soup.corners)
      m_is_named[v] = 1;
    bool is_plain = true; // triangles with distinct corners only
    for(std::size_t f = 0; f < n && is_plain; ++f)
      is_plain = has_distinct_corners(f);

    std::vector<Soup_index> face_of; // of the simplified polygons; empty: the same
    if(!is_plain)
    {
      Polygon_soup simple;
      std::vector<Soup_index> cycle;
      for(std::size_t f = 0; f < n; ++f)
      {
        cycle.assign(m_soup.begin(f), m_soup.end(f));
        simplify(cycle);
        if(cycle.size() < 3)
        {
          ++m_result.counts.shapeless_faces;
          continue;
        }
        simple.corners.insert(simple.corners.end(), cycle.begin(), cycle.end());
        simple.end_polygon();
        face_of.push_back(static_cast<Soup_index>(f));
      }
      m_soup.corners.swap(simple.corners);
      m_soup.first_corner.swap(simple.first_corner);
      if(m_result.counts.shapeless_faces > 0 && !m_repairs.drop_copies)
        return refuse(Mesh_reading_status::NEEDS_REPAIR,
                      faces_have(m_result.counts.shapeless_faces) + " fewer than three distinct vertices.");
    }
    m_triangles.points.swap(m_soup.points);
    if(m_soup.size() == 0)
      return refuse(Mesh_reading_status::NO_FACES, "No face has three distinct vertices.");

    auto file_face = [&](std::size_t f) { return face_of.empty() ? static_cast<Soup_index>(f) : face_of[f]; };
    m_triangles.corners.reserve(m_soup.size());
    m_triangles.file_face.reserve(m_soup.size());
    Polygon_triangulator triangulate;
    std::vector<Soup_vector> corners;
    for(std::size_t f = 0; f < m_soup.size(); ++f)
    {
      const Soup_index* const v = m_soup.begin(f);
      if(m_soup.size(f) == 3)
      {
        m_triangles.add({ { v[0], v[1], v[2] } }, file_face(f), no_index);
        continue;
      }
      ++m_result.counts.triangulated_polygons;
      // Copies of a polygon are cut alike, wherever they begin and in both directions.
      std::vector<Soup_index> cycle(v, v + m_soup.size(f));
      auto is_at_smaller_place = [&](Soup_index a, Soup_index b) { return place(a) < place(b); };
      std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end(), is_at_smaller_place), cycle.end());
      const bool is_reversed = is_at_smaller_place(cycle.back(), cycle[1]);
      if(is_reversed)
        std::reverse(cycle.begin() + 1, cycle.end());
      corners.clear();
      for(Soup_index a : cycle)
        corners.push_back(m_triangles.points[a]);
      add_polygon(cycle, triangulate(corners), is_reversed, file_face(f));
    }
    m_soup = Polygon_soup();
    return true;
  }

  void add_polygon(const std::vector<Soup_index>& v, const std::vector<std::array<std::size_t, 3>>& triangles,
                   bool is_reversed, Soup_index face)
  {
    std::vector<std::pair<std::array<std::size_t, 2>, Soup_index>> sides; // positions in the polygon, side
    for(std::array<std::size_t, 3> t : triangles)
    {
      if(is_reversed)
        std::swap(t[0], t[2]);
      const std::array<Soup_index, 3> c = { { v[t[0]], v[t[1]], v[t[2]] } };
      // A polygon that touches itself has corners at one place.
      if(place(c[0]) == place(c[1]) || place(c[1]) == place(c[2]) || place(c[2]) == place(c[0]))
        continue;
      for(std::size_t k = 0; k < 3; ++k)
        sides.push_back({ { { (std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3]) } },
                          static_cast<Soup_index>(m_triangles.number_of_sides() + k) });
      m_triangles.add(c, face, no_index);
    }
    std::sort(sides.begin(), sides.end());
    for(std::size_t i = 0; i + 1 < sides.size(); ++i)
      if(sides[i].first == sides[i + 1].first)
        m_diagonals.push_back({ { sides[i].second, sides[i + 1].second } });
  }

  static std::string faces_have(std::size_t n)
  {
    return "There " + std::string(n == 1 ? "is " : "are ") + count_of(n, "face", "faces") + " with";
  }

  void group_sides()
  {
    m_groups.emplace(
      m_triangles.number_of_sides(), m_triangles.points.size(), [&](std::size_t s) { return m_triangles.source(s); },
      [&](std::size_t s) { return m_triangles.target(s); });
  }

  // Whether two triangles may have the same corners. That takes an edge with more than two triangles, or two triangles
  // at an edge with the same third corner.
  bool may_have_copies() const
  {
    if(!m_triangles.place.empty())
      return true; // the groups are those of vertices, not of places
    bool result = false;
    m_groups->for_each(
      [&](Soup_index, Soup_index, const std::vector<Soup_index>& sides)
      {
        result = result || sides.size() > 2 ||
                 (sides.size() == 2 && m_triangles.source(Soup_triangles::previous(sides[0])) ==
                                         m_triangles.source(Soup_triangles::previous(sides[1])));
      });
    return result;
  }

  void drop_copies()
  {
    Copied_triangles copies(m_triangles, m_size);
    if(!copies())
      return;
    // Faces are counted, not their triangles.
    std::vector<char> is_counted(m_number_of_file_faces, 0);
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
    {
      const Soup_index face = m_triangles.file_face[f];
      if(copies.other_side(f) != no_index)
        m_triangles.set_other_side(f, m_triangles.file_face[copies.other_side(f)]);
      if(!copies.is_dropped(f))
        continue;
      if(!copies.is_in_fin(f))
        m_copies.insert(m_copies.end(), { face, m_triangles.file_face[copies.stays_for(f)] });
      if(is_counted[face])
        continue;
      is_counted[face] = 1;
      if(copies.is_in_fin(f))
        ++m_result.counts.fin_faces;
      else
      {
        ++m_result.counts.copied_faces;
        m_result.counts.other_sides += copies.is_other_side(f);
      }
    }
    m_triangles.keep_if([&](std::size_t f) { return !copies.is_dropped(f); });
    m_diagonals.clear(); // sides have other numbers now
    group_sides();
  }

  void split_border_sides()
  {
    Border_junctions junctions(m_triangles, m_repairs.merging_distance * m_size.diagonal);
    if(!junctions(*m_groups))
      return;
    m_result.counts.split_border_edges = junctions.number_split;
    m_diagonals.clear(); // sides have other numbers now
    group_sides();
  }

  bool flatten()
  {
    Flat_triangles flat(m_triangles, m_is_flat);
    const std::size_t number = flat.find().size();
    m_may_be_flat = number > 0 || !m_triangles.place.empty();
    if(number == m_triangles.size())
      return refuse(Mesh_reading_status::NO_FACES, "No face has an area.");
    if(number == 0 || !m_repairs.flatten_faces)
      return true;
    flat();
    m_result.counts.flattened_faces = flat.number_removed;
    m_diagonals.clear(); // sides have other numbers now
    return true;
  }

  bool make_vertices(bool joins_places)
  {
    Surface_vertices vertices(m_triangles, m_partner);
    vertices();
    Mesh_repair_counts& counts = m_result.counts;
    counts.split_vertices = vertices.number_split;
    if(vertices.number_split > 0 && !m_repairs.separate_sheets)
      return refuse(Mesh_reading_status::NEEDS_REPAIR,
                    "There " + std::string(vertices.number_split == 1 ? "is " : "are ") +
                      count_of(vertices.number_split, "vertex", "vertices") + " at which the surface touches itself.");
    m_vertex_of = vertices.vertex_of();
    m_origin = vertices.origin();
    if(joins_places || counts.separated_edges > 0 || counts.triangulated_polygons > 0 || counts.flattened_faces > 0 ||
       counts.split_border_edges > 0)
      vertices.separate_double_edges();

    if(m_triangles.place.empty())
      return true;
    // Vertices of faces that were dropped are one with what stays at their place.
    std::vector<Soup_index> vertex_at(m_triangles.points.size(), no_index);
    for(std::size_t v = 0; v < m_number_of_file_vertices; ++v)
      if(m_vertex_of[v] != no_index && vertex_at[place(static_cast<Soup_index>(v))] == no_index)
        vertex_at[place(static_cast<Soup_index>(v))] = m_vertex_of[v];
    for(std::size_t v = 0; v < m_number_of_file_vertices; ++v)
    {
      if(m_is_named[v] && m_vertex_of[v] == no_index)
        m_vertex_of[v] = vertex_at[place(static_cast<Soup_index>(v))];
      counts.merged_vertices += m_vertex_of[v] != no_index && m_vertex_of[v] != v;
    }
    return true;
  }

  // Vertices keep the order of the file; inserted ones come last.
  void number_vertices()
  {
    const std::size_t n = m_triangles.points.size(), nf = m_number_of_file_vertices;
    std::vector<Soup_index> mesh_number(n, no_index), file_number;
    for(const auto& triangle : m_triangles.corners)
      for(Soup_index v : triangle)
        mesh_number[v] = 0;
    for(std::size_t v = 0; v < nf; ++v)
      if(m_vertex_of[v] == no_index)
      {
        if(m_repairs.drop_unused_vertices)
          ++m_result.counts.unused_vertices;
        else
          mesh_number[v] = 0;
      }
    Soup_index number = 0;
    for(std::size_t v = 0; v < n; ++v)
    {
      if(mesh_number[v] == no_index)
        continue;
      mesh_number[v] = number;
      m_triangles.points[number] = m_triangles.points[v];
      file_number.push_back(v < nf                     ? static_cast<Soup_index>(v)
                            : v - nf < m_origin.size() ? m_origin[v - nf]
                                                       : no_index);
      ++number;
    }
    m_triangles.points.resize(number);
    for(auto& triangle : m_triangles.corners)
      for(Soup_index& v : triangle)
        v = mesh_number[v];
    for(std::size_t v = 0; v < nf; ++v)
      if(m_vertex_of[v] != no_index)
        mesh_number[v] = mesh_number[m_vertex_of[v]];
    mesh_number.resize(nf);
    m_surface.points.swap(m_triangles.points);
    m_surface.triangles.swap(m_triangles.corners);
    m_surface.opposite.swap(m_partner);
    m_result.vertices = File_numbers(std::move(file_number), std::move(mesh_number));
  }

  void number_faces()
  {
    std::vector<Soup_index> mesh_number(m_number_of_file_faces, no_index);
    for(std::size_t f = m_triangles.file_face.size(); f-- > 0;)
      mesh_number[m_triangles.file_face[f]] = static_cast<Soup_index>(f);
    // The copy that stays may be known by the number of its other side.
    for(int pass = 0; pass < 2; ++pass)
      for(std::size_t i = 0; i < m_copies.size(); i += 2)
      {
        Soup_index &copy = mesh_number[m_copies[i]], &original = mesh_number[m_copies[i + 1]];
        if(copy == no_index)
          copy = original;
        else if(original == no_index)
          original = copy;
      }
    m_result.faces = File_numbers(std::move(m_triangles.file_face), std::move(mesh_number));
  }

  void count_defects()
  {
    int longest = 0;
    const std::vector<Polygon_soup::Point>& p = m_surface.points;
    for(std::size_t f = 0; f < m_surface.triangles.size() && m_may_be_flat; ++f)
    {
      const auto& t = m_surface.triangles[f];
      m_result.number_of_degenerate_faces += m_is_flat(p[t[0]], p[t[1]], p[t[2]], longest);
    }
    const Cracks cracks = find_cracks(m_surface, m_size.diagonal);
    m_result.number_of_crack_edges = cracks.number_of_edges;
    m_crack_width = cracks.width;
  }

  bool m_may_be_flat = true; // whether the mesh may have triangles of zero area
  double m_crack_width = 0;

  // A sentence about n things that were changed; `what` follows the verb.
  void say(std::size_t n, const char* singular, const char* plural, const std::string& which, const std::string& what)
  {
    if(n > 0)
      m_result.repairs.push_back(count_of(n, singular, plural) + which + (n == 1 ? " was " : " were ") + what + ".");
  }

  void describe()
  {
    const Mesh_repair_counts& c = m_result.counts;
    say(c.unused_vertices, "vertex", "vertices", " without a face", "dropped");
    say(c.merged_vertices, "vertex", "vertices", " at the place of another one", "merged with it");
    say(c.split_border_edges, "border edge", "border edges", " on which other vertices of the border lie",
        "split there");
    say(c.shapeless_faces, "face", "faces", " with fewer than three distinct vertices", "dropped");
    say(c.copied_faces - c.other_sides, "face", "faces", " equal to another one", "dropped");
    say(c.other_sides, "face", "faces",
        " that " + std::string(c.other_sides == 1 ? "is" : "are") + " the other side of another one", "dropped");
    say(c.fin_faces, "face", "faces", " of fins without volume", "dropped");
    say(c.triangulated_polygons, "polygon", "polygons", "", "triangulated");
    say(c.flattened_faces, "triangle", "triangles", " of zero area", "removed");
    say(c.reversed_faces, "face", "faces", "", "reversed to orient the surface consistently");
    say(c.separated_edges, "edge", "edges", " with more than two faces",
        "separated into sheets, which fit together once they are meshed only if they are made to");
    say(c.split_vertices, "vertex", "vertices", " at which the surface touches itself", "split");
    say(m_number_of_lines, "line element", "line elements", "", "passed over");
    say(m_number_of_points, "point element", "point elements", "", "passed over");
    if(m_result.number_of_degenerate_faces > 0)
      m_result.repairs.push_back(count_of(m_result.number_of_degenerate_faces, "triangle", "triangles") +
                                 " of zero area " + (m_result.number_of_degenerate_faces == 1 ? "is" : "are") +
                                 " left.");
    if(m_result.number_of_crack_edges > 0)
    {
      std::ostringstream width;
      width.imbue(std::locale::classic());
      width.precision(2);
      width << m_crack_width;
      m_result.repairs.push_back(count_of(m_result.number_of_crack_edges, "border edge", "border edges") +
                                 (m_result.number_of_crack_edges == 1 ? " runs" : " run") +
                                 " along another one, up to " + width.str() +
                                 " apart: the surface may have cracks there.");
    }
  }
};

CGAL_QUAD_MESHING_INLINE bool read_triangle_surface(const std::string& filename, const Mesh_repairs& repairs,
                                                    Triangle_surface& surface, Mesh_reading_result& result)
{
  Polygon_soup soup;
  return read_soup_file(filename, soup, result) && Surface_maker(soup, repairs, surface, result)();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_IMPL_H
