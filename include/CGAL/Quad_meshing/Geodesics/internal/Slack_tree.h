// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SLACK_TREE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SLACK_TREE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Sums up what all faces violate that a path of a given length to a given point may meet: those for which the distance
// of the field and the straight line to the point are together no longer than the path.
class Slack_tree
{
public:
  typedef Simple_cartesian<double>::Point_3 Point_3;

  // Nothing nearer than `nearest` is in a face, and what it violates is at most `slack`.
  struct Finding
  {
    double nearest, slack;
    Bbox_3 box;
  };

  explicit Slack_tree(std::vector<Finding> findings) : m_findings(std::move(findings))
  {
    if(!m_findings.empty())
      make(0, m_findings.size());
  }

  double all() const { return m_nodes.empty() ? 0. : m_nodes[0].slack; }

  // An upper bound of the sum for paths of at most that length to p.
  double sum(const Point_3& p, double length) const
  {
    return m_nodes.empty() ? 0. : sum(0, 0, m_findings.size(), p, length);
  }

private:
  struct Node
  {
    double nearest, slack; // the smallest one, and the sum of all
    Bbox_3 box;
    double diameter;
    int right; // the left child is the next node
  };

  static std::size_t leaf_size() { return 8; }

  // Faces closer together than this part of the path are not told apart.
  static double resolution() { return 0.02; }

  // For the rounding of distances and their sums, relative to them.
  static double margin() { return 1e-12; }

  static double added(double a, double b) { return (a + b) * (1 + 0x1p-48); }

  int make(std::size_t begin, std::size_t end)
  {
    const int n = static_cast<int>(m_nodes.size());
    Node node{ std::numeric_limits<double>::infinity(), 0., Bbox_3(), 0., -1 };
    for(std::size_t i = begin; i < end; ++i)
    {
      node.nearest = (std::min)(node.nearest, m_findings[i].nearest);
      node.slack = added(node.slack, m_findings[i].slack);
      node.box += m_findings[i].box;
    }
    for(int k = 0; k < 3; ++k)
      node.diameter = (std::max)(node.diameter, node.box.max(k) - node.box.min(k));
    m_nodes.push_back(node);
    if(end - begin > leaf_size())
    {
      // in the middle of the longest side
      int axis = 0;
      for(int k = 1; k < 3; ++k)
        if(node.box.max(k) - node.box.min(k) > node.box.max(axis) - node.box.min(axis))
          axis = k;
      const std::size_t middle = middle_of(begin, end);
      const auto first = m_findings.begin();
      std::nth_element(first + begin, first + middle, first + end,
                       [&](const Finding& a, const Finding& b)
                       { return a.box.min(axis) + a.box.max(axis) < b.box.min(axis) + b.box.max(axis); });
      make(begin, middle);
      const int right = make(middle, end);
      m_nodes[n].right = right;
    }
    return n;
  }

  static std::size_t middle_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

  double sum(int n, std::size_t begin, std::size_t end, const Point_3& p, double length) const
  {
    const Node& node = m_nodes[n];
    if(is_beyond(node.nearest, node.box, p, length))
      return 0;
    if(node.diameter < resolution() * length)
      return node.slack;
    if(node.right == -1)
    {
      double s = 0;
      for(std::size_t i = begin; i < end; ++i)
        if(!is_beyond(m_findings[i].nearest, m_findings[i].box, p, length))
          s = added(s, m_findings[i].slack);
      return s;
    }
    const std::size_t middle = middle_of(begin, end);
    return added(sum(n + 1, begin, middle, p, length), sum(node.right, middle, end, p, length));
  }

  // Whether what begins at `nearest` and lies in the box is farther than the length in any case.
  static bool is_beyond(double nearest, const Bbox_3& box, const Point_3& p, double length)
  {
    const double rest = length + margin() * std::fabs(length) - nearest;
    if(rest < 0)
      return true;
    const double x = outside(p.x(), box.xmin(), box.xmax()), y = outside(p.y(), box.ymin(), box.ymax()),
                 z = outside(p.z(), box.zmin(), box.zmax());
    return (x * x + y * y + z * z) * (1 - 2 * margin()) > rest * rest;
  }

  static double outside(double x, double low, double high) { return (std::max)((std::max)(low - x, x - high), 0.); }

  std::vector<Finding> m_findings;
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SLACK_TREE_H
