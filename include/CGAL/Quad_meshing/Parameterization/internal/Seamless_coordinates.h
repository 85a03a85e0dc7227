// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_COORDINATES_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_COORDINATES_H

#include <CGAL/Quad_meshing/Parameterization/internal/Combed_charts.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Integer_relations.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The coordinates of all corners of a seamless map, as linear forms with integer coefficients in independent variables.
//
// Raw variables are the two coordinates of every vertex, in its first wedge, and the two translations
// of every cut path. The corners of the other wedges follow through the transitions. What remains
// are relations between raw variables: around every cut vertex the transitions must close,
// and the two ends of an aligned edge share one coordinate. They are eliminated in integers
// (`Integer_relations`), so every choice of the variables that are left, with integers for those in
// `is_integer`, is a map whose transitions are grid automorphisms, whose singular vertices lie on grid points and
// whose aligned edges lie on grid lines: there is no other condition left to check but orientation.
class Seamless_coordinates
{
public:
  typedef std::pair<int, double> Term; // variable, coefficient

  const Combed_charts& charts;
  std::vector<bool> is_integer;                              // per variable
  std::vector<std::array<std::vector<Term>, 2>> coordinates; // per wedge: u and v

  // `is_aligned` per edge: the edge has to lie on a grid line. `is_singular` per vertex: the vertex has to
  // lie on a grid point.
  Seamless_coordinates(const Combed_charts& charts, const std::vector<bool>& is_singular,
                       const std::vector<bool>& is_aligned)
    : charts(charts)
    , m_mesh(charts.mesh)
    , m_relations(2 * m_mesh.number_of_vertices() + 2 * static_cast<int>(charts.paths.size()))
    , m_raw_is_integer(m_relations.number_of_variables(), false)
  {
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_singular[v])
        m_raw_is_integer[2 * v] = m_raw_is_integer[2 * v + 1] = true;
    for(int i = 2 * m_mesh.number_of_vertices(); i < m_relations.number_of_variables(); ++i)
      m_raw_is_integer[i] = true;

    unfold_wedges();
    align_edges(is_aligned);
    for(const Grid_form& closure : m_closures)
      for(const Integer_form& f : closure)
        m_relations.add_equation(f, [this](int i) { return prefers_translations(i); });
    pin_components();
    number_variables();
  }

  int number_of_variables() const { return static_cast<int>(is_integer.size()); }

  // The coordinate (0 = u, 1 = v) that is constant along halfedge h, in the chart of its face, if the field runs
  // along it.
  int constant_coordinate(int h) const { return quarter_of(h) % 2 == 0 ? 1 : 0; }

  // The direction of the u-axis (0), v-axis (1), or their negatives (2, 3) that is nearest to halfedge h in the chart
  // of its face.
  int quarter_of(int h) const
  {
    const int f = h / 3;
    const auto x = m_mesh.vector(3 * f), d = m_mesh.vector(h);
    const auto n = CGAL::cross_product(x, m_mesh.vector(3 * f + 1));
    const auto y = CGAL::cross_product(n, x);
    const double dx = (d * x) / std::sqrt(x * x), dy = (d * y) / std::sqrt(y * y);
    const auto& u = charts.u_direction[f];
    const double a = dx * u[0] + dy * u[1], b = -dx * u[1] + dy * u[0];
    return std::abs(a) >= std::abs(b) ? (a >= 0 ? 0 : 2) : (b >= 0 ? 1 : 3);
  }

  // Value of a coordinate of a wedge for given variables.
  template <typename Vector>
  double value(int wedge, int coordinate, const Vector& x) const
  {
    double s = 0;
    for(const Term& t : coordinates[wedge][coordinate])
      s += t.second * x[t.first];
    return s;
  }

private:
  const Indexed_triangle_mesh& m_mesh;
  Integer_relations m_relations;
  std::vector<bool> m_raw_is_integer;
  std::vector<Grid_form> m_wedge_form; // per wedge, in raw variables
  std::vector<Grid_form> m_closures;   // per cut vertex inside the surface: these vanish

  int prefers_translations(int i) const { return i >= 2 * m_mesh.number_of_vertices() ? 1 : 0; }
  int prefers_vertices(int i) const { return i >= 2 * m_mesh.number_of_vertices() ? 0 : 1; }

  // The point a of the chart of the face of h, in the chart beyond h.
  Grid_form carried_across(int h, const Grid_form& a) const
  {
    const int id = charts.path_crossed(h);
    if(id == 0)
      return a;
    const int path = std::abs(id) - 1;
    const int t = 2 * m_mesh.number_of_vertices() + 2 * path;
    Grid_form b;
    if(id > 0)
    {
      b = rotated(a, charts.paths[path].rotation);
      b[0].add(Integer_form::variable(t));
      b[1].add(Integer_form::variable(t + 1));
    }
    else
    {
      b = a;
      b[0].add(Integer_form::variable(t), -1);
      b[1].add(Integer_form::variable(t + 1), -1);
      b = rotated(b, -charts.paths[path].rotation);
    }
    return b;
  }

  void unfold_wedges()
  {
    m_wedge_form.resize(charts.number_of_wedges());
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      const int first = charts.first_wedge[v], last = charts.first_wedge[v + 1];
      if(first == last)
        continue;
      m_wedge_form[first] = { { Integer_form::variable(2 * v), Integer_form::variable(2 * v + 1) } };
      Grid_form p = m_wedge_form[first];
      for(int w = first; w < last; ++w)
      {
        const int out = Indexed_triangle_mesh::prev(charts.wedge_halfedges[w].back()); // leads to the next wedge
        if(m_mesh.opposite[out] == -1)
          break;
        if(!charts.is_cut[m_mesh.edge_of[out]])
          break; // an uncut vertex inside the surface
        p = carried_across(out, p);
        if(w + 1 < last)
          m_wedge_form[w + 1] = p;
        else
        {
          Grid_form closure = p;
          closure[0].add(m_wedge_form[first][0], -1);
          closure[1].add(m_wedge_form[first][1], -1);
          m_closures.push_back(closure);
        }
      }
    }
  }

  void align_edges(const std::vector<bool>& is_aligned)
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if(!is_aligned[e])
        continue;
      const int h = m_mesh.halfedge_of_edge[e];
      const int c = constant_coordinate(h);
      const int from = charts.wedge_of_corner[h];
      const int to = charts.wedge_of_corner[Indexed_triangle_mesh::next(h)];
      // The line is an integer one, hence so is the raw coordinate that makes it up in either wedge.
      for(int w : { from, to })
        for(const Integer_form::Term& t : m_wedge_form[w][c].terms)
          m_raw_is_integer[t.first] = true;
      Integer_form f = m_wedge_form[to][c];
      f.add(m_wedge_form[from][c], -1);
      m_relations.add_equation(f, [this](int i) { return prefers_vertices(i); });
    }
  }

  // Shifting a whole component changes nothing but the values: two variables of each component are set
  // to zero. The shift by (1, 0) or (0, 1) in the chart of the disk adds the same to every vertex and (I - R) times
  // it to every translation; integers are taken first, for a shift that makes them zero need not be an integer.
  void pin_components()
  {
    struct Candidate
    {
      int variable;
      std::array<int, 2> response;
    };
    std::vector<std::vector<Candidate>> candidates(charts.number_of_components);
    auto offer = [&](int i, int component, int du, int dv)
    {
      if((du != 0 || dv != 0) && m_relations.is_free(i))
        candidates[component].push_back(Candidate{ i, { { du, dv } } });
    };
    std::vector<int> component_of_vertex(m_mesh.number_of_vertices(), -1);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      for(int v : m_mesh.corners[f])
        component_of_vertex[v] = charts.component[f];
    for(int pass = 0; pass < 3; ++pass) // integer vertex coordinates, translations, other coordinates
    {
      if(pass == 1)
      {
        static const int rotated_u[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
        for(std::size_t k = 0; k < charts.paths.size(); ++k)
        {
          const int t = 2 * m_mesh.number_of_vertices() + 2 * static_cast<int>(k), r = charts.paths[k].rotation;
          const int c = charts.component[charts.paths[k].halfedges.front() / 3];
          // (I - R) applied to the two unit shifts, read row by row
          offer(t, c, 1 - rotated_u[r][0], rotated_u[r][1]);
          offer(t + 1, c, -rotated_u[r][1], 1 - rotated_u[r][0]);
        }
        continue;
      }
      for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
        for(int c = 0; c < 2; ++c)
          if(component_of_vertex[v] != -1 && m_raw_is_integer[2 * v + c] == (pass == 0))
            offer(2 * v + c, component_of_vertex[v], c == 0, c == 1);
    }
    for(const std::vector<Candidate>& list : candidates)
    {
      const Candidate* first = nullptr;
      for(const Candidate& c : list)
      {
        if(first != nullptr && first->response[0] * c.response[1] == first->response[1] * c.response[0])
          continue;
        m_relations.add_equation(Integer_form::variable(c.variable), [](int) { return 0; });
        if(first != nullptr)
          break;
        first = &c;
      }
    }
  }

  void number_variables()
  {
    std::vector<int> number(m_relations.number_of_variables(), -1);
    coordinates.resize(m_wedge_form.size());
    for(std::size_t w = 0; w < m_wedge_form.size(); ++w)
      for(int c = 0; c < 2; ++c)
        for(const Integer_form::Term& t : m_relations.resolved(m_wedge_form[w][c]).terms)
        {
          if(number.size() < static_cast<std::size_t>(m_relations.number_of_variables()))
            number.resize(m_relations.number_of_variables(), -1);
          if(number[t.first] == -1)
          {
            number[t.first] = number_of_variables();
            // what a unimodular change of variables has added replaces integers
            is_integer.push_back(t.first >= static_cast<int>(m_raw_is_integer.size()) || m_raw_is_integer[t.first]);
          }
          coordinates[w][c].push_back(Term(number[t.first], t.second));
        }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_COORDINATES_H
