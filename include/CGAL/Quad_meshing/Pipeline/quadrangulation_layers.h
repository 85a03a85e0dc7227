// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_LAYERS_H
#define CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_LAYERS_H

#include <CGAL/Quad_meshing/IO/scene_layers.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Pipeline/internal/guide_layers.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/boost/graph/helpers.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

CGAL_QUAD_MESHING_INLINE void add_layers_of_quads(Scene& scene, const Indexed_quad_mesh& m, const std::string& group);

CGAL_QUAD_MESHING_INLINE void add_layers_of_surface(Scene& scene, const Quadrangulation_surface& surface);

CGAL_QUAD_MESHING_INLINE void add_layers_of_features(Scene& scene, const Component_copies& copies,
                                                     const Quadrangulation_surface& surface,
                                                     const Quadrangulation_options& options);

// Adds the directions in which the surface bends least, and how far the quads are off them to their layer.
CGAL_QUAD_MESHING_INLINE void add_layers_of_curvature(Scene& scene, const Quadrangulation_surface& surface,
                                                      const Quadrangulation_mesh& qm);

} // namespace internal

/*!
\ingroup PkgQuadMeshingRef

\brief adds what can be seen of a quad mesh to a scene: its quads with their measures, the irregular vertices, the
separatrices of the base complex, and histograms.

Quads can be colored by scaled Jacobian, deviation of angles from 90 degrees, edge length, aspect ratio, planarity, and
patch of the base complex; irregular vertices are colored by index: 1 for valence 3 inside, -1 for valence 5.

\tparam QuadMesh a model of `FaceListGraph`

\param scene receives layers and histograms
\param qm the mesh
\param group the heading of the layers

\pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
*/
template <typename QuadMesh>
void add_quad_mesh_layers(Scene& scene, const QuadMesh& qm, const std::string& group = "Quads")
{
  CGAL_precondition(is_quad_mesh(qm));
  internal::add_layers_of_quads(scene, internal::make_indexed_quad_mesh(qm).mesh, group);
}

/*!
\ingroup PkgQuadMeshingRef

\brief adds what a quadrangulation started from, worked with and made to a scene.

Layers are the triangles of the input, the sharp edges that were kept, those that were taken for noise and those that
were released, the working mesh with the integer grid on it, the cross field, its singularities by index in quarters,
the directions in which the surface bends least where these are reliable, the curves, strokes and places of irregular
vertices that the user has drawn, the feature edges of the quads, and those of `add_quad_mesh_layers()`. Quads can be
colored by the angle between them and those directions as well.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with an internal point map

\param scene receives layers and histograms
\param tm the triangle mesh that `q` was made of
\param q a quadrangulation after its run

\pre no feature edges were given to `q`: the layers of sharp edges show those that are detected
*/
template <typename TriangleMesh>
void add_quadrangulation_layers(Scene& scene, const TriangleMesh& tm, const Quadrangulation& q)
{
  Scene_layer input = make_display_layer(tm, "triangles", "Input", scene);
  input.side = Scene_side::LEFT;
  input.is_visible = q.quads().mesh.number_of_faces() == 0;
  scene.layers.push_back(input);
  internal::add_layers_of_features(scene, copy_components(tm), q.surface(), q.options);
  internal::add_layers_of_guides(scene, q.options);
  internal::add_layers_of_surface(scene, q.surface());
  const Quadrangulation_mesh& qm = q.quads().mesh;
  if(qm.number_of_faces() == 0)
    return;
  if(is_quad_mesh(qm))
  {
    add_quad_mesh_layers(scene, qm);
    internal::add_layers_of_curvature(scene, q.surface(), qm);
  }
  else
  {
    scene.layers.push_back(make_faces_layer(qm, "faces", "Quads"));
    scene.layers.back().side = Scene_side::RIGHT;
  }
  Scene_layer features = make_edges_layer(
    qm, [&](auto e) { return bool(q.quads().is_feature[e]); }, "feature edges", "Quads");
  features.side = Scene_side::RIGHT;
  features.color = "#c02020";
  if(features.size() > 0)
    scene.layers.push_back(features);
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Pipeline/internal/quadrangulation_layers_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_LAYERS_H
