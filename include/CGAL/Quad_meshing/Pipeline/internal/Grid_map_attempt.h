// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_ATTEMPT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_ATTEMPT_H

#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/quad_counts.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A cross field on the prepared triangles, and the feature edges that it follows.
struct Field_attempt
{
  Cross_field_method method = Cross_field_method::REPRESENTATION;
  bool frees_singularities = false; // they cost nothing but energy
  std::vector<char> is_feature;     // per edge
  std::vector<double> angle;        // per face
  std::vector<int> period_jump;     // per edge
  std::vector<int> index;           // per vertex
  double released_length = 0;       // of detected feature edges that it need not follow
  int singularities = 0, integers = 0;
  double energy = 0;
  std::shared_ptr<Seamless_map> map; // null until it is needed
  double fitting_length = 1;         // at which it has as many quads as are asked for, over the length asked for
};

// What became of a plan: a field, a map, and the quads of the map if none of its triangles is folded.
struct Grid_map_attempt
{
  std::shared_ptr<Field_attempt> field;
  double relative_length = 1;                      // of its plan
  bool evens_quads = false;                        // its map is markedly less distorted than that of the attempt before
  std::vector<Quadrangulation_kernel::Point_2> uv; // per halfedge
  std::vector<Quadrangulation_mesh::Face_index> folded, folded_before_rounding;
  int integers = 0;
  double energy = 0, relaxed_energy = 0;

  std::shared_ptr<Quadrangulation_quads> quads; // null: not made
  std::shared_ptr<const T_mesh> t_mesh;         // along which they were made; null: they are extracted from the map
  bool is_simple = true;                        // its quads form a mesh
  std::string message;                          // of the extraction
  std::size_t other_faces = 0, irregular_vertices = 0;

  // Of the quads, in target edge lengths.
  double length() const { return relative_length * field->fitting_length; }

  std::size_t number_of_quads() const { return quads ? quads->mesh.number_of_faces() : 0; }

  // Folded triangles are worst, then quads that form no mesh, then a distorted map, then a number of quads that is not
  // what was asked for.
  bool is_better_than(const Grid_map_attempt& b, double requested_quads) const
  {
    if(folded.size() != b.folded.size())
      return folded.size() < b.folded.size();
    if(!folded.empty() || !b.is_simple || !is_simple)
      return folded.empty() && is_simple && !b.is_simple;
    if(evens_quads)
      return true;
    if(requested_quads == 0 || is_about(static_cast<double>(b.number_of_quads()), requested_quads))
      return false;
    return count_deviation(static_cast<double>(number_of_quads()), requested_quads) <
           count_deviation(static_cast<double>(b.number_of_quads()), requested_quads);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_ATTEMPT_H
