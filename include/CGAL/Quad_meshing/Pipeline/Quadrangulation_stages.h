// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_STAGES_H
#define CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_STAGES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

class T_mesh;

/// \ingroup PkgQuadMeshingRef
/// \brief The kernel of a quadrangulation.
typedef Exact_predicates_inexact_constructions_kernel Quadrangulation_kernel;

/// \ingroup PkgQuadMeshingRef
/// \brief The meshes of a quadrangulation.
typedef Surface_mesh<Quadrangulation_kernel::Point_3> Quadrangulation_mesh;

/*!
\ingroup PkgQuadMeshingRef

\brief The triangles that a quadrangulation works on, with the field and the map that the quads were made of.

They are those of a working mesh (`make_working_mesh()`), or a copy of the input in an order that follows its places in
space (`Quadrangulation_options::work_on_input`); edges are split where that is needed (`split_for_alignment()`). The
maps of field and map are as `smooth_cross_field()` and `integer_grid_map()` write them.
*/
struct Quadrangulation_surface
{
  typedef Quadrangulation_mesh Mesh;

  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, std::size_t> origin; ///< the number of the input face that a face lies in, or at
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;    ///< the feature edges that the quads follow
  Mesh::Property_map<Mesh::Edge_index, bool> is_kept;       ///< those of them that are never released: the user's
  Mesh::Property_map<Mesh::Face_index, double> length;      ///< the target edge length, in the unit of the points
  Mesh::Property_map<Mesh::Face_index, double> angle;       ///< the cross field
  Mesh::Property_map<Mesh::Edge_index, int> period_jump;    ///< the cross field
  Mesh::Property_map<Mesh::Vertex_index, int> index;        ///< the singularities of the cross field, in quarters
  /// The integer-grid map; in components with a T-mesh, the seamless map that it would have been made of.
  Mesh::Property_map<Mesh::Halfedge_index, Quadrangulation_kernel::Point_2> uv;
  /// The T-meshes along which quads were made, of the components whose quads were not extracted from an integer-grid
  /// map.
  std::vector<std::shared_ptr<const T_mesh>> t_meshes;

  /// makes an empty surface.
  Quadrangulation_surface()
    : origin(mesh.add_property_map<Mesh::Face_index, std::size_t>("f:origin", 0).first)
    , is_feature(mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first)
    , is_kept(mesh.add_property_map<Mesh::Edge_index, bool>("e:is_kept", false).first)
    , length(mesh.add_property_map<Mesh::Face_index, double>("f:length", 0).first)
    , angle(mesh.add_property_map<Mesh::Face_index, double>("f:angle", 0).first)
    , period_jump(mesh.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first)
    , index(mesh.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first)
    , uv(mesh.add_property_map<Mesh::Halfedge_index, Quadrangulation_kernel::Point_2>("h:uv").first)
  {
  }

  Quadrangulation_surface(const Quadrangulation_surface&) = delete; // its maps belong to its mesh
  Quadrangulation_surface& operator=(const Quadrangulation_surface&) = delete;
};

/*!
\ingroup PkgQuadMeshingRef

\brief The quad mesh of a quadrangulation.
*/
struct Quadrangulation_quads
{
  typedef Quadrangulation_mesh Mesh;
  /// a face of the triangles and the weights of its corners, as `Polygon_mesh_processing::Face_location`
  typedef std::pair<Mesh::Face_index, std::array<double, 3>> Location;

  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Location> location; ///< where its vertices lie on the triangles of the work
  Mesh::Property_map<Mesh::Vertex_index, std::size_t> input_face; ///< the numbers of the faces of the input they lie in
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;          ///< its edges along feature edges

  /// makes an empty mesh.
  Quadrangulation_quads()
    : location(mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first)
    , input_face(mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:input_face", 0).first)
    , is_feature(mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first)
  {
  }

  Quadrangulation_quads(const Quadrangulation_quads&) = delete; // its maps belong to its mesh
  Quadrangulation_quads& operator=(const Quadrangulation_quads&) = delete;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_STAGES_H
