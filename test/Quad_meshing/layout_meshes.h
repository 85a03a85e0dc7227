// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Layouts for the meshes of test_meshes.h.

#ifndef CGAL_QUAD_MESHING_TEST_LAYOUT_MESHES_H
#define CGAL_QUAD_MESHING_TEST_LAYOUT_MESHES_H

#include "structure_meshes.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace layout_meshes {

typedef CGAL::Quad_meshing::Surface_layout Layout;
typedef structure_meshes::Quad_soup Quad_soup;

inline Layout::Place place(double x, double y, double z)
{
  Layout::Place p;
  p.point = { { x, y, z } };
  return p;
}

inline std::size_t add_arc(Layout& layout, std::size_t source, std::size_t target)
{
  layout.arcs.emplace_back();
  layout.arcs.back().source = source;
  layout.arcs.back().target = target;
  return layout.arcs.size() - 1;
}

// The rectangle [0, w] x [0, h] as one patch.
inline Layout rectangle(double w, double h)
{
  Layout layout;
  layout.nodes = { place(0, 0, 0), place(w, 0, 0), place(w, h, 0), place(0, h, 0) };
  layout.patches.resize(1);
  for(std::size_t k = 0; k < 4; ++k)
    layout.patches[0].sides[k] = { Layout::Side_arc{ add_arc(layout, k, (k + 1) % 4), true } };
  return layout;
}

// The rectangle [0, 3] x [0, 2]: a patch on the left of x = 1, whose right side has a T-vertex, and two on the right.
inline Layout t_layout()
{
  Layout layout;
  layout.nodes = { place(0, 0, 0), place(1, 0, 0), place(3, 0, 0), place(3, 0.8, 0),
                   place(3, 2, 0), place(1, 2, 0), place(0, 2, 0), place(1, 1.2, 0) };
  const std::size_t left_bottom = add_arc(layout, 0, 1), right_bottom = add_arc(layout, 1, 2),
                    right_low = add_arc(layout, 2, 3), right_high = add_arc(layout, 3, 4),
                    right_top = add_arc(layout, 4, 5), left_top = add_arc(layout, 5, 6), left = add_arc(layout, 6, 0),
                    low = add_arc(layout, 1, 7), high = add_arc(layout, 7, 5), middle = add_arc(layout, 7, 3);
  layout.patches.resize(3);
  layout.patches[0].sides = {
    { { { left_bottom, true } }, { { low, true }, { high, true } }, { { left_top, true } }, { { left, true } } }
  };
  layout.patches[1].sides = {
    { { { right_bottom, true } }, { { right_low, true } }, { { middle, false } }, { { low, false } } }
  };
  layout.patches[2].sides = {
    { { { middle, true } }, { { right_high, true } }, { { right_top, true } }, { { high, false } } }
  };
  return layout;
}

// The numbers of segments of its arcs that its four free numbers give.
inline std::vector<int> t_layout_numbers(int left_width, int right_width, int low, int high)
{
  return { left_width, right_width, low, high, right_width, left_width, low + high, low, high, right_width };
}

inline Quad_soup cube_quads() { return structure_meshes::cube(1); }

// The layout of a coarse quad mesh, after its points were mapped.
template <typename Map>
Layout mapped(Quad_soup quads, const Map& map)
{
  for(structure_meshes::Point_3& p : quads.points)
    p = map(p);
  return CGAL::Quad_meshing::layout_from_quad_mesh(structure_meshes::make_mesh(quads));
}

// Around an ellipsoid with these half axes.
inline Layout around(const Quad_soup& quads, const std::array<double, 3>& axes)
{
  typedef structure_meshes::Point_3 Point_3;
  return mapped(quads,
                [&](const Point_3& p)
                {
                  const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
                  return Point_3(axes[0] * p.x() / r, axes[1] * p.y() / r, axes[2] * p.z() / r);
                });
}

// The sides of the unit cube, and of the sheared one.
inline Layout sheared_cube(double shear = 0.5)
{
  typedef structure_meshes::Point_3 Point_3;
  return mapped(cube_quads(), [&](const Point_3& p)
                { return Point_3((p.x() + 1) / 2 + shear * (p.z() + 1) / 2, (p.y() + 1) / 2, (p.z() + 1) / 2); });
}

inline Layout cube() { return sheared_cube(0); }

// A torus cut along a circle around its axis and one around its tube: one node, two loops, one patch.
inline Layout torus(double big_radius, double small_radius)
{
  Layout layout;
  layout.nodes = { place(big_radius + small_radius, 0, 0) };
  const std::size_t around = add_arc(layout, 0, 0), tube = add_arc(layout, 0, 0);
  for(int i = 1; i < 6; ++i)
  {
    const double t = 2 * test_meshes::pi * i / 6, r = big_radius + small_radius * std::cos(t);
    layout.arcs[around].way.push_back(
      place((big_radius + small_radius) * std::cos(t), (big_radius + small_radius) * std::sin(t), 0));
    layout.arcs[tube].way.push_back(place(r, 0, small_radius * std::sin(t)));
  }
  layout.patches.resize(1);
  layout.patches[0].sides = {
    { { { around, true } }, { { tube, true } }, { { around, false } }, { { tube, false } } }
  };
  return layout;
}

// n patches around an open cylinder.
inline Layout cylinder(std::size_t n, double radius, double height)
{
  Layout layout;
  for(double z : { 0., height })
    for(std::size_t i = 0; i < n; ++i)
      layout.nodes.push_back(
        place(radius * std::cos(2 * test_meshes::pi * i / n), radius * std::sin(2 * test_meshes::pi * i / n), z));
  for(std::size_t i = 0; i < n; ++i)
    add_arc(layout, i, (i + 1) % n);
  for(std::size_t i = 0; i < n; ++i)
    add_arc(layout, n + i, n + (i + 1) % n);
  for(std::size_t i = 0; i < n; ++i)
    add_arc(layout, i, n + i);
  layout.patches.resize(n);
  for(std::size_t i = 0; i < n; ++i)
    layout.patches[i].sides = {
      { { { i, true } }, { { 2 * n + (i + 1) % n, true } }, { { n + i, false } }, { { 2 * n + i, false } } }
    };
  return layout;
}

} // namespace layout_meshes

#endif // CGAL_QUAD_MESHING_TEST_LAYOUT_MESHES_H
