// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Grid_map_search.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>
#include <CGAL/Quad_meshing/internal/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/optional.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief The way from a triangle mesh to a quad mesh, with everything that the stages leave behind.

`quadrangulate()` is this class in one call. Use the class to look at the stages: the prepared triangle mesh with its feature
edges, the cross field, the integer-grid map.

The input is copied into a mesh of its own, in which edges are split where that is needed (`split_for_alignment()`).

\sa `quadrangulate()`
*/
class Quadrangulation
{
public:
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Surface_mesh<Kernel::Point_3> Mesh;
  typedef Polygon_mesh_processing::Face_location<Mesh, double> Location;

  /// \name Parameters
  /// The defaults are those of `quadrangulate()`.
  /// @{
  double target_edge_length = 0;         ///< 0: from `target_number_of_quads` and the area
  double target_number_of_quads = 4000;  ///< counts only where `target_edge_length` is 0
  double sharpness_angle = 40;           ///< in degrees, for the detection of feature edges
  bool align_boundary = true;            ///< whether borders become chains of quad edges
  /// How the singularities of the field are found. The smoothest fields have the fewest, but their maps are more distorted. If the
  /// map for `REPRESENTATION` is folded over, the one for `POLISHED` is tried as well.
  Cross_field_method cross_field_method = Cross_field_method::REPRESENTATION;
  Rounding_method rounding_method = GREEDY_ROUNDING; ///< how the integers of the map are chosen
  double anisotropy_weight = 1;          ///< the weight of lengths against directions, in (0, 1]
  bool optimize_structure = false;       ///< whether `optimize_quad_structure()` makes the base complex coarser
  unsigned int number_of_threads = 1;    ///< that may work at the same time; the result does not depend on it
  unsigned int random_seed = 0;          ///< of the lengths that are tried when the map for the given one is not valid
  unsigned int smoothing_iterations = 20; ///< largest number of steps of the final smoothing; 0 keeps the extracted points
  /// @}

  /// \name What the Stages Leave Behind
  /// @{
  Mesh mesh;                                               ///< the prepared triangle mesh
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;   ///< its feature edges
  Mesh::Property_map<Mesh::Face_index, std::size_t> origin; ///< the number of the input face that a face lies in
  Mesh::Property_map<Mesh::Face_index, double> angle;      ///< the cross field
  Mesh::Property_map<Mesh::Edge_index, int> period_jump;   ///< the cross field
  Mesh::Property_map<Mesh::Vertex_index, int> index;       ///< the singularities of the cross field, in quarters
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv; ///< the integer-grid map
  Mesh quad_mesh;                                          ///< the result
  Mesh::Property_map<Mesh::Vertex_index, Location> location; ///< where its vertices lie on `mesh`
  Mesh::Property_map<Mesh::Edge_index, bool> quad_edge_is_feature; ///< its edges along feature edges
  /// @}

  /// copies a triangle mesh. The face of number `i` in `faces(tm)` is the origin `i` of the faces that it is split into.
  template <typename TriangleMesh, typename VertexPointMap>
  Quadrangulation(const TriangleMesh& tm, VertexPointMap vpm)
  {
    add_property_maps();
    std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, Mesh::Face_index> > copies;
    copy_face_graph(tm, mesh, parameters::vertex_point_map(vpm).face_to_face_output_iterator(std::back_inserter(copies)));
    for(std::size_t i = 0; i < copies.size(); ++i) // in the order of faces(tm)
      origin[copies[i].second] = i;
  }

  /// copies a triangle mesh whose feature edges are known; none are detected then.
  template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsFeatureMap>
  Quadrangulation(const TriangleMesh& tm, VertexPointMap vpm, EdgeIsFeatureMap edge_is_feature)
    : Quadrangulation(tm, vpm)
  {
    features_are_given = true;
    std::size_t i = 0;
    for(auto e : edges(tm)) // edges are copied in the order of edges(tm)
      is_feature[Mesh::Edge_index(static_cast<Mesh::size_type>(i++))] = get(edge_is_feature, e) && !is_border(e, tm);
  }

  /// \name Running
  /// @{

  /// runs all the stages. `direction(i)` gives a `boost::optional<Kernel::Vector_3>`, the direction that the field has to have in the
  /// input face of number `i`.
  template <typename Direction, typename Visitor>
  Quadrangulation_result run(Direction direction, Visitor& visitor)
  {
    Real_timer timer;
    timer.start();
    Quadrangulation_result result;
    run_stages(direction, visitor, result);
    result.total_seconds = timer.time();
    return result;
  }

  /// @}

private:
  bool features_are_given = false;

  void add_property_maps()
  {
    is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    origin = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:origin", 0).first;
    angle = mesh.add_property_map<Mesh::Face_index, double>("f:angle", 0).first;
    period_jump = mesh.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first;
    index = mesh.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first;
    uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    location = quad_mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
    quad_edge_is_feature = quad_mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  }

  template <typename Direction, typename Visitor>
  void run_stages(Direction& direction, Visitor& visitor, Quadrangulation_result& result)
  {
    typedef Quadrangulation_result Result;
    result.input_faces = mesh.number_of_faces();
    topology = internal::surface_topology(mesh);
    result.components = topology.size();
    if(!choose_length(result) || !prepare(result) || !make_quads(direction, visitor, result))
      return;
    if(optimize_structure && result.status == Result::VALID && result.other_faces == 0)
      restructure(visitor, result);
    else
      smooth(visitor, result);
    if(result.status != Result::STOPPED)
      check(result);
  }

  static bool fail(Quadrangulation_result& result, Quadrangulation_result::Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  }

  bool choose_length(Quadrangulation_result& result)
  {
    typedef Quadrangulation_result Result;
    if(mesh.number_of_faces() == 0)
      return fail(result, Result::INVALID_INPUT, "The mesh has no faces.");
    for(Mesh::Vertex_index v : mesh.vertices())
      for(int c = 0; c < 3; ++c)
        if(!std::isfinite(mesh.point(v)[c]))
          return fail(result, Result::INVALID_INPUT, "A vertex has a coordinate that is not a finite number.");
    const double area = Polygon_mesh_processing::area(mesh);
    if(!(area > 0))
      return fail(result, Result::INVALID_INPUT, "The mesh has no area.");
    if(target_edge_length < 0 || !std::isfinite(target_edge_length))
      return fail(result, Result::INVALID_INPUT, "The target edge length is not a positive number.");
    if(target_edge_length == 0 && !(target_number_of_quads > 0 && std::isfinite(target_number_of_quads)))
      return fail(result, Result::INVALID_INPUT, "The target number of quads is not a positive number.");
    length = target_edge_length > 0 ? target_edge_length : std::sqrt(area / target_number_of_quads);
    const double most_quads = 5e7;
    if(area / (length * length) > most_quads)
      return fail(result, Result::INVALID_INPUT, "The target edge length asks for more than 50 million quads.");
    const Bbox_3 box = Polygon_mesh_processing::bbox(mesh);
    const double diagonal = std::sqrt(square(box.x_span()) + square(box.y_span()) + square(box.z_span()));
    if(length > diagonal)
      return fail(result, Result::INVALID_INPUT, "The target edge length is larger than the model.");
    result.target_edge_length = length;
    return true;
  }

  bool prepare(Quadrangulation_result& result)
  {
    if(!features_are_given)
    {
      const Feature_edges_result features = detect_feature_edges(mesh, sharpness_angle, length, is_feature);
      result.feature_edges = features.number_of_edges;
      result.dropped_feature_edges = features.number_of_dropped_edges;
      feature_length = features.length;
    }
    else
      for(Mesh::Edge_index e : mesh.edges())
        result.feature_edges += is_feature[e];
    // A map is linear on a triangle; a few triangles per quad let it bend.
    const double longest_relative_edge = 1.5;
    split_for_alignment(mesh, mesh.points(), is_feature, align_boundary, origin, longest_relative_edge * length);
    result.prepared_faces = mesh.number_of_faces();
    return true;
  }

  template <typename Direction, typename Visitor>
  bool make_quads(Direction& direction, Visitor& visitor, Quadrangulation_result& result)
  {
    auto directions = mesh.add_property_map<Mesh::Face_index, boost::optional<Kernel::Vector_3> >("f:direction").first;
    for(Mesh::Face_index f : mesh.faces())
      directions[f] = direction(origin[f]);
    // Feature edges that the user has marked are not for us to release.
    internal::Grid_map_search<Quadrangulation, Visitor> search(*this, directions, length, features_are_given ? 0 : feature_length,
                                                               visitor, result);
    bool is_done = search.run() && extract(visitor, result);
    // The grid of a map without fold-overs may still be too coarse for a mesh, where the surface is narrow.
    for(double finer : { 0.95, 0.9 })
      if(is_done && result.status == Quadrangulation_result::NOT_VALID && result.flipped_triangles == 0 && search.run_for_length(finer))
      {
        quad_mesh.clear_without_removing_property_maps();
        is_done = extract(visitor, result);
      }
    mesh.remove_property_map(directions);
    if(result.status == Quadrangulation_result::STOPPED)
      quad_mesh.clear_without_removing_property_maps();
    return is_done && result.status != Quadrangulation_result::STOPPED;
  }

  template <typename Visitor>
  bool extract(Visitor& visitor, Quadrangulation_result& result)
  {
    typedef Quadrangulation_result Result;
    Real_timer timer;
    timer.start();
    const Quad_extraction_result extraction =
      extract_quad_mesh(mesh, uv, quad_mesh, parameters::face_location_map(location).visitor(std::ref(visitor)));
    result.extraction_seconds = timer.time();
    if(extraction.status == Quad_extraction_status::STOPPED)
      return fail(result, Result::STOPPED, extraction.message);
    if(extraction.status == Quad_extraction_status::FAILED)
      return fail(result, Result::FAILED, extraction.message);
    result.message = extraction.message;
    result.quads = extraction.quads;
    result.other_faces = extraction.other_faces;
    result.irregular_vertices = extraction.irregular_vertices + extraction.irregular_border_vertices;
    result.status = extraction.status == Quad_extraction_status::NOT_SIMPLE ? Result::NOT_VALID : Result::VALID;
    internal::transfer_feature_edges(mesh, is_feature, get(boost::vertex_index, mesh), get(boost::edge_index, mesh),
                                     quad_mesh, location, quad_edge_is_feature);
    return true;
  }

  template <typename Visitor>
  void smooth(Visitor& visitor, Quadrangulation_result& result)
  {
    if(smoothing_iterations == 0 || result.other_faces != 0 || result.status != Quadrangulation_result::VALID)
      return;
    Real_timer timer;
    timer.start();
    const Quad_mesh_smoothing_result smoothing =
      smooth_quad_mesh(quad_mesh, mesh,
                       parameters::smooth_globally(true)
                         .edge_is_constrained_map(quad_edge_is_feature)
                         .smoothing_iterations(smoothing_iterations)
                         .visitor(std::ref(visitor)),
                       parameters::edge_is_constrained_map(is_feature));
    result.folded_quads = smoothing.folded_quads_after;
    result.smoothing_seconds = timer.time();
    if(smoothing.status == Quad_mesh_smoothing_status::STOPPED)
    {
      quad_mesh.clear_without_removing_property_maps();
      fail(result, Quadrangulation_result::STOPPED, smoothing.message);
      return;
    }
    locate_vertices();
  }

  // Its last step is the smoothing.
  template <typename Visitor>
  void restructure(Visitor& visitor, Quadrangulation_result& result)
  {
    Real_timer timer;
    timer.start();
    const Quad_structure_optimization_result optimization =
      optimize_quad_structure(quad_mesh, mesh,
                              parameters::edge_is_constrained_map(quad_edge_is_feature).visitor(std::ref(visitor)),
                              parameters::edge_is_constrained_map(is_feature));
    quad_mesh.collect_garbage();
    result.structure_seconds = timer.time();
    if(optimization.status == Structure_optimization_status::STOPPED)
    {
      quad_mesh.clear_without_removing_property_maps();
      fail(result, Quadrangulation_result::STOPPED, optimization.message);
      return;
    }
    result.quads = quad_mesh.number_of_faces();
    result.irregular_vertices = optimization.structure_after.number_of_irregular_vertices;
    result.folded_quads = optimization.smoothing.quality_after.number_of_inverted_quads;
    locate_vertices();
  }

  // Vertices that have moved, or that the extraction did not make, lie at the nearest place of the triangle mesh.
  void locate_vertices()
  {
    typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
    typedef AABB_tree<internal::Aabb_traits<Kernel, Primitive> > Tree;
    const Tree tree(faces(mesh).first, faces(mesh).second, mesh);
    for(Mesh::Vertex_index v : quad_mesh.vertices())
      location[v] = Polygon_mesh_processing::locate_with_AABB_tree(quad_mesh.point(v), tree, mesh);
  }

  // The last word: a mesh is valid if it is what the caller asked for, whatever the stages think.
  void check(Quadrangulation_result& result)
  {
    typedef Quadrangulation_result Result;
    std::string flips;
    if(result.flipped_triangles != 0)
      flips = " (" + std::to_string(result.flipped_triangles) + " triangles of the map are folded over)";
    if(result.status == Result::NOT_VALID)
      result.message += flips;
    else if(!defects().empty())
      fail(result, Result::NOT_VALID, defects() + flips + ".");
    else if(internal::surface_topology(quad_mesh) != topology)
      fail(result, Result::NOT_VALID, "The topology of the quad mesh is not that of the input" + flips + ".");
    else
    {
      result.status = Result::VALID;
      result.message = "A pure quad mesh with the topology of the input";
      if(result.target_edge_length != length)
        result.message += ", for edges of length " + std::to_string(result.target_edge_length / length) + " times the one asked for";
      if(result.released_feature_share != 0)
        result.message += "; " + std::to_string(std::lround(100 * result.released_feature_share)) +
                          " percent of the length of the sharp edges left no room for quads along them and were not followed";
      result.message += ".";
    }
  }

  // What keeps the result from being a pure quad mesh for somebody who reads it as points and polygons.
  std::string defects() const
  {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t> > polygons;
    Polygon_mesh_processing::polygon_mesh_to_polygon_soup(quad_mesh, points, polygons);
    std::string list;
    for(const std::string& reason : find_quad_mesh_defects(points, polygons).reasons())
      list += (list.empty() ? "" : ", ") + reason;
    return list;
  }

  double feature_length = 0; // of all feature edges that were detected
  double length = 0; // of a quad edge, as asked for
  std::vector<internal::Component_topology> topology; // of the input
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUADRANGULATION_H
