// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_LAYERS_IMPL_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_LAYERS_IMPL_H

#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline Scene_layer layer_of_marks(const std::string& name, const std::string& group, Scene_layer_kind kind,
                                  Scene_side side)
{
  Scene_layer layer;
  layer.name = name;
  layer.group = group;
  layer.kind = kind;
  layer.side = side;
  return layer;
}

inline Scene_numbers named_numbers(const std::string& name, const std::string& unit,
                                   Scene_color_scale scale = Scene_color_scale::SEQUENCE)
{
  Scene_numbers numbers;
  numbers.name = name;
  numbers.unit = unit;
  numbers.scale = scale;
  return numbers;
}

// The quads with all that is measured on each of them.
inline Scene_layer layer_of_quads(const Indexed_quad_mesh& m, const Base_complex_of_quad_mesh& bc,
                                  const std::string& group)
{
  Scene_layer layer = layer_of_marks("quads", group, Scene_layer_kind::FACES, Scene_side::RIGHT);
  for(const Indexed_quad_mesh::Point_3& p : m.points)
    layer.add_point(coordinates(p));
  Scene_numbers jacobian = named_numbers("scaled Jacobian", ""),
                angle = named_numbers("largest angle off 90", "degrees"),
                length = named_numbers("mean edge length", ""), aspect = named_numbers("aspect ratio", ""),
                planarity = named_numbers("gap of the diagonals over side", ""),
                patch = named_numbers("patch of the base complex", "", Scene_color_scale::CATEGORIES);
  // light: a square
  jacobian.low = 0;
  jacobian.high = 1;
  angle.low = 45;
  angle.high = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    const std::array<int, 4>& c = m.corners[f];
    layer.add_element(c);
    const Quad_shape shape = shape_of_quad({ { m.points[c[0]], m.points[c[1]], m.points[c[2]], m.points[c[3]] } });
    double off = 0, sum = 0;
    for(int k = 0; k < 4; ++k)
    {
      off = (std::max)(off, std::abs(shape.angle[k] - 90));
      sum += shape.length[k];
    }
    jacobian.values.push_back(shape.minimal_scaled_jacobian());
    angle.values.push_back(off);
    length.values.push_back(sum / 4);
    aspect.values.push_back(shape.aspect_ratio());
    planarity.values.push_back(shape.planarity);
    patch.values.push_back(bc.patch[f]);
  }
  layer.numbers = { jacobian, angle, length, aspect, planarity, patch };
  layer.colored_by = 0;
  return layer;
}

// Index 1 stands for one edge less than in a grid, as in Quad_mesh_structure::sum_of_indices.
inline Scene_layer layer_of_irregular_vertices(const Indexed_quad_mesh& m, const std::string& group)
{
  Scene_layer layer = layer_of_marks("irregular vertices", group, Scene_layer_kind::POINTS, Scene_side::RIGHT);
  Scene_numbers index = named_numbers("index", "quarters", Scene_color_scale::SIGNED),
                valence = named_numbers("valence", "edges"), vertex = named_numbers("vertex", "");
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    const int edges = m.valence(v), regular = m.is_border_vertex(v) ? 3 : 4;
    if(edges == 0 || edges == regular)
      continue;
    layer.add_element(std::array<std::size_t, 1>{ { layer.add_point(coordinates(m.points[v])) } });
    index.values.push_back(regular - edges);
    valence.values.push_back(edges);
    vertex.values.push_back(v);
  }
  layer.numbers = { index, valence, vertex };
  layer.colored_by = 0;
  return layer;
}

inline Scene_layer layer_of_separatrices(const Indexed_quad_mesh& m, const Base_complex_of_quad_mesh& bc,
                                         const std::string& group)
{
  Scene_layer layer = layer_of_marks("base complex", group, Scene_layer_kind::LINES, Scene_side::RIGHT);
  layer.color = "#d07000";
  layer.is_visible = false;
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.edge(h) == h && bc.is_separatrix[h])
    {
      const std::size_t p = layer.add_point(coordinates(m.points[m.source(h)]));
      const std::size_t q = layer.add_point(coordinates(m.points[m.target(h)]));
      layer.add_element(std::array<std::size_t, 2>{ { p, q } });
    }
  return layer;
}

template <std::size_t N>
Scene_histogram histogram_of(const std::string& name, const std::string& unit, double low, double high,
                             const std::array<std::size_t, N>& counts)
{
  Scene_histogram h;
  h.name = name;
  h.unit = unit;
  h.low = low;
  h.high = high;
  h.counts.assign(counts.begin(), counts.end());
  return h;
}

CGAL_QUAD_MESHING_INLINE void add_layers_of_quads(Scene& scene, const Indexed_quad_mesh& m, const std::string& group)
{
  const Base_complex_of_quad_mesh bc = base_complex_of_quad_mesh(m);
  scene.layers.push_back(layer_of_quads(m, bc, group));
  scene.layers.push_back(layer_of_irregular_vertices(m, group));
  scene.layers.push_back(layer_of_separatrices(m, bc, group));
  // The first and the last interval also count what lies beyond them.
  const Quad_mesh_quality q = quality_of_quad_mesh(m);
  scene.histograms.push_back(histogram_of(group + ": angles, reflex ones last", "degrees", 0, 190, q.angle_histogram));
  scene.histograms.push_back(
    histogram_of(group + ": edge lengths over their mean", "", 0, 2.1, q.edge_length_histogram));
  scene.histograms.push_back(
    histogram_of(group + ": scaled Jacobians, inverted quads first", "", -0.1, 1, q.scaled_jacobian_histogram));
}

// The triangles of the work with the integer grid on them.
inline Scene_layer layer_of_map(const Quadrangulation_surface& surface)
{
  Scene_layer layer =
    make_faces_layer(surface.mesh, surface.t_meshes.empty() ? "integer grid" : "seamless map", "Field and map");
  layer.side = Scene_side::LEFT;
  layer.has_sides = false;
  layer.color = "#d8e0c8";
  Scene_numbers origin = named_numbers("input face", "", Scene_color_scale::CATEGORIES);
  for(Quadrangulation_mesh::Face_index f : surface.mesh.faces())
  {
    for(auto h : halfedges_around_face(surface.mesh.halfedge(f), surface.mesh))
      layer.grid.push_back({ { surface.uv[h].x(), surface.uv[h].y() } });
    origin.values.push_back(static_cast<double>(surface.origin[f]));
  }
  layer.numbers = { origin };
  return layer;
}

// The arcs of T-meshes.
inline Scene_layer layer_of_t_meshes(const std::vector<std::shared_ptr<const T_mesh>>& t_meshes)
{
  Scene_layer layer = layer_of_marks("T-mesh", "Field and map", Scene_layer_kind::LINES, Scene_side::LEFT);
  layer.color = "#802080";
  Scene_numbers length = named_numbers("length in the map", "quad edges", Scene_color_scale::SEQUENCE);
  for(const auto& t : t_meshes)
    for(std::size_t a = 0; a < t->arcs.size(); ++a)
    {
      const std::vector<T_mesh::Location> line = t->polyline(static_cast<int>(a));
      std::size_t last = layer.add_point(t->position(line.front()));
      for(std::size_t i = 1; i < line.size(); ++i)
      {
        const std::size_t next = layer.add_point(t->position(line[i]));
        layer.add_element(std::array<std::size_t, 2>{ { last, next } });
        length.values.push_back(t->arcs[a].length);
        last = next;
      }
    }
  layer.numbers = { length };
  return layer;
}

// A cross in some of the faces, at most so many.
inline Scene_layer layer_of_field(const Quadrangulation_surface& surface)
{
  constexpr std::size_t most_crosses = 20000; // of 100 bytes each
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  Scene_layer layer = layer_of_marks("cross field", "Field and map", Scene_layer_kind::LINES, Scene_side::LEFT);
  layer.color = "#305070";
  layer.is_visible = false;
  const Quadrangulation_mesh& mesh = surface.mesh;
  const std::size_t step = (mesh.number_of_faces() + most_crosses - 1) / most_crosses;
  for(Quadrangulation_mesh::Face_index f : mesh.faces())
  {
    if(f % step != 0)
      continue;
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
               &r = mesh.point(mesh.target(mesh.next(h)));
    // a quarter of the square root of the area, so that the crosses of neighbors do not meet
    const double size = std::sqrt(std::sqrt(squared_area(p, q, r)) * static_cast<double>(step)) / 2;
    for(int i = 0; i < 2; ++i)
    {
      const Vector_3 d = size * cross_field_direction(f, mesh, surface.angle, i);
      const std::size_t a = layer.add_point(coordinates(centroid(p, q, r) - d));
      const std::size_t b = layer.add_point(coordinates(centroid(p, q, r) + d));
      layer.add_element(std::array<std::size_t, 2>{ { a, b } });
    }
  }
  if(step > 1)
    layer.name += " in one of " + std::to_string(step) + " triangles";
  return layer;
}

inline Scene_layer layer_of_singularities(const Quadrangulation_surface& surface)
{
  Scene_layer layer = layer_of_marks("singularities", "Field and map", Scene_layer_kind::POINTS, Scene_side::LEFT);
  Scene_numbers index = named_numbers("index", "quarters", Scene_color_scale::SIGNED);
  for(Quadrangulation_mesh::Vertex_index v : surface.mesh.vertices())
    if(surface.index[v] != 0)
    {
      layer.add_element(std::array<std::size_t, 1>{ { layer.add_point(coordinates(surface.mesh.point(v))) } });
      index.values.push_back(surface.index[v]);
    }
  layer.numbers = { index };
  layer.colored_by = 0;
  return layer;
}

CGAL_QUAD_MESHING_INLINE void add_layers_of_surface(Scene& scene, const Quadrangulation_surface& surface)
{
  if(surface.mesh.number_of_faces() == 0)
    return;
  if(surface.mesh.number_of_faces() > most_triangles_of_page)
    scene.remarks.push_back("The map lies on " + std::to_string(surface.mesh.number_of_faces()) +
                            " triangles, too many to be shown here.");
  else
    scene.layers.push_back(layer_of_map(surface));
  if(!surface.t_meshes.empty())
    scene.layers.push_back(layer_of_t_meshes(surface.t_meshes));
  scene.layers.push_back(layer_of_field(surface));
  scene.layers.push_back(layer_of_singularities(surface));
}

// A layer of lines, each given by its middle and half of it; one in so many, so that there are not too many.
class Line_thinner
{
  static constexpr std::size_t most_lines = 20000; // of 50 bytes each
  const std::size_t m_step;
  std::size_t m_seen = 0;

public:
  explicit Line_thinner(std::size_t lines) : m_step((lines + most_lines - 1) / most_lines) {}

  template <typename Point, typename Vector>
  void add(Scene_layer& layer, const Point& middle, const Vector& half)
  {
    if(m_seen++ % m_step != 0)
      return;
    const std::size_t a = layer.add_point(coordinates(middle - half)), b = layer.add_point(coordinates(middle + half));
    layer.add_element(std::array<std::size_t, 2>{ { a, b } });
  }
};

CGAL_QUAD_MESHING_INLINE void add_layers_of_curvature(Scene& scene, const Quadrangulation_surface& surface,
                                                      const Quadrangulation_mesh& qm)
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, AABB_face_graph_triangle_primitive<Mesh>>> Tree;

  const Mesh& mesh = surface.mesh;
  double length = 0;
  for(Mesh::Face_index f : mesh.faces())
    length += surface.length[f] / static_cast<double>(mesh.number_of_faces());
  std::vector<std::optional<Vector_3>> direction(mesh.number_of_faces());
  std::vector<double> weight(mesh.number_of_faces(), 0.);
  if(!(length > 0) ||
     !curvature_directions(mesh, length,
                           boost::make_iterator_property_map(direction.begin(), get(boost::face_index, mesh)),
                           boost::make_iterator_property_map(weight.begin(), get(boost::face_index, mesh)),
                           parameters::face_sizing_map(surface.length).edge_is_constrained_map(surface.is_feature))
        .is_valid())
    return;

  Scene_layer salient =
    layer_of_marks("directions of least curvature", "Field and map", Scene_layer_kind::LINES, Scene_side::LEFT);
  salient.color = "#108040";
  salient.is_visible = false;
  std::size_t number = 0;
  for(const auto& d : direction)
    number += d.has_value();
  Line_thinner thinner(number);
  const double share = 0.3; // of a quad
  for(Mesh::Face_index f : mesh.faces())
    if(direction[f])
    {
      const auto h = mesh.halfedge(f);
      thinner.add(
        salient,
        centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))),
        share * surface.length[f] * *direction[f]);
    }
  if(salient.size() == 0)
    return;

  const auto quads =
    std::find_if(scene.layers.rbegin(), scene.layers.rend(),
                 [&](const Scene_layer& l) { return l.name == "quads" && l.size() == qm.number_of_faces(); });
  if(quads != scene.layers.rend())
  {
    const Tree tree(faces(mesh).first, faces(mesh).second, mesh);
    Scene_numbers off = named_numbers("off the direction of least curvature, -1: it has none", "degrees");
    off.low = 45;
    off.high = 0;
    for(Mesh::Face_index f : qm.faces())
    {
      std::array<Point_3, 4> c;
      std::size_t k = 0;
      for(Mesh::Vertex_index v : qm.vertices_around_face(qm.halfedge(f)))
        c[k++] = qm.point(v);
      const auto& d = direction[tree.closest_point_and_primitive(centroid(c[0], c[1], c[2], c[3])).second];
      double least = 90;
      for(const Vector_3& side : { (c[1] - c[0]) + (c[2] - c[3]), (c[2] - c[1]) + (c[3] - c[0]) })
        if(d)
          least =
            (std::min)(least, std::atan2(std::sqrt(cross_product(side, *d).squared_length()), std::abs(side * *d)) *
                                180 / CGAL_PI);
      off.values.push_back(d ? (std::min)(least, 45.) : -1);
    }
    quads->numbers.push_back(off);
  }
  // Beside the layers of its group: the page lists groups one after the other.
  const auto group_end = std::find_if(scene.layers.rbegin(), scene.layers.rend(),
                                      [&](const Scene_layer& l) { return l.group == salient.group; });
  scene.layers.insert(group_end.base(), salient);
}

// Whether edges of the input lie along the features of the triangles of the work, by their middles.
class Followed_edges
{
  typedef Quadrangulation_kernel::Segment_3 Segment_3;
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel,
                                AABB_segment_primitive<Quadrangulation_kernel, std::vector<Segment_3>::const_iterator>>>
    Tree;

  std::vector<Segment_3> m_segments;
  std::unique_ptr<Tree> m_tree;
  double m_largest_distance = 0;

public:
  explicit Followed_edges(const Quadrangulation_surface& surface)
  {
    const Quadrangulation_mesh& mesh = surface.mesh;
    for(Quadrangulation_mesh::Edge_index e : mesh.edges())
      if(surface.is_feature[e])
        m_segments.push_back(Segment_3(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    if(!m_segments.empty())
      m_tree = std::make_unique<Tree>(m_segments.cbegin(), m_segments.cend());
    const double largest_distance = 0.3; // in lengths of quads; a working mesh keeps its curves nearer than that
    for(Quadrangulation_mesh::Face_index f : mesh.faces())
      m_largest_distance += largest_distance * surface.length[f] / static_cast<double>(mesh.number_of_faces());
  }

  bool include(const Quadrangulation_kernel::Point_3& middle) const
  {
    return m_tree && m_tree->squared_distance(middle) <= m_largest_distance * m_largest_distance;
  }
};

CGAL_QUAD_MESHING_INLINE void add_layers_of_features(Scene& scene, const Component_copies& copies,
                                                     const Quadrangulation_surface& surface,
                                                     const Quadrangulation_options& options)
{
  const bool is_done = surface.mesh.number_of_faces() > 0;
  const Followed_edges followed(surface);
  Scene_layer kept = layer_of_marks("sharp edges, kept", "Input", Scene_layer_kind::LINES, Scene_side::LEFT);
  Scene_layer dropped =
    layer_of_marks("sharp edges, taken for noise", "Input", Scene_layer_kind::LINES, Scene_side::LEFT);
  Scene_layer released = layer_of_marks("sharp edges, released", "Input", Scene_layer_kind::LINES, Scene_side::LEFT);
  kept.color = "#c02020";
  dropped.color = "#2040d0";
  released.color = "#e08000";
  const double length =
    options.target_edge_length > 0 ? options.target_edge_length : copies.edge_length(options.target_number_of_quads);
  for(std::size_t i = 0; i < copies.surfaces.size(); ++i)
  {
    Quadrangulation_mesh& mesh = copies.surfaces[i]->mesh;
    const auto is_kept = copies.surfaces[i]->is_feature;
    detect_feature_edges(mesh, options.sharpness_angle, copies.edge_length_in(i, length), is_kept);
    const auto is_sharp = mesh.add_property_map<Quadrangulation_mesh::Edge_index, bool>("e:is_sharp", false).first;
    // 180 degrees ask for no sharp edges, which CGAL would take for all folds
    if(options.sharpness_angle < 180)
      Polygon_mesh_processing::detect_sharp_edges(mesh, options.sharpness_angle, is_sharp);
    for(Quadrangulation_mesh::Edge_index e : mesh.edges())
    {
      if(mesh.is_border(e) || (!is_kept[e] && !is_sharp[e]))
        continue;
      const auto &a = mesh.point(mesh.vertex(e, 0)), &b = mesh.point(mesh.vertex(e, 1));
      Scene_layer& layer = !is_kept[e] ? dropped : is_done && !followed.include(midpoint(a, b)) ? released : kept;
      const std::size_t p = layer.add_point(coordinates(a)), q = layer.add_point(coordinates(b));
      layer.add_element(std::array<std::size_t, 2>{ { p, q } });
    }
  }
  for(const Scene_layer& layer : { kept, dropped, released })
    if(layer.size() > 0)
      scene.layers.push_back(layer);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_LAYERS_IMPL_H
