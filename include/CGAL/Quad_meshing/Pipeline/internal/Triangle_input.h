// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_TRIANGLE_INPUT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_TRIANGLE_INPUT_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a quadrangulation starts from, in flat arrays. Faces have the numbers that they have in `faces(tm)`.
//
// Corner k of a triangle is the source of the k-th halfedge from `halfedge(f, tm)` on; side k runs from corner k to k
// + 1.
struct Triangle_input
{
  std::vector<Quadrangulation_kernel::Point_3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<char, 3>> is_feature; // per triangle and side; empty: to be detected
  std::vector<std::optional<Quadrangulation_kernel::Vector_3>> directions; // per triangle; empty: none is given
  std::vector<double> face_lengths;   // per triangle: of quad edges, 0 or less: no wish; empty: none is given
  std::vector<double> vertex_lengths; // per point: the same

  // Sides that become chains of quad edges besides those that are features: marked by the user, or along curves of the
  // user that the triangles were cut along.
  std::vector<std::array<char, 3>> is_curve; // per triangle and side; empty: there are no curves
  std::vector<std::size_t> origin;           // per triangle: its number before the cut; empty: the same

  std::size_t original(std::size_t triangle) const { return origin.empty() ? triangle : origin[triangle]; }

  bool has_features() const { return !is_feature.empty(); }
};

template <typename TriangleMesh, typename VertexPointMap>
Triangle_input triangle_input(const TriangleMesh& tm, VertexPointMap vpm)
{
  Triangle_input input;
  std::unordered_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, int> numbers;
  for(auto v : vertices(tm))
  {
    numbers.emplace(v, static_cast<int>(input.points.size()));
    const auto& p = get(vpm, v);
    input.points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  for(auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    input.triangles.push_back({ { numbers[source(h, tm)], numbers[target(h, tm)], numbers[target(next(h, tm), tm)] } });
  }
  return input;
}

// The sides of the triangles on marked edges. Border edges are features in their own right.
template <typename TriangleMesh, typename EdgeIsMarkedMap>
std::vector<std::array<char, 3>> marked_sides(const TriangleMesh& tm, EdgeIsMarkedMap is_marked)
{
  std::vector<std::array<char, 3>> result;
  for(auto f : faces(tm))
  {
    std::array<char, 3> sides;
    auto h = halfedge(f, tm);
    for(int k = 0; k < 3; ++k, h = next(h, tm))
    {
      const auto e = edge(h, tm);
      sides[k] = get(is_marked, e) && !is_border(e, tm);
    }
    result.push_back(sides);
  }
  return result;
}

template <typename TriangleMesh, typename FaceSizingMap>
void set_face_lengths(const TriangleMesh& tm, FaceSizingMap length, Triangle_input& input)
{
  input.face_lengths.clear();
  for(auto f : faces(tm))
    input.face_lengths.push_back(to_double(get(length, f)));
}

template <typename TriangleMesh, typename VertexSizingMap>
void set_vertex_lengths(const TriangleMesh& tm, VertexSizingMap length, Triangle_input& input)
{
  input.vertex_lengths.clear();
  for(auto v : vertices(tm))
    input.vertex_lengths.push_back(to_double(get(length, v)));
}

template <typename TriangleMesh, typename FaceDirectionMap>
void set_directions(const TriangleMesh& tm, FaceDirectionMap direction, Triangle_input& input)
{
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  input.directions.clear();
  for(auto f : faces(tm))
  {
    const auto d = get(direction, f);
    input.directions.push_back(d ? std::make_optional(Vector_3(to_double(d->x()), to_double(d->y()), to_double(d->z())))
                                 : std::nullopt);
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_TRIANGLE_INPUT_H
