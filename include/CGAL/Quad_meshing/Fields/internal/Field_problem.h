// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_PROBLEM_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_PROBLEM_H

#include <CGAL/Quad_meshing/Fields/Face_frames.h>
#include <CGAL/Quad_meshing/Fields/Field_sectors.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A cross field: one angle per face, one period jump per edge, oriented as the edge's halfedge.
struct Cross_field
{
  std::vector<double> angle;
  std::vector<int> period_jump;
};

// What the smoothest cross field has to respect, in flat arrays.
//
// The residual of an inner edge e with the faces i (of `halfedge_of_edge[e]`) and j (across) is
//   r_e = angle_i + kappa_e + pi/2 jump_e - angle_j,
// where kappa_e is the angle between the frames of the faces, and what the sizes turn directions by (`size_turn`);
// and the energy of a field is the sum of the squared residuals of all inner edges, weighted if there are weights, and
// of the weighted squared deviations from soft angles.
struct Field_problem
{
  const Indexed_triangle_mesh& mesh;
  const Face_frames frames;
  std::vector<char> aligned;       // per edge: the field follows it
  std::vector<char> constrained;   // per face: its angle is given
  std::vector<double> given_angle; // per face
  std::vector<double> soft_angle;  // per face: the angle that it should have; empty where none has one
  std::vector<double> soft_weight; // per face: of the squared deviation from it, in units of the residuals
  std::vector<double> edge_weight; // per edge: of its squared residual; empty where all count the same
  // Per vertex: the target edge length; empty where it is the same everywhere. Then the field is to be smooth in the
  // metric in which all quads have the same size.
  std::vector<double> length;
  std::vector<double> size_turn; // per edge: what that metric adds to kappa; empty where `length` is
  // Per vertex: the quads that an inner vertex without aligned edges must have, or `any_quads`; empty: all are free.
  std::vector<int> prescribed_quads;
  std::vector<int> component; // per face
  std::vector<int> anchor;    // per component: a free face of a component without constraint, or -1
  Field_sectors sectors;

  static constexpr int any_quads = (std::numeric_limits<int>::min)();

  // How many faces touch two aligned edges in directions that exclude each other.
  int conflicting_faces = 0;

  explicit Field_problem(const Indexed_triangle_mesh& m)
    : mesh(m)
    , frames(m)
    , aligned(m.number_of_edges(), 0)
    , constrained(m.number_of_faces(), 0)
    , given_angle(m.number_of_faces(), 0.)
  {
  }

  bool is_inner(int e) const { return !mesh.is_border_edge(e); }
  int first_face(int e) const { return mesh.halfedge_of_edge[e] / 3; }
  int second_face(int e) const { return mesh.opposite[mesh.halfedge_of_edge[e]] / 3; }

  // An edge whose period jump is a free integer. The jump across an aligned edge is not: both faces
  // have their angle from it.
  bool is_movable(int e) const { return is_inner(e) && !aligned[e]; }

  // The angle that a direction has in the second face of an edge and that is parallel to the one with angle 0 in the
  // first.
  double kappa(int e) const { return frames.kappa(e) + (size_turn.empty() ? 0. : size_turn[e]); }

  double residual(int e, const Cross_field& field) const
  {
    return turn(e, field) + (size_turn.empty() ? 0. : size_turn[e]);
  }

  // The residual on the surface as it is: what the numbers of quads around vertices are sums of.
  double turn(int e, const Cross_field& field) const
  {
    return field.angle[first_face(e)] + frames.kappa(e) + quarter_turn * field.period_jump[e] -
           field.angle[second_face(e)];
  }

  double weight(int e) const { return edge_weight.empty() ? 1. : edge_weight[e]; }

  // Makes the energy that of the surface, whatever its triangles are like: the weight of an edge is its length over the
  // distance of the two centroids from each other across it, scaled to one for two equilateral triangles.
  void set_surface_weights()
  {
    // Needles, whose centroids nearly coincide, and edges shorter than all the others must not outweigh everything.
    const double greatest = 10, least = 0.1;
    auto twice_area = [&](int f)
    { return std::sqrt(cross_product(mesh.vector(3 * f), mesh.vector(3 * f + 1)).squared_length()); };
    edge_weight.assign(mesh.number_of_edges(), 1.);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
    {
      if(!is_inner(e))
        continue;
      const double areas = twice_area(first_face(e)) + twice_area(second_face(e));
      const double squared_length = mesh.vector(mesh.halfedge_of_edge[e]).squared_length();
      edge_weight[e] = areas * greatest > std::sqrt(3.) * squared_length
                         ? (std::max)(least, std::sqrt(3.) * squared_length / areas)
                         : greatest;
    }
  }

  // The target edge length at a vertex, or the one given where it is constant.
  double length_at(int v, double constant) const { return length.empty() ? constant : length[v]; }

  // The quads that a closed sector must have, or `any_quads`.
  int quads_of_sector(int s) const
  {
    return prescribed_quads.empty() || !sectors.closed[s] ? any_quads : prescribed_quads[sectors.vertex[s]];
  }

  // Makes the field one for lengths that differ from face to face. The aligned edges must be known.
  //
  // Crosses are parallel in the metric of the surface over the squared length. This metric is conformal to that of the
  // surface: a direction that is parallel in it turns, along a path, by the derivative to the left of the logarithm
  // u of the scale, u = -log length. Across an edge from a to b, with the weight w = (cot + cot) / 2 of the dual
  // edge, this is w (u_b - u_a). Around a vertex these turns add up to the Laplacian of u, by which the metrics'
  // curvatures differ.
  void set_lengths(const std::vector<double>& face_length)
  {
    std::vector<double> log_length(mesh.number_of_vertices(), 0.), areas(mesh.number_of_vertices(), 0.);
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const double area = std::sqrt(cross_product(mesh.vector(h), mesh.vector(mesh.next(h))).squared_length());
      log_length[mesh.source(h)] += area * std::log(face_length[h / 3]);
      areas[mesh.source(h)] += area;
    }
    // Vertices whose faces have no area get the length of the last of them.
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      if(!(areas[mesh.source(h)] > 0))
        log_length[mesh.source(h)] = std::log(face_length[h / 3]);
    length.assign(mesh.number_of_vertices(), 1.);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      if(areas[v] > 0)
        log_length[v] /= areas[v];
      length[v] = std::exp(log_length[v]);
    }
    // Needles have cotangents of any size; no two neighbors are parallel across more than this.
    const double largest_turn = quarter_turn / 2;
    size_turn.assign(mesh.number_of_edges(), 0.);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(is_movable(e))
      {
        const int h = mesh.halfedge_of_edge[e];
        double weight = 0;
        for(int side : { h, mesh.opposite[h] })
        {
          const double angle = frames.corner_angle(mesh.prev(side)), sine = std::sin(angle);
          weight += sine > 0 ? std::cos(angle) / sine / 2 : 0;
        }
        const double turn = weight * (log_length[mesh.source(h)] - log_length[mesh.target(h)]);
        size_turn[e] = std::abs(turn) < largest_turn ? turn : std::copysign(largest_turn, turn);
      }
  }

  double energy(const Cross_field& field) const
  {
    double sum = 0;
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(is_inner(e))
      {
        const double r = residual(e, field);
        sum += weight(e) * r * r;
      }
    for(std::size_t f = 0; f < soft_weight.size(); ++f)
      if(soft_weight[f] > 0)
      {
        const double d = field.angle[f] - nearest_soft_angle(static_cast<int>(f), field.angle[f]);
        sum += soft_weight[f] * d * d;
      }
    return sum;
  }

  // Of the four directions of the cross that a face should have, the nearest one.
  double nearest_soft_angle(int f, double angle) const
  {
    return soft_angle[f] + quarter_turn * std::round((angle - soft_angle[f]) / quarter_turn);
  }

  // The period jump that makes the residual of an edge smallest.
  int nearest_jump(int e, double angle_i, double angle_j) const
  {
    return static_cast<int>(std::lround((angle_j - angle_i - kappa(e)) / quarter_turn));
  }

  // Turns the crosses of all faces by quarter turns so that all angles lie in [-pi/4, pi/4], and
  // adapts the period jumps: the same field, its numbers small.
  void normalize(Cross_field& field) const
  {
    std::vector<int> turns(mesh.number_of_faces());
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      turns[f] = static_cast<int>(std::lround(field.angle[f] / quarter_turn));
      field.angle[f] -= turns[f] * quarter_turn;
    }
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      field.period_jump[e] = is_inner(e) ? field.period_jump[e] + turns[first_face(e)] - turns[second_face(e)] : 0;
  }

  // Gives every face next to an aligned edge the direction of that edge. A face with two of them
  // follows the one with the larger dihedral angle, that is with the smaller cosine.
  void constrain_faces_to_aligned_edges()
  {
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      int best = -1;
      double smallest_cosine = 3;
      bool conflict = false;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if(!aligned[mesh.edge_of[h]])
          continue;
        if(best != -1 && !are_parallel_crosses(frames.direction(h), frames.direction(best)))
          conflict = true;
        const double cosine = dihedral_cosine(h);
        if(best == -1 || cosine < smallest_cosine)
        {
          best = h;
          smallest_cosine = cosine;
        }
      }
      if(best == -1)
        continue;
      constrained[f] = 1;
      given_angle[f] = frames.direction(best);
      if(conflict)
        ++conflicting_faces;
    }
  }

  // Labels the components and anchors those in which nothing is given.
  void find_components()
  {
    component.assign(mesh.number_of_faces(), -1);
    anchor.clear();
    std::vector<int> stack;
    for(int seed = 0; seed < mesh.number_of_faces(); ++seed)
    {
      if(component[seed] != -1)
        continue;
      const int id = static_cast<int>(anchor.size());
      bool anything_given = false;
      component[seed] = id;
      stack.push_back(seed);
      while(!stack.empty())
      {
        const int f = stack.back();
        stack.pop_back();
        anything_given = anything_given || constrained[f] || (!soft_weight.empty() && soft_weight[f] > 0);
        for(int h = 3 * f; h < 3 * f + 3; ++h)
          if(mesh.opposite[h] != -1 && component[mesh.opposite[h] / 3] == -1)
          {
            component[mesh.opposite[h] / 3] = id;
            stack.push_back(mesh.opposite[h] / 3);
          }
      }
      anchor.push_back(anything_given ? -1 : seed);
    }
  }

private:
  static bool are_parallel_crosses(double a, double b)
  {
    // Angles of one triangle are never this close to a multiple of a right angle by chance only.
    const double rounding = 1e-9;
    const double turns = (a - b) / quarter_turn;
    return std::abs(turns - std::round(turns)) < rounding;
  }

  // The cosine of the angle between the normals of the faces at halfedge h; 2 if there is none.
  double dihedral_cosine(int h) const
  {
    const int o = mesh.opposite[h];
    if(o == -1)
      return -1;
    const auto n = cross_product(mesh.vector(h), mesh.vector(mesh.next(h)));
    const auto m = cross_product(mesh.vector(o), mesh.vector(mesh.next(o)));
    const double l = std::sqrt(n.squared_length() * m.squared_length());
    return l > 0 ? (n * m) / l : 2;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIELD_PROBLEM_H
