// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TEXT_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TEXT_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline const char* layout_chart_name(Layout_chart chart)
{
  switch(chart)
  {
    case Layout_chart::AUTOMATIC: return "auto";
    case Layout_chart::UNIT: return "unit";
    case Layout_chart::RECTANGLE: return "rectangle";
    case Layout_chart::QUADRILATERAL: return "quadrilateral";
  }
  return "";
}

// Reads a layout from a text, line by line.
class Layout_text
{
public:
  Surface_layout layout;
  std::string error; // names the line

  explicit Layout_text(std::istream& in) : m_in(in) {}

  bool read_layout()
  {
    if(!next_line() || word() != "quad_layout" || word() != "1" || has_more())
      return fail("a layout begins with the line 'quad_layout 1'");
    while(next_line())
    {
      const std::string kind = word();
      bool is_good = false;
      if(kind == "node")
      {
        layout.nodes.emplace_back();
        is_good = read_place(layout.nodes.back());
      }
      else if(kind == "arc")
        is_good = read_arc();
      else if(kind == "patch")
        is_good = read_patch();
      else
        return fail("'" + kind + "' is not one of node, arc and patch");
      if(!is_good)
        return false;
      if(has_more())
        return fail("there is more than a " + kind + " needs");
    }
    return true;
  }

  bool read_curves()
  {
    std::vector<Surface_layout::Place> points;
    std::vector<std::vector<std::size_t>> lines;
    while(next_line())
    {
      const std::string kind = word();
      if(kind == "v")
      {
        points.emplace_back();
        if(!read_point(points.back()))
          return false;
      }
      else if(kind == "l")
      {
        lines.emplace_back();
        while(has_more())
        {
          const std::string item = word();
          char* end = nullptr;
          const long long i = std::strtoll(item.c_str(), &end, 10);
          const long long n = static_cast<long long>(points.size());
          const long long index = i < 0 ? n + i : i - 1;
          if(end == item.c_str() || (*end != '\0' && *end != '/') || index < 0 || index >= n)
            return fail("'" + item + "' is not the number of a vertex before it");
          lines.back().push_back(static_cast<std::size_t>(index));
        }
        if(lines.back().size() < 2)
          return fail("a curve has two points or more");
      }
    }
    if(lines.empty())
      return fail("there are no curves, that is, no 'l' elements");
    make_arcs(points, lines);
    return true;
  }

private:
  bool fail(const std::string& what)
  {
    error = "Line " + std::to_string(m_line) + ": " + what + ".";
    return false;
  }

  // The next line that is not empty; what follows a # is a comment.
  bool next_line()
  {
    std::string text;
    while(std::getline(m_in, text))
    {
      ++m_line;
      const std::size_t comment = text.find('#');
      if(comment != std::string::npos)
        text.erase(comment);
      m_words.clear();
      m_next = 0;
      std::istringstream words(text);
      for(std::string w; words >> w;)
        m_words.push_back(w);
      if(!m_words.empty())
        return true;
    }
    return false;
  }

  bool has_more() const { return m_next < m_words.size(); }
  std::string word() { return has_more() ? m_words[m_next++] : std::string(); }
  bool next_is(const std::string& w) const { return has_more() && m_words[m_next] == w; }

  bool read_number(double& x)
  {
    const std::string w = word();
    char* end = nullptr;
    x = std::strtod(w.c_str(), &end);
    return (!w.empty() && *end == '\0' && std::isfinite(x)) || fail("'" + w + "' is not a finite number");
  }

  bool read_index(std::size_t& i, const std::string& what)
  {
    const std::string w = word();
    char* end = nullptr;
    const unsigned long long n = std::strtoull(w.c_str(), &end, 10);
    i = static_cast<std::size_t>(n);
    return (!w.empty() && *end == '\0' && w[0] != '-' && w[0] != '+' && i != Surface_layout::none) ||
           fail("'" + w + "' is not the number of " + what);
  }

  bool read_point(Surface_layout::Place& place)
  {
    return read_number(place.point[0]) && read_number(place.point[1]) && read_number(place.point[2]);
  }

  bool read_place(Surface_layout::Place& place)
  {
    if(!next_is("vertex"))
      return read_point(place);
    word();
    return read_index(place.vertex, "a vertex");
  }

  bool read_arc()
  {
    layout.arcs.emplace_back();
    Surface_layout::Arc& arc = layout.arcs.back();
    if(!read_index(arc.source, "a node") || !read_index(arc.target, "a node"))
      return false;
    if(arc.source >= layout.nodes.size() || arc.target >= layout.nodes.size())
      return fail("the arc names a node that no line before it defines");
    while(has_more())
    {
      const std::string option = word();
      if(option == "aligned")
        arc.is_aligned = true;
      else if(option == "length")
      {
        if(!read_number(arc.edge_length))
          return false;
        if(!(arc.edge_length > 0))
          return fail("the length of edges must be positive");
      }
      else if(option == "via")
      {
        arc.way.emplace_back();
        if(!read_place(arc.way.back()))
          return false;
      }
      else
        return fail("'" + option + "' is not one of aligned, length and via");
    }
    return true;
  }

  bool read_patch()
  {
    layout.patches.emplace_back();
    Surface_layout::Patch& patch = layout.patches.back();
    std::size_t side = 0;
    while(has_more())
    {
      const std::string item = word();
      if(item == "/")
      {
        if(++side == 4)
          return fail("a patch has four sides, separated by '/'");
      }
      else if(item == "chart")
      {
        const std::string name = word();
        bool is_known = false;
        for(Layout_chart c :
            { Layout_chart::AUTOMATIC, Layout_chart::UNIT, Layout_chart::RECTANGLE, Layout_chart::QUADRILATERAL })
          if(name == layout_chart_name(c))
          {
            patch.chart = c;
            is_known = true;
          }
        if(!is_known)
          return fail("'" + name + "' is not one of auto, unit, rectangle and quadrilateral");
      }
      else
      {
        char* end = nullptr;
        const unsigned long long n = item.size() < 2 ? 0 : std::strtoull(item.c_str() + 1, &end, 10);
        if(item.size() < 2 || (item[0] != '+' && item[0] != '-') || item[1] == '-' || item[1] == '+' || *end != '\0')
          return fail("'" + item + "' is not an arc with its direction, as +3 or -3");
        if(n >= layout.arcs.size())
          return fail("the patch names an arc that no line before it defines");
        patch.sides[side].push_back(Surface_layout::Side_arc{ static_cast<std::size_t>(n), item[0] == '+' });
      }
    }
    return side == 3 || fail("a patch has four sides, separated by '/'");
  }

  // Cuts curves at the points where their number of segments is not two.
  void make_arcs(const std::vector<Surface_layout::Place>& points, const std::vector<std::vector<std::size_t>>& lines)
  {
    std::vector<std::set<std::size_t>> neighbours(points.size());
    for(const std::vector<std::size_t>& line : lines)
      for(std::size_t i = 0; i + 1 < line.size(); ++i)
        if(line[i] != line[i + 1])
        {
          neighbours[line[i]].insert(line[i + 1]);
          neighbours[line[i + 1]].insert(line[i]);
        }
    std::vector<std::size_t> node(points.size(), Surface_layout::none);
    for(std::size_t p = 0; p < points.size(); ++p)
      if(!neighbours[p].empty() && neighbours[p].size() != 2)
      {
        node[p] = layout.nodes.size();
        layout.nodes.push_back(points[p]);
      }
    std::set<std::pair<std::size_t, std::size_t>> done;
    auto follow = [&](std::size_t start, std::size_t second)
    {
      Surface_layout::Arc arc;
      arc.source = node[start];
      arc.is_aligned = true;
      std::size_t before = start, here = second;
      for(;;)
      {
        done.insert({ before, here });
        done.insert({ here, before });
        if(node[here] != Surface_layout::none)
          break;
        arc.way.push_back(points[here]);
        const std::size_t first = *neighbours[here].begin(), last = *neighbours[here].rbegin();
        const std::size_t next = first == before ? last : first;
        before = here;
        here = next;
      }
      arc.target = node[here];
      layout.arcs.push_back(arc);
    };
    for(std::size_t p = 0; p < points.size(); ++p)
      if(node[p] != Surface_layout::none)
        for(std::size_t q : neighbours[p])
          if(done.count({ p, q }) == 0)
            follow(p, q);
    // closed curves that meet no other one have a node somewhere
    for(std::size_t p = 0; p < points.size(); ++p)
      if(!neighbours[p].empty() && node[p] == Surface_layout::none && done.count({ p, *neighbours[p].begin() }) == 0)
      {
        node[p] = layout.nodes.size();
        layout.nodes.push_back(points[p]);
        follow(p, *neighbours[p].begin());
      }
  }

  std::istream& m_in;
  std::size_t m_line = 0;
  std::vector<std::string> m_words; // of the line
  std::size_t m_next = 0;
};

inline void write_layout_place(std::ostream& out, const Surface_layout::Place& place)
{
  if(place.vertex != Surface_layout::none)
    out << " vertex " << place.vertex;
  else
    out << ' ' << place.point[0] << ' ' << place.point[1] << ' ' << place.point[2];
}

inline void write_layout_text(std::ostream& out, const Surface_layout& layout)
{
  out << "quad_layout 1\n";
  for(const Surface_layout::Place& n : layout.nodes)
  {
    out << "node";
    write_layout_place(out, n);
    out << '\n';
  }
  for(const Surface_layout::Arc& a : layout.arcs)
  {
    out << "arc " << a.source << ' ' << a.target;
    if(a.is_aligned)
      out << " aligned";
    if(a.edge_length > 0)
      out << " length " << a.edge_length;
    for(const Surface_layout::Place& p : a.way)
    {
      out << " via";
      write_layout_place(out, p);
    }
    out << '\n';
  }
  for(const Surface_layout::Patch& p : layout.patches)
  {
    out << "patch";
    for(std::size_t k = 0; k < 4; ++k)
    {
      if(k > 0)
        out << " /";
      for(const Surface_layout::Side_arc& s : p.sides[k])
        out << ' ' << (s.is_forward ? '+' : '-') << s.arc;
    }
    if(p.chart != Layout_chart::AUTOMATIC)
      out << " chart " << layout_chart_name(p.chart);
    out << '\n';
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TEXT_H
