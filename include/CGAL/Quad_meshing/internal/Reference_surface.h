// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_REFERENCE_SURFACE_H
#define CGAL_QUAD_MESHING_INTERNAL_REFERENCE_SURFACE_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/closest_in_triangle.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A triangle surface onto which points are projected.
//
// `locate()` finds the closest point of the whole surface by an AABB tree. `walk()` goes downhill
// over neighbouring triangles from where the point was before: it takes a handful of triangle
// tests, and unlike a global search it cannot jump to the other side of a thin part.
class Reference_surface
{
public:
  typedef Simple_cartesian<double> Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;
  typedef Kernel::Triangle_3 Triangle_3;

  struct Location
  {
    int face;
    Point_3 point;
  };

  explicit Reference_surface(Indexed_triangle_mesh mesh) : m_mesh(std::move(mesh)), m_normals(m_mesh.corners.size())
  {
    for(std::size_t f = 0; f < m_normals.size(); ++f)
    {
      const Triangle_3 t = triangle(static_cast<int>(f));
      m_normals[f] = unit_or_zero(cross_product(t[1] - t[0], t[2] - t[0]));
    }
  }

  const Indexed_triangle_mesh& mesh() const { return m_mesh; }
  const Vector_3& normal(int face) const { return m_normals[face]; }

  // Whether there is nothing to project onto.
  bool empty() const
  {
    return std::all_of(m_normals.begin(), m_normals.end(), [](const Vector_3& n) { return n == NULL_VECTOR; });
  }

  Triangle_3 triangle(int f) const
  {
    const std::array<int, 3>& c = m_mesh.corners[f];
    return Triangle_3(m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]]);
  }

  // The closest point of all. The search is fast if the walk from `hint`, the place of a point
  // nearby, ends close to it; -1 if no place is known.
  Location locate(const Point_3& query, int hint)
  {
    if(m_tree == nullptr)
      build_tree();
    if(hint == -1)
      hint = m_first_face;
    const Location close = walk(query, hint);
    const auto closest = m_tree->closest_point_and_primitive(query, std::make_pair(close.point, close.face));
    return Location{ closest.second, closest.first };
  }

  // The place of a point that is at most so far from the surface, by a walk from a place of a point nearby. A walk can
  // end at a corner that hides the rest of the surface: only then it is the closest point of all.
  Location follow(const Point_3& query, int start, double largest_distance)
  {
    const Location place = walk(query, start);
    return squared_distance(place.point, query) <= largest_distance * largest_distance ? place
                                                                                       : locate(query, place.face);
  }

  Location walk(const Point_3& query, int start) const
  {
    Location best{ start, Point_3() };
    int entity = closest_in_triangle(query, start, best.point);
    double distance = squared_distance(query, best.point);
    while(entity != Place_in_triangle::inside)
    {
      // across the side, or anywhere around the corner, that the closest point lies on
      Location better = best;
      double better_distance = distance;
      int better_entity = Place_in_triangle::inside;
      auto test = [&](int f)
      {
        Point_3 p;
        const int where = closest_in_triangle(query, f, p);
        const double d = squared_distance(query, p);
        if(d < better_distance)
        {
          better = Location{ f, p };
          better_distance = d;
          better_entity = where;
        }
      };
      if(entity < Place_in_triangle::first_corner)
      {
        const int o = m_mesh.opposite[3 * best.face + entity];
        if(o != -1)
          test(o / 3);
      }
      else
      {
        const int first = 3 * best.face + entity - Place_in_triangle::first_corner;
        int h = first;
        for(int turn = 0; turn < 2; ++turn)
        {
          h = first;
          while((h = turn == 0 ? m_mesh.next_around_source(h) : m_mesh.previous_around_source(h)) != -1 && h != first)
            test(h / 3);
          if(h == first)
            break;
        }
      }
      if(!(better_distance < distance))
        break;
      best = better;
      distance = better_distance;
      entity = better_entity;
    }
    return best;
  }

private:
  int closest_in_triangle(const Point_3& p, int f, Point_3& closest) const
  {
    const std::array<int, 3>& c = m_mesh.corners[f];
    return internal::closest_in_triangle(p, m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]], closest);
  }

  struct Primitive
  {
    typedef int Id;
    typedef Point_3 Point;
    typedef Triangle_3 Datum;

    Primitive(std::vector<int>::const_iterator f, const Reference_surface* surface) : face(*f), surface(surface) {}

    int face;
    const Reference_surface* surface;

    Id id() const { return face; }
    Datum datum() const { return surface->triangle(face); }
    Point reference_point() const { return surface->m_mesh.points[surface->m_mesh.corners[face][0]]; }
  };
  typedef AABB_tree<Aabb_traits<Kernel, Primitive>> Tree;

  void build_tree()
  {
    std::vector<int> faces;
    faces.reserve(m_mesh.corners.size());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_normals[f] != NULL_VECTOR)
        faces.push_back(f);
    m_tree.reset(new Tree(faces.cbegin(), faces.cend(), static_cast<const Reference_surface*>(this)));
    // the points of a walk are better hints than those of a search tree, and cost nothing to build
    m_tree->do_not_accelerate_distance_queries();
    m_tree->build();
    m_first_face = faces.front();
  }

  Indexed_triangle_mesh m_mesh;
  std::vector<Vector_3> m_normals; // per face: unit, zero if it has no area
  std::unique_ptr<Tree> m_tree;    // built at the first call of locate()
  int m_first_face = -1;           // a face that has area

public:
  // The tree points back to this object.
  Reference_surface(const Reference_surface&) = delete;
  Reference_surface& operator=(const Reference_surface&) = delete;
};

// The triangles that two corners of each quad cut off by the diagonal from corner 0: the surface of
// a quad mesh as a reference for itself.
inline Indexed_triangle_mesh triangulated_quad_mesh(const Indexed_quad_mesh& qm)
{
  Indexed_triangle_mesh tm;
  tm.points = qm.points;
  const int nf = qm.number_of_faces();
  tm.corners.resize(2 * nf);
  tm.opposite.assign(6 * nf, -1);
  // halfedge k of face f becomes this one; 6*f+2 and 6*f+3 are the diagonal
  auto image = [](int h)
  {
    const int k = h & 3;
    return 6 * (h / 4) + (k < 2 ? k : k + 2);
  };
  for(int f = 0; f < nf; ++f)
  {
    const std::array<int, 4>& c = qm.corners[f];
    tm.corners[2 * f] = { { c[0], c[1], c[2] } };
    tm.corners[2 * f + 1] = { { c[0], c[2], c[3] } };
    tm.opposite[6 * f + 2] = 6 * f + 3;
    tm.opposite[6 * f + 3] = 6 * f + 2;
    for(int h = 4 * f; h < 4 * f + 4; ++h)
      if(qm.opposite[h] != -1)
        tm.opposite[image(h)] = image(qm.opposite[h]);
  }
  return tm;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_REFERENCE_SURFACE_H
