// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_REPORT_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_REPORT_H

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief says whether a cross field is consistent, or the first defect among those below.
 */
enum class Cross_field_report_status
{
  CONSISTENT,          ///< there is no defect
  NOT_A_TRIANGLE_MESH, ///< a face has not three vertices
  POINT_NOT_FINITE,    ///< a coordinate of a point is not a finite number
  NON_MANIFOLD_VERTEX, ///< the faces around a vertex form more than one fan; the message says which vertex
  ANGLE_NOT_FINITE,    ///< an angle is not a finite number
  MISALIGNED_EDGE,     ///< the cross of a face at a constrained edge does not follow the edge
  WRONG_JUMP,          ///< the period jump across a constrained edge turns the direction along the edge
  WRONG_INDEX,         ///< an index is not that of the field
  EMPTY_SECTOR         ///< a sector between constrained edges, or around a vertex, has no quad
};

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief returns the name of a status in lower case, for instance `"wrong_jump"`.
 */
inline const char* status_name(Cross_field_report_status status)
{
  switch(status)
  {
    case Cross_field_report_status::CONSISTENT: return "consistent";
    case Cross_field_report_status::NOT_A_TRIANGLE_MESH: return "not_a_triangle_mesh";
    case Cross_field_report_status::POINT_NOT_FINITE: return "point_not_finite";
    case Cross_field_report_status::NON_MANIFOLD_VERTEX: return "non_manifold_vertex";
    case Cross_field_report_status::ANGLE_NOT_FINITE: return "angle_not_finite";
    case Cross_field_report_status::MISALIGNED_EDGE: return "misaligned_edge";
    case Cross_field_report_status::WRONG_JUMP: return "wrong_jump";
    case Cross_field_report_status::WRONG_INDEX: return "wrong_index";
    case Cross_field_report_status::EMPTY_SECTOR: return "empty_sector";
  }
  return "";
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief is the answer of `check_cross_field()` and `cross_field_indices()`: which simplices show what defect.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
template <typename TriangleMesh>
struct Cross_field_report
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// the first defect
  Cross_field_report_status status = Cross_field_report_status::CONSISTENT;
  /// the same as a sentence, with numbers
  std::string message;
  /// faces whose angle is not a finite number
  std::vector<face_descriptor> faces_not_finite;
  /// constrained edges that the cross of a face at them does not follow
  std::vector<edge_descriptor> misaligned_edges;
  /// constrained edges across which the period jump turns the direction along the edge
  std::vector<edge_descriptor> edges_with_wrong_jump;
  /// vertices whose index is not that of the field
  std::vector<vertex_descriptor> vertices_with_wrong_index;
  /// vertices with a sector between constrained edges, or a whole fan, without a quad
  std::vector<vertex_descriptor> vertices_without_quads;
  /// the sum of the indices in the map
  int index_sum = 0;
  /// four times the Euler number: what indices sum up to if the field is aligned with the border
  int expected_index_sum = 0;

  /// returns whether there is no defect.
  bool is_valid() const { return status == Cross_field_report_status::CONSISTENT; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_REPORT_H
