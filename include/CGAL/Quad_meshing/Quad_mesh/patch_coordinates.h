// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_PATCH_COORDINATES_H
#define CGAL_QUAD_MESHING_QUAD_MESH_PATCH_COORDINATES_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingStructureRef

\brief gives the corners of quads coordinates of an integer grid that is continuous within patches.

Each quad is a unit square. Across an edge that is not cut the coordinates go on; the smallest ones of a patch are 0.
With the separatrices of `base_complex()` as cuts, a patch of `n` times `m` quads gets the rectangle from 0 to `n` and
from 0 to `m`. A patch that is closed to a ring has one more edge at which the coordinates are not continuous.

\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsCutMap a model of `ReadablePropertyMap` with the edges as keys and `bool` as value type
\tparam CornerMap a model of `ReadWritePropertyMap` with the halfedges as keys and `std::array<double, 2>` as value type

\param qm the mesh
\param edge_is_cut the edges between patches
\param corner receives the coordinates at the targets of the halfedges of faces

\pre `CGAL::is_quad_mesh(qm)`

\sa `base_complex()`
*/
template <typename QuadMesh, typename EdgeIsCutMap, typename CornerMap>
void patch_coordinates(const QuadMesh& qm, EdgeIsCutMap edge_is_cut, CornerMap corner)
{
  typedef typename boost::graph_traits<QuadMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::face_descriptor face_descriptor;
  typedef std::array<double, 2> Point;

  CGAL_precondition(is_quad_mesh(qm));
  const auto is_reached = get(CGAL::dynamic_face_property_t<bool>(), qm);
  for(face_descriptor f : faces(qm))
    put(is_reached, f, false);
  // The quad to the left of a halfedge whose ends have coordinates.
  auto lay_out = [&](halfedge_descriptor h, const Point& p, const Point& q)
  {
    const Point left = { { p[1] - q[1], q[0] - p[0] } };
    put(corner, prev(h, qm), p);
    put(corner, h, q);
    put(corner, next(h, qm), Point{ { q[0] + left[0], q[1] + left[1] } });
    put(corner, next(next(h, qm), qm), Point{ { p[0] + left[0], p[1] + left[1] } });
    put(is_reached, face(h, qm), true);
  };
  for(face_descriptor first : faces(qm))
  {
    if(get(is_reached, first))
      continue;
    lay_out(halfedge(first, qm), Point{ { 0, 0 } }, Point{ { 1, 0 } });
    std::vector<face_descriptor> patch(1, first);
    for(std::size_t i = 0; i < patch.size(); ++i)
      for(halfedge_descriptor h : halfedges_around_face(halfedge(patch[i], qm), qm))
      {
        const halfedge_descriptor o = opposite(h, qm);
        if(is_border(o, qm) || get(is_reached, face(o, qm)) || get(edge_is_cut, edge(h, qm)))
          continue;
        lay_out(o, get(corner, h), get(corner, prev(h, qm)));
        patch.push_back(face(o, qm));
      }
    Point low = get(corner, halfedge(first, qm));
    for(int pass = 0; pass < 2; ++pass)
      for(face_descriptor f : patch)
        for(halfedge_descriptor h : halfedges_around_face(halfedge(f, qm), qm))
        {
          const Point p = get(corner, h);
          if(pass == 0)
            low = { { (std::min)(low[0], p[0]), (std::min)(low[1], p[1]) } };
          else
            put(corner, h, Point{ { p[0] - low[0], p[1] - low[1] } });
        }
  }
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_PATCH_COORDINATES_H
