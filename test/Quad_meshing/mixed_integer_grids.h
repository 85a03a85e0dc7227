// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_GRIDS_H
#define CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_GRIDS_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>

// Calls f(i, j, is_down, form) for every edge of a grid of width * width variables, that of row i and column j being
// i * width + j. The edge leads from there to the next row, or to the next column; the form is the difference
// of the variables at its ends.
template <typename Function>
void for_each_grid_edge(int width, const Function& f)
{
  for(int i = 0; i < width; ++i)
    for(int j = 0; j < width; ++j)
      for(bool is_down : { true, false })
      {
        const int i2 = i + is_down, j2 = j + !is_down;
        if(i2 == width || j2 == width)
          continue;
        const CGAL::Quad_meshing::Mixed_integer_problem::Linear_form form = { { i2 * width + j2, 1. },
                                                                              { i * width + j, -1. } };
        f(i, j, is_down, form);
      }
}

#endif // CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_GRIDS_H
