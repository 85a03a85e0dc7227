// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_T_MESH_BUILDER_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_T_MESH_BUILDER_H

#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Motorcycle_graph.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Puts the lines of a motorcycle graph together to a T-mesh, and checks that it is one: all patches are rectangles,
// whose opposite sides are equally long, and they cover the surface.
class T_mesh_builder
{
  typedef Motorcycle_graph::Line Line;
  typedef Motorcycle_graph::Length Length;
  typedef Motorcycle_graph::End End;

public:
  // The parameters are those of Motorcycle_graph.
  static T_mesh build(std::shared_ptr<const Seamless_charts> charts, const std::vector<Chart_point>& second,
                      const std::vector<bool>& is_critical, Stage_progress& progress)
  {
    T_mesh result;
    result.m_charts = charts;
    const Motorcycle_graph graph(*charts, second, is_critical, progress);
    if(!graph.is_complete)
      result.message = "The lines of the motorcycle graph could not be followed to their ends.";
    else
    {
      T_mesh_builder builder(*charts, graph, is_critical, result);
      result.message = builder.run();
    }
    return result;
  }

private:
  // One line of the graph, or two that met head-on.
  struct Track
  {
    int first, second; // lines; second is -1 if there is only one
    Length length;
    bool is_closed = false;
    int first_arc = -1, last_arc = -1;
    int end_node = -1;
  };

  struct Stop
  {
    Length at;
    int node;
  };

  // A line that ends on a track.
  struct Arrival
  {
    Length at;
    bool is_from_left;
    int track; // that ends
  };

  const Seamless_charts& m_charts;
  const Motorcycle_graph& m_graph;
  const std::vector<bool>& m_is_critical;
  T_mesh& m_result;
  std::vector<Track> m_tracks;
  std::vector<int> m_track_of_line;
  std::vector<int> m_covered_by;                // per line: the other one that covers it from end to end, or -1
  std::vector<std::vector<Arrival>> m_arrivals; // per track
  std::map<int, int> m_node_of_vertex;

  T_mesh_builder(const Seamless_charts& charts, const Motorcycle_graph& graph, const std::vector<bool>& is_critical,
                 T_mesh& result)
    : m_charts(charts), m_graph(graph), m_is_critical(is_critical), m_result(result)
  {
  }

  std::string run()
  {
    if(!join_lines())
      return "Two lines of the T-mesh overlap.";
    gather_arrivals();
    make_nodes_of_vertices();
    for(std::size_t t = 0; t < m_tracks.size(); ++t)
      if(!make_arcs(static_cast<int>(t)))
        return "Two nodes of the T-mesh lie on each other.";
    if(!gather_directions())
      return "The lines around a node of the T-mesh are not in order.";
    if(!make_patches())
      return "A patch of the T-mesh is no rectangle.";
    if(!covers_the_surface())
      return "The patches of the T-mesh do not cover the surface.";
    return std::string();
  }

  // ---- tracks

  bool join_lines()
  {
    const int n = static_cast<int>(m_graph.lines.size());
    m_track_of_line.assign(n, -1);
    m_covered_by.assign(n, -1);
    for(int i = 0; i < n; ++i)
    {
      const Line& line = m_graph.lines[i];
      Track track{ i, -1, line.length };
      track.is_closed = line.starts_freely;
      if(line.end == End::HEAD_ON)
      {
        const Line& other = m_graph.lines[line.other];
        if(other.end == End::AT_A_NODE && line.pieces.empty())
        {
          m_covered_by[i] = line.other;
          continue;
        }
        if(other.end != End::HEAD_ON || other.other != i)
          return false;
        if(line.other < i)
          continue;
        track.second = line.other;
        m_track_of_line[line.other] = static_cast<int>(m_tracks.size());
      }
      m_track_of_line[i] = static_cast<int>(m_tracks.size());
      m_tracks.push_back(track);
    }
    for(int i = 0; i < n; ++i)
      if(m_covered_by[i] != -1)
        m_track_of_line[i] = m_track_of_line[m_covered_by[i]];
    m_result.m_lines.resize(m_tracks.size());
    for(std::size_t t = 0; t < m_tracks.size(); ++t)
      lay_pieces(m_tracks[t], m_result.m_lines[t]);
    return true;
  }

  bool is_forward(int line) const { return m_tracks[m_track_of_line[line]].first == line; }

  // A position on a line, on the track that it belongs to.
  Length on_track(int line, const Length& at) const
  {
    if(is_forward(line))
      return at;
    const Length& whole = m_tracks[m_track_of_line[line]].length;
    return { whole.real - at.real, whole.integer - at.integer };
  }

  void lay_pieces(const Track& track, T_mesh::Line& result) const
  {
    result.length = track.length.real;
    result.is_closed = track.is_closed;
    for(const Motorcycle_graph::Piece& p : m_graph.lines[track.first].pieces)
      result.pieces.push_back({ p.face, p.edge, p.heading, p.origin, p.begin, p.end });
    if(track.second == -1)
      return;
    const std::vector<Motorcycle_graph::Piece>& pieces = m_graph.lines[track.second].pieces;
    for(auto p = pieces.rbegin(); p != pieces.rend(); ++p)
    {
      T_mesh::Piece piece{ p->face,
                           p->edge,
                           p->heading,
                           moved(p->origin, p->heading, result.length),
                           result.length - p->end,
                           result.length - p->begin };
      if(p->edge != -1)
      {
        piece.origin = m_charts.across(p->edge, piece.origin);
        piece.heading = m_charts.heading_across(p->edge, piece.heading);
        piece.edge = m_charts.mesh.opposite[p->edge];
        piece.face = piece.edge / 3;
      }
      piece.heading = (piece.heading + 2) & 3;
      result.pieces.push_back(piece);
    }
  }

  void gather_arrivals()
  {
    m_arrivals.resize(m_tracks.size());
    for(std::size_t i = 0; i < m_graph.lines.size(); ++i)
      for(const Motorcycle_graph::Meeting& m : m_graph.lines[i].meetings)
      {
        const int line = static_cast<int>(i);
        m_arrivals[m_track_of_line[line]].push_back(
          { on_track(line, m.at), m.is_from_left == is_forward(line), m_track_of_line[m.line] });
      }
    for(std::vector<Arrival>& list : m_arrivals)
      std::stable_sort(list.begin(), list.end(),
                       [](const Arrival& a, const Arrival& b) { return a.at.real < b.at.real; });
  }

  // ---- nodes and arcs

  int add_node()
  {
    m_result.nodes.emplace_back();
    return static_cast<int>(m_result.nodes.size()) - 1;
  }

  void make_nodes_of_vertices()
  {
    for(int v = 0; v < m_charts.mesh.number_of_vertices(); ++v)
      if(m_graph.is_node[v])
      {
        const int n = m_node_of_vertex[v] = add_node();
        m_result.nodes[n].vertex = v;
        m_result.nodes[n].is_critical = m_is_critical[v];
      }
  }

  bool make_arcs(int t)
  {
    Track& track = m_tracks[t];
    const Line& line = m_graph.lines[track.first];
    std::vector<Stop> stops;
    if(!track.is_closed)
      stops.push_back({ { 0, 0 }, m_node_of_vertex.at(line.start) });
    for(const Arrival& a : m_arrivals[t])
    {
      if(stops.empty() || stops.back().at.real != a.at.real)
        stops.push_back({ a.at, add_node() });
      if(m_result.nodes[stops.back().node].vertex != -1)
        return false;
      m_tracks[a.track].end_node = stops.back().node;
    }
    if(track.is_closed)
    {
      if(stops.empty())
        return false;
      const Length& first = stops.front().at;
      stops.push_back({ { first.real + track.length.real, first.integer + track.length.integer }, stops.front().node });
    }
    else
    {
      int end = -1; // where it ends on another track, the node may not be known yet
      if(track.second != -1)
        end = m_node_of_vertex.at(m_graph.lines[track.second].start);
      else if(line.end == End::AT_A_NODE)
      {
        const auto n = m_node_of_vertex.find(end_vertex(track));
        if(n == m_node_of_vertex.end())
          return false;
        end = n->second;
      }
      if(end != -1)
        track.end_node = end;
      if(!(stops.back().at.real < track.length.real))
        return false;
      stops.push_back({ track.length, end });
    }
    for(std::size_t i = 0; i + 1 < stops.size(); ++i)
    {
      T_mesh::Arc arc;
      arc.source = stops[i].node;
      arc.target = stops[i + 1].node;
      arc.length = stops[i + 1].at.real - stops[i].at.real;
      arc.rounded_length = stops[i + 1].at.integer - stops[i].at.integer;
      arc.is_aligned = line.is_chain;
      arc.line = t;
      arc.begin = stops[i].at.real;
      if(i == 0)
        track.first_arc = static_cast<int>(m_result.arcs.size());
      track.last_arc = static_cast<int>(m_result.arcs.size());
      m_result.arcs.push_back(arc);
    }
    return true;
  }

  int end_vertex(const Track& track) const
  {
    const Line& line = m_graph.lines[track.first];
    if(line.is_chain)
      return m_charts.mesh.target(line.last_halfedge);
    const int covered = line_covered_by(track.first);
    return covered == -1 ? -1 : m_graph.lines[covered].start;
  }

  int line_covered_by(int line) const
  {
    const auto i = std::find(m_covered_by.begin(), m_covered_by.end(), line);
    return i == m_covered_by.end() ? -1 : static_cast<int>(i - m_covered_by.begin());
  }

  // ---- directions around nodes

  bool gather_directions()
  {
    for(const Track& track : m_tracks)
      if(m_result.arcs[track.last_arc].target == -1)
      {
        if(track.end_node == -1)
          return false;
        m_result.arcs[track.last_arc].target = track.end_node;
      }
    for(std::size_t t = 0; t < m_tracks.size(); ++t)
      gather_around_t_vertices(static_cast<int>(t));
    return gather_around_vertices();
  }

  void gather_around_t_vertices(int t)
  {
    const Track& track = m_tracks[t];
    const bool is_border = m_graph.lines[track.first].is_border;
    std::vector<std::array<int, 4>> out; // per T-vertex on the track, in order: ahead, left, back, right
    std::vector<int> node;
    for(const Arrival& a : m_arrivals[t])
    {
      const int n = m_tracks[a.track].end_node;
      if(node.empty() || node.back() != n)
      {
        node.push_back(n);
        out.push_back({ { -1, -1, -1, -1 } });
      }
      out.back()[a.is_from_left ? 1 : 3] = 2 * m_tracks[a.track].last_arc + 1;
    }
    for(std::size_t i = 0; i < node.size(); ++i)
    {
      const int ahead = track.first_arc + static_cast<int>(i) + (track.is_closed ? 0 : 1);
      out[i][0] = 2 * ahead;
      out[i][2] = 2 * (track.is_closed && i == 0 ? track.last_arc : ahead - 1) + 1;
      T_mesh::Node& n = m_result.nodes[node[i]];
      n.is_on_border = is_border;
      n.right_angles = is_border ? 2 : 4;
      for(int d = 0; d < 4; ++d)
        if(out[i][d] != -1)
        {
          n.directions.push_back(out[i][d]);
          n.headings.push_back(d);
        }
    }
  }

  bool gather_around_vertices()
  {
    typedef std::pair<int, int> Slot;                         // corner, heading in it
    std::map<int, std::vector<std::pair<Slot, int>>> leaving; // per vertex: slots and directions
    const Slot last_of_border(-1, -1);
    for(const Track& track : m_tracks)
    {
      if(track.is_closed)
        continue;
      const Line& line = m_graph.lines[track.first];
      leaving[line.start].push_back({ Slot(line.start_halfedge, line.start_heading), 2 * track.first_arc });
      const int back = 2 * track.last_arc + 1;
      if(track.second != -1 || (line.end == End::AT_A_NODE && !line.is_chain))
      {
        const int i = track.second != -1 ? track.second : line_covered_by(track.first);
        if(i == -1)
          return false;
        const Line& other = m_graph.lines[i];
        leaving[other.start].push_back({ Slot(other.start_halfedge, other.start_heading), back });
      }
      else if(line.is_chain)
      {
        const int o = m_charts.mesh.opposite[line.last_halfedge];
        leaving[m_charts.mesh.target(line.last_halfedge)].push_back(
          { o == -1 ? last_of_border : Slot(o, m_charts.heading_of(o)), back });
      }
    }
    for(const auto& of_vertex : m_node_of_vertex)
    {
      T_mesh::Node& node = m_result.nodes[of_vertex.second];
      std::map<Slot, int> direction;
      for(const auto& l : leaving[of_vertex.first])
        if(!direction.emplace(l.first, l.second).second)
          return false;
      int heading = 0;
      std::size_t found = 0;
      const auto take = [&](const Slot& slot)
      {
        const auto d = direction.find(slot);
        if(d == direction.end())
          return;
        node.directions.push_back(d->second);
        node.headings.push_back(heading);
        ++found;
      };
      m_charts.for_each_heading(of_vertex.first,
                                [&](int h, int d)
                                {
                                  take(Slot(h, d));
                                  ++heading;
                                });
      take(last_of_border);
      node.right_angles = heading;
      node.is_on_border = m_charts.mesh.opposite[m_charts.mesh.halfedge_of_vertex[of_vertex.first]] == -1;
      if(found != direction.size())
        return false;
    }
    return true;
  }

  // ---- patches

  // The direction after d around the patch on its left, -1 if there is nothing; and the right angles between them.
  int next(int d, const std::vector<int>& place, int& angle) const
  {
    const T_mesh::Node& n = m_result.nodes[m_result.target(d)];
    const int k = place[d ^ 1];
    if(k == 0 && n.is_on_border)
      return -1;
    const int size = static_cast<int>(n.directions.size()), i = (k + size - 1) % size;
    angle = n.headings[k] - n.headings[i] + (k == 0 ? n.right_angles : 0);
    return n.directions[i];
  }

  bool make_patches()
  {
    const int number = 2 * static_cast<int>(m_result.arcs.size());
    std::vector<int> place(number, -1); // per direction: its place around its source
    for(const T_mesh::Node& n : m_result.nodes)
      for(std::size_t k = 0; k < n.directions.size(); ++k)
        place[n.directions[k]] = static_cast<int>(k);
    if(std::find(place.begin(), place.end(), -1) != place.end())
      return false;
    std::vector<bool> is_done(number, false);
    for(int first = 0; first < number; ++first)
    {
      if(is_done[first])
        continue;
      std::vector<int> cycle;
      std::vector<bool> turns; // after each direction
      int d = first;
      while(d != -1 && !is_done[d])
      {
        is_done[d] = true;
        int angle = 0;
        const int after = next(d, place, angle);
        if(after != -1 && angle != 1 && angle != 2)
          return false;
        cycle.push_back(d);
        turns.push_back(angle == 1);
        d = after;
      }
      if(d == -1)
      {
        if(cycle.size() != 1)
          return false;
        continue; // outside
      }
      if(d != first || !add_patch(cycle, turns))
        return false;
    }
    return true;
  }

  bool add_patch(const std::vector<int>& cycle, const std::vector<bool>& turns)
  {
    const std::size_t n = cycle.size();
    std::size_t begin = 0;
    while(begin < n && !turns[(begin + n - 1) % n])
      ++begin;
    T_mesh::Patch patch;
    std::size_t side = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      if(side == 4)
        return false;
      const std::size_t k = (begin + i) % n;
      patch.sides[side].push_back(cycle[k]);
      side += turns[k];
    }
    if(side != 4)
      return false;
    const int number = static_cast<int>(m_result.patches.size());
    Length length[4];
    for(int k = 0; k < 4; ++k)
      for(int d : patch.sides[k])
      {
        T_mesh::Arc& arc = m_result.arcs[d / 2];
        arc.patch[d & 1] = number;
        length[k].real += arc.length;
        length[k].integer += arc.rounded_length;
      }
    for(int k = 0; k < 2; ++k)
      if(length[k].real != length[k + 2].real || length[k].integer != length[k + 2].integer)
        return false;
    m_result.patches.push_back(patch);
    return true;
  }

  bool covers_the_surface() const
  {
    const Indexed_triangle_mesh& m = m_charts.mesh;
    int surface = m.number_of_faces() - m.number_of_edges();
    for(int v = 0; v < m.number_of_vertices(); ++v)
      surface += m.halfedge_of_vertex[v] != -1;
    return surface == static_cast<int>(m_result.nodes.size()) - static_cast<int>(m_result.arcs.size()) +
                        static_cast<int>(m_result.patches.size());
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_T_MESH_BUILDER_H
