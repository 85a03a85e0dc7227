// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H
#define CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Global_quad_smoother.h>
#include <CGAL/Quad_meshing/Smoothing/work_on_quad_mesh_copy.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells what `smooth_quad_mesh()` did.
 *
 * A quad is *folded* if it is not strictly convex (its scaled Jacobian is not positive) or if its
 * normal is opposed, by more than 120 degrees, to the normal of the reference surface below it.
 */
struct Quad_mesh_smoothing_result
{
  /// outcome of the smoothing
  enum Status {
    smoothed,             ///< the mesh has been smoothed
    not_a_quad_mesh,      ///< the mesh has faces that are not quads; it has not been touched
    empty_reference,      ///< the reference has no triangle of positive area; the mesh has not been touched
    stopped               ///< the visitor asked for an early end; the mesh is as it was
  };

  Status status = smoothed;                 ///< the outcome
  std::string message;                      ///< the outcome as a sentence
  std::size_t folded_quads_before = 0;      ///< number of folded quads in the input
  std::size_t folded_quads_after = 0;       ///< number of folded quads in the output
  Quad_mesh_quality quality_before;         ///< measures of the input
  Quad_mesh_quality quality_after;          ///< measures of the output
  unsigned int iterations = 0;              ///< number of sweeps over the vertices, and of steps of all together
};

namespace internal {

// The smoothing on flat arrays. If `globally`, vertices may have to go far: after a few sweeps all of them are moved at once.
template <typename Visitor>
Quad_mesh_smoothing_result
smooth_indexed_quad_mesh(Indexed_quad_mesh& m, Smoothing_reference& reference, const std::vector<char>& is_fixed_vertex,
                         unsigned int number_of_iterations, bool globally, Visitor& visitor)
{
  // Sweeps before all vertices are moved at once, where quads have just been unfolded.
  constexpr unsigned int sweeps_after_unfolding = 2;
  // How many of these steps there are at most: so many that this is the number of quads in all of them together.
  constexpr unsigned int most_quads_moved = 200000, least_number_of_steps = 4;
  typedef Quad_mesh_smoothing_result Result;
  Result result;
  result.quality_before = result.quality_after = quality_of_quad_mesh(m);
  if(m.number_of_faces() == 0)
  {
    result.message = "The mesh has no faces.";
    return result;
  }

  const std::vector<Indexed_quad_mesh::Point_3> input_points = m.points;
  visitor.on_stage_begin("smoothing");
  Global_quad_smoother smoother(m, reference.surface, reference.features, reference.borders, is_fixed_vertex);
  smoother.project();
  std::vector<int> folded = smoother.folded_quads();
  result.folded_quads_before = folded.size();
  if(!folded.empty())
    smoother.unfold(folded);

  const unsigned int sweeps = !globally ? number_of_iterations : folded.empty() ? 0 : sweeps_after_unfolding;
  const unsigned int steps = (std::max)(least_number_of_steps, most_quads_moved / static_cast<unsigned int>(m.number_of_faces()));
  number_of_iterations = (std::min)(number_of_iterations, sweeps + steps);
  smoother.start_sweeps();
  bool moving = true;
  for(; moving && result.iterations < number_of_iterations && visitor.go_further(); ++result.iterations)
  {
    if(result.iterations < sweeps)
      moving = smoother.sweep() || globally;
    else
      moving = smoother.step();
    moving = smoother.project_leftovers() || moving;
    visitor.progress(double(result.iterations + 1) / number_of_iterations);
  }
  if(globally && result.iterations > 0)
    smoother.mend();
  result.folded_quads_after = smoother.folded_quads().size();
  visitor.on_stage_end("smoothing");

  if(!visitor.go_further())
  {
    m.points = input_points;
    result.status = Result::stopped;
    result.folded_quads_after = result.folded_quads_before;
    result.message = "The smoothing was stopped; the mesh is as it was.";
    return result;
  }
  result.quality_after = quality_of_quad_mesh(m);
  result.message = result.folded_quads_after == 0
    ? "The mesh has been smoothed; no quad is folded."
    : "The mesh has been smoothed; number of folded quads: " + std::to_string(result.folded_quads_after) + ".";
  return result;
}

// Smooths on `make_reference(flat copy)` and writes the points back.
template <typename QuadMesh, typename NamedParameters, typename MakeReference>
Quad_mesh_smoothing_result
smooth_quad_mesh_with(QuadMesh& qm, const NamedParameters& np, const MakeReference& make_reference)
{
  typedef typename GetVertexPointMap<QuadMesh, NamedParameters>::type Vertex_point_map;
  typedef typename boost::property_traits<Vertex_point_map>::value_type Point;

  const unsigned int number_of_iterations =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), 20);
  const bool globally =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::smooth_globally), false);
  return work_on_quad_mesh_copy<Quad_mesh_smoothing_result>(qm, np, make_reference,
    [&](auto& copy, const std::vector<char>& is_fixed, Smoothing_reference& reference, auto& visitor, auto vpm, auto)
    {
      const std::vector<Indexed_quad_mesh::Point_3> before = copy.mesh.points;
      const Quad_mesh_smoothing_result result =
        smooth_indexed_quad_mesh(copy.mesh, reference, is_fixed, number_of_iterations, globally, visitor);
      for(std::size_t i = 0; i < copy.vertices.size(); ++i)
      {
        const Indexed_quad_mesh::Point_3& p = copy.mesh.points[i];
        if(p != before[i])
          put(vpm, copy.vertices[i], Point(p.x(), p.y(), p.z()));
      }
      return result;
    });
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief smooths a quad mesh on a reference surface, so that its quads become more like squares and
 * their sizes more even.
 *
 * Only positions change. Each vertex moves within its realm: a vertex on no constrained edge on the
 * reference surface, a vertex between two constrained edges along the feature curves of the
 * reference, a vertex between two boundary edges along its boundary. All other vertices on
 * constrained edges stay where they are: those where one, three or more constrained or boundary
 * edges meet, those at a corner of the curve (where the reference curve turns by more than 50
 * degrees or branches), and those that the user fixes.
 *
 * The energy of each corner is the ratio of the squared lengths of its sides to its area, least for
 * a square corner, with a smaller part that asks for the mean area of the neighbourhood; it is
 * minimized vertex by vertex. A quad that is strictly convex stays so and is not turned over, because
 * steps that would do so are not taken. If the input has folded quads, these and their neighbourhood
 * are first unfolded with the energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov: *Foldover-free maps in 50 lines of code*, ACM TOG 40(4), 2021. That needs no valid start and
 * mostly succeeds, but is not guaranteed to.
 *
 * Vertex by vertex, a mesh gets well shaped where it has to move by a few quads. With `smooth_globally`, all vertices are moved at
 * once by steps of Newton's method, as long as they help: they can go all over the surface. Corners are to be right angles first
 * then, and quads may become rectangles. Quads with scaled Jacobians below 0.5 do not become worse, better ones not worse than that,
 * and the worst ones are improved in the end.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh to smooth
 * \param tm the reference surface, a triangle mesh
 * \param np_qm an optional sequence of named parameters for `qm` among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `qm`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, qm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the feature edges of `qm`. The boundary needs not be marked.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the vertices of `qm` that must not move}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no vertex is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of sweeps and steps; the smoothing ends sooner when all vertices rest}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`20`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smooth_globally}
 *     \cgalParamDescription{whether all vertices are moved at once: if they have to go far}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor with the interface of `Default_visitor`, passed as `std::ref(visitor)`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_tm an optional sequence of named parameters for `tm` among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the feature edges of `tm`, along which the
 *                           vertices of constrained edges of `qm` slide}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no edge is constrained. The vertices of constrained edges of
 *                       `qm` then slide along the polylines that these edges form in the input.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return what was done, with the measures before and after
 *
 * \pre `CGAL::is_triangle_mesh(tm)`, and no vertex of `tm` or `qm` is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh,
          typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_mesh_smoothing_result
smooth_quad_mesh(QuadMesh& qm, const TriangleMesh& tm,
                 const NamedParametersQM& np_qm = parameters::default_values(),
                 const NamedParametersTM& np_tm = parameters::default_values())
{
  CGAL_precondition(is_triangle_mesh(tm));
  return internal::smooth_quad_mesh_with(qm, np_qm, [&](const internal::Indexed_quad_mesh& m)
  {
    return internal::smoothing_reference(m, tm, np_tm);
  });
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief smooths a quad mesh on the surface that its quads, cut into two triangles each, form in the
 * input.
 *
 * Otherwise as above.
 */
template <typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quad_mesh_smoothing_result
smooth_quad_mesh(QuadMesh& qm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::smooth_quad_mesh_with(qm, np, [](const internal::Indexed_quad_mesh& m)
  {
    return internal::Smoothing_reference(m);
  });
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H
