// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_QUAD_EXTRACTOR_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_QUAD_EXTRACTOR_H

#include <CGAL/Quad_meshing/Extraction/Quad_extraction_result.h>
#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph_repair.h>
#include <CGAL/Quad_meshing/Extraction/internal/Grid_map_repair.h>
#include <CGAL/Quad_meshing/Extraction/internal/cells_with_holes.h>
#include <CGAL/Quad_meshing/Extraction/internal/compare_topology.h>
#include <CGAL/Quad_meshing/Extraction/internal/extract_quads.h>
#include <CGAL/Quad_meshing/Extraction/internal/read_grid_map.h>
#include <CGAL/Quad_meshing/Extraction/internal/trace_grid_graph.h>
#include <CGAL/Quad_meshing/Extraction/internal/write_grid_graph.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Faces of more sides are holes rather than faces.
const int largest_degree_kept = 16;

// The stages of the extraction (Ebke, Bommes, Campen, Kobbelt 2013): make the map consistent, find the grid points,
// trace the grid lines between them, walk around the faces, repair what fold-overs left.
class Quad_extractor
{
public:
  Quad_extractor(Grid_map& map, Extracted_quads& quads, Quad_extraction_result& result, Stage_progress& progress,
                 int unfolding_sweeps)
    : m_map(map)
    , m_quads(quads)
    , m_graph(quads.graph)
    , m_vertex_of_ray(quads.vertex_of_ray)
    , m_result(result)
    , m_progress(progress)
    , m_unfolding_sweeps(unfolding_sweeps)
  {
  }

  // Returns whether there is something to write.
  bool run()
  {
    const bool is_done = run_stages();
    return m_progress.is_stopped() ? stop() : is_done;
  }

private:
  Grid_map& m_map;
  Extracted_quads& m_quads;
  Grid_graph& m_graph;
  std::vector<int>& m_vertex_of_ray;
  Quad_extraction_result& m_result;
  Stage_progress& m_progress;
  const int m_unfolding_sweeps;
  std::vector<Grid_location> m_locations; // per node
  std::vector<int> m_node_of_vertex;

  bool fail(const std::string& why)
  {
    m_result.status = Quad_extraction_status::FAILED;
    m_result.message = why;
    return false;
  }

  // How far the progress has come at the end of each part.
  static constexpr double consistent = 0.3, collected = 0.4, traced = 0.9;

  // After a stop by the visitor, whatever is computed is not used.
  bool run_stages()
  {
    if(m_map.mesh.number_of_faces() == 0)
      return fail("The triangle mesh has no faces.");
    const std::string defect = defect_of_coordinates(m_map);
    if(!defect.empty())
      return fail(defect);

    m_progress.begin_part(consistent);
    make_map_consistent();
    if(!m_progress.go_further(consistent))
      return false;
    m_progress.begin_part(collected);
    const Grid_nodes nodes(m_map, m_progress);
    if(!m_progress.go_further(collected) || !make_grid_graph(m_map, nodes, m_graph, m_progress, collected, traced))
      return false;
    locate(nodes);

    m_progress.begin_part(1.);
    if(!m_progress.go_further())
      return false;
    m_graph.find_faces();
    if(!m_progress.go_further())
      return false;
    repair();
    if(!m_progress.go_further())
      return false;
    open_cells_with_holes(nodes);
    m_node_of_vertex = make_vertices(m_graph, m_vertex_of_ray);
    for(int n : m_node_of_vertex)
      m_quads.vertices.push_back(m_locations[n]);
    if(!m_progress.go_further())
      return false;
    const bool is_done = summarize();
    return m_progress.go_further(1.) && is_done;
  }

  void make_map_consistent()
  {
    const std::vector<int> inexact = make_transitions(m_map);
    Grid_map_repair map_repair(m_map, m_progress);
    m_result.inexact_transitions = inexact.size();
    if(!inexact.empty())
    {
      map_repair.make_transitions_exact(inexact);
      m_result.inconsistent_transitions = map_repair.number_of_inexact_transitions();
      m_result.largest_coordinate_change = map_repair.largest_change;
    }

    compute_signs(m_map);
    const std::ptrdiff_t bad = number_of_bad_faces();
    if(bad > 0 && m_unfolding_sweeps > 0)
    {
      map_repair.undo_fold_overs(m_unfolding_sweeps);
      map_repair.relax_fold_overs(m_unfolding_sweeps);
    }
    m_result.moved_vertices = map_repair.moved_vertices;
    m_result.unfolded_faces = bad - number_of_bad_faces();
    if(number_of_bad_faces() > 0)
      map_repair.perturb_fold_overs();
    for(int f = 0; f < m_map.mesh.number_of_faces(); ++f)
      if(m_map.sign[f] <= 0)
        (m_map.sign[f] < 0 ? m_result.folded_faces : m_result.degenerate_faces).push_back(f);
  }

  std::ptrdiff_t number_of_bad_faces() const
  {
    return std::count_if(m_map.sign.begin(), m_map.sign.end(), [](signed char s) { return s <= 0; });
  }

  bool stop()
  {
    m_result.status = Quad_extraction_status::STOPPED;
    m_result.message = "The visitor stopped the extraction.";
    return false;
  }

  void locate(const Grid_nodes& nodes)
  {
    m_locations.resize(nodes.number_of_nodes());
    for(int n = 0; n < nodes.number_of_nodes(); ++n)
    {
      const int h = nodes.node_halfedge[n], f = h / 3, k = h % 3;
      Grid_location& l = m_locations[n];
      l.face = f;
      l.weights = { { 0, 0, 0 } };
      const Grid_map::Point_2& p = nodes.node_point[n];
      if(nodes.is_on_vertex(n))
        l.weights[k] = 1;
      else if(nodes.is_on_edge(n))
      {
        const Grid_map::Point_2& a = m_map.uv[h];
        const Grid_map::Point_2& b = m_map.uv[Indexed_triangle_mesh::next(h)];
        const double dx = b.x() - a.x(), dy = b.y() - a.y();
        const double t = std::fabs(dx) >= std::fabs(dy) ? (p.x() - a.x()) / dx : (p.y() - a.y()) / dy;
        l.weights[k] = 1 - t;
        l.weights[(k + 1) % 3] = t;
      }
      else
      {
        const Grid_map::Point_2* c = &m_map.uv[3 * f];
        double sum = 0;
        for(int i = 0; i < 3; ++i)
        {
          const Grid_map::Point_2& a = c[(i + 1) % 3];
          const Grid_map::Point_2& b = c[(i + 2) % 3];
          l.weights[i] = std::fabs((a.x() - p.x()) * (b.y() - p.y()) - (a.y() - p.y()) * (b.x() - p.x()));
          sum += l.weights[i];
        }
        // In a triangle thinner than round-off any point is as good.
        for(double& w : l.weights)
          w = sum > 0 ? w / sum : 1. / 3;
      }
    }
  }

  // An exact map leaves nothing to do here, and all faces of its graph are quads.
  void repair()
  {
    m_result.edges_cut_by_border =
      std::count(m_graph.opposite.begin(), m_graph.opposite.end(), static_cast<int>(Grid_graph::CUT_BY_BORDER));
    bool clean = std::all_of(m_graph.degree.begin(), m_graph.degree.end(), [](int d) { return d == 4; });
    clean &= std::count(m_graph.opposite.begin(), m_graph.opposite.end(), static_cast<int>(Grid_graph::FAILED)) == 0;
    if(clean)
      return;
    m_result.singular_vertices_off_grid = number_of_singular_vertices_off_grid(m_map);

    Grid_graph_repair graph_repair(m_graph);
    graph_repair(m_progress);
    m_result.cancelled_crossings = graph_repair.cancelled_crossings;
    m_result.merged_vertices = graph_repair.merged_nodes;
    m_result.removed_edges = graph_repair.removed_edges;

    const Grid_face_splitter splitter(
      m_graph, largest_degree_kept,
      [&](int m, int n)
      { return squared_distance(position(m_map.mesh, m_locations[m]), position(m_map.mesh, m_locations[n])); });
    m_result.joined_faces = splitter.joined_faces;
    m_result.split_faces = splitter.split_faces;

    m_graph.find_faces();
    m_result.dropped_faces =
      m_graph.drop_faces([&](int f) { return m_graph.degree[f] < 3 || m_graph.degree[f] > largest_degree_kept; });
  }

  // Only where the map is positive everywhere the left side of a line is known by orientation tests.
  void open_cells_with_holes(const Grid_nodes& nodes)
  {
    if(number_of_bad_faces() > 0)
      return;
    std::vector<char> is_open(m_graph.number_of_faces(), false);
    for(int f : Cells_with_holes(m_map, nodes, m_graph)())
      is_open[f] = true;
    m_result.cells_with_holes = m_graph.drop_faces([&](int f) { return is_open[f]; });
  }

  void summarize_vertices()
  {
    const std::size_t n = m_node_of_vertex.size();
    std::vector<int> valence(n, 0);
    std::vector<char> on_border(n, false), has_vertex(m_graph.number_of_nodes(), false);
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
    {
      const int v = m_vertex_of_ray[r];
      if(v == -1)
        continue;
      ++valence[v];
      if(m_graph.face[r] < 0 || m_graph.face[m_graph.opposite[r]] < 0)
        on_border[v] = true;
    }
    for(std::size_t v = 0; v < n; ++v)
    {
      if(valence[v] != (on_border[v] ? 3 : 4))
        ++(on_border[v] ? m_result.irregular_border_vertices : m_result.irregular_vertices);
      m_result.split_vertices += has_vertex[m_node_of_vertex[v]];
      has_vertex[m_node_of_vertex[v]] = true;
    }

    std::vector<std::pair<int, int>> neighbors;
    for(int i = 0; i < m_graph.number_of_nodes(); ++i)
    {
      neighbors.clear();
      m_graph.for_each_ray_of_node(i,
                                   [&](int r)
                                   {
                                     const int v = m_vertex_of_ray[r];
                                     if(v == -1)
                                       return;
                                     const int w = m_vertex_of_ray[m_graph.opposite[r]];
                                     if(v < w)
                                       neighbors.push_back(std::make_pair(v, w));
                                     else if(v == w && r < m_graph.opposite[r])
                                       ++m_result.multiple_edges;
                                   });
      std::sort(neighbors.begin(), neighbors.end());
      m_result.multiple_edges += neighbors.end() - std::unique(neighbors.begin(), neighbors.end());
    }
  }

  bool summarize()
  {
    m_result.vertices = m_node_of_vertex.size();
    for(int d : m_graph.degree)
      ++(d == 4 ? m_result.quads : m_result.other_faces);
    summarize_vertices();
    m_result.same_topology = surface_topology(halfedge_arrays(m_map.mesh)) ==
                             surface_topology(halfedge_arrays(m_graph, m_vertex_of_ray, m_node_of_vertex.size()));

    double area = 0;
    for(int f = 0; f < m_map.mesh.number_of_faces(); ++f)
      area += CGAL::area(m_map.uv[3 * f], m_map.uv[3 * f + 1], m_map.uv[3 * f + 2]);
    m_result.uncovered_area = area - static_cast<double>(m_result.quads);

    if(m_graph.number_of_faces() == 0)
      return fail(is_repaired() ? defects_of_map() + "nothing could be extracted."
                                : "The map covers no complete grid cell.");
    if(is_repaired())
    {
      m_result.status = Quad_extraction_status::REPAIRED;
      m_result.message = defects_of_map() + "the mesh has " + std::to_string(m_result.quads) + " quads and " +
                         std::to_string(m_result.other_faces) + " other faces, and " +
                         (m_result.same_topology ? "the topology of the input." : "another topology than the input.");
    }
    else if(m_result.multiple_edges > 0)
    {
      m_result.status = Quad_extraction_status::NOT_SIMPLE;
      m_result.message = "The grid is too coarse: " + std::to_string(m_result.multiple_edges) +
                         " edges join vertices that another edge joins already.";
    }
    else
    {
      m_result.status = Quad_extraction_status::VALID;
      m_result.message = "The mesh has " + std::to_string(m_result.quads) + " quads and " +
                         std::to_string(m_result.irregular_vertices) + " irregular inner vertices.";
    }
    return true;
  }

  // The first part of a sentence.
  std::string defects_of_map() const
  {
    std::string s;
    auto add = [&](std::size_t n, const char* what)
    {
      if(n > 0)
        s += (s.empty() ? "" : ", ") + std::to_string(n) + what;
    };
    add(m_result.unfolded_faces, " triangles had to be unfolded");
    add(m_result.folded_faces.size(), " triangles are folded over");
    add(m_result.degenerate_faces.size(), " triangles have no area");
    add(m_result.inconsistent_transitions, " transitions are inconsistent");
    add(m_result.singular_vertices_off_grid, " singular vertices are not on grid points");
    return "The map is no integer-grid map" + (s.empty() ? s : " (" + s + ")") + "; ";
  }

  bool is_repaired() const
  {
    return !m_result.folded_faces.empty() || !m_result.degenerate_faces.empty() || m_result.unfolded_faces > 0 ||
           m_result.inconsistent_transitions > 0 || m_result.removed_edges > 0 || m_result.cancelled_crossings > 0 ||
           m_result.other_faces > 0 || m_result.dropped_faces > 0;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_QUAD_EXTRACTOR_H
