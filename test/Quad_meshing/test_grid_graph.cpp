// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The graph of the grid lines of a folded map knows how far every edge leads. In a map with one chart that is the
// difference of coordinates of its two ends, before and after the repair of the graph.

#undef NDEBUG
#include "stage_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph_repair.h>
#include <CGAL/Quad_meshing/Extraction/internal/read_grid_map.h>
#include <CGAL/Quad_meshing/Extraction/internal/trace_grid_graph.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

namespace internal = CGAL::Quad_meshing::internal;

namespace {

// The unit squares of a 6 x 6 grid, each of two triangles, with inner vertices that are moved in the map.
struct Folded_square
{
  typedef internal::Grid_map::Point_2 Point_2;

  static constexpr int size = 6;
  internal::Indexed_triangle_mesh mesh;
  internal::Grid_map map;

  // All coordinates are multiples of 1 / denominator. A vertex gets over the next two at most.
  Folded_square(int moved_vertices, int denominator, unsigned int seed)
    : mesh(internal::make_indexed_triangle_mesh(test_meshes::make_mesh(test_meshes::grid(size, size, size, size)),
                                                CGAL::parameters::default_values()))
    , map(mesh)
  {
    std::mt19937 rng(seed);
    std::vector<Point_2> image;
    for(const auto& p : mesh.points)
      image.emplace_back(p.x(), p.y());
    for(int i = 0; i < moved_vertices; ++i)
    {
      const int x = 1 + static_cast<int>(rng() % (size - 1)), y = 1 + static_cast<int>(rng() % (size - 1));
      const auto jump = [&]()
      { return (static_cast<int>(rng() % (4 * denominator + 1)) - 2 * denominator) * 1. / denominator; };
      const double dx = jump(), dy = jump();
      image[y * (size + 1) + x] = Point_2(x + dx, y + dy);
    }
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      map.uv.push_back(image[mesh.source(h)]);
    internal::make_transitions(map);
    internal::compute_signs(map);
  }
};

// Every edge leads from either end as far as it says, along a line of the grid. Returns how many have length 0.
std::size_t check_lengths(const internal::Grid_graph& g, const internal::Grid_nodes& nodes)
{
  std::size_t of_length_0 = 0;
  for(int r = 0; r < g.number_of_rays(); ++r)
  {
    const int o = g.opposite[r];
    if(o < 0)
      continue;
    assert(g.opposite[o] == r);
    const auto from = nodes.point_of_ray(r), to = nodes.point_of_ray(o);
    const int d = nodes.ray_direction[r];
    assert(internal::coordinate(to, d + 1) == internal::coordinate(from, d + 1));
    assert(internal::coordinate(to, d) - internal::coordinate(from, d) == g.length[r]);
    of_length_0 += g.length[r] == 0;
  }
  return of_length_0;
}

void test_lengths()
{
  std::size_t of_length_0 = 0, joined = 0;
  for(int denominator : { 64, 8, 2 })
    for(unsigned int run = 0; run < 600; ++run)
    {
      const Folded_square square(1 + run % 4, denominator, run);
      // The extraction moves vertices until no triangle is without area: a line may pass a grid point there unseen.
      if(std::count(square.map.sign.begin(), square.map.sign.end(), 0) > 0)
        continue;
      stage_checks::Silent_progress silent;
      const internal::Grid_nodes nodes(square.map, silent.progress);
      internal::Grid_graph g;
      assert(internal::make_grid_graph(square.map, nodes, g, silent.progress, 0, 1));
      of_length_0 += check_lengths(g, nodes);
      internal::Grid_graph_repair repair(g);
      repair(silent.progress);
      // Edges that are removed leave nodes of two rays that may bound a right angle.
      if(repair.cancelled_crossings == 0 || repair.removed_edges != 0)
        continue;
      ++joined;
      check_lengths(g, nodes);
    }
  std::cout << of_length_0 << " edges of length 0; " << joined << " graphs repaired" << std::endl;
  assert(of_length_0 > 1000 && joined > 50);
}

} // namespace

int main(int argc, char** argv) { return run_cases(argc, argv, { { "lengths", test_lengths } }); }
