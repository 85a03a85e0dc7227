// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_EXTRACT_QUAD_MESH_H
#define CGAL_QUAD_MESHING_EXTRACTION_EXTRACT_QUAD_MESH_H

#include <CGAL/Quad_meshing/Extraction/Quad_extraction_result.h>
#include <CGAL/Quad_meshing/Extraction/internal/extract_quads.h>
#include <CGAL/Quad_meshing/Extraction/internal/write_grid_graph.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/copy_corners.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/use.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingExtractionRef
 *
 * \brief extracts the quad mesh that an integer-grid map stands for.
 *
 * The map gives each triangle an image in the plane; the preimage of the grid of integer
 * isolines is the quad mesh. The map is an *integer-grid map* if (1) across each edge the images
 * of both triangles differ by a rotation by a multiple of 90 degrees and an integer translation, (2) each
 * vertex around which the angles of the images do not add up to 360 degrees lies on a grid point, and (3) all triangles
 * have positive orientation. If all this holds exactly in the `double` numbers given, and
 * borders run along isolines, then the result is a pure quad mesh with the topology of `tm`: all decisions
 * are made by exact predicates. Cells that are cut by a border which does not run along isolines are left out.
 *
 * A map that only nearly fulfills (1) and (2), as one read from a text file, is first moved to the nearest one that
 * fulfills them exactly. Where triangles are folded over, the images of vertices nearby are moved to undo it
 * where this is possible, and else pairs of grid points of opposite orientation are removed; the result is still a
 * manifold mesh, but it may contain faces that are no quads, or holes. The members of `Quad_extraction_result` tell
 * what was done.
 *
 * The function has no tolerance and is deterministic. Its running time is linear in the number of triangles, quads, and
 * crossings of isolines with edges.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
 * \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
 *         as key type and a two-dimensional point as value type, whose coordinates convert to `double`
 * \tparam QuadMesh a model of `MutableFaceGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tm the triangle mesh
 * \param uv the map: at a halfedge, the image of its target in the chart of its face. Border halfedges are not read.
 * \param qm the output. Its elements are added to what it contains; it remains untouched if nothing can be extracted.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0` and
 *     `num_vertices(tm) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0` and
 *     `num_faces(tm) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_location_map}
 *     \cgalParamDescription{a property map that receives for each vertex of `qm` the place on `tm` where it lies}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor`
 *                    as key type and `Polygon_mesh_processing::Face_location<TriangleMesh, double>` as value type}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that learns about the progress and can stop the extraction; pass it by
 *     `std::ref`}
 *     \cgalParamType{a class with the members of `Default_visitor`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * Where the faces around a vertex form several fans, as where two border loops touch, the map of each fan counts for
 * itself: if the vertex lies on a grid point, the quad mesh has one vertex there for each fan.
 *
 * \return what was extracted, and what had to be done for it; `FAILED` if a face is no triangle
 *
 * \sa `transfer_feature_edges()`
 */
template <typename TriangleMesh, typename HalfedgeUVMap, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Quad_extraction_result extract_quad_mesh(const TriangleMesh& tm, HalfedgeUVMap uv, QuadMesh& qm,
                                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor quad_vertex_descriptor;
  typedef typename boost::property_map<QuadMesh, vertex_point_t>::type Quad_vpm;
  typedef typename boost::property_traits<Quad_vpm>::value_type Quad_point;

  internal::check_parameters<NamedParameters, internal_np::vertex_point_t, internal_np::vertex_index_t,
                             internal_np::face_index_t, internal_np::face_location_map_t, internal_np::visitor_t>();

  internal::Named_visitor<NamedParameters> visitor(np);

  Quad_extraction_result result;
  if(!is_triangle_mesh(tm))
  {
    result.message = "The mesh has a face that is not a triangle.";
    return result;
  }
  auto fim = internal::face_numbers(tm, np);
  internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  internal::split_non_manifold_vertices(mesh);
  internal::Extracted_quads quads;
  if(!internal::extract_quads(mesh, internal::copy_corners(tm, uv, fim), visitor, quads, result))
    return result;

  std::vector<face_descriptor> face_of_index(mesh.number_of_faces());
  for(face_descriptor f : faces(tm))
    face_of_index[get(fim, f)] = f;

  Quad_vpm quad_vpm = get(vertex_point, qm);
  auto face_location_map = get_parameter(np, internal_np::face_location_map);
  internal::write_grid_graph(
    quads.graph, quads.vertex_of_ray, quads.vertices.size(), qm,
    [&](std::size_t i)
    {
      const internal::Grid_location& l = quads.vertices[i];
      const quad_vertex_descriptor v = add_vertex(qm);
      const auto p = internal::position(mesh, l);
      put(quad_vpm, v, Quad_point(p.x(), p.y(), p.z()));
      if constexpr(!is_default_parameter<NamedParameters, internal_np::face_location_map_t>::value)
        put(face_location_map, v, std::make_pair(face_of_index[l.face], l.weights));
      else
        CGAL_USE(face_location_map);
      return v;
    });
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_EXTRACT_QUAD_MESH_H
