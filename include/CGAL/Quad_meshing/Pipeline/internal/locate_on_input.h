// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Where the vertices of a quad mesh lie on the triangle mesh that the quadrangulation started from.
template <typename TriangleMesh>
class Input_locator
{
public:
  typedef Quadrangulation::Mesh Mesh;
  typedef Quadrangulation::Kernel::Point_3 Point_3;
  // as Polygon_mesh_processing::Face_location<TriangleMesh, double>
  typedef std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3> > Location;

  template <typename VertexPointMap>
  Input_locator(const TriangleMesh& tm, VertexPointMap vpm, const Quadrangulation& q)
    : q(q)
  {
    for(auto f : faces(tm))
    {
      input_faces.push_back(f);
      const auto h = halfedge(f, tm);
      std::array<Point_3, 3> p;
      const auto corners = { source(h, tm), target(h, tm), target(next(h, tm), tm) };
      std::transform(corners.begin(), corners.end(), p.begin(), [&](auto v)
      {
        const auto& x = get(vpm, v);
        return Point_3(to_double(x.x()), to_double(x.y()), to_double(x.z()));
      });
      points.push_back(p);
    }
  }

  Location operator()(Mesh::Vertex_index v) const
  {
    const Quadrangulation::Location& location = q.quads().location[v];
    const Mesh& mesh = q.surface().mesh;
    const Mesh::Halfedge_index h = mesh.halfedge(location.first);
    const Point_3 p = CGAL::barycenter(mesh.point(mesh.source(h)), location.second[0], mesh.point(mesh.target(h)), location.second[1],
                                       mesh.point(mesh.target(mesh.next(h))), location.second[2]);
    const std::size_t i = q.surface().origin[location.first];
    return Location(input_faces[i], weights(p, points[i]));
  }

private:
  const Quadrangulation& q;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> input_faces;
  std::vector<std::array<Point_3, 3> > points; // per input face

  // Barycentric weights of a point of the triangle; of the nearest corner if the triangle has no area.
  static std::array<double, 3> weights(const Point_3& p, const std::array<Point_3, 3>& t)
  {
    const auto n = cross_product(t[1] - t[0], t[2] - t[0]);
    const double area = n * n;
    std::array<double, 3> w = {{ 0, 0, 0 }};
    if(!(area > 0))
    {
      int nearest = 0;
      for(int k = 1; k < 3; ++k)
        if(squared_distance(p, t[k]) < squared_distance(p, t[nearest]))
          nearest = k;
      w[nearest] = 1;
      return w;
    }
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      w[k] = (std::max)(0., (cross_product(t[(k + 1) % 3] - p, t[(k + 2) % 3] - p) * n) / area);
      sum += w[k];
    }
    for(double& x : w)
      x /= sum;
    return w;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H
