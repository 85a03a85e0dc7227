// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_STRUCTURE_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_STRUCTURE_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is the topological class of a quad mesh, from the most regular on.
 *
 * A regular mesh has no irregular vertex, or is a rectangle with four corners. The other classes go
 * by relative measures, which only mean something for meshes of similar size: in a *semi-regular*
 * mesh few vertices are irregular and there are few patches for the number of quads, in a *valence
 * semi-regular* mesh only the former holds, in an *unstructured* mesh neither does.
 */
enum class Quad_mesh_class
{
  REGULAR,
  SEMI_REGULAR,
  VALENCE_SEMI_REGULAR,
  UNSTRUCTURED
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief holds the topological measures of a quad mesh.
 *
 * Inside the mesh a vertex is regular if it has four edges, on the boundary if it has three. A *dual
 * curve* crosses from quad to quad through opposite sides; it is closed or joins two boundary
 * edges. The *base complex* is what all straight chains of edges that start at irregular vertices,
 * together with the boundary, cut the surface into.
 */
struct Quad_mesh_structure
{
  /// A mesh in which at most this share of the vertices is irregular is not unstructured.
  static constexpr double few_irregular_vertices = 0.1;
  /// A mesh with at most this number of patches per quad can be semi-regular.
  static constexpr double few_patches = 0.25;

  std::size_t number_of_vertices = 0;       ///< vertices that have a face
  std::size_t number_of_edges = 0;          ///< edges
  std::size_t number_of_quads = 0;          ///< faces
  std::size_t number_of_components = 0;     ///< connected components
  std::size_t number_of_boundary_loops = 0; ///< boundary cycles
  int euler_characteristic = 0;             ///< vertices - edges + faces

  /// \name Irregular vertices
  /// @{
  std::map<int, std::size_t> inner_valences;    ///< number of inner vertices of each valence but 4
  std::map<int, std::size_t> boundary_valences; ///< number of boundary vertices of each valence but 3
  std::size_t number_of_irregular_vertices = 0; ///< sum of both
  /// sum of 4 - valence over the inner and 3 - valence over the boundary vertices. It is 4 times the
  /// Euler characteristic, on every mesh.
  int sum_of_indices = 0;
  /// @}

  /// \name Dual curves
  /// @{
  std::size_t number_of_dual_curves = 0;                   ///< dual curves
  std::size_t number_of_closed_dual_curves = 0;            ///< those that close up
  std::size_t number_of_self_intersecting_dual_curves = 0; ///< those that cross themselves
  std::size_t number_of_self_intersections = 0;            ///< quads in which a dual curve crosses itself
  std::size_t number_of_parallel_classes = 0;              ///< classes of topologically parallel dual curves
  std::size_t longest_dual_curve = 0;                      ///< largest number of quads on one of them
  /// @}

  /// \name Base complex
  /// @{
  std::size_t number_of_patches = 0; ///< its faces
  std::size_t number_of_nodes = 0;   ///< its vertices
  std::size_t number_of_arcs = 0;    ///< its edges
  /// patches that do not have four corners; they occur only on components without an irregular vertex.
  std::size_t number_of_patches_not_rectangular = 0;
  /// crossings of one dual curve from each parallel class: the number of patches by the dual
  /// construction. It is the same number if all patches are rectangular.
  std::size_t number_of_representative_crossings = 0;
  /// @}

  /// \name Helices
  /// @{
  std::size_t number_of_helices = 0; ///< minimal q-helices
  /// the same if a turn may cross itself: how often a dual curve comes back beside itself in any way.
  std::size_t number_of_helices_with_crossings = 0;
  int smallest_pitch = 0;            ///< smallest absolute pitch, 0 if there are no helices
  double largest_winding_number = 0; ///< largest winding number
  /// @}

  /// number of irregular vertices per vertex.
  double irregularity() const
  {
    return number_of_vertices == 0 ? 0 : double(number_of_irregular_vertices) / number_of_vertices;
  }

  /// number of patches per quad.
  double patch_density() const { return number_of_quads == 0 ? 0 : double(number_of_patches) / number_of_quads; }

  /// the class of the mesh.
  Quad_mesh_class classification() const
  {
    const bool rectangle = number_of_irregular_vertices == 4 && number_of_boundary_loops == 1 &&
                           boundary_valences.count(2) > 0 && boundary_valences.at(2) == 4;
    if((number_of_irregular_vertices == 0 || rectangle) && number_of_components == 1)
      return Quad_mesh_class::REGULAR;
    if(irregularity() > few_irregular_vertices)
      return Quad_mesh_class::UNSTRUCTURED;
    return patch_density() > few_patches ? Quad_mesh_class::VALENCE_SEMI_REGULAR : Quad_mesh_class::SEMI_REGULAR;
  }
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is a minimal q-helix: a part of a dual curve along which `turn_length` steps ahead lead to
 * the same place as `abs(pitch)` steps sideways, in the same direction. No turn crosses itself.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 */
template <typename QuadMesh>
struct Quad_helix
{
  /// the first of its dual edges: in the face of this halfedge, heading across its edge.
  typename boost::graph_traits<QuadMesh>::halfedge_descriptor first;
  /// steps to the left per turn, positive for a right-handed helix.
  int pitch;
  /// steps along the helix per turn.
  int turn_length;
  /// number of its dual edges.
  int length;

  /// number of turns.
  double winding_number() const { return double(length) / turn_length; }
};

namespace internal {

CGAL_QUAD_MESHING_INLINE Quad_mesh_structure structure_of_quad_mesh(const Indexed_quad_mesh& m);

// The base complex of a mesh: the halfedges on it, and the patch of each face.
struct Base_complex_of_quad_mesh
{
  std::vector<char> is_separatrix;
  std::vector<int> patch;
  int number_of_patches = 0;
};

CGAL_QUAD_MESHING_INLINE Base_complex_of_quad_mesh base_complex_of_quad_mesh(const Indexed_quad_mesh& m);

// A minimal q-helix: its first dual edge as a halfedge, and what `Quad_helix` says about it.
struct Helix_of_quad_mesh
{
  int first;
  int pitch, turn_length, length;
};

// All minimal q-helices, by decreasing winding number.
CGAL_QUAD_MESHING_INLINE std::vector<Helix_of_quad_mesh> helices_of_quad_mesh(const Indexed_quad_mesh& m);

// The flat copy of a mesh for purely topological questions.
template <typename QuadMesh>
Indexed_quad_mesh_copy<QuadMesh> make_indexed_quad_mesh(const QuadMesh& qm)
{
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor edge_descriptor;
  return make_indexed_quad_mesh(qm, get(vertex_point, qm), Static_boolean_property_map<edge_descriptor, false>());
}
} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief measures the topological structure of a quad mesh: irregular vertices, dual curves, base
 * complex and helices.
 *
 * The time is linear in the size of the mesh but for a logarithm in the search for helices.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 *
 * \param qm the mesh
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 *
 * \sa `quad_mesh_quality()`
 * \sa `base_complex()`
 * \sa `minimal_q_helices()`
 */
template <typename QuadMesh>
Quad_mesh_structure quad_mesh_structure(const QuadMesh& qm)
{
  CGAL_precondition(is_quad_mesh(qm));
  return internal::structure_of_quad_mesh(internal::make_indexed_quad_mesh(qm).mesh);
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief marks the edges and the patches of the base complex of a quad mesh.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam EdgeSeparatrixMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type
 * \tparam FacePatchMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<QuadMesh>::%face_descriptor` as key type and an integer as value type
 *
 * \param qm the mesh
 * \param edge_is_separatrix tells the edges of the base complex, boundary edges included
 * \param face_patch the patch of each face, numbered from 0
 *
 * \return the number of patches
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 */
template <typename QuadMesh, typename EdgeSeparatrixMap, typename FacePatchMap>
std::size_t base_complex(const QuadMesh& qm, EdgeSeparatrixMap edge_is_separatrix, FacePatchMap face_patch)
{
  CGAL_precondition(is_quad_mesh(qm));
  const auto copy = internal::make_indexed_quad_mesh(qm);
  const internal::Base_complex_of_quad_mesh bc = internal::base_complex_of_quad_mesh(copy.mesh);
  for(int h = 0; h < copy.mesh.number_of_halfedges(); ++h)
    if(copy.mesh.edge(h) == h)
      put(edge_is_separatrix, edge(internal::original_halfedge(h, copy, qm), qm), bc.is_separatrix[h] != 0);
  for(std::size_t f = 0; f < copy.faces.size(); ++f)
    put(face_patch, copy.faces[f], bc.patch[f]);
  return bc.number_of_patches;
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief finds all minimal q-helices of a quad mesh: those whose pitch is at most their turn length
 * and that contain no turn of a helix of smaller pitch.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 *
 * \param qm the mesh
 *
 * \return the helices, by decreasing winding number
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 */
template <typename QuadMesh>
std::vector<Quad_helix<QuadMesh>> minimal_q_helices(const QuadMesh& qm)
{
  CGAL_precondition(is_quad_mesh(qm));
  const auto copy = internal::make_indexed_quad_mesh(qm);
  std::vector<Quad_helix<QuadMesh>> helices;
  for(const internal::Helix_of_quad_mesh& h : internal::helices_of_quad_mesh(copy.mesh))
    helices.push_back(
      Quad_helix<QuadMesh>{ internal::original_halfedge(h.first, copy, qm), h.pitch, h.turn_length, h.length });
  return helices;
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_structure_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_STRUCTURE_H
