// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MOTORCYCLE_GRAPH_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MOTORCYCLE_GRAPH_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_charts.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The motorcycle graph of a seamless map: from every node a line starts in each heading and runs straight on until it
// meets an earlier line, an aligned edge, or a node. Together with the chains of aligned edges these lines cut the
// surface into rectangles with T-vertices (Eppstein, Goodrich, Kim and Tamstorf, "Motorcycle graphs: canonical quad
// mesh partitioning", 2008; on seamless maps: Campen, Bommes and Kobbelt, "Quantized global parametrization", 2015).
//
// The map must be exact, without fold-overs: then every place where two lines meet has coordinates that are doubles,
// and every decision is a comparison of doubles or an orientation test. All lengths are measured in a second map
// besides, with the same transitions up to translations: that is what they become when integers are chosen.
class Motorcycle_graph
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;
  typedef Indexed_triangle_mesh Mesh;

public:
  struct Length
  {
    double real = 0;    // in the map
    double integer = 0; // in the second map
  };

  enum class End
  {
    ON_A_LINE, // that another node has sent, or on a chain of aligned edges
    AT_A_NODE,
    HEAD_ON,      // met a line that came the opposite way
    AT_THE_BORDER // that is not aligned
  };

  struct Meeting
  {
    int line; // that ends here
    bool is_from_left;
    Length at; // from the start
  };

  // A part of a line in a face, or along an edge of it; then the face lies on the left.
  struct Piece
  {
    int face;
    int edge;           // the halfedge that it runs along, -1 if none
    int heading;        // in the chart of the face
    Chart_point origin; // the start of the line, seen from this chart
    double begin, end;  // distances from the start, rounded
  };

  struct Line
  {
    int start = -1;          // vertex
    int start_halfedge = -1; // whose corner it starts in
    int start_heading = 0;
    bool is_chain = false;      // of aligned edges
    bool is_border = false;     // nothing lies on its right
    bool starts_freely = false; // a closed chain without nodes: its start is any of its vertices
    End end = End::AT_THE_BORDER;
    int last_halfedge = -1;        // of a chain
    int other = -1;                // the line on which it ends, or that it met
    Length on_other;               // where
    Length length;                 // head-on: the distance of the two starts
    std::vector<Meeting> meetings; // where others end on it, in no order
    std::vector<Piece> pieces;     // in order
  };

  std::vector<Line> lines;
  std::vector<bool> is_node; // per vertex: lines start there

  // Whether all lines were followed to their ends; if not, the map is not what it should be, or the visitor stopped.
  bool is_complete = false;

  // `second` is per halfedge, as the corners of the charts. `is_irregular` per vertex: those that lines start from.
  // Where that is not enough to leave only rectangles, more lines start.
  Motorcycle_graph(const Seamless_charts& charts, const std::vector<Chart_point>& second,
                   const std::vector<bool>& is_irregular, Stage_progress& progress)
    : is_node(is_irregular)
    , m_charts(charts)
    , m_mesh(charts.mesh)
    , m_second(second)
    , m_progress(progress)
    , m_segments(charts.mesh.number_of_faces())
    , m_steps_left(1000 + 200LL * charts.mesh.number_of_faces()) // far beyond what a map without fold-overs needs
  {
    is_complete = lay_chains() && start_from_nodes() && open_annuli();
  }

private:
  static constexpr double any = (std::numeric_limits<double>::max)();

  // The start of a line, seen from some chart, in both maps.
  struct Origin
  {
    Chart_point real, integer;
  };

  // A part of a line within a face, in the chart of the face.
  struct Segment
  {
    int line;
    int heading;
    Origin origin;
    double begin, end; // distances from the start; -any and any where it goes from side to side
  };

  // A line on its way.
  struct Rider
  {
    int line;
    int h; // on a vertex: the corner at the source of h, else the halfedge that it crosses into the face of h
    bool on_vertex;
    int heading;
    Origin origin;
    int along = -1;     // the edge of the face of h that it runs along, -1 if none
    double reached = 0; // a bound on the distance from the start, for the order of the race
    double crossed = 0; // the distance from the start, rounded, where it entered the face
  };

  const Seamless_charts& m_charts;
  const Mesh& m_mesh;
  const std::vector<Chart_point>& m_second;
  Stage_progress& m_progress;
  std::vector<std::vector<Segment>> m_segments; // per face
  long long m_steps_left;

  double ahead(const Origin& o, int h, int heading) const
  {
    return distance_along(o.real, m_charts.corner[h], heading);
  }

  static Length distance(const Origin& from, const Origin& to, int heading)
  {
    return { distance_along(from.real, to.real, heading), distance_along(from.integer, to.integer, heading) };
  }

  Origin corner(int h) const { return { m_charts.corner[h], m_second[h] }; }

  void carry_across(int h, int& heading, Origin& origin) const
  {
    const int beyond = Mesh::next(m_mesh.opposite[h]);
    double x = origin.integer[0] - m_second[h][0], y = origin.integer[1] - m_second[h][1];
    Grid_automorphism::rotate(m_charts.turn[h], x, y);
    origin.integer = { { x + m_second[beyond][0], y + m_second[beyond][1] } };
    origin.real = m_charts.across(h, origin.real);
    heading = m_charts.heading_across(h, heading);
  }

  bool is_aligned(int h) const { return m_charts.is_aligned[m_mesh.edge_of[h]]; }

  // ---- chains of aligned edges

  bool lay_chains()
  {
    std::vector<bool> is_laid(m_mesh.number_of_edges(), false);
    for(bool closed : { false, true })
      for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
        if(is_aligned(h) && !is_laid[m_mesh.edge_of[h]] && (closed || is_node[m_mesh.source(h)]))
          if(!lay_chain(h, closed, is_laid))
            return false;
    return true;
  }

  bool lay_chain(int h, bool closed, std::vector<bool>& is_laid)
  {
    const int number = static_cast<int>(lines.size());
    lines.emplace_back();
    Line& line = lines.back();
    line.start = m_mesh.source(h);
    line.start_halfedge = h;
    line.is_chain = true;
    line.is_border = m_mesh.opposite[h] == -1;
    line.starts_freely = closed;
    Origin origin = corner(h);
    int heading = line.start_heading = m_charts.heading_of(h);
    while(heading != -1)
    {
      is_laid[m_mesh.edge_of[h]] = true;
      const Segment segment{ number, heading, origin, ahead(origin, h, heading),
                             ahead(origin, Mesh::next(h), heading) };
      m_segments[h / 3].push_back(segment);
      line.pieces.push_back({ h / 3, h, heading, origin.real, segment.begin, segment.end });
      if(m_mesh.opposite[h] != -1)
      {
        Segment beyond = segment;
        carry_across(h, beyond.heading, beyond.origin);
        m_segments[m_mesh.opposite[h] / 3].push_back(beyond);
      }
      line.length = distance(origin, corner(Mesh::next(h)), heading);
      line.last_halfedge = h;
      const int v = m_mesh.target(h);
      if(is_node[v] || v == line.start)
      {
        line.end = End::AT_A_NODE;
        return is_node[v] || closed;
      }
      // on over the faces on the left
      h = Mesh::next(h);
      while(!is_aligned(h))
      {
        if(m_mesh.opposite[h] == -1)
          return false; // it ends at a border that is not aligned
        carry_across(h, heading, origin);
        h = Mesh::next(m_mesh.opposite[h]);
      }
      if(is_laid[m_mesh.edge_of[h]] || m_charts.heading_of(h) != heading)
        return false;
    }
    return false;
  }

  // ---- where lines start

  bool start_from_nodes()
  {
    std::vector<bool> has_lines(m_mesh.number_of_vertices(), false); // per vertex, then spread over components
    std::vector<Rider> riders;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_node[v])
        start_from(v, riders);
    if(!race(riders))
      return false;
    for(const Line& line : lines)
      has_lines[line.start] = true;
    return start_on_bare_components(has_lines);
  }

  // On a torus there may be neither nodes nor aligned edges: any vertex will do.
  bool start_on_bare_components(const std::vector<bool>& has_lines)
  {
    std::vector<bool> is_seen(m_mesh.number_of_faces(), false);
    for(int seed = 0; seed < m_mesh.number_of_faces(); ++seed)
    {
      if(is_seen[seed])
        continue;
      bool is_bare = true;
      std::vector<int> front(1, seed);
      is_seen[seed] = true;
      while(!front.empty())
      {
        const int f = front.back();
        front.pop_back();
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          is_bare = is_bare && !has_lines[m_mesh.source(h)] && m_mesh.opposite[h] != -1;
          const int o = m_mesh.opposite[h];
          if(o != -1 && !is_seen[o / 3])
          {
            is_seen[o / 3] = true;
            front.push_back(o / 3);
          }
        }
      }
      if(!is_bare)
        continue;
      std::vector<Rider> riders;
      is_node[m_mesh.source(3 * seed)] = true;
      start_from(m_mesh.source(3 * seed), riders);
      if(!race(riders))
        return false;
    }
    return true;
  }

  // A closed chain without nodes where no line ends on one side bounds an annulus there: a line has to cut it.
  bool open_annuli()
  {
    for(std::size_t i = 0; i < lines.size(); ++i)
    {
      if(!lines[i].starts_freely)
        continue;
      bool has_left = false, has_right = lines[i].is_border;
      for(const Meeting& m : lines[i].meetings)
        (m.is_from_left ? has_left : has_right) = true;
      if(has_left && has_right)
        continue;
      const int v = lines[i].start;
      std::vector<std::pair<int, int>> headings;
      m_charts.for_each_heading(v, [&](int h, int d) { headings.emplace_back(h, d); });
      const auto here =
        std::find(headings.begin(), headings.end(), std::make_pair(lines[i].start_halfedge, lines[i].start_heading));
      if(here == headings.end())
        return false;
      const std::size_t k = here - headings.begin(), n = headings.size();
      is_node[v] = true;
      lines[i].starts_freely = false;
      std::vector<Rider> riders;
      if(!has_left)
        start(headings[(k + 1) % n].first, headings[(k + 1) % n].second, riders);
      if(!has_right)
        start(headings[(k + n - 1) % n].first, headings[(k + n - 1) % n].second, riders);
      if(!race(riders))
        return false;
    }
    return true;
  }

  void start_from(int v, std::vector<Rider>& riders)
  {
    m_charts.for_each_heading(v,
                              [&](int h, int d)
                              {
                                if(!(is_aligned(h) && m_charts.heading_of(h) == d))
                                  start(h, d, riders);
                              });
  }

  void start(int h, int d, std::vector<Rider>& riders)
  {
    Rider r;
    r.line = static_cast<int>(lines.size());
    r.h = h;
    r.on_vertex = true;
    r.heading = d;
    r.origin = corner(h);
    riders.push_back(r);
    lines.emplace_back();
    lines.back().start = m_mesh.source(h);
    lines.back().start_halfedge = h;
    lines.back().start_heading = d;
  }

  // ---- the race

  bool race(std::vector<Rider>& riders)
  {
    typedef std::tuple<double, int> Key; // distance, rider
    std::priority_queue<Key, std::vector<Key>, std::greater<Key>> front;
    for(std::size_t i = 0; i < riders.size(); ++i)
      front.emplace(0., static_cast<int>(i));
    const int steps_per_report = 256;
    Small_steps steps(m_progress, steps_per_report);
    while(!front.empty())
    {
      if(--m_steps_left < 0 || !steps.go_further())
        return false;
      const int i = std::get<1>(front.top());
      front.pop();
      bool is_done = false;
      if(!advance(riders[i], is_done))
        return false;
      if(!is_done)
        front.emplace(riders[i].reached, i);
    }
    return true;
  }

  // Follows a line through one face, or along one edge. Returns false if that is not possible.
  bool advance(Rider& r, bool& is_done)
  {
    const int left = (r.heading + 1) & 3;
    int exit = -1, vertex_ahead = -1; // the halfedge that it leaves through, or the one whose source it reaches
    double entered = -any;
    r.along = -1;
    if(r.on_vertex)
    {
      entered = r.crossed = ahead(r.origin, r.h, r.heading);
      if(ahead(r.origin, Mesh::next(r.h), left) == 0)
      {
        r.along = r.h;
        vertex_ahead = Mesh::next(r.h);
      }
      else
        exit = Mesh::next(r.h);
    }
    else
    {
      const int apex = Mesh::prev(r.h);
      const double side = ahead(r.origin, apex, left);
      if(side == 0)
        vertex_ahead = apex;
      else
        exit = side > 0 ? Mesh::next(r.h) : apex;
    }

    const int f = r.h / 3;
    if(meets(r, f, entered, any))
    {
      is_done = true;
      return true;
    }
    const double to_vertex = vertex_ahead == -1 ? any : ahead(r.origin, vertex_ahead, r.heading);
    const double left_at = vertex_ahead == -1 ? where_it_crosses(r, exit) : to_vertex;
    lay_segment(r, f, entered, to_vertex);
    lines[r.line].pieces.push_back({ f, r.along, r.heading, r.origin.real, r.crossed, left_at });
    r.crossed = left_at;
    r.along = -1;

    if(vertex_ahead != -1)
      return pass_vertex(r, vertex_ahead, is_done);
    if(is_aligned(exit))
      return false; // it would have met the chain
    r.reached =
      (std::max)(r.reached, (std::max)(ahead(r.origin, exit, r.heading), ahead(r.origin, Mesh::next(exit), r.heading)));
    if(m_mesh.opposite[exit] == -1)
      return false; // a border that is not aligned
    carry_across(exit, r.heading, r.origin);
    r.h = m_mesh.opposite[exit];
    r.on_vertex = false;
    return true;
  }

  void lay_segment(const Rider& r, int f, double begin, double end)
  {
    Segment segment{ r.line, r.heading, r.origin, begin, end };
    m_segments[f].push_back(segment);
    if(r.along != -1 && m_mesh.opposite[r.along] != -1)
    {
      carry_across(r.along, segment.heading, segment.origin);
      m_segments[m_mesh.opposite[r.along] / 3].push_back(segment);
    }
  }

  double where_it_crosses(const Rider& r, int exit) const
  {
    const int left = (r.heading + 1) & 3;
    const double a = ahead(r.origin, exit, left), b = ahead(r.origin, Mesh::next(exit), left);
    const double from = ahead(r.origin, exit, r.heading), to = ahead(r.origin, Mesh::next(exit), r.heading);
    return from + (to - from) * (a / (a - b));
  }

  // At the vertex at the source of h, a corner of the face that the line comes from.
  bool pass_vertex(Rider& r, int h, bool& is_done)
  {
    const double at = ahead(r.origin, h, r.heading);
    r.reached = (std::max)(r.reached, at);
    Line& line = lines[r.line];
    if(is_node[m_mesh.source(h)])
    {
      line.end = End::AT_A_NODE;
      line.length = distance(r.origin, corner(h), r.heading);
      is_done = true;
      return true;
    }
    for(int g = h;;)
    {
      // A line across may touch the faces here in this vertex alone.
      if(g != h && meets(r, g / 3, at, at))
      {
        is_done = true;
        return true;
      }
      const int out = Mesh::prev(g); // the edge to the next face, counterclockwise
      if(m_mesh.opposite[out] == -1)
        return false; // a border that is not aligned
      carry_across(out, r.heading, r.origin);
      g = m_mesh.opposite[out];
      if(m_charts.is_in_corner(g, r.heading))
      {
        r.h = g;
        r.on_vertex = true;
        return true;
      }
      if(g == h)
        return false;
    }
  }

  // Whether the line meets another one in a face, at a distance from `first` to `last`; then it ends there.
  bool meets(const Rider& r, int f, double first, double last)
  {
    const Segment* met = nullptr;
    bool is_head_on = false;
    double least = any;
    for(const Segment& s : m_segments[f])
    {
      if(s.line == r.line && s.heading == r.heading)
        continue;
      if(((s.heading - r.heading) & 1) == 0)
      {
        if(s.heading == r.heading || lines[s.line].is_chain ||
           distance_along(r.origin.real, s.origin.real, (r.heading + 1) & 3) != 0)
          continue;
        // It reaches as far as the other one has come; that it has come out of the face is enough to know.
        const double at = s.end == any ? -any : distance_along(r.origin.real, s.origin.real, r.heading) - s.end;
        if(at < least && at <= last)
        {
          met = &s;
          is_head_on = true;
          least = at;
        }
        continue;
      }
      const double at = distance_along(r.origin.real, s.origin.real, r.heading);
      const double on_other = distance_along(s.origin.real, r.origin.real, s.heading);
      if(!(at > 0) || at < first || at > last || at > least || (at == least && !is_head_on) || on_other < s.begin ||
         on_other > s.end)
        continue;
      Chart_point p = r.origin.real;
      p[r.heading & 1] = s.origin.real[r.heading & 1];
      if(!is_in_face(f, p))
        continue;
      met = &s;
      is_head_on = false;
      least = at;
    }
    if(met == nullptr)
      return false;
    Line& line = lines[r.line];
    line.other = met->line;
    line.length = distance(r.origin, met->origin, r.heading);
    if(is_head_on)
    {
      line.end = End::HEAD_ON;
      return true;
    }
    line.end = End::ON_A_LINE;
    line.on_other = distance(met->origin, r.origin, met->heading);
    const bool is_from_left = ((r.heading - met->heading) & 3) == 3;
    lines[met->line].meetings.push_back({ r.line, is_from_left, line.on_other });
    line.pieces.push_back({ f, r.along, r.heading, r.origin.real, r.crossed, least });
    lay_segment(r, f, first, least);
    return true;
  }

  bool is_in_face(int f, const Chart_point& p) const
  {
    const Point_2 q(p[0], p[1]);
    for(int h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Chart_point &a = m_charts.corner[h], &b = m_charts.corner[Mesh::next(h)];
      if(CGAL::orientation(Point_2(a[0], a[1]), Point_2(b[0], b[1]), q) == CGAL::RIGHT_TURN)
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MOTORCYCLE_GRAPH_H
